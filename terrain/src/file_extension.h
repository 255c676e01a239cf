#pragma once

#include <string>

namespace dbd {

/// ".tif" of "DEM.TIF".
std::string LowerExtension(const std::string& file);

/// Lower-case extensions of formats with points, lines or areas.
bool IsVectorExtension(const std::string& extension);
/// .bt and .ot
bool IsOctreeExtension(const std::string& extension);
/// .ply and .obj
bool IsMeshExtension(const std::string& extension);

}  // namespace dbd
