#include "machine_peaks.h"

#include <cstdlib>
#include <cstring>
#include <memory>

namespace dbd {

const char* ReadableBytes(std::size_t count) {
  struct Free {
    void operator()(char* bytes) const { std::free(bytes); }
  };
  static std::unique_ptr<char, Free> bytes;
  static std::size_t size = 0;
  if (size < count) {
    bytes.reset(static_cast<char*>(std::aligned_alloc(64, count)));
    std::memset(bytes.get(), 0, count);
    size = count;
  }
  return bytes.get();
}

}  // namespace dbd
