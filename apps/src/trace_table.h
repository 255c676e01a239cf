#pragma once

#include <dbd/planner/plan_types.h>
#include <dbd/terrain/local_frame.h>

#include <functional>
#include <string>
#include <vector>

namespace dbd {

/// One column of the exported trace. `value` is in the unit that ends the name.
struct TraceColumn {
  std::string name;  ///< "speed_mps", "roll_deg"
  int decimals = 3;
  std::function<double(const TraceSample&)> value;
};

/// The columns of every exported trace, in order: time and place (map coordinates; longitude and
/// latitude where the terrain has a coordinate system), then the vehicle. `frame` must outlive
/// the columns.
std::vector<TraceColumn> TraceColumns(const LocalFrame& frame);

/// The whole time series as CSV with one header line.
std::string TraceCsv(const std::vector<TraceSample>& trace, const LocalFrame& frame);

/// The driven line alone as CSV: x_m, y_m in map coordinates and height of the ground.
std::string RouteCsv(const std::vector<TraceSample>& trace, const LocalFrame& frame);

/// One row per driven metre that holds the worst of each quantity met in that metre (largest
/// angles by absolute value, slip, sinkage; least clearance and traction reserve), and the place
/// and time at its beginning.
std::vector<TraceSample> WorstPerMeter(const std::vector<TraceSample>& trace);

}  // namespace dbd
