#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dbd {

/// A directory that receives all of a command's files or none: they are written to a staging
/// directory and moved when every one of them is complete.
class OutputDirectory {
 public:
  /// Finds out now, before the long work, whether the directory can be created and written, and
  /// leaves no trace of having tried. `flag` is named in messages; `stale` are the files of an
  /// earlier run that `Commit` removes unless they were staged, so that no two answers are mixed.
  /// Throws InputError.
  explicit OutputDirectory(const std::string& directory, const std::string& flag = "--out",
                           std::vector<std::string> stale = AnswerFiles());

  /// Removes what was not committed.
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  /// Where to write the file with this name until `Commit`.
  std::filesystem::path Stage(const std::string& name);

  /// Moves the staged files into the directory and removes stale ones.
  void Commit();

  /// As it was typed.
  const std::string& name() const { return name_; }
  const std::vector<std::string>& staged() const { return staged_; }

 private:
  /// What the answers to `plan` and `simulate` consist of, whichever of them a run writes.
  static std::vector<std::string> AnswerFiles();

  void CreateStaging();
  void RemoveStaging();
  [[noreturn]] void Refuse(const std::string& reason) const;

  std::string name_;
  std::string flag_;
  std::vector<std::string> stale_;
  std::filesystem::path directory_;  ///< absolute
  std::filesystem::path staging_;
  std::vector<std::filesystem::path> created_parents_;  ///< outermost first
  std::vector<std::string> staged_;
};

}  // namespace dbd
