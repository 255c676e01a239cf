// Plans from one place to several with one service, shows how far it is, and gives up after a
// while: plan_many ELEVATION X0 Y0 X1 Y1 [X2 Y2 ...]

#include <dbd/core/vehicle_database.h>
#include <dbd/planner/planning_service.h>
#include <dbd/terrain/terrain_cache.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

int main(int argc, char** argv) {
  if (argc < 6 || argc % 2 != 0) return 2;
  const auto place = [&](int i) {
    return Eigen::Vector2d(std::atof(argv[i]), std::atof(argv[i + 1]));
  };
  dbd::TerrainFiles files;
  files.elevation = argv[1];
  dbd::TerrainCache terrains(2e9);  // outlives the service, whose jobs use it
  dbd::PlanningService service({.threads = 0, .queue_limit = 100});

  std::vector<dbd::PlanningService::Handle> handles;
  for (int i = 4; i < argc; i += 2) {
    dbd::PlanJob job;
    job.prepare = [&terrains, files, start = place(2), goal = place(i)] {
      dbd::PlanInputs inputs;
      inputs.terrain = terrains.Get(files);
      inputs.vehicle = dbd::LoadVehicle("tomcar-tm27");
      inputs.request.start = inputs.terrain->frame().FromSource(start);
      inputs.request.goal = inputs.terrain->frame().FromSource(goal);
      inputs.options.sampling.candidates = 8;
      return inputs;
    };
    handles.push_back(service.Submit(std::move(job)));
  }

  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const dbd::JobProgress progress = handles.front().progress();
  std::printf("first: %s %d of %d\n", progress.stage.c_str(), progress.done, progress.total);
  const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  for (auto& handle : handles) {
    while (handle.state() <= dbd::JobState::kRunning) {
      if (std::chrono::steady_clock::now() > patience) handle.Cancel();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    const dbd::JobResult& result = handle.Wait();
    std::printf("%s: %s%s\n", dbd::JobStateName(result.state),
                result.error.empty() ? dbd::PlanStatusName(result.plan.status) : "",
                result.error.c_str());
  }
  return 0;
}
