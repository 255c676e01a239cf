#include <dbd/core/error.h>
#include <dbd/core/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "initial_state.h"
#include "scene_vehicle.h"
#include "state_hash.h"
#include "vehicle_views.h"

namespace dbd {
namespace {

[[noreturn]] void Refuse(std::size_t index, const std::string& rule) {
  throw InputError("scene: vehicle " + std::to_string(index) + ": " + rule);
}

void CheckRates(std::size_t index, const DrawbarModel& drawbar) {
  if (!(drawbar.length > 0)) Refuse(index, "drawbar.length must be greater than 0");
  if (!(drawbar.stiffness > 0)) Refuse(index, "drawbar.stiffness must be greater than 0");
  if (!(drawbar.damping >= 0)) Refuse(index, "drawbar.damping must not be negative");
}

void Check(const std::vector<SceneVehicle>& vehicles, const SceneOptions& options) {
  if (vehicles.empty()) throw InputError("scene: needs at least one vehicle");
  if (!(options.gap.time_gap > 0)) throw InputError("scene: time_gap must be greater than 0");
  if (!(options.bumper.stiffness > 0)) {
    throw InputError("scene: bumper.stiffness must be greater than 0");
  }
  std::vector<int> followed(vehicles.size(), -1);
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const int ahead = vehicles[i].ahead;
    if (vehicles[i].model == nullptr) Refuse(i, "needs a model");
    if (ahead >= static_cast<int>(i)) {
      Refuse(i, "ahead is " + std::to_string(ahead) + ", must be an earlier vehicle or -1");
    }
    if (vehicles[i].drawbar) CheckRates(i, *vehicles[i].drawbar);
    if (ahead < 0) {
      if (vehicles[i].drawbar) Refuse(i, "has a drawbar but nothing ahead");
      continue;
    }
    int& follower = followed[static_cast<std::size_t>(ahead)];
    if (follower >= 0) {
      Refuse(i, "is behind vehicle " + std::to_string(ahead) + ", as is vehicle " +
                    std::to_string(follower));
    }
    follower = static_cast<int>(i);
  }
}

Couple MakeCouple(const SceneVehicle& behind, const VehicleModel& ahead,
                  const BumperModel& bumper) {
  Couple couple{Bumpers(ahead, bumper.height), Bumpers(*behind.model, bumper.height), bumper,
                behind.drawbar.has_value(), behind.drawbar.value_or(DrawbarModel{})};
  couple.drawbar.hitch -= ahead.bodies[0].p_RB;
  couple.drawbar.pivot -= behind.model->bodies[0].p_RB;
  return couple;
}

}  // namespace

struct Scene::Impl {
  Impl(std::vector<SceneVehicle> given, const Ground& surface, const SceneOptions& scene_options)
      : vehicles(std::move(given)), ground(surface), options(scene_options) {
    Check(vehicles, options);
    for (const SceneVehicle& vehicle : vehicles) {
      step = std::min(step, vehicle.model->steps.construction);
    }
    members.reserve(vehicles.size());
    for (std::size_t i = 0; i < vehicles.size(); ++i) AddMember(i);
    scratch.emplace_back(MakeScratch());
  }

  using Scratch = std::vector<Workspace<double>>;  // by kind

  void AddMember(std::size_t index);
  int KindOf(const VehicleModel& model);
  void Settle();
  void StepRange(int worker, std::int64_t round, int begin, int end, bool settling);

  Scratch MakeScratch() const {
    Scratch works;
    for (const auto& kind : kinds) works.emplace_back(kind->model);
    return works;
  }

  const SceneVehicle& At(int index) const { return vehicles[static_cast<std::size_t>(index)]; }
  const SceneMember& Member(int index) const { return members[static_cast<std::size_t>(index)]; }
  const BodyState<double>& ChassisOf(int index) const { return Member(index).state.bodies[0]; }

  std::vector<SceneVehicle> vehicles;
  const Ground& ground;
  SceneOptions options;
  double step = std::numeric_limits<double>::infinity();
  std::vector<const VehicleModel*> models;  // as given, like kinds
  std::vector<std::unique_ptr<const SceneKind>> kinds;
  std::vector<SceneMember> members;
  std::vector<Couple> couples;
  std::array<std::vector<Published>, 2> published;  // read in even and written in odd rounds, ...
  std::vector<Scratch> scratch;                     // by worker
  std::int64_t rounds_done = 0;                     // settling included
  std::int64_t steps = 0;
};

int Scene::Impl::KindOf(const VehicleModel& model) {
  const auto found = std::find(models.begin(), models.end(), &model);
  if (found != models.end()) return static_cast<int>(found - models.begin());
  models.push_back(&model);
  kinds.push_back(std::make_unique<const SceneKind>(model, step));
  return static_cast<int>(kinds.size()) - 1;
}

void Scene::Impl::AddMember(std::size_t index) {
  const SceneVehicle& vehicle = vehicles[index];
  SceneMember member;
  member.kind = KindOf(*vehicle.model);
  member.ahead = vehicle.ahead;
  const SceneKind& kind = *kinds[static_cast<std::size_t>(member.kind)];
  const auto initial = InitialState<double>(kind.model, ground, vehicle.position, vehicle.heading);
  member.state = initial;  // a copy has no room to spare
  const auto ahead = static_cast<std::size_t>(std::max(0, vehicle.ahead));
  if (vehicle.ahead >= 0) members[ahead].behind = static_cast<int>(index);
  couples.push_back(MakeCouple(vehicle, *vehicles[ahead].model, options.bumper));
  published[0].push_back({initial.bodies[0]});
  published[1].push_back({initial.bodies[0]});
  members.push_back(std::move(member));
}

void Scene::Impl::StepRange(int worker, std::int64_t round, int begin, int end, bool settling) {
  const std::size_t now = static_cast<std::size_t>(rounds_done + round) % 2;
  const SceneSurroundings around{ground, vehicles, couples, published[now], options.gap, settling};
  Scratch& works = scratch[static_cast<std::size_t>(worker)];
  for (int index = begin; index < end; ++index) {
    const auto i = static_cast<std::size_t>(index);
    const auto kind = static_cast<std::size_t>(members[i].kind);
    StepMember(*kinds[kind], index, around, works[kind], members[i], published[1 - now][i]);
  }
}

void Scene::Impl::Settle() {
  const auto rounds = static_cast<std::int64_t>(std::ceil(options.settle_time / step));
  const int count = static_cast<int>(members.size());
  SerialExecutor().Run(rounds, count, [this](int worker, std::int64_t round, int begin, int end) {
    StepRange(worker, round, begin, end, true);
  });
  rounds_done += rounds;
  for (SceneMember& member : members) {
    member.state.step = 0;
  }
}

Scene::Scene(std::vector<SceneVehicle> vehicles, const Ground& ground, const SceneOptions& options)
    : impl_(std::make_unique<Impl>(std::move(vehicles), ground, options)) {
  impl_->Settle();
}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;

void Scene::Advance(double duration, LockstepExecutor& executor) {
  Impl& s = *impl_;
  while (static_cast<int>(s.scratch.size()) < executor.worker_count()) {
    s.scratch.push_back(s.MakeScratch());
  }
  const auto rounds = static_cast<std::int64_t>(std::llround(duration / s.step));
  executor.Run(rounds, vehicle_count(), [&s](int worker, std::int64_t round, int begin, int end) {
    s.StepRange(worker, round, begin, end, false);
  });
  s.rounds_done += rounds;
  s.steps += rounds;
}

double Scene::time() const { return static_cast<double>(impl_->steps) * impl_->step; }
double Scene::step() const { return impl_->step; }
int Scene::vehicle_count() const { return static_cast<int>(impl_->members.size()); }

int Scene::body_count() const {
  std::size_t count = 0;
  for (const SceneMember& member : impl_->members) count += member.state.bodies.size();
  return static_cast<int>(count);
}

ChassisView Scene::Chassis(int vehicle) const { return ViewOfChassis(impl_->ChassisOf(vehicle)); }

double Scene::Gap(int vehicle) const {
  const int ahead = impl_->Member(vehicle).ahead;
  if (ahead < 0) return std::numeric_limits<double>::infinity();
  return BumperGap(impl_->couples[static_cast<std::size_t>(vehicle)], impl_->ChassisOf(ahead),
                   impl_->ChassisOf(vehicle));
}

double Scene::BumperForce(int vehicle) const { return impl_->Member(vehicle).bumper_force; }
double Scene::DrawbarForce(int vehicle) const { return impl_->Member(vehicle).drawbar_force; }

double Scene::DrawbarStretch(int vehicle) const {
  const Couple& couple = impl_->couples[static_cast<std::size_t>(vehicle)];
  if (!couple.towed) return 0;
  const CoupledBody ahead{impl_->ChassisOf(impl_->Member(vehicle).ahead)};
  const CoupledBody behind{impl_->ChassisOf(vehicle)};
  const Vec3<double> d = ahead.At(Broadcast<double>(couple.drawbar.hitch)).p -
                         behind.At(Broadcast<double>(couple.drawbar.pivot)).p;
  return Norm(d) - couple.drawbar.length;
}

bool Scene::Arrived(int vehicle) const {
  return impl_->At(vehicle).driver != nullptr && impl_->Member(vehicle).driver.arrived;
}

bool Scene::IsSane() const {
  for (int i = 0; i < vehicle_count(); ++i) {
    const double most = impl_->At(i).drawbar ? kTornLink : 1;
    if (!impl_->Member(i).sane || !(std::abs(DrawbarStretch(i)) < most)) return false;
  }
  return true;
}

std::uint64_t Scene::StateHash(int vehicle) const {
  const SceneMember& member = impl_->Member(vehicle);
  return HashState(member.state, member.powertrain);
}

std::uint64_t Scene::StateHash() const {
  std::uint64_t hash = 0;
  for (int i = 0; i < vehicle_count(); ++i) hash = hash * 1099511628211ull ^ StateHash(i);
  return hash;
}

std::size_t Scene::StateBytes(int vehicle) const {
  const EngineState<double>& state = impl_->Member(vehicle).state;
  return sizeof(SceneMember) + 2 * sizeof(Published) +
         state.bodies.size() * sizeof(state.bodies[0]) +
         state.wheels.size() * sizeof(state.wheels[0]) +
         state.contacts.size() * sizeof(PointContactState<double>) +
         state.frictions.size() * sizeof(double);
}

}  // namespace dbd
