#include "corners.h"

#include <algorithm>

namespace dbd {
namespace {

/// Lanes and rows of the bodies, and what goes wrong on the way.
class CornerFinder {
 public:
  explicit CornerFinder(const VehicleModel& vehicle) : vehicle_(vehicle) {
    CornerRow chassis;
    chassis.fill(0);
    found_.bodies.push_back(chassis);
    for (int body = 1; body < static_cast<int>(vehicle.bodies.size()); ++body) {
      const int lane = (body - 1) % kCornerLanes;
      if (lane == 0) found_.bodies.push_back(Nobody());
      found_.bodies.back()[lane] = body;
    }
  }

  std::optional<Corners> Find() {
    PlaceWheels();
    for (int i = 0; i < Count(vehicle_.links); ++i) {
      const LinkModel& link = vehicle_.links[i];
      Place(i, link.body_a, link.body_b, link.steered_wheel, found_.links);
    }
    for (int i = 0; i < Count(vehicle_.springs); ++i) {
      const SpringModel& spring = vehicle_.springs[i];
      Place(i, spring.body_a, spring.body_b, kNobody, found_.springs);
    }
    for (int i = 0; i < Count(vehicle_.joints); ++i) {
      const AxisJointModel& joint = vehicle_.joints[i];
      Place(i, joint.body_a, joint.body_b, joint.steered_wheel, found_.joints);
    }
    for (int i = 0; i < Count(vehicle_.contacts); ++i) {
      const int body = vehicle_.contacts[i].body;
      Place(i, body, body, kNobody, found_.contacts);
    }
    for (int i = 0; i < Count(vehicle_.frictions); ++i) {
      const FrictionModel& friction = vehicle_.frictions[i];
      Place(i, friction.body_a, friction.body_b, kNobody, found_.frictions,
            static_cast<int>(friction.motion));
    }
    for (int i = 0; i < Count(vehicle_.loads); ++i) {
      const int body = vehicle_.loads[i].body;
      Place(i, body, body, kNobody, found_.loads, vehicle_.loads[i].turns_with_body ? 1 : 0);
    }
    if (!fits_) return std::nullopt;
    return std::move(found_);
  }

 private:
  static CornerRow Nobody() {
    CornerRow row;
    row.fill(kNobody);
    return row;
  }
  template <class Elements>
  static int Count(const Elements& elements) {
    return static_cast<int>(elements.size());
  }

  static int RowOf(int body) { return body == 0 ? 0 : 1 + (body - 1) / kCornerLanes; }
  static int LaneOf(int body) { return body == 0 ? kNobody : (body - 1) % kCornerLanes; }

  void PlaceWheels() {
    for (int i = 0; i < Count(vehicle_.wheels); ++i) {
      const WheelModel& wheel = vehicle_.wheels[i];
      fits_ = fits_ && wheel.body != 0;
      found_.wheel_places.push_back(
          Place(i, wheel.reaction_body, wheel.body, kNobody, found_.wheels));
      fits_ = fits_ && wheel.tire.points == vehicle_.wheels[0].tire.points;
    }
    const auto on_hub = [](const WheelModel& wheel) { return wheel.steers_hub; };
    const bool hubs_steer = std::any_of(vehicle_.wheels.begin(), vehicle_.wheels.end(), on_hub);
    for (int i = 0; hubs_steer && i < Count(vehicle_.wheels); ++i) {
      fits_ = fits_ && (on_hub(vehicle_.wheels[i]) || !Steers(i));
    }
  }

  bool Steers(int wheel) const {
    return vehicle_.axles[vehicle_.wheels[wheel].axle].steer_ratio != 0;
  }

  /// Whether what no wheel steers can stand in a row that wheels do: that of its lane never turns.
  bool StandsStill(int wheel_row, int lane) const {
    const int wheel = found_.wheels[wheel_row].elements[lane];
    return wheel == kNobody || !Steers(wheel);
  }

  bool AllStandStill(const CornerElements& row, int wheel_row) const {
    for (int lane = 0; lane < kCornerLanes; ++lane) {
      if (row.elements[lane] != kNobody && !StandsStill(wheel_row, lane)) return false;
    }
    return true;
  }

  /// Element `index` goes into the lane of its body, in the first row that has room there and joins
  /// the same bodies; what joins the chassis to itself, where there is room.
  CornerPlace Place(int index, int body_a, int body_b, int steered_wheel,
                    std::vector<CornerElements>& rows, int kind = 0) {
    int lane = LaneOf(body_b) == kNobody ? LaneOf(body_a) : LaneOf(body_b);
    if (LaneOf(body_a) != kNobody && LaneOf(body_a) != lane) fits_ = false;
    int wheel = kNobody;
    if (steered_wheel >= 0) {
      const CornerPlace place = found_.wheel_places[steered_wheel];
      wheel = place.row;
      fits_ = fits_ && place.lane == lane;
    }
    const auto takes = [&](const CornerElements& row, int in_lane) {
      return row.elements[in_lane] == kNobody && row.body_a == RowOf(body_a) &&
             row.body_b == RowOf(body_b) && row.kind == kind &&
             (row.wheel == wheel || (wheel == kNobody && StandsStill(row.wheel, in_lane)) ||
              (row.wheel == kNobody && AllStandStill(row, wheel)));
    };
    for (int row = 0; row < Count(rows); ++row) {
      for (int l = 0; l < kCornerLanes; ++l) {
        if ((lane != kNobody && l != lane) || !takes(rows[row], l)) continue;
        rows[row].elements[l] = index;
        rows[row].wheel = std::max(rows[row].wheel, wheel);
        return {row, l};
      }
    }
    if (lane == kNobody) lane = 0;
    rows.push_back({Nobody(), RowOf(body_a), RowOf(body_b), wheel, kind});
    rows.back().elements[lane] = index;
    return {Count(rows) - 1, lane};
  }

  const VehicleModel& vehicle_;
  Corners found_;
  bool fits_ = true;
};

}  // namespace

Corners::Corners() = default;
Corners::~Corners() = default;
Corners::Corners(const Corners& other) = default;
Corners::Corners(Corners&& other) noexcept = default;

std::optional<Corners> FindCorners(const VehicleModel& vehicle) {
  return CornerFinder(vehicle).Find();
}

Corners OneLane(const VehicleModel& vehicle) {
  Corners rows;
  const auto row_of = [](int element) { return CornerRow{element, kNobody, kNobody, kNobody}; };
  const auto add = [&](auto& all, int a, int b, int wheel = kNobody, int kind = 0) {
    all.push_back({row_of(static_cast<int>(all.size())), a, b, wheel, kind});
  };
  for (int i = 0; i < static_cast<int>(vehicle.bodies.size()); ++i) {
    rows.bodies.push_back(row_of(i));
  }
  for (const WheelModel& w : vehicle.wheels) add(rows.wheels, w.reaction_body, w.body);
  for (const LinkModel& e : vehicle.links) add(rows.links, e.body_a, e.body_b, e.steered_wheel);
  for (const SpringModel& e : vehicle.springs) add(rows.springs, e.body_a, e.body_b);
  for (const AxisJointModel& e : vehicle.joints) {
    add(rows.joints, e.body_a, e.body_b, e.steered_wheel);
  }
  for (const ContactModel& e : vehicle.contacts) add(rows.contacts, e.body, e.body);
  for (const FrictionModel& e : vehicle.frictions) {
    add(rows.frictions, e.body_a, e.body_b, kNobody, static_cast<int>(e.motion));
  }
  for (const AppliedLoadModel& e : vehicle.loads) {
    add(rows.loads, e.body, e.body, kNobody, e.turns_with_body ? 1 : 0);
  }
  return rows;
}

}  // namespace dbd
