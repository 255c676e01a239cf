#pragma once

namespace dbd {

/// The program's exit codes.
enum ExitCode : int {
  kExitOk = 0,           ///< route found, or the command did what it was asked
  kExitBug = 1,          ///< our mistake
  kExitBadInput = 2,     ///< bad usage or input
  kExitNoSafeRoute = 3,  ///< no safe route; said why and where
  kExitStopped = 4,      ///< stopped by deadline or interrupt before any answer
};

/// The `dbd` program: data on standard output; notes and, on failure, exactly one line
/// "dbd: <message>" on standard error. Never throws.
int RunProgram(int argc, const char* const* argv);

}  // namespace dbd
