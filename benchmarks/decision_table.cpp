#include "decision_table.h"

#include <algorithm>
#include <cstdio>

namespace dbd {
namespace {

double Regret(const QueryResult& result) { return result.chosen.score / result.best.score - 1; }

const char* Verdict(const Judged& judged) {
  return !judged.index ? "none" : !judged.reached ? "fails" : judged.holds ? "holds" : "breaks";
}

void PrintRoute(const char* name, const Judged& judged) {
  std::printf("| %s %7.1f %-6s ", name, judged.score, Verdict(judged));
}

}  // namespace

void PrintQuery(int number, const QueryResult& r) {
  std::printf("%3d %-9s %4.0f m ", number, r.site.c_str(), r.distance);
  PrintRoute("chosen", r.chosen);
  PrintRoute("without draws", r.trusting);
  PrintRoute("shortest", r.shortest);
  PrintRoute("cheapest", r.cheapest);
  PrintRoute("best", r.best);
  if (r.best.reached && r.chosen.reached) std::printf("| regret %5.1f %% ", 100 * Regret(r));
  std::printf("| %.2f s, first %.2f s, kinematic %.2f s | %.1f,%.1f %.1f,%.1f\n", r.plan_time,
              r.first_route_time.value_or(-1), r.kinematic_time, r.start.x(), r.start.y(),
              r.goal.x(), r.goal.y());
  std::fflush(stdout);
}

namespace {

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

void PrintShare(const char* what, long part, long whole) {
  std::printf("%-58s %3ld of %3ld", what, part, whole);
  if (whole > 0)
    std::printf("  (%.1f %%)", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
  std::printf("\n");
}

/// One route's worth against the chosen one's.
void PrintAgainst(const char* name, const std::vector<QueryResult>& results,
                  const Judged QueryResult::*other) {
  std::vector<double> ratios;
  long reached = 0, holds = 0, better = 0, solved = 0;
  for (const QueryResult& r : results) {
    if (!r.best.reached) continue;
    ++solved;
    const Judged& judged = r.*other;
    reached += judged.reached, holds += judged.holds;
    better += r.chosen.score < judged.score;
    if (judged.reached && r.chosen.reached) ratios.push_back(r.chosen.time / judged.time);
  }
  std::printf(
      "%-16s reached %ld, holds %ld of %ld; chosen scores better in %ld; chosen's time / its: "
      "median %.3f\n",
      name, reached, holds, solved, better, Quantile(ratios, 0.5));
}

void PrintTimes(const char* what, const std::vector<double>& seconds) {
  std::printf("time to %-26s median %.2f s, p95 %.2f s (%zu queries)\n", what,
              Quantile(seconds, 0.5), Quantile(seconds, 0.95), seconds.size());
}

}  // namespace

void PrintSummary(const std::vector<QueryResult>& results) {
  std::vector<double> regrets, plan, first, kinematic;
  long solved = 0, answered = 0, holdable = 0, holds = 0;
  for (const QueryResult& r : results) {
    plan.push_back(r.plan_time), kinematic.push_back(r.kinematic_time);
    if (r.first_route_time) first.push_back(*r.first_route_time);
    if (!r.best.reached) continue;
    ++solved;
    answered += r.chosen.reached;
    if (r.chosen.reached) regrets.push_back(100 * Regret(r));
    holdable += r.best.holds || r.chosen.holds || r.shortest.holds || r.cheapest.holds;
    holds += r.chosen.holds;
  }
  std::printf("\n%zu queries, %ld with a route in the pool\n", results.size(), solved);
  PrintShare("answered with a route where there is one", answered, solved);
  PrintShare("chosen route holds, where one of those driven again does", holds, holdable);
  std::printf("regret: median %.1f %%, p95 %.1f %%, max %.1f %%\n", Quantile(regrets, 0.5),
              Quantile(regrets, 0.95), Quantile(regrets, 1));
  PrintAgainst("without draws", results, &QueryResult::trusting);
  PrintAgainst("shortest", results, &QueryResult::shortest);
  PrintAgainst("cheapest", results, &QueryResult::cheapest);
  PrintAgainst("best of all", results, &QueryResult::best);
  PrintTimes("kinematic planning alone", kinematic);
  PrintTimes("first driven route", first);
  PrintTimes("final answer", plan);
}

}  // namespace dbd
