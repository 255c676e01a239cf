#include "scenario_plots.h"

#include <dbd/core/error.h>
#include <dbd/core/spectrum.h>
#include <dbd/core/units.h>

#include <cmath>

#include "plot_script.h"
#include "text.h"

namespace dbd {
namespace {

constexpr double kSpectrumFrom = 2.0;     // [s] the vehicle stands until then
constexpr double kSpectrumEnd = 30.0;     // [Hz] wheel hop is near 17 Hz
constexpr std::size_t kLeastSamples = 8;  // of a spectrum

/// Columns: time, position, height, pitch, spring force, link force.
std::string DriveTable(const std::vector<TrajectoryRow>& rows, const std::vector<double>& link) {
  std::string table = "# t [s], x [m], z [m], pitch [deg], spring [kN], link [kN]\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TrajectoryRow& row = rows[i];
    table += Format("%.4f,%.5f,%.6f,%.5f,%.5f", row.t, row.x_cg, row.z_cg, ToDegrees(row.pitch),
                    1e-3 * row.spring_force[3]);
    if (!link.empty()) table += Format(",%.5f", 1e-3 * link[i]);
    table += '\n';
  }
  return table;
}

/// Time step of rows that are evenly spaced.
double StepOf(const std::vector<TrajectoryRow>& rows) {
  const double step = (rows.back().t - rows.front().t) / static_cast<double>(rows.size() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (std::abs(rows[i].t - rows.front().t - static_cast<double>(i) * step) > 0.1 * step) {
      throw InputError("--compare: rows must be evenly spaced in time for the spectrum");
    }
  }
  return step;
}

/// Columns: frequency, amplitude of the chassis' vertical acceleration.
std::string SpectrumTable(const std::vector<TrajectoryRow>& rows) {
  std::string table = "# frequency [Hz], amplitude [m/s^2]\n";
  const double step = StepOf(rows);
  std::vector<double> heights;
  for (const TrajectoryRow& row : rows) {
    if (row.t >= kSpectrumFrom) heights.push_back(row.z_cg);
  }
  if (heights.size() < kLeastSamples + 2) return table;
  for (const SpectrumLine& line : AmplitudeSpectrum(SecondDerivative(heights, step), step)) {
    table += Format("%.5f,%.6g\n", line.frequency, line.amplitude);
  }
  return table;
}

class Figures {
 public:
  explicit Figures(const ScenarioPlots& plots) : plots_(plots) {}

  PlotFigure Motion() const {
    return {"motion",
            plots_.title + ": chassis, centre of mass",
            {Panel("position [m]", "height [m]", "drive", 2, 3),
             Panel("position [m]", "pitch, nose down [deg]", "drive", 2, 4)}};
  }

  PlotFigure Forces() const {
    PlotFigure figure{"forces",
                      plots_.title + ": forces",
                      {Panel("time [s]", "rear right spring [kN]", "drive", 1, 5)}};
    if (!plots_.link_force.empty()) {
      PlotPanel link{
          "time [s]", "tension of a link [kN]", {{"drive.csv", 1, 6, "dbd, " + plots_.link_name}}};
      figure.panels.push_back(link);
    }
    return figure;
  }

  PlotFigure Spectrum() const {
    PlotPanel panel = Panel("frequency [Hz]", "amplitude [m/s²]", "spectrum", 1, 2);
    panel.x_end = kSpectrumEnd;
    return {"spectrum", plots_.title + ": vertical acceleration of the chassis", {panel}};
  }

 private:
  PlotPanel Panel(const std::string& x_label, const std::string& y_label, const std::string& data,
                  int x_column, int y_column) const {
    PlotPanel panel{x_label, y_label, {}};
    if (!plots_.reference.empty()) {
      panel.curves.push_back({"reference-" + data + ".csv", x_column, y_column, "reference", true});
    }
    panel.curves.push_back({data + ".csv", x_column, y_column, "dbd"});
    return panel;
  }

  const ScenarioPlots& plots_;
};

}  // namespace

void WriteScenarioPlots(const ScenarioPlots& plots, const Gnuplot& gnuplot,
                        OutputDirectory* output) {
  const auto write = [output](const std::string& name, const std::string& text) {
    WriteTextFile(output->Stage(name), text);
  };
  write("drive.csv", DriveTable(plots.rows, plots.link_force));
  write("spectrum.csv", SpectrumTable(plots.rows));
  if (!plots.reference.empty()) {
    write("reference-drive.csv", DriveTable(plots.reference, {}));
    write("reference-spectrum.csv", SpectrumTable(plots.reference));
  }
  const Figures figures(plots);
  for (const PlotFigure& figure : {figures.Motion(), figures.Forces(), figures.Spectrum()}) {
    output->Stage(figure.name + ".png");
    output->Stage(figure.name + ".svg");
    const auto script = output->Stage(figure.name + ".gp");
    WriteTextFile(script, PlotScript(figure));
    gnuplot.Run(script);
  }
}

std::vector<std::string> ScenarioPlotFiles() {
  std::vector<std::string> files{"drive.csv", "spectrum.csv", "reference-drive.csv",
                                 "reference-spectrum.csv"};
  for (const char* name : {"motion", "forces", "spectrum"}) {
    for (const char* extension : {".gp", ".png", ".svg"}) {
      files.push_back(std::string(name) + extension);
    }
  }
  return files;
}

}  // namespace dbd
