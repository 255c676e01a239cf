#include "report_data.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <dbd/core/units.h>
#include <dbd/planner/scoring.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "json_parts.h"
#include "limit_units.h"
#include "map_style.h"
#include "places.h"
#include "summary.h"
#include "text.h"
#include "trace_table.h"
#include "versions.h"

namespace dbd {
namespace {

using nlohmann::ordered_json;

constexpr double kLineSpacing = 5.0;  // [m] of candidates on the map
constexpr char kFirstColor[] = "#12348c", kSecondColor[] = "#e69f00";

std::string DataUrl(const std::filesystem::path& image) {
  std::ifstream stream(image, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  char* text =
      CPLBase64Encode(static_cast<int>(bytes.size()), reinterpret_cast<const GByte*>(bytes.data()));
  const std::string url = std::string("data:image/png;base64,") + text;
  CPLFree(text);
  return url;
}

Eigen::Vector2d Pixel(const MapLayout& layout, const Eigen::Vector2d& local) {
  return layout.view.ToPixel(local) + Eigen::Vector2d(0, layout.top);
}

/// One chart: its lines are columns of the trace.
struct ChartLine {
  const char* name;
  const char* column;
  const char* color;
};

ordered_json ChartJson(const char* title, const char* unit, const std::vector<ChartLine>& lines,
                       const std::vector<double>& limits) {
  ordered_json series = ordered_json::array();
  for (const ChartLine& line : lines) {
    series.push_back({{"name", line.name}, {"column", line.column}, {"color", line.color}});
  }
  ordered_json bounds = ordered_json::array();
  for (const double limit : limits) bounds.push_back(Rounded(limit, 4));
  return {{"title", title}, {"unit", unit}, {"series", series}, {"limits", bounds}};
}

ordered_json ChartsJson(const VehicleLimits& limits) {
  const double roll = ToDegrees(limits.max_roll), pitch = ToDegrees(limits.max_pitch);
  ordered_json charts = ordered_json::array();
  charts.push_back(ChartJson("Height", "m", {{"ground", "ground_z_m", kFirstColor}}, {}));
  charts.push_back(ChartJson(
      "Speed", "m/s",
      {{"speed", "speed_mps", kFirstColor}, {"target", "target_speed_mps", kSecondColor}}, {}));
  charts.push_back(
      ChartJson("Roll (left side up)", "°", {{"roll", "roll_deg", kFirstColor}}, {-roll, roll}));
  charts.push_back(
      ChartJson("Pitch (nose down)", "°", {{"pitch", "pitch_deg", kFirstColor}}, {-pitch, pitch}));
  charts.push_back(
      ChartJson("Slip of the wheel that slips most", "", {{"slip", "slip", kFirstColor}}, {}));
  charts.push_back(ChartJson("Sinkage of the deepest wheel", "m",
                             {{"sinkage", "sinkage_m", kFirstColor}}, {limits.max_sinkage}));
  charts.push_back(ChartJson("Net traction reserve, share of the weight", "",
                             {{"reserve", "net_traction_reserve", kFirstColor}}, {0}));
  charts.push_back(ChartJson("Clearance below the belly", "m",
                             {{"clearance", "clearance_m", kFirstColor}}, {limits.min_clearance}));
  return charts;
}

ordered_json RouteDataJson(const PlanRecord& record, const MapLayout& layout) {
  const Rollout* chosen = record.chosen();
  if (!chosen) return nullptr;
  const std::vector<TraceSample> rows = WorstPerMeter(chosen->trace);
  ordered_json route = {{"s", ordered_json::array()},
                        {"t", ordered_json::array()},
                        {"x", ordered_json::array()},
                        {"y", ordered_json::array()}};
  for (const TraceSample& row : rows) {
    const Eigen::Vector2d pixel = Pixel(layout, {row.x, row.y});
    route["s"].push_back(Rounded(row.s, 2));
    route["t"].push_back(Rounded(row.t, 2));
    route["x"].push_back(Rounded(pixel.x(), 1));
    route["y"].push_back(Rounded(pixel.y(), 1));
  }
  ordered_json& columns = route["columns"] = ordered_json::object();
  for (const TraceColumn& column : TraceColumns(record.terrain.frame())) {
    ordered_json values = ordered_json::array();
    for (const TraceSample& row : rows)
      values.push_back(Rounded(column.value(row), column.decimals));
    columns[column.name] = std::move(values);
  }
  return route;
}

ordered_json LimitsJson(const PlanRecord& record) {
  ordered_json limits = ordered_json::array();
  const Rollout* chosen = record.chosen();
  if (!chosen) return limits;
  const LimitMargin* binding = TightestLimit(*chosen);
  for (const LimitMargin& margin : chosen->margins) {
    const LimitUnit unit = UnitOfLimit(margin.name);
    const auto text = [&unit](double value) {
      return Format("%.*f%s", unit.decimals, value * unit.factor, unit.symbol);
    };
    std::string name = margin.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    limits.push_back({{"name", name},
                      {"worst", text(margin.worst)},
                      {"limit", text(margin.limit)},
                      {"margin", Rounded(margin.margin, 4)},
                      {"s", Rounded(margin.s, 1)},
                      {"place", DescribePlace(record.terrain.frame(), margin.place)},
                      {"binding", &margin == binding}});
  }
  return limits;
}

std::string LinePoints(const Path& path, const MapLayout& layout) {
  std::string points;
  for (double s = 0; s < path.length() + kLineSpacing; s += kLineSpacing) {
    const Eigen::Vector2d pixel = Pixel(layout, path.Position(std::min(s, path.length())));
    points += Format("%.1f,%.1f ", pixel.x(), pixel.y());
  }
  return points;
}

std::string CssColor(const Color& color) {
  return Format("rgb(%.0f,%.0f,%.0f)", 255 * color.red, 255 * color.green, 255 * color.blue);
}

/// What the draws say of a candidate; empty cells where it was not driven on them.
ordered_json SuccessCells(const Plan& plan, std::size_t i) {
  if (plan.success.empty() || !plan.success[i]) return ordered_json::array();
  const SuccessEstimate& estimate = *plan.success[i];
  return {
      Format("%.0f %% (%.0f–%.0f)", 100 * estimate.p_go(), 100 * estimate.low, 100 * estimate.high),
      Format("%.1f", estimate.mean_time), Format("%.1f", estimate.cvar_time)};
}

ordered_json CandidateJson(const PlanRecord& record, std::size_t i, const std::string& round,
                           const MapLayout& layout) {
  const Plan& plan = record.plan;
  const Rollout& rollout = plan.rollouts[i];
  std::string outcome = OutcomeName(rollout.outcome);
  std::replace(outcome.begin(), outcome.end(), '_', ' ');
  const Score& score = plan.scores[i];
  return {{"id", i},
          {"round", round},
          {"origin", plan.candidates[i].origin},
          {"outcome", outcome},
          {"color", CssColor(OutcomeColor(rollout.outcome))},
          {"score", score.feasible ? ordered_json(Rounded(score.total, 2)) : ordered_json(nullptr)},
          {"time", Rounded(rollout.time, 2)},
          {"length", Rounded(rollout.distance, 1)},
          {"progress", Rounded(rollout.progress, 4)},
          {"place", DescribePlace(record.terrain.frame(), rollout.place.head<2>())},
          {"reason", rollout.reason},
          {"extra", SuccessCells(plan, i)},
          {"chosen", plan.chosen == static_cast<int>(i)},
          {"line", LinePoints(plan.candidates[i].path, layout)}};
}

ordered_json CandidatesJson(const PlanRecord& record, const MapLayout& layout) {
  ordered_json candidates = ordered_json::array();
  std::size_t next = 0;
  for (std::size_t r = 0; r < record.plan.rounds.size(); ++r) {
    const PlanRound& round = record.plan.rounds[r];
    const std::string name = Format("%zu %s", r + 1, round.name.c_str());
    for (int i = 0; i < round.candidates; ++i) {
      candidates.push_back(CandidateJson(record, next++, name, layout));
    }
  }
  return candidates;
}

ordered_json RoundsDataJson(const Plan& plan) {
  ordered_json rows = ordered_json::array();
  double before = std::numeric_limits<double>::infinity();
  for (const PlanRound& round : plan.rounds) {
    const bool any = std::isfinite(round.best_score);
    const std::string gain =
        std::isfinite(before) ? Format("%.1f", before - round.best_score) : std::string("–");
    rows.push_back({round.name, round.candidates, round.reached,
                    any ? Format("%.1f", round.best_score) : std::string("–"), gain});
    before = round.best_score;
  }
  return {{"columns", {"round", "driven", "reached", "best score so far [s]", "gained [s]"}},
          {"rows", std::move(rows)}};
}

ordered_json BasisJson(const PlanRecord& record) {
  ordered_json basis = ordered_json::array();
  for (const BasisItem& item : record.basis) {
    const std::string origin = item.sha256.empty() ? " (built in)" : "\nSHA-256 " + item.sha256;
    basis.push_back({item.what, item.name + origin});
  }
  basis.push_back({"vehicle name", record.vehicle.name});
  basis.push_back({"coordinate system", record.terrain.frame().CrsName()});
  const UncertaintyOptions& uncertainty = record.options.uncertainty;
  if (uncertainty.draws > 1) {
    basis.push_back(
        {"uncertainty",
         Format("%d draws at most; strength of soils by %g times their tables' spread; heights "
                "%g m, alike over %g m; least success %.0f %%",
                uncertainty.draws, uncertainty.spread.soil, uncertainty.spread.elevation_error,
                uncertainty.spread.elevation_correlation, 100 * uncertainty.min_success)});
  }
  basis.push_back({"seed", std::to_string(record.options.seed)});
  basis.push_back({"digest", HashText(record.plan.digest)});
  for (const auto& [name, version] : Versions()) basis.push_back({name, version});
  return basis;
}

}  // namespace

ordered_json ReportData(const PlanRecord& record, const std::filesystem::path& image,
                        const MapLayout& layout) {
  return {{"title", PlanHeadline(record)},
          {"reason", record.plan.reason},
          {"map", {{"image", DataUrl(image)}, {"width", layout.width}, {"height", layout.height}}},
          {"route", RouteDataJson(record, layout)},
          {"charts", ChartsJson(record.vehicle.limits)},
          {"limits", LimitsJson(record)},
          {"rounds", RoundsDataJson(record.plan)},
          {"extraColumns", record.plan.success.empty()
                               ? ordered_json::array()
                               : ordered_json({"P(go)", "mean time [s]", "slowest tenth [s]"})},
          {"candidates", CandidatesJson(record, layout)},
          {"basis", BasisJson(record)}};
}

}  // namespace dbd
