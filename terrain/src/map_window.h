#pragma once

#include "raster_file.h"

namespace dbd {

/// Cuts a raster whose heights would need more than the request's memory limit, at
/// `bytes_per_cell`, to a window round the request's places: as large as the limit allows, but no
/// wider on each side than the places are apart (at least 500 cells).
/// Returns a sentence that says so; empty when the raster is small enough.
/// Throws InputError when there are no places or the window does not fit either.
std::string CutToMemory(const RasterRequest& request, std::size_t bytes_per_cell, RasterFile* file);

}  // namespace dbd
