#include <dbd/core/error.h>

#include <cstdio>
#include <cstdlib>

namespace dbd {

void FailAssertion(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: internal error: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace dbd
