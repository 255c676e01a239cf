#include <dbd/core/error.h>
#include <dbd/terrain/file_info.h>

#include <filesystem>

#include "file_extension.h"
#include "file_formats.h"

namespace dbd {
FileInfo DescribeFile(const std::string& file, int band) {
  std::error_code ignored;
  const bool is_virtual = file.rfind("/vsi", 0) == 0;
  if (!is_virtual && !std::filesystem::exists(file, ignored)) {
    throw InputError(file + ": no such file");
  }
  const std::string extension = LowerExtension(file);
  if (IsOctreeExtension(extension) || extension == ".graph") return DescribeOctreeFile(file);
  if (IsMeshExtension(extension)) return DescribeMeshFile(file);
  for (const char* points : {".xyz", ".pcd", ".las", ".laz"}) {
    if (extension == points) return DescribePointFile(file, extension);
  }
  return IsVectorExtension(extension) ? DescribeVectorFile(file) : DescribeRasterFile(file, band);
}

}  // namespace dbd
