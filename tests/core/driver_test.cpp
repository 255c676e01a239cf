#include <dbd/core/driver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

using Points = std::vector<Eigen::Vector2d>;

Points Arc(double radius, double angle) {
  Points points;
  for (double a = 0; a <= angle; a += 0.01) {
    points.emplace_back(radius * std::sin(a), radius * (1 - std::cos(a)));
  }
  return points;
}

Points StraightThenArc(double radius) {
  Points points{{0, 0}};
  for (const Eigen::Vector2d& p : Arc(radius, 1.5)) points.emplace_back(40 + p.x(), p.y());
  return points;
}

TEST(Ackermann, AllWheelNormalsMeetInOnePoint) {
  for (const double steer : {-0.5, -0.1, 0.05, 0.3, 0.55}) {
    const std::vector<double> angles = AckermannAngles(Tm27(), steer);
    const double centre_y = 2.032 / std::tan(steer);  // on the rear axle's line
    for (const AxleModel& axle : Tm27().axles) {
      for (const bool left : {true, false}) {
        const int wheel = left ? axle.left : axle.right;
        const Eigen::Vector2d place(axle.x, (left ? 0.5 : -0.5) * axle.track);
        const double a = angles[static_cast<std::size_t>(wheel)];
        const Eigen::Vector2d rolling(std::cos(a), std::sin(a));
        const Eigen::Vector2d to_centre = Eigen::Vector2d(0, centre_y) - place;
        EXPECT_NEAR(rolling.dot(to_centre) / to_centre.norm(), 0, 1e-12) << steer;
      }
    }
  }
}

TEST(Ackermann, AnglesByHand) {
  // Mean 0.3 rad: turning centre 2.032 / 0.309336 = 6.56890 m to the left; inner wheel
  // atan(2.032 / 5.81490) = 0.336182, outer atan(2.032 / 7.32290) = 0.270674.
  const std::vector<double> angles = AckermannAngles(Tm27(), 0.3);
  EXPECT_NEAR(angles[2], 0.336182, 2e-5);
  EXPECT_NEAR(angles[3], 0.270674, 2e-5);
  EXPECT_EQ(angles[0], 0);
  EXPECT_EQ(angles[1], 0);
}

TEST(Ackermann, LeftAndRightMirror) {
  const auto left = AckermannAngles(Tm27(), 0.2), right = AckermannAngles(Tm27(), -0.2);
  EXPECT_NEAR(left[2], -right[3], 1e-15);
  EXPECT_NEAR(left[3], -right[2], 1e-15);
  for (const double angle : AckermannAngles(Tm27(), 0)) EXPECT_EQ(angle, 0);
}

/// A point that moves exactly as the kinematic model of the rear axle's middle.
double FarthestFromCircle(double radius, double speed) {
  const Path path(Arc(radius, 12));
  const Driver driver(Tm27(), path, {.target_speed = speed, .stop_at_end = false});
  DriverState state;
  DriverView view{{0, 0}, 0, speed};
  const Eigen::Vector2d centre(0, radius);
  double worst = 0;
  const double dt = 4e-3;
  while (state.arc_length < 8 * radius) {
    const DriverCommand command = driver.Update(view, dt, state);
    view.heading += dt * speed * std::tan(command.steer) / Tm27().wheelbase();
    view.position += dt * speed * Eigen::Vector2d(std::cos(view.heading), std::sin(view.heading));
    worst = std::max(worst, std::abs((view.position - centre).norm() - radius));
  }
  return worst;
}

TEST(Driver, PurePursuitHoldsACircle) {
  EXPECT_LT(FarthestFromCircle(20, 3), 0.02);
  EXPECT_LT(FarthestFromCircle(20, 5), 0.05);
  EXPECT_LT(FarthestFromCircle(8, 2), 0.05);
}

TEST(Driver, SteersTowardsThePathAndWithinTheLimit) {
  const Driver driver(Tm27(), Path(Points{{0, 0}, {100, 0}}), {});
  DriverState state;
  EXPECT_LT(driver.Update({{5, 1}, 0, 3}, 4e-3, state).steer, 0);
  state = {};
  EXPECT_GT(driver.Update({{5, -1}, 0, 3}, 4e-3, state).steer, 0);
  state = {};
  EXPECT_EQ(driver.Update({{5, 0}, 0, 3}, 4e-3, state).steer, 0);
  state = {};
  const double most = Tm27().axles[1].max_steer;
  EXPECT_LE(std::abs(driver.Update({{5, 3}, 2.5, 0}, 4e-3, state).steer), most);
}

TEST(Driver, SlowsDownBeforeACurve) {
  const Driver driver(Tm27(), Path(StraightThenArc(10)), {.target_speed = 12});
  const double in_curve = driver.SpeedLimit(46);
  EXPECT_NEAR(in_curve, std::sqrt(2.0 * 10), 0.3);  // 2 m/s^2 of lateral acceleration
  EXPECT_NEAR(driver.SpeedLimit(0), 12, 0.35);      // sqrt(20 + 2 * 1.5 * 38.5) = 11.6 or more
  for (double s = 0; s + 0.5 < 40; s += 0.5) {      // no harder braking than planned, v dv <= a ds
    const double a = driver.SpeedLimit(s), b = driver.SpeedLimit(s + 0.5);
    EXPECT_LE((a * a - b * b) / (2 * 0.5), 1.5 + 1e-9) << s;
  }
}

TEST(Driver, KeepsTheSpeedsThatTheGroundAllows) {
  DriverOptions options{.target_speed = 8};
  options.speed_limits.assign(201, 100.0);
  for (std::size_t i = 100; i < 120; ++i) options.speed_limits[i] = 3;  // 50 m to 60 m
  const Driver driver(Tm27(), Path(Points{{0, 0}, {100, 0}}), options);
  EXPECT_NEAR(driver.SpeedLimit(55), 3, 1e-12);
  EXPECT_NEAR(driver.SpeedLimit(48), std::sqrt(9 + 2 * 1.5 * 2), 1e-9);
  EXPECT_NEAR(driver.SpeedLimit(10), 8, 1e-12);
  EXPECT_NEAR(driver.SpeedLimit(70), 8, 1e-12);
}

TEST(Driver, NeverAsksForMoreThanTheVehiclesSpeedLimit) {
  const Driver driver(Tm27(), Path(Points{{0, 0}, {1000, 0}}), {.target_speed = 100});
  EXPECT_EQ(driver.SpeedLimit(0), 18);
}

TEST(Driver, StopsAtTheEnd) {
  const Driver driver(Tm27(), Path(Points{{0, 0}, {50, 0}}), {.target_speed = 5});
  DriverState state{.arc_length = 45};
  DriverCommand command = driver.Update({{46, 0}, 0, 5}, 4e-3, state);
  // 4 m before the end: sqrt(2 * 1.5 * 4) = 3.46 m/s at most, so it brakes.
  EXPECT_LE(state.target_speed, 3.4642);
  EXPECT_GT(command.brake, 0);
  EXPECT_FALSE(state.arrived);
  state.arc_length = 49;
  command = driver.Update({{49.95, 0}, 0, 0.5}, 4e-3, state);
  EXPECT_EQ(command.brake, 1);
  EXPECT_FALSE(state.arrived);
  driver.Update({{49.97, 0}, 0, 0.01}, 4e-3, state);
  EXPECT_TRUE(state.arrived);
}

TEST(Driver, StandsWhenARockingVehiclesSpeedPassesZeroBetweenTwoDecisions) {
  const Driver driver(Tm27(), Path(Points{{0, 0}, {50, 0}}), {.target_speed = 5});
  DriverState state{.arc_length = 49.5};
  driver.Update({{49.95, 0}, 0, 0.4}, 0.04, state);
  EXPECT_FALSE(state.arrived);
  driver.Update({{49.96, 0}, 0, 0.2}, 0.04, state);
  EXPECT_FALSE(state.arrived);
  driver.Update({{49.96, 0}, 0, -0.3}, 0.04, state);
  EXPECT_TRUE(state.arrived);
}

TEST(Driver, WithoutAPathItGoesStraightAheadForever) {
  Driver driver(Tm27(), Path(), {.target_speed = 5});
  driver.SetStart({3, 4}, std::numbers::pi / 2);
  DriverState state;
  const DriverCommand command = driver.Update({{3, 1000}, std::numbers::pi / 2, 5}, 4e-3, state);
  EXPECT_NEAR(command.steer, 0, 1e-9);
  EXPECT_EQ(state.target_speed, 5);
}

TEST(Driver, ThrottleIntegratesAwayASteadyError) {
  Driver driver(Tm27(), Path(), {.target_speed = 5});
  driver.SetStart({0, 0}, 0);
  DriverState state;
  const double first = driver.Update({{0, 0}, 0, 4.8}, 4e-3, state).engine_torque;
  // 750 kg on 0.32443 m driven through 3 * 6.429: 12.616 N m of the engine for 1 m/s^2, so 60.05 N
  // m per m/s and 30.03 N m per m.
  EXPECT_NEAR(first, 60.05 * 0.2 + 30.03 * 0.2 * 4e-3, 2e-3);
  double last = first;
  for (int i = 0; i < 100; ++i) last = driver.Update({{0, 0}, 0, 4.8}, 4e-3, state).engine_torque;
  EXPECT_NEAR(last, 60.05 * 0.2 + 30.03 * 0.2 * 4e-3 * 101, 2e-3);
}

/// Moves exactly as the kinematic model says, with the speed that the driver aims for as soon as
/// 2 m/s^2 allow.
class KinematicVehicle {
 public:
  explicit KinematicVehicle(const Path& path) : path_(path), driver_(Tm27(), path, {}) {}

  void Drive(double seconds) {
    constexpr double kDt = 4e-3;
    for (double time = 0; time < seconds && !state.arrived; time += kDt) {
      const DriverCommand command = driver_.Update(view, kDt, state);
      const double wanted = (command.reverse ? -1 : 1) * state.target_speed;
      view.speed += std::clamp(wanted - view.speed, -2 * kDt, 2 * kDt);
      view.heading += kDt * view.speed * std::tan(command.steer) / Tm27().wheelbase();
      view.position +=
          kDt * view.speed * Eigen::Vector2d(std::cos(view.heading), std::sin(view.heading));
      fastest_back = std::min(fastest_back, view.speed);
      const double s = path_.NearestArcLength(view.position, 0, path_.length());
      farthest_off = std::max(farthest_off, (path_.Position(s) - view.position).norm());
    }
  }

  DriverView view;
  DriverState state;
  double fastest_back = 0;
  double farthest_off = 0;

 private:
  const Path& path_;
  Driver driver_;
};

TEST(Driver, TurnsRoundInThreeStretches) {
  // Arcs of 60 degrees with radius 6 m: left forward, on in reverse, left forward.
  Points points;
  std::vector<bool> reverse;
  Eigen::Vector2d place(0, 0);
  double heading = 0;
  for (int stretch = 0; stretch < 3; ++stretch) {
    const double way = stretch == 1 ? -0.1 : 0.1;
    for (int i = 0; i < 63; ++i) {
      points.push_back(place);
      reverse.push_back(stretch == 1);
      heading += 0.1 / 6;
      place += way * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    }
  }
  // Each point belongs to the stretch that leads to it.
  reverse.insert(reverse.begin(), false);
  reverse.pop_back();
  const Path path(points, reverse);
  ASSERT_EQ(path.stretches().size(), 3u);
  KinematicVehicle vehicle(path);
  vehicle.Drive(60);
  EXPECT_TRUE(vehicle.state.arrived);
  EXPECT_EQ(vehicle.state.stretch, 2u);
  EXPECT_NEAR(vehicle.view.heading, std::numbers::pi, 0.15);
  EXPECT_LT((vehicle.view.position - points.back()).norm(), 0.25);
  EXPECT_LT(vehicle.farthest_off, 0.2);
  EXPECT_LT(vehicle.fastest_back, -1.0);
  EXPECT_GE(vehicle.fastest_back, -kReverseSpeed);
}

TEST(Driver, BacksAlongACircleAsItDrivesAlongIt) {
  Points points = Arc(10, 2);
  for (Eigen::Vector2d& p : points) p.x() = -p.x();  // to the rear, still curving to the left
  const Path path(points, std::vector<bool>(points.size(), true));
  EXPECT_NEAR(path.VehicleHeading(0), 0, 0.01);
  KinematicVehicle vehicle(path);
  vehicle.Drive(60);
  EXPECT_TRUE(vehicle.state.arrived);
  EXPECT_NEAR(vehicle.view.heading, -2, 0.1);
  EXPECT_LT(vehicle.farthest_off, 0.1);  // of which the turn-in
}

TEST(Driver, StandsBeforeItChangesDirection) {
  const Path path(Points{{0, 0}, {10, 0}, {4, 0}}, {false, false, true});
  const Driver driver(Tm27(), path, {});
  DriverState state{.arc_length = 9.95};
  DriverCommand command = driver.Update({{9.96, 0}, 0, 0.4}, 4e-3, state);
  EXPECT_EQ(command.brake, 1);
  EXPECT_FALSE(command.reverse);
  EXPECT_FALSE(state.arrived);
  driver.Update({{9.97, 0}, 0, 0.01}, 4e-3, state);  // asks for nothing yet
  EXPECT_FALSE(state.arrived);
  command = driver.Update({{9.97, 0}, 0, 0.01}, 4e-3, state);
  EXPECT_TRUE(command.reverse);
  EXPECT_GT(command.engine_torque, 0);
  EXPECT_EQ(command.brake, 0);
}

}  // namespace
}  // namespace dbd
