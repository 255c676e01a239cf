#pragma once

#include <string>

namespace dbd {

/// What is said on standard error besides the answer.
enum class Verbosity { kQuiet, kNormal, kVerbose };

/// Sets how much is said from now on and routes GDAL's messages to `Detail`.
void ConfigureConsole(Verbosity verbosity);

/// One line each, starting with "dbd: ". Errors are always shown, notes unless quiet, details only
/// when verbose. Line breaks in the text become spaces.
void PrintError(const std::string& text);
void PrintNote(const std::string& text);
void PrintDetail(const std::string& text);

/// Shows the progress of a long stage as one line that is rewritten in place. Silent unless
/// standard error is a terminal.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void Show(const std::string& stage, int done, int total);
  void Clear();

 private:
  bool enabled_ = false;
  bool shown_ = false;
};

}  // namespace dbd
