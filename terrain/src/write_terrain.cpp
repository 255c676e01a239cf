#include "write_terrain.h"

#include <dbd/core/error.h>
#include <dbd/terrain/material_map.h>
#include <gdal_priv.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "gdal_session.h"
#include "octree_file.h"

namespace dbd {
namespace {

namespace fs = std::filesystem;

constexpr int kEpsg = 32633;                                  // UTM zone 33 north
const Eigen::Vector2d kSouthWestCorner(500000.0, 5200000.0);  // map coordinates [m]
constexpr std::array kSoils = {Soil::kFirm, Soil::kTilled, Soil::kSoft, Soil::kVerySoft};

// New files that replace old ones together, or vanish.
class FileSet {
 public:
  explicit FileSet(const std::string& directory) : directory_(directory) {
    std::error_code error;
    created_directory_ = fs::create_directories(directory_, error);
    if (error || !fs::is_directory(directory_)) {
      throw InputError(directory + ": cannot be created: " +
                       (error ? error.message() : "it is not a directory"));
    }
  }

  ~FileSet() {
    std::error_code ignored;
    for (const fs::path& name : names_) fs::remove(Temporary(name), ignored);
    if (!is_complete_ && created_directory_) fs::remove(directory_, ignored);
  }

  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  // Where to write the file.
  std::string Add(const std::string& name) {
    names_.emplace_back(name);
    return Temporary(name).string();
  }

  void Publish() {
    for (const fs::path& name : names_) {
      std::error_code error;
      fs::rename(Temporary(name), directory_ / name, error);
      if (error) throw InputError((directory_ / name).string() + ": " + error.message());
    }
    is_complete_ = true;
  }

  std::string Final(const std::string& name) const { return (directory_ / name).string(); }

 private:
  fs::path Temporary(const fs::path& name) const { return directory_ / (name.string() + ".part"); }

  fs::path directory_;
  bool created_directory_ = false;
  bool is_complete_ = false;
  std::vector<fs::path> names_;
};

struct Format {
  GDALDataType type;
  const char* predictor;
  double nodata;
};

GDALDatasetUniquePtr CreateGeoTiff(const std::string& file, const HeightMap::Grid& grid,
                                   const Format& format) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const char* options[] = {"COMPRESS=DEFLATE", "TILED=YES", format.predictor, nullptr};
  GDALDatasetUniquePtr dataset(driver->Create(file.c_str(), grid.columns, grid.rows, 1, format.type,
                                              const_cast<char**>(options)));
  if (!dataset) return dataset;
  const double north = kSouthWestCorner.y() + grid.rows * grid.cell_size.y();
  double transform[6] = {kSouthWestCorner.x(), grid.cell_size.x(), 0, north, 0,
                         -grid.cell_size.y()};
  OGRSpatialReference crs;
  crs.importFromEPSG(kEpsg);
  dataset->SetGeoTransform(transform);
  dataset->SetSpatialRef(&crs);
  dataset->GetRasterBand(1)->SetNoDataValue(format.nodata);
  return dataset;
}

// `values`: rows x columns, row 0 south.
template <typename Value>
void WriteRaster(const std::string& file, const HeightMap::Grid& grid, const Format& format,
                 std::vector<Value> values) {
  const GdalSession gdal;
  GDALDatasetUniquePtr dataset = CreateGeoTiff(file, grid, format);
  for (int row = 0; dataset && row < grid.rows; ++row) {
    Value* line = values.data() + static_cast<std::size_t>(grid.rows - 1 - row) * grid.columns;
    const CPLErr written = dataset->GetRasterBand(1)->RasterIO(
        GF_Write, 0, row, grid.columns, 1, line, grid.columns, 1, format.type, 0, 0, nullptr);
    if (written != CE_None) break;
  }
  dataset.reset();  // writes what is still buffered
  if (!gdal.error().empty()) throw InputError(file + ": cannot be written: " + gdal.error());
}

void WriteHeights(const std::string& file, const HeightMap& heights) {
  const HeightMap::Grid& grid = heights.grid();
  std::vector<float> values(grid.CellCount());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      values[static_cast<std::size_t>(row) * grid.columns + column] =
          static_cast<float>(heights.CellHeight(column, row));
    }
  }
  WriteRaster(file, grid, {GDT_Float32, "PREDICTOR=3", -9999.0}, std::move(values));
}

void WriteSoils(const std::string& file, const SyntheticLandscape& landscape,
                const MaterialTable& table) {
  std::array<std::uint8_t, kSoils.size()> code_of;
  for (const Soil soil : kSoils) {
    code_of[static_cast<std::size_t>(soil)] =
        static_cast<std::uint8_t>(table.GetName(SoilName(soil)).code);
  }
  std::vector<std::uint8_t> codes;
  codes.reserve(landscape.soils().size());
  for (const Soil soil : landscape.soils())
    codes.push_back(code_of[static_cast<std::size_t>(soil)]);
  WriteRaster(file, landscape.heights().grid(), {GDT_Byte, "PREDICTOR=1", 0.0}, std::move(codes));
}

void CloseStream(const std::string& file, std::ofstream* stream) {
  stream->close();
  if (!*stream) throw InputError(file + ": cannot be written");
}

void WriteTable(const std::string& file, const MaterialTable& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Soil soil : kSoils) {
    const Material& material = table.GetName(SoilName(soil));
    rows.push_back({{"code", material.code},
                    {"name", material.name},
                    {"cone_index_kpa", material.soil.cone_index / 1e3},
                    {"friction_limit", material.soil.friction_limit},
                    {"cone_index_spread", material.cone_index_spread},
                    {"passable", material.passable},
                    {"source", material.source}});
    if (material.uscs) rows.back()["uscs"] = UscsName(*material.uscs);
  }
  const nlohmann::ordered_json root = {
      {"schema", "dbd.materials/1"}, {"name", "generated"}, {"materials", rows}};
  std::ofstream stream(file);
  stream << std::setw(2) << root << '\n';
  CloseStream(file, &stream);
}

void WriteObstacles(const std::string& file, octomap::OcTree& obstacles) {
  std::ofstream stream(file, std::ios::binary);
  WriteOctree(obstacles, stream);
  CloseStream(file, &stream);
}

}  // namespace

GeneratedTerrain WriteTerrain(const SyntheticLandscape& landscape, octomap::OcTree& obstacles,
                              const std::string& directory) {
  FileSet files(directory);
  const MaterialTable table = MaterialTable::Load("basic");
  WriteHeights(files.Add("dem.tif"), landscape.heights());
  WriteSoils(files.Add("materials.tif"), landscape, table);
  WriteTable(files.Add("materials.json"), table);
  WriteObstacles(files.Add("obstacles.bt"), obstacles);
  files.Publish();
  GeneratedTerrain terrain;
  terrain.elevation = files.Final("dem.tif");
  terrain.materials = files.Final("materials.tif");
  terrain.material_table = files.Final("materials.json");
  terrain.obstacles = files.Final("obstacles.bt");
  terrain.obstacles_origin = kSouthWestCorner;
  return terrain;
}

}  // namespace dbd
