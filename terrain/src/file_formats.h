#pragma once

#include <dbd/terrain/file_info.h>

#include <string>

// One function for each kind of file; `DescribeFile` chooses. All throw InputError.

namespace dbd {

FileInfo DescribeRasterFile(const std::string& file, int band);
FileInfo DescribeVectorFile(const std::string& file);
FileInfo DescribeOctreeFile(const std::string& file);
FileInfo DescribeMeshFile(const std::string& file);
FileInfo DescribePointFile(const std::string& file, const std::string& extension);

}  // namespace dbd
