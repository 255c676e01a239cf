#include "scene_plots.h"

#include <algorithm>

#include "plot_script.h"
#include "text.h"

namespace dbd {
namespace {

constexpr int kMostCurves = 8;  // vehicles that are drawn: more cannot be told apart

int CountVehicles(const std::vector<SceneRow>& rows) {
  int last = 0;
  for (const SceneRow& row : rows) last = std::max(last, row.vehicle);
  return last + 1;
}

/// Time, then one column per vehicle and signal: speeds, gaps, drawbar forces.
std::string Table(const std::vector<SceneRow>& rows, int vehicles) {
  std::string table = "# t [s], then of each vehicle: speed [m/s], gap [m], drawbar [kN]\n";
  for (const SceneRow& row : rows) {
    if (row.vehicle == 0) table += Format("%.3f", row.t);
    table += Format(",%.4f,%.4f,%.4f", row.speed, row.gap, 1e-3 * row.drawbar_force);
    if (row.vehicle + 1 == vehicles) table += '\n';
  }
  return table;
}

/// `signal`: 0 speed, 1 gap, 2 drawbar force.
PlotPanel Panel(const std::string& label, int signal, int first, int vehicles) {
  PlotPanel panel{"time [s]", label, {}};
  for (int vehicle = first; vehicle < std::min(vehicles, kMostCurves); ++vehicle) {
    PlotCurve curve{"scene.csv", 1, 2 + 3 * vehicle + signal, std::to_string(vehicle + 1)};
    curve.color = vehicle;
    panel.curves.push_back(curve);
  }
  return panel;
}

}  // namespace

void WriteScenePlots(const std::string& title, const std::vector<SceneRow>& rows,
                     const Gnuplot& gnuplot, OutputDirectory* output) {
  const int vehicles = CountVehicles(rows);
  const bool tows = std::any_of(rows.begin(), rows.end(),
                                [](const SceneRow& row) { return row.drawbar_force != 0; });
  PlotFigure figure{"scene", title, {Panel("speed [m/s]", 0, 0, vehicles)}};
  if (tows) {
    figure.panels.push_back(Panel("drawbar, tension [kN]", 2, 1, vehicles));
  } else if (vehicles > 1) {
    figure.panels.push_back(Panel("gap to the vehicle ahead [m]", 1, 1, vehicles));
  }
  WriteTextFile(output->Stage("scene.csv"), Table(rows, vehicles));
  output->Stage("scene.png");
  output->Stage("scene.svg");
  const auto script = output->Stage("scene.gp");
  WriteTextFile(script, PlotScript(figure));
  gnuplot.Run(script);
}

std::vector<std::string> ScenePlotFiles() {
  return {"scene.csv", "scene.gp", "scene.png", "scene.svg"};
}

}  // namespace dbd
