#pragma once

#include <map>
#include <string>
#include <vector>

namespace dbd {

/// The result file of a batch (JSON lines): every line is appended in one piece and on the disk
/// before `Append` returns, so that a crash, a kill or a full disk loses no result that was
/// reported, and another run can go on with it.
class BatchResults {
 public:
  /// `resume`: goes on with a file that is already there; a line that was cut off by a crash is
  /// removed. Throws InputError when the file exists and `resume` is not set, cannot be written, is
  /// being written by another process, or does not hold results.
  BatchResults(const std::string& path, bool resume);
  ~BatchResults();
  BatchResults(const BatchResults&) = delete;
  BatchResults& operator=(const BatchResults&) = delete;

  /// Line number of the request -> id, of what the file already answers.
  const std::map<std::size_t, std::string>& answered() const { return answered_; }

  /// `line`: without a line break. Throws InputError when it cannot be written whole; the file then
  /// ends with the line before.
  void Append(const std::string& line);

 private:
  void ReadAnswers();
  [[noreturn]] void Fail(const std::string& what) const;

  std::string path_;
  int file_ = -1;
  std::map<std::size_t, std::string> answered_;
};

/// Joins result files of shards, ordered by the line of their requests. Throws InputError when two
/// of them answer the same line, when one cannot be read, or when `out` exists.
void MergeBatchResults(const std::vector<std::string>& parts, const std::string& out);

}  // namespace dbd
