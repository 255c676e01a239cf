#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace dbd {

/// Writes files side by side.
class FileWriters {
 public:
  /// `threads`: as in PlanOptions.
  explicit FileWriters(int threads = 0);

  /// Waits for what has been begun.
  ~FileWriters();
  FileWriters(const FileWriters&) = delete;
  FileWriters& operator=(const FileWriters&) = delete;

  /// Begins some time between now and `Wait`. What `write` refers to must stay until then.
  void Run(std::function<void()> write);
  void WriteText(std::filesystem::path file, std::function<std::string()> text);

  /// Returns when all is written. Throws what one of the writers has thrown.
  void Wait();

 private:
  struct Tasks;
  std::unique_ptr<Tasks> tasks_;
};

}  // namespace dbd
