#include "route_formats.h"

#include <dbd/core/error.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <functional>

namespace dbd {
namespace {

OGRPoint PointOf(const TraceSample& sample, const LocalFrame& frame) {
  const Eigen::Vector2d lon_lat = frame.ToWgs84({sample.x, sample.y});
  return {lon_lat.x(), lon_lat.y(), sample.ground_z, sample.t};
}

OGRLineString LineOf(const Rollout& rollout, const LocalFrame& frame) {
  OGRLineString line;
  for (const TraceSample& sample : rollout.trace) {
    const OGRPoint point = PointOf(sample, frame);
    line.addPoint(&point);
  }
  return line;
}

void SetTime(double seconds, OGRFeature* feature) {
  constexpr int kUtc = 100;  // OGR's flag
  const int whole = static_cast<int>(seconds);
  const int minutes = whole / 60;
  const int hours = minutes / 60;
  const auto rest = static_cast<float>(whole % 60 + (seconds - whole));
  feature->SetField(feature->GetFieldIndex("time"), 2000, 1, 1 + hours / 24, hours % 24,
                    minutes % 60, rest, kUtc);
}

OGRLayer* AddLayer(GDALDataset* dataset, const char* name, OGRwkbGeometryType type) {
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return dataset->CreateLayer(name, &wgs84, type, nullptr);
}

bool AddField(OGRLayer* layer, const char* name, OGRFieldType type) {
  OGRFieldDefn field(name, type);
  return layer->CreateField(&field) == OGRERR_NONE;
}

bool AddLine(GDALDataset* dataset, const Rollout& rollout, const std::string& name,
             const LocalFrame& frame, OGRwkbGeometryType type) {
  OGRLayer* layer = AddLayer(dataset, "route", type);
  if (!layer || !AddField(layer, "name", OFTString) || !AddField(layer, "duration_s", OFTReal)) {
    return false;
  }
  OGRLineString line = LineOf(rollout, frame);
  line.setMeasured(wkbHasM(type));
  OGRFeature feature(layer->GetLayerDefn());
  feature.SetField("name", name.c_str());
  feature.SetField("duration_s", rollout.time);
  feature.SetGeometry(&line);
  return layer->CreateFeature(&feature) == OGRERR_NONE;
}

// Fills and adds one feature for each sample.
bool AddPoints(OGRLayer* layer, const Rollout& rollout, const LocalFrame& frame,
               const std::function<void(const TraceSample&, OGRFeature*)>& fill) {
  for (const TraceSample& sample : rollout.trace) {
    OGRPoint point = PointOf(sample, frame);
    point.setMeasured(FALSE);
    OGRFeature feature(layer->GetLayerDefn());
    SetTime(sample.t, &feature);
    fill(sample, &feature);
    feature.SetGeometry(&point);
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
  }
  return true;
}

void Write(const char* format, const std::filesystem::path& file,
           const std::function<bool(GDALDataset*)>& fill) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(format);
  if (!driver) throw InputError(file.string() + ": this GDAL cannot write " + format);
  // So that one plan gives the same file today and tomorrow.
  CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00Z");
  GDALDataset* dataset = driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  // In a database each feature would be a transaction of its own.
  const bool is_database = dataset && dataset->TestCapability(ODsCTransactions);
  const bool begun = dataset && (!is_database || dataset->StartTransaction() == OGRERR_NONE);
  const bool filled = begun && fill(dataset);
  const bool written = filled && (!is_database || dataset->CommitTransaction() == OGRERR_NONE);
  if (dataset) GDALClose(dataset);
  CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr);
  if (!written) throw InputError(file.string() + ": cannot be written");
}

}  // namespace

void WriteGpx(const std::filesystem::path& file, const Rollout& rollout, const std::string& name,
              const LocalFrame& frame) {
  Write("GPX", file, [&](GDALDataset* dataset) {
    OGRLayer* layer = AddLayer(dataset, "track_points", wkbPoint25D);
    return layer &&
           AddPoints(layer, rollout, frame, [&](const TraceSample& sample, OGRFeature* feature) {
             feature->SetField("ele", sample.ground_z);
             feature->SetField("track_fid", 0);
             feature->SetField("track_seg_id", 0);
             feature->SetField("track_name", name.c_str());
           });
  });
}

void WriteKml(const std::filesystem::path& file, const Rollout& rollout, const std::string& name,
              const LocalFrame& frame) {
  Write("KML", file, [&](GDALDataset* dataset) {
    return AddLine(dataset, rollout, name, frame, wkbLineString25D);
  });
}

void WriteGeoPackage(const std::filesystem::path& file, const Rollout& rollout,
                     const std::string& name, const LocalFrame& frame) {
  Write("GPKG", file, [&](GDALDataset* dataset) {
    if (!AddLine(dataset, rollout, name, frame, wkbLineStringZM)) return false;
    OGRLayer* layer = AddLayer(dataset, "points", wkbPoint25D);
    return layer && AddField(layer, "time", OFTDateTime) && AddField(layer, "speed_mps", OFTReal) &&
           AddPoints(layer, rollout, frame, [](const TraceSample& sample, OGRFeature* feature) {
             feature->SetField("speed_mps", sample.speed);
           });
  });
}

}  // namespace dbd
