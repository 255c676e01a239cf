#pragma once

#include <stdexcept>
#include <string>

namespace dbd {

/// The user's mistake: a file, field or value that breaks a rule. The message is one line that
/// names what was given and the rule. Thrown by loaders and validation only.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void FailAssertion(const char* condition, const char* file, int line);

}  // namespace dbd

/// Our mistake: ends the program with the place. Never used for what a user can cause.
#define DBD_ASSERT(condition)                               \
  do {                                                      \
    if (!(condition)) {                                     \
      ::dbd::FailAssertion(#condition, __FILE__, __LINE__); \
    }                                                       \
  } while (false)
