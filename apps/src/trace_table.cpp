#include "trace_table.h"

#include <dbd/core/units.h>

#include <algorithm>
#include <cmath>

#include "places.h"
#include "text.h"

namespace dbd {
namespace {

void AddPlaceColumns(const LocalFrame& frame, std::vector<TraceColumn>* columns) {
  const auto map = [&frame](const TraceSample& a) { return frame.ToMap({a.x, a.y}); };
  columns->push_back({"x_m", 3, [map](const TraceSample& a) { return map(a).x(); }});
  columns->push_back({"y_m", 3, [map](const TraceSample& a) { return map(a).y(); }});
  if (frame.has_crs()) {
    const auto wgs84 = [&frame](const TraceSample& a) { return frame.ToWgs84({a.x, a.y}); };
    columns->push_back(
        {"longitude_deg", 8, [wgs84](const TraceSample& a) { return wgs84(a).x(); }});
    columns->push_back({"latitude_deg", 8, [wgs84](const TraceSample& a) { return wgs84(a).y(); }});
  }
  columns->push_back({"z_m", 3, [](const TraceSample& a) { return a.z; }});
  columns->push_back({"ground_z_m", 3, [](const TraceSample& a) { return a.ground_z; }});
}

void AddVehicleColumns(std::vector<TraceColumn>* columns) {
  using Sample = const TraceSample&;
  const std::vector<TraceColumn> vehicle = {
      {"heading_deg", 2, [](Sample a) { return CompassDegrees(a.yaw); }},
      {"pitch_deg", 3, [](Sample a) { return ToDegrees(a.pitch); }},
      {"roll_deg", 3, [](Sample a) { return ToDegrees(a.roll); }},
      {"speed_mps", 3, [](Sample a) { return a.speed; }},
      {"target_speed_mps", 3, [](Sample a) { return a.target_speed; }},
      {"slip", 4, [](Sample a) { return a.slip; }},
      {"sinkage_m", 4, [](Sample a) { return a.sinkage; }},
      {"net_traction_reserve", 4, [](Sample a) { return a.net_traction_reserve; }},
      {"clearance_m", 3, [](Sample a) { return a.clearance; }},
      {"load_transfer_ratio", 4, [](Sample a) { return a.load_transfer_ratio; }},
      {"ground_slope_deg", 3, [](Sample a) { return ToDegrees(a.ground_slope); }},
      {"power_w", 0, [](Sample a) { return a.power; }},
      {"absorbed_power_w", 2, [](Sample a) { return a.absorbed_power; }},
      {"vertical_acceleration_mps2", 2, [](Sample a) { return a.vertical_acceleration; }},
  };
  columns->insert(columns->end(), vehicle.begin(), vehicle.end());
}

double LargerMagnitude(double a, double b) { return std::abs(b) > std::abs(a) ? b : a; }

void KeepWorst(const TraceSample& sample, TraceSample* worst) {
  worst->pitch = LargerMagnitude(worst->pitch, sample.pitch);
  worst->roll = LargerMagnitude(worst->roll, sample.roll);
  worst->speed = std::max(worst->speed, sample.speed);
  worst->slip = LargerMagnitude(worst->slip, sample.slip);
  worst->sinkage = std::max(worst->sinkage, sample.sinkage);
  worst->net_traction_reserve = std::min(worst->net_traction_reserve, sample.net_traction_reserve);
  worst->clearance = std::min(worst->clearance, sample.clearance);
  worst->load_transfer_ratio = std::max(worst->load_transfer_ratio, sample.load_transfer_ratio);
  worst->ground_slope = std::max(worst->ground_slope, sample.ground_slope);
  worst->power = std::max(worst->power, sample.power);
  worst->absorbed_power = std::max(worst->absorbed_power, sample.absorbed_power);
  worst->vertical_acceleration =
      std::max(worst->vertical_acceleration, sample.vertical_acceleration);
}

}  // namespace

std::vector<TraceColumn> TraceColumns(const LocalFrame& frame) {
  std::vector<TraceColumn> columns = {
      {"time_s", 3, [](const TraceSample& a) { return a.t; }},
      {"distance_m", 3, [](const TraceSample& a) { return a.s; }},
  };
  AddPlaceColumns(frame, &columns);
  AddVehicleColumns(&columns);
  return columns;
}

std::string TraceCsv(const std::vector<TraceSample>& trace, const LocalFrame& frame) {
  const std::vector<TraceColumn> columns = TraceColumns(frame);
  std::string csv;
  for (const TraceColumn& column : columns) {
    csv += (&column == &columns.front() ? "" : ",") + column.name;
  }
  csv += '\n';
  for (const TraceSample& sample : trace) {
    for (const TraceColumn& column : columns) {
      if (&column != &columns.front()) csv += ',';
      csv += Format("%.*f", column.decimals, column.value(sample));
    }
    csv += '\n';
  }
  return csv;
}

std::string RouteCsv(const std::vector<TraceSample>& trace, const LocalFrame& frame) {
  std::string csv = "x_m,y_m,ground_z_m\n";
  for (const TraceSample& sample : trace) {
    const Eigen::Vector2d map = frame.ToMap({sample.x, sample.y});
    csv += Format("%.3f,%.3f,%.3f\n", map.x(), map.y(), sample.ground_z);
  }
  return csv;
}

std::vector<TraceSample> WorstPerMeter(const std::vector<TraceSample>& trace) {
  std::vector<TraceSample> rows;
  double meter = -1;
  for (const TraceSample& sample : trace) {
    if (rows.empty() || std::floor(sample.s) > meter) {
      rows.push_back(sample);
      meter = std::floor(sample.s);
    } else {
      KeepWorst(sample, &rows.back());
    }
  }
  return rows;
}

}  // namespace dbd
