#include "gnuplot.h"

#include <dbd/core/error.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

#include "support/temporary_directory.h"

namespace dbd {
namespace {

/// PATH holds one directory with a program called gnuplot: a stand-in that the test writes.
class GnuplotTest : public testing::Test {
 protected:
  GnuplotTest() : path_(std::getenv("PATH")) {
    setenv("PATH", scratch_.path().c_str(), 1);
    std::filesystem::create_directory(scratch_.File("work"));
  }
  ~GnuplotTest() override { setenv("PATH", path_.c_str(), 1); }

  void Install(const std::string& shell_script) {
    const std::string file = scratch_.File("gnuplot");
    std::ofstream(file) << "#!/bin/sh\n" << shell_script;
    chmod(file.c_str(), 0755);
  }

  static std::string ErrorOf(const std::function<void()>& call) {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  TemporaryDirectory scratch_;

 private:
  std::string path_;
};

TEST_F(GnuplotTest, SaysWhatToInstall) {
  EXPECT_EQ(ErrorOf([] { Gnuplot("--plots"); }),
            "--plots: needs the program gnuplot (Debian package gnuplot-nox)");
}

TEST_F(GnuplotTest, RunsTheScriptWhereItLies) {
  Install("while read -r line; do echo \"$line\"; done < \"$1\" > seen\n");
  std::ofstream(scratch_.File("work/a b.gp")) << "plot x\n";
  Gnuplot("--plots").Run(scratch_.File("work/a b.gp"));
  std::ifstream seen(scratch_.File("work/seen"));
  std::string line;
  std::getline(seen, line);
  EXPECT_EQ(line, "plot x");
}

TEST_F(GnuplotTest, PassesTheComplaintOn) {
  Install(
      "echo 'plot y' >&2; echo '     ^' >&2; echo 'line 1: undefined variable: y' >&2; exit 1\n");
  EXPECT_EQ(
      ErrorOf([&] { Gnuplot("--plots").Run(scratch_.File("work/a.gp")); }),
      "--plots: " + scratch_.File("gnuplot") + " failed on a.gp: line 1: undefined variable: y");
}

TEST(QuoteForGnuplot, LeavesNothingToExpand) {
  EXPECT_EQ(QuoteForGnuplot("a"), "'a'");
  EXPECT_EQ(QuoteForGnuplot("it's\n`x`"), "'it''s `x`'");
}

}  // namespace
}  // namespace dbd
