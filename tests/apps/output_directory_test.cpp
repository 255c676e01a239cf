#include "output_directory.h"

#include <dbd/core/error.h>
#include <gmock/gmock.h>

#include <fstream>

#include "support/temporary_directory.h"
#include "text.h"

namespace dbd {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> NamesIn(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

TEST(OutputDirectory, ProbingLeavesNothingBehind) {
  const TemporaryDirectory scratch;
  { const OutputDirectory output(scratch.File("a/b/out")); }
  EXPECT_THAT(NamesIn(scratch.path()), testing::IsEmpty());
}

TEST(OutputDirectory, FilesAppearTogetherOnCommit) {
  const TemporaryDirectory scratch;
  OutputDirectory output(scratch.File("a/out/"));
  WriteTextFile(output.Stage("map.png"), "1");
  WriteTextFile(output.Stage("plan.json"), "2");
  EXPECT_FALSE(fs::exists(scratch.File("a/out")));
  output.Commit();
  EXPECT_THAT(NamesIn(scratch.File("a/out")),
              testing::UnorderedElementsAre("map.png", "plan.json"));
  EXPECT_THAT(NamesIn(scratch.File("a")), testing::ElementsAre("out"));
}

TEST(OutputDirectory, WithoutCommitNothingIsLeft) {
  const TemporaryDirectory scratch;
  {
    OutputDirectory output(scratch.File("a/out"));
    WriteTextFile(output.Stage("map.png"), "1");
  }
  EXPECT_THAT(NamesIn(scratch.path()), testing::IsEmpty());
}

TEST(OutputDirectory, AnOldAnswerIsNotMixedWithTheNewOne) {
  const TemporaryDirectory scratch;
  fs::create_directory(scratch.File("out"));
  WriteTextFile(scratch.File("out/route.gpx"), "old route");
  WriteTextFile(scratch.File("out/plan.json"), "old plan");
  WriteTextFile(scratch.File("out/notes.txt"), "the user's own");
  OutputDirectory output(scratch.File("out"));
  WriteTextFile(output.Stage("plan.json"), "no route");
  output.Commit();
  EXPECT_THAT(NamesIn(scratch.File("out")),
              testing::UnorderedElementsAre("plan.json", "notes.txt"));
  std::ifstream plan(scratch.File("out/plan.json"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(plan), {}), "no route");
}

TEST(OutputDirectory, RefusesAFileAndAPlaceBelowAFile) {
  const TemporaryDirectory scratch;
  WriteTextFile(scratch.File("file"), "");
  for (const char* name : {"file", "file/out", "file/deeper/out"}) {
    try {
      const OutputDirectory output(scratch.File(name));
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("--out " + scratch.File(name) + ": "));
    }
  }
  EXPECT_THAT(NamesIn(scratch.path()), testing::ElementsAre("file"));
}

}  // namespace
}  // namespace dbd
