#include <dbd/core/error.h>
#include <dbd/terrain/local_frame.h>

#include <cmath>
#include <mutex>
#include <utility>

#include "crs_definition.h"
#include "gdal_session.h"

namespace dbd {
namespace {

std::string Coordinates(const Eigen::Vector2d& place) {
  return std::to_string(place.x()) + ", " + std::to_string(place.y());
}

}  // namespace

/// From one coordinate system to another and back, x first. PROJ's objects are not for two threads
/// at once, hence the lock; conversions happen at the ends of a job, never in its loops.
class LocalFrame::Transformation {
 public:
  Transformation(const OGRSpatialReference& from, const OGRSpatialReference& to,
                 std::string to_name)
      : to_name_(std::move(to_name)),
        forward_(OGRCreateCoordinateTransformation(&from, &to)),
        backward_(forward_ ? forward_->GetInverse() : nullptr) {
    if (!forward_ || !backward_) {
      throw InputError("no transformation is known from the terrain's coordinate system to " +
                       to_name_);
    }
  }

  Eigen::Vector2d Forward(const Eigen::Vector2d& place) const {
    return Apply(forward_.get(), place, "map", to_name_);
  }
  Eigen::Vector2d Backward(const Eigen::Vector2d& place) const {
    return Apply(backward_.get(), place, to_name_, "map");
  }

 private:
  Eigen::Vector2d Apply(OGRCoordinateTransformation* transformation, const Eigen::Vector2d& place,
                        const std::string& from, const std::string& to) const {
    const GdalSession gdal;
    const std::scoped_lock lock(mutex_);
    Eigen::Vector2d result = place;
    if (!transformation->Transform(1, &result.x(), &result.y()) || !result.allFinite()) {
      throw InputError("the " + from + " coordinates " + Coordinates(place) +
                       " cannot be converted to " + to +
                       " coordinates: " + gdal.Reason("they lie beyond the coordinate system"));
    }
    return result;
  }

  using Pointer = std::unique_ptr<OGRCoordinateTransformation>;
  std::string to_name_;
  mutable std::mutex mutex_;
  Pointer forward_;
  Pointer backward_;
};

LocalFrame::LocalFrame(std::string map_wkt, const Eigen::Vector2d& origin)
    : map_wkt_(std::move(map_wkt)), origin_(origin) {
  if (map_wkt_.empty()) return;
  const GdalSession gdal;
  const OGRSpatialReference map = ParseCrs(map_wkt_);
  if (!map.IsProjected()) {
    throw InputError("the coordinate system '" + CrsName() + "' is not projected");
  }
  OGRSpatialReference wgs84 = ParseCrs("EPSG:4326");
  wgs84_from_map_ = std::make_shared<const Transformation>(map, wgs84, "WGS84");
}

LocalFrame::~LocalFrame() = default;
LocalFrame::LocalFrame(const LocalFrame&) = default;
LocalFrame::LocalFrame(LocalFrame&&) noexcept = default;
LocalFrame& LocalFrame::operator=(const LocalFrame&) = default;
LocalFrame& LocalFrame::operator=(LocalFrame&&) noexcept = default;

Eigen::Vector2d LocalFrame::ToWgs84(const Eigen::Vector2d& local) const {
  if (!has_crs()) throw InputError("the terrain has no coordinate system, so no WGS84 coordinates");
  return wgs84_from_map_->Forward(ToMap(local));
}

Eigen::Vector2d LocalFrame::FromWgs84(const Eigen::Vector2d& lon_lat) const {
  if (!has_crs()) throw InputError("the terrain has no coordinate system, so no WGS84 coordinates");
  return ToLocal(wgs84_from_map_->Backward(lon_lat));
}

Eigen::Vector2d LocalFrame::FromSource(const Eigen::Vector2d& source) const {
  return ToLocal(source_from_map_ ? source_from_map_->Backward(source) : source);
}

Eigen::Vector2d LocalFrame::ToSource(const Eigen::Vector2d& local) const {
  const Eigen::Vector2d map = ToMap(local);
  return source_from_map_ ? source_from_map_->Forward(map) : map;
}

void LocalFrame::set_source_wkt(std::string wkt) {
  source_wkt_ = std::move(wkt);
  source_from_map_.reset();
  if (source_wkt_.empty() || map_wkt_.empty()) return;
  const GdalSession gdal;
  const OGRSpatialReference map = ParseCrs(map_wkt_);
  const OGRSpatialReference source = ParseCrs(source_wkt_);
  if (source.IsSame(&map)) return;
  source_from_map_ = std::make_shared<const Transformation>(map, source, "file");
}

std::string LocalFrame::CrsName() const { return CrsDefinitionName(map_wkt_); }

}  // namespace dbd
