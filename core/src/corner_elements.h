#pragma once

#include <algorithm>
#include <functional>

#include "body_motion.h"
#include "corner_model.h"
#include "elements.h"

namespace dbd {

// The numbers of a vehicle's bodies and force elements, brought into lanes.

/// The elements of one row; where a lane has none, `idle`. `Real` makes each of these templates a
/// function of its translation unit's instruction set alone.
template <class Real, class Element>
using CornerFour = std::array<const Element*, LaneTraits<Real>::kLanes>;

template <class Real, class Element>
CornerFour<Real, Element> Pick(const CornerRow& row, const std::vector<Element>& elements,
                               const Element& idle) {
  CornerFour<Real, Element> four;
  for (int lane = 0; lane < LaneTraits<Real>::kLanes; ++lane) {
    four[lane] = row[lane] == kNobody ? &idle : &elements[row[lane]];
  }
  return four;
}

template <class Real, class Four, class Field>
Real InLanes(const Four& four, const Field& field) {
  Real pack;
  for (int lane = 0; lane < LaneTraits<Real>::kLanes; ++lane) {
    SetNumber(pack, lane, std::invoke(field, *four[lane]));
  }
  return pack;
}

template <class Real, class Four, class Field>
Vec3<Real> VectorsInLanes(const Four& four, const Field& field) {
  Vec3<Real> packs;
  for (int lane = 0; lane < LaneTraits<Real>::kLanes; ++lane) {
    const Eigen::Vector3d& v = std::invoke(field, *four[lane]);
    SetNumber(packs.x, lane, v.x());
    SetNumber(packs.y, lane, v.y());
    SetNumber(packs.z, lane, v.z());
  }
  return packs;
}

/// Far enough above its body that nothing there touches the ground.
inline constexpr double kOutOfReach = 10;  // [m]

template <class Real>
CornerBody<Real> MakeCornerBody(const CornerRow& row, const VehicleModel& vehicle) {
  BodyModel idle;
  idle.mass = 1;
  const auto four = Pick<Real>(row, vehicle.bodies, idle);
  CornerBody<Real> body{InLanes<Real>(four, &BodyModel::mass),
                        {VectorsInLanes<Real>(four, &BodyModel::inertia), true}};
  for (const BodyModel* b : four) {
    body.inertia.spherical = body.inertia.spherical && IsSpherical(b->inertia);
  }
  return body;
}

template <class Real>
CornerLink<Real> MakeCornerLink(const CornerElements& row, const VehicleModel& vehicle) {
  LinkModel idle;
  idle.p_B.z() = kOutOfReach;
  const auto four = Pick<Real>(row.elements, vehicle.links, idle);
  return {row.body_a,
          row.body_b,
          row.wheel,
          VectorsInLanes<Real>(four, &LinkModel::p_A),
          VectorsInLanes<Real>(four, &LinkModel::p_B),
          InLanes<Real>(four, &LinkModel::stiffness),
          InLanes<Real>(four, &LinkModel::damping),
          InLanes<Real>(four, &LinkModel::free_length),
          InLanes<Real>(four, &LinkModel::steer_linear),
          InLanes<Real>(four, &LinkModel::steer_quadratic)};
}

/// Lanes without a curve get a straight one, where others have one.
template <class Real, class Four>
CornerCurve<Real> MakeCornerCurve(const Four& four, CurveModel SpringModel::*field,
                                  double SpringModel::*slope) {
  CornerCurve<Real> curve{};
  std::size_t hinges = 0;
  for (const SpringModel* spring : four) {
    curve.is_given = curve.is_given || (spring->*field).given();
    hinges = std::max(hinges, (spring->*field).hinges.size());
  }
  if (!curve.is_given) return curve;
  curve.hinges.resize(hinges);
  for (int lane = 0; lane < LaneTraits<Real>::kLanes; ++lane) {
    const CurveModel& c = four[lane]->*field;
    SetNumber(curve.origin, lane, c.origin);
    SetNumber(curve.value, lane, c.value);
    SetNumber(curve.slope, lane, c.given() ? c.slope : four[lane]->*slope);
    for (std::size_t i = 0; i < hinges; ++i) {
      const bool has = i < c.hinges.size();
      SetNumber(curve.hinges[i].at, lane, has ? c.hinges[i].at : 0);
      SetNumber(curve.hinges[i].slope_change, lane, has ? c.hinges[i].slope_change : 0);
    }
  }
  return curve;
}

template <class Real, class Four>
CornerStop<Real> MakeCornerStop(const Four& four) {
  const auto lanes = [&](const auto& number) {
    return InLanes<Real>(four, [&](const SpringModel& s) { return number(s.bump_stop); });
  };
  return {lanes([](const BumpStopModel& stop) { return stop.stiffness; }),
          lanes([](const BumpStopModel& stop) { return StiffnessGrowth(stop); }),
          lanes([](const BumpStopModel& stop) { return stop.damping; }),
          lanes([](const BumpStopModel& stop) { return stop.shortest_length; }),
          lanes([](const BumpStopModel& stop) { return stop.longest_length; })};
}

template <class Real>
CornerSpring<Real> MakeCornerSpring(const CornerElements& row, const VehicleModel& vehicle) {
  SpringModel idle;
  idle.p_A.z() = kOutOfReach;
  const auto four = Pick<Real>(row.elements, vehicle.springs, idle);
  const bool stops =
      std::any_of(four.begin(), four.end(), [](const SpringModel* s) { return HasStops(*s); });
  return {row.body_a,
          row.body_b,
          VectorsInLanes<Real>(four, &SpringModel::p_A),
          VectorsInLanes<Real>(four, &SpringModel::p_Q),
          VectorsInLanes<Real>(four, &SpringModel::p_B),
          InLanes<Real>(four, &SpringModel::lever),
          InLanes<Real>(four, &SpringModel::stiffness),
          InLanes<Real>(four, &SpringModel::damping),
          InLanes<Real>(four, &SpringModel::free_length),
          MakeCornerCurve<Real>(four, &SpringModel::force_curve, &SpringModel::stiffness),
          MakeCornerCurve<Real>(four, &SpringModel::damping_curve, &SpringModel::damping),
          MakeCornerStop<Real>(four),
          stops};
}

template <class Real>
CornerJoint<Real> MakeCornerJoint(const CornerElements& row, const VehicleModel& vehicle) {
  const AxisJointModel idle;
  const auto four = Pick<Real>(row.elements, vehicle.joints, idle);
  return {row.body_a,
          row.body_b,
          row.wheel,
          VectorsInLanes<Real>(four, &AxisJointModel::axis_a),
          VectorsInLanes<Real>(four, &AxisJointModel::axis_b),
          InLanes<Real>(four, &AxisJointModel::stiffness),
          InLanes<Real>(four, &AxisJointModel::damping),
          InLanes<Real>(four, &AxisJointModel::rest)};
}

template <class Real>
CornerContact<Real> MakeCornerContact(const CornerElements& row, const VehicleModel& vehicle) {
  ContactModel idle;
  idle.p_B.z() = kOutOfReach;
  const auto four = Pick<Real>(row.elements, vehicle.contacts, idle);
  return {row.body_b,
          VectorsInLanes<Real>(four, &ContactModel::p_B),
          InLanes<Real>(four, &ContactModel::stiffness),
          InLanes<Real>(four, &ContactModel::damping),
          InLanes<Real>(four, &ContactModel::friction),
          InLanes<Real>(four, &ContactModel::tangential_stiffness),
          InLanes<Real>(four, &ContactModel::tangential_damping)};
}

template <class Real>
CornerFriction<Real> MakeCornerFriction(const CornerElements& row, const VehicleModel& vehicle) {
  FrictionModel idle;
  idle.stiffness = 1;
  const auto four = Pick<Real>(row.elements, vehicle.frictions, idle);
  return {static_cast<FrictionModel::Motion>(row.kind),
          row.body_a,
          row.body_b,
          VectorsInLanes<Real>(four, &FrictionModel::axis_a),
          VectorsInLanes<Real>(four, &FrictionModel::p_B),
          InLanes<Real>(four, &FrictionModel::limit),
          InLanes<Real>(four, &FrictionModel::stiffness),
          InLanes<Real>(four, &FrictionModel::damping)};
}

template <class Real>
CornerLoad<Real> MakeCornerLoad(const CornerElements& row, const VehicleModel& vehicle) {
  const AppliedLoadModel idle;
  const auto four = Pick<Real>(row.elements, vehicle.loads, idle);
  return {row.body_b, VectorsInLanes<Real>(four, &AppliedLoadModel::p_B),
          VectorsInLanes<Real>(four, &AppliedLoadModel::force),
          VectorsInLanes<Real>(four, &AppliedLoadModel::torque), row.kind != 0};
}

}  // namespace dbd
