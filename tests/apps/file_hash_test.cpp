#include "file_hash.h"

#include <gtest/gtest.h>

#include "support/temporary_directory.h"
#include "text.h"

namespace dbd {
namespace {

// The example of FIPS 180-2, appendix B.1.
TEST(Sha256OfFile, MatchesThePublishedExample) {
  const TemporaryDirectory scratch;
  WriteTextFile(scratch.File("abc"), "abc");
  EXPECT_EQ(Sha256OfFile(scratch.File("abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

// RFC 6234, test 3 of SHA-256: a million times "a", more than one buffer.
TEST(Sha256OfFile, ReadsFilesThatAreLargerThanItsBuffer) {
  const TemporaryDirectory scratch;
  WriteTextFile(scratch.File("long"), std::string(1000000, 'a'));
  EXPECT_EQ(Sha256OfFile(scratch.File("long")),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256OfFile, IsEmptyForWhatIsNoFile) {
  const TemporaryDirectory scratch;
  EXPECT_EQ(Sha256OfFile("tomcar-tm27"), "");
  EXPECT_EQ(Sha256OfFile(scratch.File("missing")), "");
  EXPECT_EQ(Sha256OfFile(scratch.path()), "");
}

}  // namespace
}  // namespace dbd
