#include <benchmark/benchmark.h>
#include <dbd/terrain/terrain.h>
#include <gdal_priv.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

// Time and memory that loading a raster takes.

namespace dbd {
namespace {

// A GeoTIFF of float heights, removed at the end.
class LargeRaster {
 public:
  explicit LargeRaster(int side)
      : file_(std::filesystem::temp_directory_path() /
              ("dbd-benchmark-" + std::to_string(getpid()) + ".tif")) {
    GDALAllRegister();
    GDALDatasetUniquePtr raster(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file_.c_str(), side, side, 1, GDT_Float32, nullptr));
    double transform[] = {500000, 1, 0, 5200000, 0, -1};
    raster->SetGeoTransform(transform);
    OGRSpatialReference crs;
    crs.importFromEPSG(32633);
    raster->SetSpatialRef(&crs);
    std::vector<float> line(static_cast<std::size_t>(side));
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        line[static_cast<std::size_t>(column)] =
            static_cast<float>(std::sin(0.3 * column) + std::cos(0.2 * row));
      }
      if (raster->GetRasterBand(1)->RasterIO(GF_Write, 0, row, side, 1, line.data(), side, 1,
                                             GDT_Float32, 0, 0, nullptr) != CE_None) {
        throw std::runtime_error(file_.string() + ": cannot be written");
      }
    }
  }
  ~LargeRaster() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  LargeRaster(const LargeRaster&) = delete;
  LargeRaster& operator=(const LargeRaster&) = delete;

  std::string file() const { return file_.string(); }

 private:
  std::filesystem::path file_;
};

// Run alone: the peak is that of the process.
void LoadRaster(benchmark::State& state) {
  const LargeRaster raster(static_cast<int>(state.range(0)));
  TerrainFiles files;
  files.elevation = raster.file();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(LoadTerrain(files));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_memory_gb"] = 1024e-9 * static_cast<double>(usage.ru_maxrss);
}
BENCHMARK(LoadRaster)->Arg(1000)->Arg(10000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dbd

BENCHMARK_MAIN();
