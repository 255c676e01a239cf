#pragma once

#include <cstddef>

namespace dbd::internal {

/// Asks the system to back this memory, which nothing has touched yet, with large pages. Along a
/// drive across the rows of a fine raster each row lies on a page of its own, more of them than the
/// processor keeps addresses for. A hint: without effect where the system has none, or on pieces
/// smaller than such a page.
void AdviseHugePages(void* memory, std::size_t bytes);

}  // namespace dbd::internal
