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

/// Writes a PNG file. Strips of rows are compressed in parallel in the caller's task arena, each
/// for itself, so that the file is the same for any number of threads. Fast: a tenth larger than at
/// zlib's usual level, in a fifth of the time.
void WritePng(const std::filesystem::path& file, const PixelRows& image);

}  // namespace dbd
