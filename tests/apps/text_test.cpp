#include "text.h"

#include <dbd/core/error.h>
#include <gtest/gtest.h>

namespace dbd {
namespace {

TEST(FormatDuration, ChangesToMinutes) {
  EXPECT_EQ(FormatDuration(12.34), "12.3 s");
  EXPECT_EQ(FormatDuration(59.97), "1 min 00 s");
  EXPECT_EQ(FormatDuration(204), "3 min 24 s");
}

TEST(HashText, HasAllItsDigits) { EXPECT_EQ(HashText(0xfcull), "00000000000000fc"); }

TEST(FormatLength, ChangesToKilometers) {
  EXPECT_EQ(FormatLength(999.4), "999 m");
  EXPECT_EQ(FormatLength(1118), "1.12 km");
}

TEST(WriteTextFile, NamesTheFileThatCannotBeWritten) {
  EXPECT_THROW(WriteTextFile("/nonexistent/file", "text"), InputError);
}

}  // namespace
}  // namespace dbd
