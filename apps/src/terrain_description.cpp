#include "terrain_description.h"

#include <dbd/core/units.h>

#include <nlohmann/json.hpp>

#include "file_description.h"
#include "json_parts.h"
#include "text.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

ordered_json PointJson(const Eigen::Vector2d& point) {
  return ordered_json::array({Rounded(point.x(), 3), Rounded(point.y(), 3)});
}

// Perhaps degrees.
ordered_json FilePointJson(const Eigen::Vector2d& point) {
  return ordered_json::array({Rounded(point.x(), 9), Rounded(point.y(), 9)});
}

ordered_json NameJson(const std::string& name) {
  return name.empty() ? ordered_json(nullptr) : ordered_json(name);
}

ordered_json GroundJson(const TerrainInfo& info) {
  const auto degrees = [](double angle) { return Rounded(ToDegrees(angle), 2); };
  return {{"columns", info.columns},
          {"rows", info.rows},
          {"cell_size", PointJson(info.cell_size)},
          {"extent", PointJson(info.extent)},
          {"file_crs", NameJson(info.file_crs_name)},
          {"file_south_west", FilePointJson(info.file_south_west)},
          {"file_north_east", FilePointJson(info.file_north_east)},
          {"map_crs", NameJson(info.crs_name)},
          {"map_min", PointJson(info.map_min)},
          {"map_max", PointJson(info.map_max)},
          {"lowest", Rounded(info.lowest, 3)},
          {"highest", Rounded(info.highest, 3)},
          {"unknown_share", Rounded(info.unknown_share, 6)},
          {"slope_deg",
           {{"median", degrees(info.median_slope)},
            {"90_percent", degrees(info.slope_90_percent)},
            {"99_percent", degrees(info.slope_99_percent)},
            {"steepest", degrees(info.steepest_slope)}}},
          {"memory_bytes", info.memory_bytes}};
}

/// In the file's own coordinates, and in those that dbd drives in where they are others.
std::string CornersText(const TerrainInfo& info) {
  std::string text = "  requests take places in " +
                     (info.file_crs_name.empty() ? "the file's coordinates" : info.file_crs_name) +
                     "\n";
  text += Format("  x        %.10g to %.10g\n", info.file_south_west.x(), info.file_north_east.x());
  text += Format("  y        %.10g to %.10g\n", info.file_south_west.y(), info.file_north_east.y());
  if (info.file_south_west == info.map_min) return text;
  text += "  drives are in " + info.crs_name + "\n";
  text += Format("  x        %.2f to %.2f\n", info.map_min.x(), info.map_max.x());
  return text + Format("  y        %.2f to %.2f\n", info.map_min.y(), info.map_max.y());
}

std::string GroundText(const TerrainInfo& info) {
  std::string text =
      Format("  ground   %d x %d cells of %.4g m x %.4g m (%s x %s)\n", info.columns, info.rows,
             info.cell_size.x(), info.cell_size.y(), FormatLength(info.extent.x()).c_str(),
             FormatLength(info.extent.y()).c_str());
  text += CornersText(info);
  text += Format("  height   %.2f m to %.2f m\n", info.lowest, info.highest);
  text += Format("  slope    median %.1f°, 90 %% below %.1f°, 99 %% below %.1f°, steepest %.1f°\n",
                 ToDegrees(info.median_slope), ToDegrees(info.slope_90_percent),
                 ToDegrees(info.slope_99_percent), ToDegrees(info.steepest_slope));
  text += Format("  unknown  %.3g %% of the cells\n", 100 * info.unknown_share);
  return text + Format("  memory   %.1f MB\n", static_cast<double>(info.memory_bytes) / 1e6);
}

}  // namespace

std::string TerrainInfoText(const DescribedFile& described) {
  return described.name + "\n" + FileInfoText(described.file) +
         (described.ground ? GroundText(*described.ground) : "");
}

std::string TerrainInfoJson(const std::vector<DescribedFile>& files) {
  ordered_json document = {{"schema", "dbd.terrain_info/2"}, {"files", ordered_json::array()}};
  for (const DescribedFile& described : files) {
    ordered_json row = {{"file", described.name}};
    row.update(FileInfoJson(described.file));
    row["ground"] = described.ground ? GroundJson(*described.ground) : ordered_json(nullptr);
    document["files"].push_back(std::move(row));
  }
  return JsonText(document);
}

}  // namespace dbd
