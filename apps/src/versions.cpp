#include "versions.h"

#include <gdal.h>
#include <ogr_srs_api.h>

namespace dbd {
namespace {

std::string ProjVersion() {
  int major = 0, minor = 0, patch = 0;
  OSRGetPROJVersion(&major, &minor, &patch);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> Versions() {
  return {{"dbd", DBD_VERSION},
          {"gdal", GDALVersionInfo("RELEASE_NAME")},
          {"proj", ProjVersion()},
          {"ompl", DBD_OMPL_VERSION},
          {"octomap", DBD_OCTOMAP_VERSION},
          {"tbb", DBD_TBB_VERSION}};
}

}  // namespace dbd
