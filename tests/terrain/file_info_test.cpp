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

struct StatedFile {
  std::string name;
  std::vector<std::pair<std::string, std::string>> facts;
};

// Each line of a table: file, then key=value.
std::vector<StatedFile> ReadTable(const std::string& name) {
  std::ifstream table(std::string(DBD_TEST_DIRECTORY) + "/terrain/" + name);
  std::vector<StatedFile> files;
  for (std::string line; std::getline(table, line);) {
    const std::vector<std::string> parts = Split(line);
    StatedFile file{parts[0], {}};
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const std::size_t equals = parts[i].find('=');
      file.facts.emplace_back(parts[i].substr(0, equals), parts[i].substr(equals + 1));
    }
    files.push_back(std::move(file));
  }
  return files;
}

void ExpectFacts(const StatedFile& stated, const FileInfo& info) {
  Facts facts = std::visit([](const auto& content) { return FactsOf(content); }, info.content);
  for (const auto& [key, value] : stated.facts) {
    if (key == "warning") {
      EXPECT_THAT(info.warnings, testing::Contains(HasSubstr(value)));
    } else {
      EXPECT_TRUE(IsAsStated(value, facts[key]))
          << key << " is " << facts[key] << ", not " << value;
    }
  }
}

// The header of avaKot_resistance.shp states a larger extent than its polygons have; the table
// holds the true one.
TEST(FileInfo, StatesWhatRealFilesHold) {
  if (SharedFile("dem").empty()) GTEST_SKIP() << "no shared data";
  const std::vector<StatedFile> files = ReadTable("real_files.csv");
  EXPECT_GE(files.size(), 70U);
  for (const StatedFile& stated : files) {
    SCOPED_TRACE(stated.name);
    try {
      ExpectFacts(stated, DescribeFile(SharedFile(stated.name)));
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

// Refused in one line that says why, or read to the end with a warning that says what is odd.
void ExpectRefusedOrWarned(const StatedFile& stated) {
  const std::string file = SharedFile(stated.name);
  std::optional<FileInfo> info;
  const std::string message = ErrorOf([&] { info = DescribeFile(file); });
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  if (!info) {
    EXPECT_EQ(message.rfind(file + ": ", 0), 0U) << message;
    ASSERT_EQ(stated.facts.front().first, "error") << message;
    EXPECT_THAT(message, HasSubstr(stated.facts.front().second));
    return;
  }
  EXPECT_FALSE(info->warnings.empty());
  ASSERT_NE(stated.facts.front().first, "error") << "is read";
  ExpectFacts(stated, *info);
}

TEST(FileInfo, RefusesMalformedFilesOrWarnsQuicklyAndSilently) {
  const std::string directory = SharedFile("malformed");
  if (directory.empty()) GTEST_SKIP() << "no shared data";
  testing::internal::CaptureStderr();
  const std::vector<StatedFile> files = ReadTable("malformed_files.csv");
  for (const StatedFile& stated : files) {
    SCOPED_TRACE(stated.name);
    const auto start = std::chrono::steady_clock::now();
    ExpectRefusedOrWarned(stated);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    EXPECT_LT(time.count(), 5);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  std::size_t present = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    present += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(present, files.size()) << "the table lacks files";
}

std::vector<std::string> WarningsOf(const std::string& name, const std::string& text) {
  const TemporaryDirectory directory;
  return DescribeFile(directory.Write(name, text)).warnings;
}

constexpr char kLine[] =
    "<LineString><coordinates>14,46 15,46</coordinates></LineString></Placemark>";

TEST(FileInfo, NamesElementsThatKmlDoesNotHave) {
  const std::string head =
      "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\" "
      "xmlns:gx=\"http://www.google.com/kml/ext/2.2\"><Document><Placemark>";
  const std::string tail = std::string(kLine) + "</Document></kml>";
  EXPECT_THAT(WarningsOf("a.kml", head + "<name>n</name><gx:balloonVisibility/>" + tail),
              testing::IsEmpty());
  EXPECT_THAT(WarningsOf("a.kml", head + "<nickname>n</nickname>" + tail),
              testing::ElementsAre("its <nickname> is no element of KML"));
  EXPECT_THAT(WarningsOf("a.kml", head + "<gx:Track/></Placemark><Placemark>" + tail),
              testing::ElementsAre(HasSubstr("its <gx:Track> is not read")));
}

TEST(FileInfo, NamesGpxExtensionsWithoutNamespace) {
  const std::string head =
      "<gpx version=\"1.1\" creator=\"t\" xmlns=\"http://www.topografix.com/GPX/1/1\" "
      "xmlns:o=\"http://o.org\"><wpt lat=\"46\" lon=\"14\"><extensions>";
  const std::string tail = "</extensions></wpt></gpx>";
  EXPECT_THAT(WarningsOf("a.gpx", head + "<o:a/><b xmlns=\"http://b.org\">c</b>" + tail),
              testing::IsEmpty());
  EXPECT_THAT(WarningsOf("a.gpx", head + "<o:a/><b/><b/>" + tail),
              testing::ElementsAre(HasSubstr("its extension <b> has no namespace")));
}

}  // namespace
}  // namespace dbd
