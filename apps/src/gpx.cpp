#include "gpx.h"

#include <dbd/core/error.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

namespace dbd {
namespace {

OGRMultiLineString TrackGeometry(const Rollout& rollout, const LocalFrame& frame) {
  OGRLineString line;
  for (const TraceSample& sample : rollout.trace) {
    const Eigen::Vector2d lon_lat = frame.ToWgs84({sample.x, sample.y});
    line.addPoint(lon_lat.x(), lon_lat.y(), sample.ground_z);
  }
  OGRMultiLineString track;
  track.addGeometry(&line);
  return track;
}

bool AddTrack(GDALDataset* dataset, const std::string& name, const OGRMultiLineString& track) {
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRLayer* layer = dataset->CreateLayer("tracks", &wgs84, wkbMultiLineString25D, nullptr);
  if (!layer) return false;
  OGRFeature feature(layer->GetLayerDefn());
  feature.SetField("name", name.c_str());
  feature.SetGeometry(&track);
  return layer->CreateFeature(&feature) == OGRERR_NONE;
}

}  // namespace

void WriteGpx(const std::filesystem::path& file, const Rollout& rollout, const std::string& name,
              const LocalFrame& frame) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPX");
  if (!driver) throw InputError(file.string() + ": this GDAL cannot write GPX");
  GDALDataset* dataset = driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  const bool written = dataset && AddTrack(dataset, name, TrackGeometry(rollout, frame));
  if (dataset) GDALClose(dataset);
  if (!written) throw InputError(file.string() + ": cannot be written");
}

}  // namespace dbd
