#include "corners.h"

#include <dbd/core/vehicle_database.h>
#include <gtest/gtest.h>

#include <set>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

int CountIn(const std::vector<CornerElements>& rows) {
  int count = 0;
  for (const CornerElements& row : rows) {
    for (const int element : row.elements) count += element != kNobody;
  }
  return count;
}

int RowOf(const Corners& corners, int body) {
  for (std::size_t row = 0; row < corners.bodies.size(); ++row) {
    for (const int b : corners.bodies[row]) {
      if (b == body) return static_cast<int>(row);
    }
  }
  return -1;
}

TEST(Corners, EachWheelOfACarIsALane) {
  const auto corners = FindCorners(Tm27());
  ASSERT_TRUE(corners);
  ASSERT_EQ(corners->bodies.size(), 2u);  // the chassis, and four carriers side by side
  EXPECT_EQ(corners->bodies[0], (CornerRow{0, 0, 0, 0}));
  EXPECT_EQ(corners->bodies[1], (CornerRow{1, 2, 3, 4}));
  EXPECT_EQ(corners->wheels.size(), 1u);
  EXPECT_EQ(corners->springs.size(), 1u);
  // A trailing arm has four links, a wishbone with its tie rod five: the rear lanes idle in one.
  EXPECT_EQ(corners->links.size(), 5u);
  // Rear wheels have toe and camber joints, front ones toe only, which is steered.
  EXPECT_EQ(corners->joints.size(), 2u);
}

TEST(Corners, EveryElementOfEveryVehicleIsThereOnce) {
  for (const std::string& name : BuiltInVehicleNames()) {
    const auto vehicle = LoadVehicle(name);
    const auto corners = FindCorners(*vehicle);
    ASSERT_TRUE(corners) << name;
    EXPECT_EQ(CountIn(corners->wheels), static_cast<int>(vehicle->wheels.size())) << name;
    EXPECT_EQ(CountIn(corners->links), static_cast<int>(vehicle->links.size())) << name;
    EXPECT_EQ(CountIn(corners->springs), static_cast<int>(vehicle->springs.size())) << name;
    EXPECT_EQ(CountIn(corners->joints), static_cast<int>(vehicle->joints.size())) << name;
    EXPECT_EQ(CountIn(corners->contacts), static_cast<int>(vehicle->contacts.size())) << name;
    std::set<int> seen;
    for (const CornerElements& row : corners->links) {
      for (int lane = 0; lane < kCornerLanes; ++lane) {
        if (row.elements[lane] == kNobody) continue;
        const LinkModel& link = vehicle->links[row.elements[lane]];
        EXPECT_TRUE(seen.insert(row.elements[lane]).second) << name << " " << link.name;
        EXPECT_EQ(row.body_a, RowOf(*corners, link.body_a)) << name << " " << link.name;
        EXPECT_EQ(corners->bodies[row.body_b][lane], link.body_b) << name << " " << link.name;
      }
    }
  }
}

TEST(Corners, BothWheelsOfAnAxleStandInItsLane) {
  const auto vehicle = LoadVehicle("tractor");  // two solid axles, bodies 1 and 2
  const auto corners = FindCorners(*vehicle);
  ASSERT_TRUE(corners);
  EXPECT_EQ(corners->bodies[1], (CornerRow{1, 2, kNobody, kNobody}));
  ASSERT_EQ(corners->wheels.size(), 2u);  // left and right
  for (std::size_t i = 0; i < vehicle->wheels.size(); ++i) {
    const CornerPlace place = corners->wheel_places[i];
    EXPECT_EQ(corners->bodies[1][place.lane], vehicle->wheels[i].body);
    EXPECT_EQ(corners->wheels[place.row].elements[place.lane], static_cast<int>(i));
  }
}

TEST(Corners, ALinkAcrossTwoLanesHasNoPlace) {
  VehicleModel vehicle = Tm27();
  LinkModel anti_roll;
  anti_roll.body_a = 1, anti_roll.body_b = 2;
  vehicle.links.push_back(anti_roll);
  EXPECT_FALSE(FindCorners(vehicle));
}

TEST(Corners, TiresOfDifferentNumbersOfPointsHaveNoPlace) {
  VehicleModel vehicle = Tm27();
  vehicle.wheels[2].tire.points = 40;
  EXPECT_FALSE(FindCorners(vehicle));
}

TEST(Corners, OneLaneHasEverythingInTheVehiclesOrder) {
  const VehicleModel& vehicle = Tm27();
  const Corners rows = OneLane(vehicle);
  ASSERT_EQ(rows.bodies.size(), vehicle.bodies.size());
  ASSERT_EQ(rows.links.size(), vehicle.links.size());
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    EXPECT_EQ(rows.links[i].elements[0], static_cast<int>(i));
    EXPECT_EQ(rows.links[i].body_a, vehicle.links[i].body_a);
    EXPECT_EQ(rows.links[i].body_b, vehicle.links[i].body_b);
    EXPECT_EQ(rows.links[i].wheel, vehicle.links[i].steered_wheel);
  }
  ASSERT_EQ(rows.wheels.size(), vehicle.wheels.size());
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    EXPECT_EQ(rows.wheels[i].body_b, vehicle.wheels[i].body);
    EXPECT_EQ(rows.wheels[i].body_a, vehicle.wheels[i].reaction_body);
  }
}

}  // namespace
}  // namespace dbd
