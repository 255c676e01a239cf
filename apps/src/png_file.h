#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace dbd {

/// A picture in memory, one 0x??RRGGBB per pixel, rows from top to bottom.
struct PixelRows {
  int width = 0;
  int height = 0;
  std::size_t stride = 0;  ///< from one row to the next [pixels]
  const std::uint32_t* pixels = nullptr;
};

/// Writes a PNG file, quickly rather than small. Throws InputError where it cannot be written.
void WritePng(const std::filesystem::path& file, const PixelRows& image);

}  // namespace dbd
