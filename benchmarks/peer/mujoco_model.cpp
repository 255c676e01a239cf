#include "mujoco_model.h"

#include <dbd/core/units.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>

namespace dbd {
namespace {

// Share of a contact's force that MuJoCo's regularisation makes a spring and damper of; the rest
// acts like a mass on the contact, here of a ninth of the wheel's.
constexpr double kImpedance = 0.1;
// Friction is this much harder than the normal direction: slip of mm/s under the largest force.
constexpr double kFrictionImpedance = 1000;

/// A height field: nodes from (x0, y0) on, `cell` apart.
struct HeightField {
  double x0 = -4, y0 = -4, cell_x = 0.5, cell_y = 0.5;
  int columns = 0, rows = 0;
  double least = 0, most = 0;
  std::vector<float> heights = {};
};

HeightField SampleGround(const Ground& ground, double cell_x, double cell_y) {
  HeightField field{.cell_x = cell_x, .cell_y = cell_y};
  field.columns = static_cast<int>(52 / cell_x) + 1;
  field.rows = static_cast<int>(8 / cell_y) + 1;
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      field.heights.push_back(
          static_cast<float>(ground.Height(field.x0 + column * cell_x, field.y0 + row * cell_y)));
    }
  }
  const auto [least, most] = std::minmax_element(field.heights.begin(), field.heights.end());
  field.least = *least;
  field.most = *most;
  return field;
}

/// As few triangles as will do, since their number decides the time: A is a plane with a bar, B
/// strips of 0.25 m across the way, C and D have the ground's own nodes. (Between those a bilinear
/// patch is up to a quarter of its twist away from two triangles; cells of half the size agree
/// better with dbd and take one and a half to two and a half times as long.)
HeightField FieldOf(const Scenario& scenario) {
  if (scenario.name == "A") return {};
  if (scenario.name == "B") return SampleGround(*scenario.ground, 0.25, 8);
  return SampleGround(*scenario.ground, 0.5, 0.5);
}

/// Attributes and elements of MuJoCo's model language.
class Text {
 public:
  template <class... Parts>
  Text& operator()(const Parts&... parts) {
    (Put(parts), ...);
    return *this;
  }
  std::string str() const { return out_.str(); }

 private:
  void Put(const Eigen::Vector3d& v) { out_ << v.x() << ' ' << v.y() << ' ' << v.z(); }
  template <class T>
  void Put(const T& value) {
    out_ << value;
  }

  std::ostringstream out_;
};

void AddInertia(const BodyModel& body, double spin_inertia, Text& text) {
  const Eigen::Vector3d inertia(body.inertia.x(), std::max(body.inertia.y(), spin_inertia),
                                body.inertia.z());
  text("<inertial pos='0 0 0' mass='", body.mass, "' diaginertia='", inertia, "'/>");
}

/// The joint that holds the wheel's toe, or null.
const AxisJointModel* ToeJoint(const VehicleModel& vehicle, std::size_t wheel) {
  for (const AxisJointModel& joint : vehicle.joints) {
    if (joint.steered_wheel == static_cast<int>(wheel)) return &joint;
  }
  return nullptr;
}

void AddWheel(const VehicleModel& vehicle, std::size_t index, Text& text) {
  const WheelModel& wheel = vehicle.wheels[index];
  const BodyModel& carrier = vehicle.bodies[wheel.body];
  const WheelStrut strut = WheelStrutOf(vehicle, wheel);
  text("<body name='", wheel.name, "' pos='", carrier.p_RB + wheel.p_BH - vehicle.bodies[0].p_RB,
       "'>");
  AddInertia(carrier, wheel.spin_inertia, text);
  text("<joint name='", wheel.name, " travel' type='slide' axis='0 0 1' stiffness='",
       strut.stiffness, "' damping='", strut.damping, "' springref='",
       -strut.preload / strut.stiffness, "'/>");
  if (const AxisJointModel* toe = ToeJoint(vehicle, index)) {
    text("<joint name='", wheel.name, " steer' type='hinge' axis='0 0 1' stiffness='",
         toe->stiffness, "' damping='", toe->damping, "'/>");
  }
  text("<joint name='", wheel.name, " spin' type='hinge' axis='0 1 0' frictionloss='1'/>");
  text("<geom type='sphere' size='", wheel.tire.radius,
       "' contype='0' conaffinity='1' priority='1' friction='", wheel.tire.traction.traction_max,
       " 0 0'/></body>");
}

void AddGround(const Scenario& scenario, const HeightField& field, Text& text) {
  if (scenario.name == "A") {
    text(
        "<geom type='plane' size='0 0 1' contype='1' conaffinity='0'/>"
        "<geom type='capsule' fromto='15 -4 0 15 4 0' size='0.1' contype='1' conaffinity='0'/>");
    return;
  }
  text("<geom type='hfield' hfield='ground' contype='1' conaffinity='0' pos='",
       Eigen::Vector3d(field.x0 + 0.5 * field.cell_x * (field.columns - 1),
                       field.y0 + 0.5 * field.cell_y * (field.rows - 1), field.least),
       "'/>");
}

void AddAsset(const HeightField& field, Text& text) {
  if (field.heights.empty()) return;
  text("<asset><hfield name='ground' nrow='", field.rows, "' ncol='", field.columns, "' size='",
       0.5 * field.cell_x * (field.columns - 1), ' ', 0.5 * field.cell_y * (field.rows - 1), ' ',
       field.most - field.least, " 1'/></asset>");
}

std::string ModelText(const Scenario& scenario, const VehicleModel& vehicle,
                      const HeightField& field, MujocoContact contact) {
  Text text;
  text("<mujoco><compiler angle='radian'/><size njmax='1000' nconmax='300'/><option timestep='",
       vehicle.steps.construction, "' gravity='0 0 ", -kGravity, "'");
  if (contact == MujocoContact::kTire) {
    text(" cone='elliptic' impratio='", kFrictionImpedance, "'");
  }
  text("/>");
  AddAsset(field, text);
  text("<worldbody>");
  AddGround(scenario, field, text);
  const Eigen::Vector3d& p_RB = vehicle.bodies[0].p_RB;
  text("<body name='chassis' pos='",
       p_RB + Eigen::Vector3d(-vehicle.path_point_x(), 0, vehicle.reference_height),
       "'><freejoint/>");
  AddInertia(vehicle.bodies[0], 0, text);
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) AddWheel(vehicle, i, text);
  return text("</body></worldbody></mujoco>").str();
}

MujocoModel Compile(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "vehicle.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[1000] = "";
  MujocoModel model(mj_loadXML("vehicle.xml", files.get(), error, sizeof(error)));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + error);
  return model;
}

/// MuJoCo's contacts are spring-dampers per effective mass: so that they become the tire's.
void SetTireStiffness(const VehicleModel& vehicle, mjModel& model) {
  for (const WheelModel& wheel : vehicle.wheels) {
    const int body = FindMujocoWheel(model, wheel).body;
    const double per_mass = (1 - kImpedance) * model.body_invweight0[2 * body];
    mjtNum* reference = model.geom_solref + mjNREF * model.body_geomadr[body];
    reference[0] = -wheel.tire.stiffness * per_mass;
    reference[1] = -wheel.tire.damping * per_mass;
    mjtNum* impedance = model.geom_solimp + mjNIMP * model.body_geomadr[body];
    impedance[0] = impedance[1] = kImpedance;
  }
}

}  // namespace

WheelStrut WheelStrutOf(const VehicleModel& vehicle, const WheelModel& wheel) {
  const auto spring = std::find_if(vehicle.springs.begin(), vehicle.springs.end(),
                                   [&](const SpringModel& s) { return s.body_b == wheel.body; });
  if (spring == vehicle.springs.end()) throw std::runtime_error(wheel.name + ": has no spring");
  const Eigen::Vector3d p_RB = vehicle.bodies[spring->body_b].p_RB + spring->p_B;
  const Eigen::Vector3d& p_RA = vehicle.bodies[spring->body_a].p_RB;
  const Eigen::Vector3d lower = (1 - spring->lever) * (p_RA + spring->p_Q) + spring->lever * p_RB;
  const double force =
      spring->stiffness * (spring->free_length - (lower - p_RA - spring->p_A).norm());
  const double preload = wheel.static_load - kGravity * vehicle.bodies[wheel.body].mass;
  const double ratio = preload / force;
  return {ratio * ratio * spring->stiffness, ratio * ratio * spring->damping, preload};
}

MujocoModel MakeMujocoModel(const Scenario& scenario, const VehicleModel& vehicle,
                            MujocoContact contact) {
  const HeightField field = FieldOf(scenario);
  MujocoModel model = Compile(ModelText(scenario, vehicle, field, contact));
  const double range = std::max(field.most - field.least, 1e-9);
  for (std::size_t i = 0; i < field.heights.size(); ++i) {
    model->hfield_data[i] = static_cast<float>((field.heights[i] - field.least) / range);
  }
  if (contact == MujocoContact::kTire) SetTireStiffness(vehicle, *model);
  return model;
}

MujocoWheelAddress FindMujocoWheel(const mjModel& model, const WheelModel& wheel) {
  const auto joint = [&](const char* kind) {
    return mj_name2id(&model, mjOBJ_JOINT, (wheel.name + " " + kind).c_str());
  };
  MujocoWheelAddress address;
  address.body = mj_name2id(&model, mjOBJ_BODY, wheel.name.c_str());
  address.travel_q = model.jnt_qposadr[joint("travel")];
  if (joint("steer") >= 0) address.steer_q = model.jnt_qposadr[joint("steer")];
  address.spin_dof = model.jnt_dofadr[joint("spin")];
  return address;
}

}  // namespace dbd
