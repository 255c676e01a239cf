#pragma once

#include <dbd/core/trajectory.h>

#include <string>
#include <vector>

#include "gnuplot.h"
#include "output_directory.h"

namespace dbd {

/// A recorded scenario as it is drawn.
struct ScenarioPlots {
  std::string title;
  std::vector<TrajectoryRow> rows;
  std::vector<double> link_force;        ///< one per row, tension positive [N]; empty: not drawn
  std::string link_name;                 ///< which link of the front suspension
  std::vector<TrajectoryRow> reference;  ///< empty: dbd's curves alone
};

/// Writes what the paper's Figs. 10-12 show, as data, gnuplot scripts, PNG and SVG: `motion`
/// (chassis height and pitch against position), `forces` (rear right spring and front link against
/// time), `spectrum` (amplitudes of the vertical chassis acceleration from t = 2 s on). Throws
/// InputError when gnuplot fails, and when the reference's rows are not evenly spaced in time.
void WriteScenarioPlots(const ScenarioPlots& plots, const Gnuplot& gnuplot,
                        OutputDirectory* output);

/// All files that it may write.
std::vector<std::string> ScenarioPlotFiles();

}  // namespace dbd
