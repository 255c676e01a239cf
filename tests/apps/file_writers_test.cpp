#include "file_writers.h"

#include <dbd/core/error.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>

#include "support/temporary_directory.h"

namespace dbd {
namespace {

TEST(FileWriters, WriteAllUntilWaitReturns) {
  const TemporaryDirectory directory;
  for (const int threads : {0, 1, 2, 3}) {
    FileWriters writers(threads);
    std::atomic<int> written = 0;
    for (int i = 0; i < 20; ++i) writers.Run([&written] { ++written; });
    writers.WriteText(directory.path() / "text", [threads] { return std::to_string(threads); });
    writers.Wait();
    EXPECT_EQ(written, 20);
    EXPECT_EQ(std::filesystem::file_size(directory.path() / "text"), 1u);
  }
}

TEST(FileWriters, PassOnWhatAWriterThrows) {
  FileWriters writers;
  writers.WriteText("/nowhere/text", [] { return "text"; });
  EXPECT_THROW(writers.Wait(), InputError);
}

TEST(FileWriters, WaitBeforeTheyGo) {
  std::atomic<int> written = 0;
  {
    FileWriters writers(2);
    for (int i = 0; i < 20; ++i) writers.Run([&written] { ++written; });
  }
  EXPECT_EQ(written, 20);
  FileWriters failing(2);
  failing.WriteText("/nowhere/text", [] { return "text"; });
}

}  // namespace
}  // namespace dbd
