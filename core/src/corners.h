#pragma once

#include <dbd/core/vehicle_model.h>

#include <array>
#include <optional>
#include <vector>

namespace dbd {

// A single vehicle in lanes: every body but the chassis gets a lane, and every force element goes
// into the lane of its body. Elements of one kind that stand in different lanes and join the same
// slots are evaluated together, four at a time; two in the same lane never are, so that each lane
// gathers its own forces. (The colouring of contacts in a graph, in the special case that all
// bodies are joined by way of the chassis.)

inline constexpr int kCornerLanes = 4;
inline constexpr int kNobody = -1;

/// Elements of one kind, one for each lane, kNobody where a lane has none.
using CornerRow = std::array<int, kCornerLanes>;

/// Where something of the vehicle stands: lane of row `row`.
struct CornerPlace {
  int row = 0;
  int lane = 0;
};

/// Elements that are evaluated together. Bodies are numbered as rows of `Corners::bodies`.
struct CornerElements {
  CornerRow elements;
  int body_a = 0;
  int body_b = 0;
  int wheel = kNobody;  ///< row of the wheels that steer them
  int kind = 0;         ///< frictions: their motion; loads: whether they turn with the body
};

/// Rows of a vehicle's bodies, wheels and force elements.
struct Corners {
  // In a translation unit for any processor, as those for wide instructions use them.
  Corners();
  ~Corners();
  Corners(const Corners& other);
  Corners(Corners&& other) noexcept;

  std::vector<CornerRow> bodies;       ///< row 0: the chassis, in every lane
  std::vector<CornerElements> wheels;  ///< body_a: takes the reaction of the drive torque
  std::vector<CornerElements> links;
  std::vector<CornerElements> springs;
  std::vector<CornerElements> joints;
  std::vector<CornerElements> contacts;  ///< body_b only
  std::vector<CornerElements> frictions;
  std::vector<CornerElements> loads;  ///< body_b only

  std::vector<CornerPlace> wheel_places;  ///< like the vehicle's wheels
};

/// Nothing where an element joins two bodies other than the chassis that stand in different lanes,
/// or where tires have different numbers of points.
std::optional<Corners> FindCorners(const VehicleModel& vehicle);

/// Every body, wheel and element in a row of its own, in lane 0: in the order of the vehicle.
Corners OneLane(const VehicleModel& vehicle);

}  // namespace dbd
