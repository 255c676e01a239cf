#include "plan_files.h"

#include "console.h"
#include "file_writers.h"
#include "geojson.h"
#include "map_image.h"
#include "report_page.h"
#include "route_files.h"
#include "summary.h"
#include "text.h"

namespace dbd {
namespace {

MapContent PlanMapContent(const PlanRecord& record) {
  const Plan& plan = record.plan;
  MapContent content;
  content.title = PlanHeadline(record);
  content.subtitle = PlanSubtitle(record);
  content.start = record.request.start;
  content.goal = record.request.goal;
  content.obstacle_height = record.vehicle.outline.height;
  for (std::size_t i = 0; i < plan.rollouts.size(); ++i) {
    const Rollout& rollout = plan.rollouts[i];
    content.candidates.push_back(
        {plan.candidates[i].path.points(), rollout.outcome, rollout.place.head<2>()});
  }
  if (const Rollout* chosen = record.chosen()) {
    for (const TraceSample& sample : chosen->trace) content.route.push_back({sample.x, sample.y});
  }
  if (plan.blocked_at) content.blocked = plan.blocked_at->head<2>();
  return content;
}

}  // namespace

void WritePlanFiles(const PlanRecord& record, OutputDirectory* output) {
  const LocalFrame& frame = record.terrain.frame();
  FileWriters writers(record.options.threads);
  const auto plan = output->Stage("plan.json");
  // The longest first.
  writers.Run([&record, image = output->Stage("map.png"), report = output->Stage("report.html")] {
    const MapLayout layout = WriteMapImage(image, record.terrain, PlanMapContent(record));
    WriteTextFile(report, ReportPage(record, image, layout));
  });
  if (frame.has_crs()) {
    writers.WriteText(output->Stage("candidates.geojson"),
                      [&] { return CandidatesGeoJson(record.plan, frame); });
  } else {
    PrintNote(
        "the elevation file has no coordinate system: route.csv in its coordinates instead of "
        "GeoJSON and GPX");
  }
  writers.WriteText(plan, [&] { return PlanJson(record); });
  if (const Rollout* route = record.chosen()) {
    WriteRouteFiles(*route, record.vehicle.name + " route", frame, output, &writers);
  }
  writers.Wait();
  output->Commit();
}

}  // namespace dbd
