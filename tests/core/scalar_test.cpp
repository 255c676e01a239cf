#include "scalar.h"

#include <dbd/core/scenario.h>
#include <gtest/gtest.h>

#include "support/core_engine.h"
#include "support/core_pack2.h"
#include "support/core_vehicle.h"

namespace dbd {
namespace {

TEST(Scalar, FunctionsOfOneNumber) {
  EXPECT_EQ(Select(true, 1.0, 2.0), 1);
  EXPECT_EQ(Min(1.0, 2.0), 1);
  EXPECT_EQ(Max(1.0, 2.0), 2);
  EXPECT_EQ(Clamp(5.0, -1.0, 1.0), 1);
  EXPECT_EQ(Clamp(-5.0, -1.0, 1.0), -1);
  EXPECT_EQ(Clamp(0.5, -1.0, 1.0), 0.5);
  EXPECT_EQ(LeastLane(3.0), 3);
  EXPECT_EQ(LaneTraits<double>::kLanes, 1);
}

Vec3<Pack2> Packed(const Vec3<double>& a, const Vec3<double>& b) {
  return {{a.x, b.x}, {a.y, b.y}, {a.z, b.z}};
}

/// Two vehicles that stand in different places, as one pack.
EngineState<Pack2> Packed(const EngineState<double>& a, const EngineState<double>& b) {
  EngineState<Pack2> pack;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    const BodyState<double>&x = a.bodies[i], &y = b.bodies[i];
    pack.bodies.push_back(
        {Packed(x.p_WB, y.p_WB),
         {{x.q_WB.w, y.q_WB.w}, {x.q_WB.x, y.q_WB.x}, {x.q_WB.y, y.q_WB.y}, {x.q_WB.z, y.q_WB.z}},
         Packed(x.v_WB, y.v_WB),
         Packed(x.h_WB, y.h_WB),
         Packed(x.w_WB, y.w_WB)});
  }
  WheelState<Pack2> wheel{};
  wheel.contact.normal_W.z = Pack2(1);
  pack.wheels.assign(a.wheels.size(), wheel);
  return pack;
}

double Lane(const Pack2& pack, int lane) { return lane == 0 ? pack.a : pack.b; }

void ExpectSame(const EngineState<Pack2>& pack, int lane, const EngineState<double>& alone) {
  const auto expect_vector = [&](const Vec3<Pack2>& p, const Vec3<double>& v) {
    EXPECT_EQ(Lane(p.x, lane), v.x);
    EXPECT_EQ(Lane(p.y, lane), v.y);
    EXPECT_EQ(Lane(p.z, lane), v.z);
  };
  for (std::size_t i = 0; i < alone.bodies.size(); ++i) {
    expect_vector(pack.bodies[i].p_WB, alone.bodies[i].p_WB);
    expect_vector(pack.bodies[i].v_WB, alone.bodies[i].v_WB);
    expect_vector(pack.bodies[i].w_WB, alone.bodies[i].w_WB);
    EXPECT_EQ(Lane(pack.bodies[i].q_WB.w, lane), alone.bodies[i].q_WB.w);
  }
  for (std::size_t i = 0; i < alone.wheels.size(); ++i) {
    EXPECT_EQ(Lane(pack.wheels[i].spin, lane), alone.wheels[i].spin);
    EXPECT_EQ(Lane(pack.wheels[i].slip, lane), alone.wheels[i].slip);
    EXPECT_EQ(Lane(pack.wheels[i].slip_angle, lane), alone.wheels[i].slip_angle);
  }
}

/// Each lane of a pack drives exactly as it would alone: the same engine serves one or many.
TEST(Scalar, LanesOfAPackDriveAsTheyWouldAlone) {
  const auto ground = MakeRandomGround(-10, 0.2, 0.5, 7);
  const VehicleModel& vehicle = Tm27();
  const EngineModel engine(vehicle);
  EngineState<double> alone[2] = {
      InitialState<double>(vehicle, *ground, Eigen::Vector2d(0, 1), 0.2),
      InitialState<double>(vehicle, *ground, Eigen::Vector2d(20, -3), -1.4)};
  EngineState<Pack2> pack = Packed(alone[0], alone[1]);
  Workspace<double> work[2] = {Workspace<double>(vehicle), Workspace<double>(vehicle)};
  Workspace<Pack2> pack_work(vehicle);
  WheelControls<double> controls[2] = {};
  WheelControls<Pack2> pack_controls{};
  for (const int wheel : {0, 1}) {  // the first vehicle drives off, the second brakes
    controls[0].drive_torque[wheel] = 300;
    controls[1].brake_torque[wheel] = 400;
    pack_controls.drive_torque[wheel] = Pack2(300, 0);
    pack_controls.brake_torque[wheel] = Pack2(0, 400);
  }
  controls[0].steer_sine[2] = 0.2;
  pack_controls.steer_sine[2] = Pack2(0.2, 0);

  for (int i = 0; i < 500; ++i) {
    StepEngine(engine, *ground, pack_controls, pack, pack_work);
    for (int lane = 0; lane < 2; ++lane) {
      StepEngine(engine, *ground, controls[lane], alone[lane], work[lane]);
    }
  }
  EXPECT_GT(alone[0].bodies[0].v_WB.x, 0.5);  // something happened
  ExpectSame(pack, 0, alone[0]);
  ExpectSame(pack, 1, alone[1]);
}

}  // namespace
}  // namespace dbd
