#include "png_file.h"

#include <cpl_vsi.h>
#include <dbd/core/error.h>
#include <gdal_priv.h>

#include <cstdint>
#include <string>

#include "text.h"

namespace dbd {
namespace {

/// The picture's own memory, seen as a raster of three bands.
GDALDatasetUniquePtr RasterOf(const PixelRows& image) {
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  GDALDatasetUniquePtr raster(memory->Create("", image.width, image.height, 0, GDT_Byte, nullptr));
  const auto* bytes = reinterpret_cast<const char*>(image.pixels);
  for (const int byte : {2, 1, 0}) {  // red, green and blue of a little-endian number
    CPLStringList options;
    options.SetNameValue("DATAPOINTER",
                         std::to_string(reinterpret_cast<std::uintptr_t>(bytes + byte)).c_str());
    options.SetNameValue("PIXELOFFSET", std::to_string(sizeof *image.pixels).c_str());
    options.SetNameValue("LINEOFFSET", std::to_string(sizeof *image.pixels * image.stride).c_str());
    const CPLErr added = raster->AddBand(GDT_Byte, options.List());
    DBD_ASSERT(added == CE_None);
  }
  return raster;
}

/// A file in memory, which goes when this does.
class MemoryFile {
 public:
  explicit MemoryFile(const void* owner)
      : path_("/vsimem/dbd/" + std::to_string(reinterpret_cast<std::uintptr_t>(owner)) + ".png") {}
  ~MemoryFile() { VSIUnlink(path_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }
  std::string Text() const {
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(path_.c_str(), &size, FALSE);
    return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
  }

 private:
  std::string path_;
};

}  // namespace

void WritePng(const std::filesystem::path& file, const PixelRows& image) {
  DBD_ASSERT(image.width > 0 && image.height > 0);
  GDALAllRegister();
  const GDALDatasetUniquePtr raster = RasterOf(image);
  const MemoryFile memory(&raster);
  CPLStringList options;
  options.SetNameValue("ZLEVEL", "1");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("PNG");
  if (driver == nullptr) throw InputError(file.string() + ": this GDAL writes no PNG");
  GDALDatasetUniquePtr png(driver->CreateCopy(memory.path().c_str(), raster.get(), FALSE,
                                              options.List(), nullptr, nullptr));
  DBD_ASSERT(png);
  png.reset();
  WriteTextFile(file, memory.Text());
}

}  // namespace dbd
