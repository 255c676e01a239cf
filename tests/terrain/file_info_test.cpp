#include <dbd/terrain/file_info.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <sstream>

#include "support/terrain_files.h"

namespace dbd {
namespace {

using testing::HasSubstr;
using Facts = std::map<std::string, std::string>;

template <typename Value>
std::string Text(const Value& value) {
  std::ostringstream text;
  text.precision(12);
  text << value;
  return text.str();
}

std::string Text(const std::optional<double>& value) { return value ? Text(*value) : "none"; }

void AddExtent(const std::string& prefix, const FileExtent& extent, Facts* facts) {
  if (extent.empty()) return;
  const char* const axes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    (*facts)[prefix + "min_" + axes[i]] = Text(extent.low[i]);
    (*facts)[prefix + "max_" + axes[i]] = Text(extent.high[i]);
  }
}

Facts FactsOf(const RasterFileInfo& info) {
  return {{"columns", Text(info.columns)},
          {"rows", Text(info.rows)},
          {"bands", Text(info.bands)},
          {"type", info.data_type},
          {"georeference", info.has_georeference ? "yes" : "no"},
          {"cell_x", Text(info.cell_size.x())},
          {"cell_y", Text(info.cell_size.y())},
          {"unit", info.unit},
          {"crs", info.crs_name.empty() ? "none" : info.crs_name},
          {"nodata", Text(info.nodata)},
          {"lowest", Text(info.lowest)},
          {"highest", Text(info.highest)},
          {"nodata_share", Text(info.nodata_share)}};
}

Facts FactsOf(const VectorFileInfo& info) {
  Facts facts;
  for (const VectorFileInfo::Layer& layer : info.layers) {
    facts[layer.name + ".features"] = Text(layer.features);
    AddExtent(layer.name + ".", layer.extent, &facts);
  }
  return facts;
}

Facts FactsOf(const OctreeFileInfo& info) {
  Facts facts = {{"resolution", Text(info.resolution)},
                 {"occupied", Text(info.occupied_leaves)},
                 {"free", Text(info.free_leaves)}};
  AddExtent("", info.extent, &facts);
  return facts;
}

Facts FactsOf(const MeshFileInfo& info) {
  Facts facts = {{"vertices", Text(info.vertices)}, {"triangles", Text(info.triangles)}};
  AddExtent("", info.extent, &facts);
  return facts;
}

Facts FactsOf(const PointFileInfo& info) { return {{"points", Text(info.points)}}; }

// As exact as the table: six significant digits, extents of octrees to 0.1.
bool IsAsStated(const std::string& stated, const std::string& found) {
  std::istringstream stated_stream(stated);
  std::istringstream found_stream(found);
  double a = 0;
  double b = 0;
  if (!(stated_stream >> a) || !(found_stream >> b)) {
    return found.find(stated) != std::string::npos;
  }
  const std::size_t point = stated.find('.');
  const double last_digit = point == std::string::npos
                                ? 0
                                : std::pow(10.0, -static_cast<double>(stated.size() - point - 1));
  return std::abs(a - b) <= std::max(0.51 * last_digit, 5.1e-6 * std::abs(a));
}

std::vector<std::string> Split(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

// Each line of the table: file, then key=value. The header of avaKot_resistance.shp states a larger
// extent than its polygons have; the table holds the true one.
TEST(FileInfo, StatesWhatRealFilesHold) {
  if (SharedFile("dem").empty()) GTEST_SKIP() << "no shared data";
  std::ifstream table(std::string(DBD_TEST_DIRECTORY) + "/terrain/real_files.csv");
  int files = 0;
  for (std::string line; std::getline(table, line); ++files) {
    const std::vector<std::string> parts = Split(line);
    SCOPED_TRACE(parts[0]);
    Facts facts;
    try {
      const FileInfo info = DescribeFile(SharedFile(parts[0]));
      facts = std::visit([](const auto& content) { return FactsOf(content); }, info.content);
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const std::size_t equals = parts[i].find('=');
      const std::string key = parts[i].substr(0, equals);
      const std::string stated = parts[i].substr(equals + 1);
      EXPECT_TRUE(IsAsStated(stated, facts[key]))
          << key << " is " << facts[key] << ", not " << stated;
    }
  }
  EXPECT_GE(files, 70);
}

TEST(FileInfo, RefusesOrReadsMalformedFilesQuicklyAndSilently) {
  const std::string directory = SharedFile("malformed");
  if (directory.empty()) GTEST_SKIP() << "no shared data";
  testing::internal::CaptureStderr();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    if (!entry.is_regular_file()) continue;
    const std::string file = entry.path().string();
    const auto start = std::chrono::steady_clock::now();
    const std::string message = ErrorOf([&] { DescribeFile(file); });
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    EXPECT_LT(time.count(), 5) << file;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_TRUE(message.empty() || message.rfind(file + ": ", 0) == 0) << message;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace dbd
