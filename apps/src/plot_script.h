#pragma once

#include <string>
#include <vector>

namespace dbd {

/// A curve in a panel: two columns of a CSV file beside the script.
struct PlotCurve {
  std::string file;
  int x_column = 1;
  int y_column = 2;
  std::string name;        ///< in the legend
  bool reference = false;  ///< drawn broad and pale, below the others
  int color = 0;           ///< of a palette of eight, again from the first after the last
};

struct PlotPanel {
  std::string x_label;
  std::string y_label;
  std::vector<PlotCurve> curves;
  double x_end = 0;  ///< 0: as far as the data go
};

/// One picture: panels one below the other.
struct PlotFigure {
  std::string name;  ///< of its files, without extension
  std::string title;
  std::vector<PlotPanel> panels;
};

/// A gnuplot script that draws `<name>.png` and `<name>.svg`.
std::string PlotScript(const PlotFigure& figure);

}  // namespace dbd
