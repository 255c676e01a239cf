#include "batch_results.h"

#include <dbd/core/error.h>
#include <gmock/gmock.h>

#include "support/program.h"

namespace dbd {
namespace {

using testing::HasSubstr;
using testing::Pair;
using testing::UnorderedElementsAre;

std::string Result(int line, const std::string& id) {
  return "{\"schema\":\"dbd.result/1\",\"id\":\"" + id + "\",\"line\":" + std::to_string(line) +
         "}";
}

std::string MessageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class BatchResultsTest : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  std::string file_ = directory_.File("results.jsonl");
};

TEST_F(BatchResultsTest, GoesOnBehindTheLastWholeLine) {
  { BatchResults(file_, false).Append(Result(4, "d")); }
  std::ofstream(file_, std::ios::app) << Result(5, "torn").substr(0, 20);
  BatchResults results(file_, true);
  EXPECT_THAT(results.answered(), UnorderedElementsAre(Pair(4, "d")));
  results.Append(Result(2, "b"));
  EXPECT_EQ(ReadWhole(file_), Result(4, "d") + "\n" + Result(2, "b") + "\n");
}

TEST_F(BatchResultsTest, OneProcessAtATime) {
  const BatchResults results(file_, false);
  EXPECT_THAT(MessageOf([&] { BatchResults(file_, true); }), HasSubstr("by another process"));
}

TEST_F(BatchResultsTest, RefusesWhatHoldsNoResults) {
  std::ofstream(file_) << "{\"schema\":\"dbd.plan/1\"}\n";
  EXPECT_THAT(MessageOf([&] { BatchResults(file_, true); }), HasSubstr("(line 1): schema"));
  EXPECT_EQ(ReadWhole(file_), "{\"schema\":\"dbd.plan/1\"}\n");
  EXPECT_THAT(MessageOf([&] { BatchResults(directory_.File("no/where"), false); }),
              HasSubstr("cannot be opened"));
}

TEST_F(BatchResultsTest, MergeOrdersByLineAndRefusesTwoAnswers) {
  const std::string one = directory_.Write("1", Result(3, "c") + "\n" + Result(1, "a") + "\n");
  const std::string two = directory_.Write("2", Result(2, "b") + "\n");
  MergeBatchResults({one, two}, file_);
  EXPECT_EQ(ReadWhole(file_),
            Result(1, "a") + "\n" + Result(2, "b") + "\n" + Result(3, "c") + "\n");
  EXPECT_THAT(MessageOf([&] {
                MergeBatchResults({one, one}, directory_.File("3"));
              }),
              HasSubstr("answers request line 3, which another part"));
}

}  // namespace
}  // namespace dbd
