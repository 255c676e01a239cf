#include <algorithm>
#include <cmath>
#include <limits>

#include "time_steps.h"

namespace dbd {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The body's name without its side.
std::string WithoutSide(std::string name) {
  for (const std::string side : {" left", " right"}) {
    const std::size_t at = name.find(side);
    if (at != std::string::npos) name.erase(at, side.size());
  }
  return name;
}

class Groups {
 public:
  explicit Groups(const VehicleModel& vehicle) : vehicle_(vehicle) {}

  void Add(const std::string& kind, int body, const CriticalStep& critical) {
    const std::string name = kind + ", " + WithoutSide(vehicle_.bodies[body].name);
    auto group = std::find_if(groups_.begin(), groups_.end(),
                              [&](const CriticalGroup& g) { return g.name == name; });
    if (group == groups_.end()) {
      group = groups_.insert(groups_.end(), {name, 0, kNone, kNone});
    }
    ++group->count;
    group->translational = std::min(group->translational, critical.translational);
    group->rotational = std::min(group->rotational, critical.rotational);
  }

  std::vector<CriticalGroup> Take() { return std::move(groups_); }

 private:
  const VehicleModel& vehicle_;
  std::vector<CriticalGroup> groups_;
};

}  // namespace

std::vector<CriticalGroup> GroupCriticalSteps(const VehicleModel& vehicle) {
  Groups groups(vehicle);
  const auto mass_step = [&](int body, double stiffness) {
    return CriticalStep{std::sqrt(vehicle.bodies[body].mass / stiffness), kNone};
  };
  for (const LinkModel& link : vehicle.links) {
    groups.Add("links", link.body_b, CriticalStepOf(vehicle, link));
  }
  for (const AxisJointModel& joint : vehicle.joints) {
    const double inertia = std::min(vehicle.bodies[joint.body_a].inertia.minCoeff(),
                                    vehicle.bodies[joint.body_b].inertia.minCoeff());
    groups.Add("joints", joint.body_b, {kNone, std::sqrt(inertia / joint.stiffness)});
  }
  for (const SpringModel& spring : vehicle.springs) {
    const double at_body = spring.lever * spring.lever * spring.stiffness;
    groups.Add("springs", spring.body_b, mass_step(spring.body_b, at_body));
    if (spring.bump_stop.stiffness == 0) continue;
    const double stop = spring.lever * spring.lever * spring.bump_stop.stiffness;
    groups.Add("bump stops", spring.body_b, mass_step(spring.body_b, stop));
  }
  for (const WheelModel& wheel : vehicle.wheels) {
    groups.Add("tires", wheel.body, mass_step(wheel.body, wheel.tire.stiffness));
  }
  for (const ContactModel& contact : vehicle.contacts) {
    groups.Add("contacts", contact.body, mass_step(contact.body, contact.stiffness));
  }
  return groups.Take();
}

}  // namespace dbd
