// Plans one route: plan_one ELEVATION X0 Y0 X1 Y1, in the coordinates of the elevation file.

#include <dbd/core/error.h>
#include <dbd/core/vehicle_database.h>
#include <dbd/planner/plan_route.h>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  try {
    dbd::TerrainFiles files;
    files.elevation = argv[1];
    const auto terrain = dbd::LoadTerrain(files);
    const auto vehicle = dbd::LoadVehicle("tomcar-tm27");
    dbd::PlanRequest request;
    request.start = terrain->frame().FromSource({std::atof(argv[2]), std::atof(argv[3])});
    request.goal = terrain->frame().FromSource({std::atof(argv[4]), std::atof(argv[5])});
    dbd::PlanOptions options;
    options.sampling.candidates = 8;

    const dbd::Plan plan = dbd::PlanRoute(terrain, vehicle, request, options);
    if (!plan.chosen) {
      std::printf("%s: %s\n", dbd::PlanStatusName(plan.status), plan.reason.c_str());
      return 3;
    }
    const dbd::Rollout& route = plan.rollouts[static_cast<std::size_t>(*plan.chosen)];
    std::printf("%.0f m in %.0f s\n", route.distance, route.time);
    for (const dbd::LimitMargin& limit : route.margins) {
      std::printf("  %-14s %3.0f %% left\n", limit.name.c_str(), 100 * limit.margin);
    }
    return 0;
  } catch (const dbd::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
