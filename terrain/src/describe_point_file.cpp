#include <utility>

#include "file_formats.h"
#include "point_file.h"

namespace dbd {
namespace {

PointFileInfo DescribeXyz(const std::string& file) {
  PointFileInfo content;
  for (const Eigen::Vector3d& point : ReadXyz(file)) {
    ++content.points;
    content.extent.Add(point);
  }
  return content;
}

}  // namespace

FileInfo DescribePointFile(const std::string& file, const std::string& extension) {
  FileInfo info;
  if (extension == ".xyz") {
    info.format = "XYZ";
    info.content = DescribeXyz(file);
  } else if (extension == ".pcd") {
    info.format = "PCD";
    info.content = ReadPcdHeader(file);
    info.warnings.emplace_back("only the header of PCD files is read; convert it to XYZ");
  } else {
    info.format = extension == ".laz" ? "LAZ" : "LAS";
    info.content = ReadLasHeader(file);
    info.warnings.emplace_back("only the header of LAS and LAZ files is read; convert it to XYZ");
  }
  return info;
}

}  // namespace dbd
