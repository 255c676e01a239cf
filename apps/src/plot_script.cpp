#include "plot_script.h"

#include <iterator>

#include "gnuplot.h"
#include "text.h"

namespace dbd {
namespace {

constexpr int kWidth = 900;        // [px]
constexpr int kPanelHeight = 300;  // [px]
constexpr int kTitleHeight = 40;   // [px]
constexpr char kFont[] = "'DejaVu Sans,11'";

constexpr char kStyle[] = R"(set encoding utf8
set datafile separator ','
set border 3 linecolor '#555555'
set tics nomirror
set grid linecolor '#dddddd' linetype 1
set key above right horizontal samplen 2 width -1
set lmargin 11
set rmargin 4
)";

/// The first is dark blue; the others are told apart by colour-blind readers too (Okabe & Ito).
constexpr const char* kPalette[] = {"#1d3557", "#e69f00", "#56b4e9", "#009e73",
                                    "#d55e00", "#cc79a7", "#0072b2", "#999999"};

std::string CurveText(const PlotCurve& curve) {
  const std::string color = kPalette[static_cast<std::size_t>(curve.color) % std::size(kPalette)];
  const std::string style = curve.reference ? "linecolor '#f4a261' linewidth 4"
                                            : "linecolor '" + color + "' linewidth 1.5";
  return Format("%s using %d:%d with lines %s title %s", QuoteForGnuplot(curve.file).c_str(),
                curve.x_column, curve.y_column, style.c_str(), QuoteForGnuplot(curve.name).c_str());
}

std::string PanelText(const PlotPanel& panel) {
  std::string text = "set xlabel " + QuoteForGnuplot(panel.x_label) + "\nset ylabel " +
                     QuoteForGnuplot(panel.y_label) + "\n";
  text +=
      panel.x_end > 0 ? Format("set xrange [0:%g]\n", panel.x_end) : "set xrange [*:*] noextend\n";
  std::string curves;
  for (const PlotCurve& curve : panel.curves) {
    curves += (curves.empty() ? "plot " : ", \\\n     ") + CurveText(curve);
  }
  return text + curves + "\n";
}

}  // namespace

std::string PlotScript(const PlotFigure& figure) {
  const int rows = static_cast<int>(figure.panels.size());
  const int height = kTitleHeight + rows * kPanelHeight;
  std::string panels =
      Format("set multiplot layout %d,1 title %s\n", rows, QuoteForGnuplot(figure.title).c_str());
  for (const PlotPanel& panel : figure.panels) panels += PanelText(panel);
  panels += "unset multiplot\n";
  std::string script = kStyle;
  for (const char* format : {"png", "svg"}) {
    const bool png = format == std::string("png");
    script +=
        Format("set terminal %s size %d,%d font %s noenhanced%s\nset output %s\n",
               png ? "pngcairo" : "svg", kWidth, height, kFont, png ? "" : " background '#ffffff'",
               QuoteForGnuplot(figure.name + "." + format).c_str());
    script += panels;
  }
  return script + "unset output\n";
}

}  // namespace dbd
