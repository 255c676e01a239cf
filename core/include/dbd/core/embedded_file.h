#pragma once

#include <span>
#include <string_view>

namespace dbd {

/// A text file built into the library.
struct EmbeddedFile {
  std::string_view name;  ///< file name without directory and extension
  std::string_view text;
};

}  // namespace dbd
