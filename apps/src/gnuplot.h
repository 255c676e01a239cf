#pragma once

#include <filesystem>
#include <string>

namespace dbd {

/// gnuplot, a program of its own that turns script files into pictures. It is run without a shell.
class Gnuplot {
 public:
  /// Looks for it in PATH. Throws InputError that names `flag` and says what to install.
  explicit Gnuplot(const std::string& flag);

  /// Runs a script in the script's directory. Throws InputError with gnuplot's complaint.
  void Run(const std::filesystem::path& script) const;

 private:
  std::string flag_;
  std::filesystem::path program_;
};

/// A text as gnuplot reads it back unchanged: in single quotes nothing is expanded. Control
/// characters become spaces.
std::string QuoteForGnuplot(const std::string& text);

}  // namespace dbd
