#include "vehicle_file_elements.h"

#include <dbd/core/connection.h>

#include <set>

#include "vehicle_file_parts.h"

namespace dbd {
namespace {

using internal::JsonObject;
using internal::NearestWord;

int ReadBody(const JsonObject& object, const std::string& key, const VehicleModel& vehicle) {
  const std::string name = object.Text(key);
  std::set<std::string> names;
  for (std::size_t i = 0; i < vehicle.bodies.size(); ++i) {
    if (vehicle.bodies[i].name == name) return static_cast<int>(i);
    names.insert(vehicle.bodies[i].name);
  }
  object.Fail(key, "is \"" + name + "\", not the name of a body; did you mean \"" +
                       NearestWord(name, names) + "\"?");
}

/// A point of `body`, given in the reference frame.
Eigen::Vector3d ReadPointOn(const JsonObject& object, const std::string& key, int body,
                            const VehicleModel& vehicle) {
  return object.Point(key) - vehicle.bodies[body].p_RB;
}

Eigen::Vector3d ReadAxis(const JsonObject& object) {
  const Eigen::Vector3d axis = object.Point("axis");
  if (axis.norm() < 1e-9) object.Fail("axis", "must not be zero");
  return axis.normalized();
}

/// Bodies hang on the chassis: the trim solves them one by one.
void ReadConnection(const JsonObject& object, VehicleModel& vehicle) {
  Connection connection;
  connection.name = object.Text("name");
  connection.body_b = ReadBody(object, "body", vehicle);
  if (connection.body_b == 0) object.Fail("body", "is the chassis, on which the others hang");
  const std::string kind = object.Text("kind");
  connection.p_R = object.Point("point");
  if (kind == "spherical") {
    connection.kind = ConnectionKind::kSpherical;
  } else if (kind == "revolute") {
    connection.kind = ConnectionKind::kRevolute;
    connection.axis = ReadAxis(object);
  } else if (kind != "fixed") {
    object.Fail("kind", "is \"" + kind + "\", must be spherical, revolute or fixed");
  }
  connection.base = object.Number("base", 1e-3, kMostLength, connection.base);
  connection.stiffness = object.Number("stiffness", kTiny, kMostStiffness);
  connection.damping = object.Number("damping", 0, kMostStiffness);
  object.RefuseUnknownKeys();
  AddConnection(connection, vehicle);
}

void ReadContact(const JsonObject& object, VehicleModel& vehicle) {
  ContactModel contact;
  contact.name = object.Text("name");
  contact.body = ReadBody(object, "body", vehicle);
  contact.p_B = ReadPointOn(object, "point", contact.body, vehicle);
  contact.stiffness = object.Number("stiffness", kTiny, kMostStiffness);
  contact.damping = object.Number("damping", 0, kMostStiffness);
  contact.friction = object.Number("friction", 0, 2);
  contact.tangential_stiffness =
      object.Number("tangential_stiffness", kTiny, kMostStiffness, contact.stiffness);
  contact.tangential_damping =
      object.Number("tangential_damping", 0, kMostStiffness, contact.damping);
  object.RefuseUnknownKeys();
  vehicle.contacts.push_back(contact);
}

void ReadFriction(const JsonObject& object, VehicleModel& vehicle) {
  FrictionModel friction;
  friction.name = object.Text("name");
  friction.body_a = object.Has("body_a") ? ReadBody(object, "body_a", vehicle) : 0;
  friction.body_b = ReadBody(object, "body_b", vehicle);
  if (friction.body_a == friction.body_b) object.Fail("body_b", "must differ from body_a");
  const std::string motion = object.Text("motion");
  if (motion != "sliding" && motion != "turning") {
    object.Fail("motion", "is \"" + motion + "\", must be sliding or turning");
  }
  friction.axis_a = ReadAxis(object);
  if (motion == "sliding") {
    friction.p_B = ReadPointOn(object, "point", friction.body_b, vehicle);
  } else {
    friction.motion = FrictionModel::Motion::kTurning;
  }
  friction.limit = object.Number("limit", kTiny, kMostStiffness);
  friction.stiffness = object.Number("stiffness", kTiny, kMostStiffness);
  friction.damping = object.Number("damping", 0, kMostStiffness, 0);
  object.RefuseUnknownKeys();
  vehicle.frictions.push_back(friction);
}

void ReadLoad(const JsonObject& object, VehicleModel& vehicle) {
  AppliedLoadModel load;
  load.name = object.Text("name");
  load.body = ReadBody(object, "body", vehicle);
  if (object.Has("force")) {
    load.force = object.Point("force");
    load.p_B = ReadPointOn(object, "point", load.body, vehicle);
  }
  if (object.Has("torque")) load.torque = object.Point("torque");
  load.turns_with_body = object.Flag("turns_with_body", false);
  object.RefuseUnknownKeys();
  vehicle.loads.push_back(load);
}

}  // namespace

void ReadElements(const JsonObject& root, VehicleModel& vehicle) {
  const auto read_all = [&](const std::string& key, auto read) {
    if (!root.Has(key)) return;
    for (const JsonObject& object : root.Children(key)) read(object, vehicle);
  };
  read_all("connections", ReadConnection);
  read_all("contacts", ReadContact);
  read_all("frictions", ReadFriction);
  read_all("loads", ReadLoad);
}

}  // namespace dbd
