#include "load_polygons.h"

#include <dbd/core/error.h>
#include <gdal_alg.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "file_extension.h"
#include "gdal_session.h"
#include "load_classes.h"
#include "vector_file.h"

namespace dbd {
namespace {

[[noreturn]] void Fail(const std::string& file, const std::string& what) {
  throw InputError(file + ": " + what);
}

// Polygons in map coordinates and what to burn for each.
struct Shapes {
  std::vector<OGRGeometryUniquePtr> geometries;
  std::vector<double> codes;
};

int FieldIndex(const std::string& file, const std::string& field, OGRLayer* layer) {
  OGRFeatureDefn* attributes = layer->GetLayerDefn();
  if (!field.empty()) {
    const int index = attributes->GetFieldIndex(field.c_str());
    if (index < 0) Fail(file, "its areas have no attribute '" + field + "'");
    return index;
  }
  for (const char* name : {"class", "code", "material", "name"}) {
    const int index = attributes->GetFieldIndex(name);
    if (index >= 0) return index;
  }
  Fail(file, "its areas have no attribute class, code, material or name; say which one to use");
}

// A class number as it stands, or that of the material with this name (case does not count).
int CodeOf(const std::string& file, const std::string& text, const MaterialTable& table) {
  int code = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code);
  if (error == std::errc() && end == text.data() + text.size()) return code;
  for (const Material& material : table.materials()) {
    if (EQUAL(material.name.c_str(), text.c_str())) return material.code;
  }
  Fail(file, "class '" + text + "' is neither a number nor a material of the table '" +
                 table.name() + "'");
}

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

Transformation ToMap(OGRLayer* layer, const std::string& map_wkt) {
  const OGRSpatialReference* from = layer->GetSpatialRef();
  if (from == nullptr || map_wkt.empty()) return nullptr;
  OGRSpatialReference map;
  map.importFromWkt(map_wkt.c_str());
  map.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return Transformation(OGRCreateCoordinateTransformation(from, &map));
}

void CollectShapes(const std::string& file, const std::string& field, const MaterialTable& table,
                   const std::string& map_wkt, OGRLayer* layer, Shapes* shapes) {
  const int attribute = FieldIndex(file, field, layer);
  const Transformation to_map = ToMap(layer, map_wkt);
  for (const auto& feature : layer) {
    OGRGeometryUniquePtr geometry(feature->StealGeometry());
    if (!geometry || geometry->getDimension() != 2) continue;
    if (to_map && geometry->transform(to_map.get()) != OGRERR_NONE) {
      Fail(file, "its coordinates cannot be converted to those of the elevation");
    }
    shapes->codes.push_back(CodeOf(file, feature->GetFieldAsString(attribute), table));
    shapes->geometries.push_back(std::move(geometry));
  }
}

GDALDatasetUniquePtr EmptyClasses(const HeightMap::Grid& grid) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDatasetUniquePtr dataset(driver->Create("", grid.columns, grid.rows, 1, GDT_Int32, nullptr));
  const Eigen::Vector2d corner = grid.first_center - 0.5 * grid.cell_size;
  double transform[6] = {corner.x(), grid.cell_size.x(), 0, corner.y(), 0, grid.cell_size.y()};
  dataset->SetGeoTransform(transform);
  dataset->GetRasterBand(1)->Fill(kNoClass);
  return dataset;
}

}  // namespace

bool IsPolygonFile(const std::string& file) { return IsVectorExtension(LowerExtension(file)); }

std::vector<std::int32_t> LoadPolygons(const std::string& file, const std::string& field,
                                       const MaterialTable& table, const HeightMap::Grid& map_grid,
                                       const std::string& map_wkt) {
  const GDALDatasetUniquePtr source = OpenVector(file);
  const GdalSession gdal;
  Shapes shapes;
  for (OGRLayer* layer : source->GetLayers()) {
    CollectShapes(file, field, table, map_wkt, layer, &shapes);
  }
  if (shapes.geometries.empty()) Fail(file, "holds no areas");
  const GDALDatasetUniquePtr classes = EmptyClasses(map_grid);
  std::vector<OGRGeometryH> handles;
  for (const auto& shape : shapes.geometries) handles.push_back(OGRGeometry::ToHandle(shape.get()));
  int band = 1;
  const CPLErr burnt = GDALRasterizeGeometries(
      GDALDataset::ToHandle(classes.get()), 1, &band, static_cast<int>(handles.size()),
      handles.data(), nullptr, nullptr, shapes.codes.data(), nullptr, nullptr, nullptr);
  std::vector<std::int32_t> result(map_grid.CellCount());
  const CPLErr read = classes->GetRasterBand(1)->RasterIO(
      GF_Read, 0, 0, map_grid.columns, map_grid.rows, result.data(), map_grid.columns,
      map_grid.rows, GDT_Int32, 0, 0, nullptr);
  if (burnt != CE_None || read != CE_None) Fail(file, "cannot be rasterised: " + gdal.Reason(""));
  if (std::all_of(result.begin(), result.end(), [](int code) { return code == kNoClass; })) {
    Fail(file, "has no area anywhere on the elevation raster; do they overlap?");
  }
  return result;
}

}  // namespace dbd
