#include "deepest_sinkage.h"

#include <dbd/core/mobility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dbd {
namespace {

/// Which wheel of its track it is, counted from the front.
int PassOf(const VehicleModel& vehicle, const WheelModel& wheel) {
  const double x = vehicle.axles[static_cast<std::size_t>(wheel.axle)].x;
  return 1 + static_cast<int>(std::count_if(vehicle.axles.begin(), vehicle.axles.end(),
                                            [x](const AxleModel& axle) { return axle.x > x; }));
}

/// The first wheel with the tire of wheel `i`, as far as sinkage depends on it beside deflection.
std::size_t FirstLike(const VehicleModel& vehicle, std::size_t i) {
  const auto same = [&tire = vehicle.wheels[i].tire](const WheelModel& wheel) {
    return wheel.tire.width == tire.width && wheel.tire.radius == tire.radius;
  };
  return static_cast<std::size_t>(std::find_if(vehicle.wheels.begin(), vehicle.wheels.end(), same) -
                                  vehicle.wheels.begin());
}

bool AnyPlate(const MaterialTable& table) {
  return std::any_of(table.materials().begin(), table.materials().end(), [](const Material& m) {
    return m.soil.traction_model == TractionModel::kBekker;
  });
}

WheelFooting FootingOf(const TireModel& tire, const WheelView& wheel) {
  return {wheel.cone_index, wheel.load, tire.width, 2 * tire.radius,
          wheel.deflection / tire.section_height};
}

/// N = CI b d / (W (1 - delta/h)^1.5), as the sinkage relations have it, to round-off.
double Numeric(const WheelFooting& w) {
  const double left = 1 - std::min(w.deflection_ratio, 0.9);
  return w.cone_index * w.width * w.diameter / (w.load * left * std::sqrt(left));
}

}  // namespace

DeepestSinkage::DeepestSinkage(const Terrain& terrain, const VehicleModel& vehicle,
                               const SinkageOptions& options, double negligible)
    : terrain_(terrain), vehicle_(vehicle), options_(options), negligible_(negligible) {
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    pass_.push_back(PassOf(vehicle, vehicle.wheels[i]));
    first_like_.push_back(FirstLike(vehicle, i));
  }
  monotonic_ = options.multipass_exponent <= 0 && vehicle.wheels.size() <= kMostWheels &&
               !AnyPlate(terrain.materials().table());
  least_numeric_.fill(std::numeric_limits<double>::infinity());
  most_slipping_.fill(0);
}

double DeepestSinkage::Of(const std::vector<WheelView>& wheels) {
  return monotonic_ ? OfWorst(wheels) : OfAll(wheels);
}

bool DeepestSinkage::IsNegligible(const std::vector<WheelView>& wheels) const {
  if (!monotonic_) return false;
  const Severity now = SeverityOf(wheels);
  for (std::size_t tire = 0; tire < wheels.size(); ++tire) {
    if (now.least[tire] < least_numeric_[tire] || now.most[tire] > most_slipping_[tire]) {
      return false;
    }
  }
  return true;
}

double DeepestSinkage::OfAll(const std::vector<WheelView>& wheels) const {
  double deepest = 0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const WheelView& wheel = wheels[i];
    if (wheel.load <= 0) continue;
    SoilSample soil = terrain_.Soil(wheel.contact_W.x(), wheel.contact_W.y());
    soil.cone_index = wheel.cone_index;
    deepest = std::max(deepest, WheelSinkage(vehicle_.wheels[i].tire, soil, wheel.load,
                                             wheel.deflection, wheel.slip, pass_[i], options_));
  }
  return deepest;
}

DeepestSinkage::Severity DeepestSinkage::SeverityOf(const std::vector<WheelView>& wheels) const {
  Severity s;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    s.numeric[i] = 0, s.slipping[i] = -1;
    s.least[i] = std::numeric_limits<double>::infinity(), s.most[i] = 0;
    if (wheels[i].load <= 0 || wheels[i].cone_index <= 0) continue;
    const double numeric = Numeric(FootingOf(vehicle_.wheels[i].tire, wheels[i]));
    const double squared = numeric * numeric;
    s.numeric[i] = numeric;
    s.slipping[i] = std::abs(wheels[i].slip) / (squared * squared * numeric);
    const std::size_t tire = first_like_[i];
    s.least[tire] = std::min(s.least[tire], numeric);
    s.most[tire] = std::max(s.most[tire], s.slipping[i]);
  }
  return s;
}

/// With one tire, powered sinkage falls with the wheel's numeric N, and sinkage at slip s grows
/// with |s| / N^5. Exponentials and roots are left to the wheels that are worst by these, or so
/// nearly that round-off could decide.
double DeepestSinkage::OfWorst(const std::vector<WheelView>& wheels) {
  constexpr double kNearly = 1e-9;
  const Severity now = SeverityOf(wheels);
  double deepest = 0;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    if (now.slipping[i] < 0) continue;
    const std::size_t tire = first_like_[i];
    const WheelFooting w = FootingOf(vehicle_.wheels[i].tire, wheels[i]);
    if (now.numeric[i] <= now.least[tire] * (1 + kNearly)) {
      deepest = std::max(
          deepest, PoweredSinkage(w.cone_index, w.load, w.width, w.diameter, w.deflection_ratio));
    }
    if (now.slipping[i] >= now.most[tire] * (1 - kNearly)) {
      deepest = std::max(deepest, PoweredSinkageAtSlip(w, wheels[i].slip));
    }
  }
  if (deepest > negligible_) return deepest;
  for (std::size_t tire = 0; tire < wheels.size(); ++tire) {
    least_numeric_[tire] = std::min(least_numeric_[tire], now.least[tire]);
    most_slipping_[tire] = std::max(most_slipping_[tire], now.most[tire]);
  }
  return deepest;
}

}  // namespace dbd
