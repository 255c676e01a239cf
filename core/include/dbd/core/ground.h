#pragma once

#include <dbd/core/bekker.h>
#include <dbd/core/ground_facets.h>
#include <dbd/core/ground_grid.h>
#include <dbd/core/ground_soils.h>

#include <limits>
#include <optional>

namespace dbd {

/// Which relations give traction and motion resistance on a soil.
enum class TractionModel { kBrixius, kWismerLuth, kBekker };

/// What the tire model needs to know of the soil at one place.
struct SoilSample {
  double cone_index = 1.8e6;     ///< mean cone index of the top 0.15 m [Pa]
  double friction_limit = 0.88;  ///< upper bound of the gross traction ratio [-]
  TractionModel traction_model = TractionModel::kBrixius;
  BekkerSoil plate = {};  ///< read by kBekker alone
};

/// The ground as the engine sees it: implemented by the terrain module and by test surfaces.
///
/// Places are x, y in the world frame W (local east-north-up, m). One call answers for a whole
/// wheel, or for the wheels of many vehicles, so that no virtual call is spent per contact point.
/// All functions are const and safe to call from many threads. Every height is finite: outside
/// the known ground an implementation continues its nearest known height, and the caller finds
/// out by asking `IsKnown`.
class Ground {
 public:
  virtual ~Ground() = default;

  /// Ground heights z [m] at `count` places.
  virtual void Heights(int count, const double* x, const double* y, double* z) const = 0;

  /// Soil at `count` places.
  virtual void Soils(int count, const double* x, const double* y, SoilSample* soil) const = 0;

  /// An upper bound of the ground height [m] within `radius` [m] of each of `count` places; may be
  /// generous, never too low. Infinity, the default, means "not known, look at every point".
  virtual void HighestWithin(double radius, int count, const double* x, const double* y,
                             double* z) const {
    (void)radius, (void)x, (void)y;
    for (int i = 0; i < count; ++i) z[i] = std::numeric_limits<double>::infinity();
  }

  /// Whether the height at this place was surveyed (inside the map and not nodata).
  virtual bool IsKnown(double x, double y) const {
    (void)x, (void)y;
    return true;
  }

  /// The heights as a grid, where they are nothing else: packs of vehicles read it themselves.
  /// Nothing, the default, means "ask Heights and HighestWithin".
  virtual std::optional<GroundGrid> Grid() const { return std::nullopt; }

  /// The triangles that the heights come from, where there are any: packs of vehicles read them
  /// themselves, and ask `Heights` off all of them. Nothing, the default, means "ask Heights".
  virtual std::optional<GroundFacets> Facets() const { return std::nullopt; }

  /// The soils, where they are one for all places or one for each class of a raster: packs of
  /// vehicles read them themselves. Nothing, the default, means "ask Soils".
  virtual std::optional<GroundSoils> SoilClasses() const { return std::nullopt; }

  double Height(double x, double y) const {
    double z = 0;
    Heights(1, &x, &y, &z);
    return z;
  }

  SoilSample Soil(double x, double y) const {
    SoilSample soil;
    Soils(1, &x, &y, &soil);
    return soil;
  }
};

}  // namespace dbd
