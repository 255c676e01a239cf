#include <dbd/core/vehicle_database.h>
#include <dbd/planner/plan_route.h>
#include <dbd/terrain/generator.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>

// How late a plan ends after its deadline, or after it was cancelled, at random moments of a plan
// on a generated landscape: `deadline_benchmark [MOMENTS [SIZE]]`, half of them of each kind.

namespace dbd {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct Site {
  std::shared_ptr<const Terrain> terrain;
  PlanRequest request;
};

Site GenerateSite(int size) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("dbd-deadline-" + std::to_string(getpid()));
  GeneratorOptions options;
  options.size = size;
  const GeneratedTerrain generated = GenerateTerrain(options, directory.string());
  Site site{LoadTerrain(FilesOf(generated)), {}};
  site.request.start = site.terrain->frame().ToLocal(generated.start);
  site.request.goal = site.terrain->frame().ToLocal(generated.goal);
  std::filesystem::remove_all(directory);
  return site;
}

struct Stopped {
  double late = 0;  // [s]
  Plan plan;
};

Stopped PlanUntilDeadline(const Site& site, double moment) {
  PlanOptions options;
  options.deadline = moment;
  const auto begin = Clock::now();
  Plan plan = PlanRoute(site.terrain, LoadVehicle("tomcar-tm27"), site.request, options);
  return {SecondsSince(begin) - moment, std::move(plan)};
}

Stopped PlanUntilCancelled(const Site& site, double moment) {
  std::stop_source source;
  Clock::time_point asked;
  std::jthread canceller([&] {
    std::this_thread::sleep_for(std::chrono::duration<double>(moment));
    asked = Clock::now();
    source.request_stop();
  });
  Plan plan =
      PlanRoute(site.terrain, LoadVehicle("tomcar-tm27"), site.request, {}, {}, source.get_token());
  const Clock::time_point ended = Clock::now();
  canceller.join();
  return {std::chrono::duration<double>(ended - asked).count(), std::move(plan)};
}

void Print(const char* name, std::vector<double> late, int with_route) {
  std::sort(late.begin(), late.end());
  if (late.empty()) return;
  const auto at = [&](double share) {
    return 1e3 * late[static_cast<std::size_t>(share * static_cast<double>(late.size() - 1))];
  };
  std::printf(
      "%-9s %4zu moments, %4d with a route: late by p50 %.1f ms, p90 %.1f, p99 %.1f, max %.1f\n",
      name, late.size(), with_route, at(0.5), at(0.9), at(0.99), at(1));
}

void Measure(int moments, int size) {
  const Site site = GenerateSite(size);
  const auto begin = Clock::now();
  PlanRoute(site.terrain, LoadVehicle("tomcar-tm27"), site.request, {});
  const double whole = SecondsSince(begin);
  std::printf("whole plan %.2f s\n", whole);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(0, whole);
  for (const bool cancel : {false, true}) {
    std::vector<double> late;
    int with_route = 0;
    for (int i = 0; i < moments / 2; ++i) {
      const double moment = anywhere(random);
      const Stopped stopped =
          cancel ? PlanUntilCancelled(site, moment) : PlanUntilDeadline(site, moment);
      if (stopped.plan.status == PlanStatus::kRoute) continue;  // had ended before
      late.push_back(stopped.late);
      with_route += stopped.plan.chosen.has_value();
    }
    Print(cancel ? "cancel" : "deadline", std::move(late), with_route);
  }
}

}  // namespace
}  // namespace dbd

int main(int argc, char** argv) {
  dbd::Measure(argc > 1 ? std::atoi(argv[1]) : 200, argc > 2 ? std::atoi(argv[2]) : 400);
}
