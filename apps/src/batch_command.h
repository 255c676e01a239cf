#pragma once

#include <string>
#include <vector>

namespace dbd {

/// What `dbd batch` was asked, as typed.
struct BatchArguments {
  std::vector<std::string> requests;  ///< one file, "-" for standard input; or the parts to merge
  std::string out;
  bool resume = false;
  bool merge = false;
  std::string shard;  ///< "i/n" or empty
  int threads = 0;
  double memory_gb = 4;
};

/// Answers every request of the file, or joins the results of shards. Returns the exit code: 0 when
/// all were answered, 2 when some were refused, 4 when stopped before the end. Throws InputError.
int RunBatch(const BatchArguments& arguments);

}  // namespace dbd
