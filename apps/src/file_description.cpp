#include "file_description.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "json_parts.h"
#include "text.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

std::string OrNone(const std::string& text) { return text.empty() ? "none" : text; }

ordered_json OrNull(const std::string& text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

ordered_json OrNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json(nullptr);
}

std::string ExtentText(const FileExtent& extent) {
  if (extent.empty()) return "not known";
  return Format("%.10g, %.10g, %.10g to %.10g, %.10g, %.10g", extent.low.x(), extent.low.y(),
                extent.low.z(), extent.high.x(), extent.high.y(), extent.high.z());
}

ordered_json ExtentJson(const FileExtent& extent) {
  if (extent.empty()) return nullptr;
  return {{extent.low.x(), extent.low.y(), extent.low.z()},
          {extent.high.x(), extent.high.y(), extent.high.z()}};
}

std::string CellText(const RasterFileInfo& info) {
  if (!info.has_georeference) return "unknown (no georeference)";
  return Format("%.6g x %.6g %s", info.cell_size.x(), info.cell_size.y(), info.unit.c_str());
}

std::string ClassText(const RasterFileInfo& info) {
  std::string text;
  for (const std::int64_t code : info.classes)
    text += Format(" %lld", static_cast<long long>(code));
  return text;
}

std::string ContentText(const RasterFileInfo& info) {
  std::string text = Format("  raster   %d x %d cells, %d band%s, %s\n", info.columns, info.rows,
                            info.bands, info.bands == 1 ? "" : "s", info.data_type.c_str());
  text += Format("  cell     %s\n", CellText(info).c_str());
  text += Format("  system   %s\n", OrNone(info.crs_name).c_str());
  text += info.lowest ? Format("  values   %.6g to %.6g\n", *info.lowest, *info.highest)
                      : "  values   none\n";
  text += Format("  nodata   %s, %.3g %% of the cells\n",
                 info.nodata ? Format("%.6g", *info.nodata).c_str() : "not declared",
                 100 * info.nodata_share);
  if (!info.classes.empty()) text += Format("  classes %s\n", ClassText(info).c_str());
  return text + Format("  to load  %.1f MB of memory as elevation\n",
                       static_cast<double>(info.memory_bytes_to_load) / 1e6);
}

std::string ContentText(const VectorFileInfo& info) {
  std::string text;
  for (const VectorFileInfo::Layer& layer : info.layers) {
    text += Format("  layer    %s: %lld x %s, system %s\n", layer.name.c_str(),
                   static_cast<long long>(layer.features), layer.geometry.c_str(),
                   OrNone(layer.crs_name).c_str());
    text += Format("  extent   %s\n", ExtentText(layer.extent).c_str());
  }
  return text;
}

std::string ContentText(const OctreeFileInfo& info) {
  return Format("  octree   %zu occupied and %zu free leaves, voxels of %.4g m\n",
                info.occupied_leaves, info.free_leaves, info.resolution) +
         Format("  extent   %s\n", ExtentText(info.extent).c_str());
}

std::string ContentText(const MeshFileInfo& info) {
  return Format("  mesh     %zu vertices, %zu triangles\n", info.vertices, info.triangles) +
         Format("  extent   %s\n", ExtentText(info.extent).c_str());
}

std::string ContentText(const PointFileInfo& info) {
  return Format("  points   %zu\n", info.points) +
         Format("  extent   %s\n", ExtentText(info.extent).c_str());
}

ordered_json ContentJson(const RasterFileInfo& info) {
  return {
      {"columns", info.columns},
      {"rows", info.rows},
      {"bands", info.bands},
      {"data_type", info.data_type},
      {"has_georeference", info.has_georeference},
      {"cell_size", {info.cell_size.x(), info.cell_size.y()}},
      {"unit", OrNull(info.unit)},
      {"crs", OrNull(info.crs_name)},
      {"nodata", info.nodata ? ordered_json(Format("%.10g", *info.nodata)) : ordered_json(nullptr)},
      {"lowest", OrNull(info.lowest)},
      {"highest", OrNull(info.highest)},
      {"nodata_share", Rounded(info.nodata_share, 8)},
      {"classes", info.classes},
      {"memory_bytes_to_load", info.memory_bytes_to_load}};
}

ordered_json ContentJson(const VectorFileInfo& info) {
  ordered_json layers = ordered_json::array();
  for (const VectorFileInfo::Layer& layer : info.layers) {
    layers.push_back({{"name", layer.name},
                      {"geometry", layer.geometry},
                      {"features", layer.features},
                      {"extent", ExtentJson(layer.extent)},
                      {"crs", OrNull(layer.crs_name)}});
  }
  return {{"layers", layers}};
}

ordered_json ContentJson(const OctreeFileInfo& info) {
  return {{"resolution", info.resolution},
          {"occupied_leaves", info.occupied_leaves},
          {"free_leaves", info.free_leaves},
          {"extent", ExtentJson(info.extent)}};
}

ordered_json ContentJson(const MeshFileInfo& info) {
  return {{"vertices", info.vertices},
          {"triangles", info.triangles},
          {"extent", ExtentJson(info.extent)}};
}

ordered_json ContentJson(const PointFileInfo& info) {
  return {{"points", info.points}, {"extent", ExtentJson(info.extent)}};
}

}  // namespace

std::string FileInfoText(const FileInfo& info) {
  std::string text = Format("  format   %s\n", info.format.c_str());
  text += std::visit([](const auto& content) { return ContentText(content); }, info.content);
  for (const std::string& warning : info.warnings) {
    text += Format("  warning  %s\n", warning.c_str());
  }
  return text;
}

ordered_json FileInfoJson(const FileInfo& info) {
  ordered_json json = {{"format", info.format}};
  json.update(std::visit([](const auto& content) { return ContentJson(content); }, info.content));
  json["warnings"] = info.warnings;
  return json;
}

}  // namespace dbd
