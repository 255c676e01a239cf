#include "plot_script.h"

#include <gmock/gmock.h>

namespace dbd {
namespace {

using testing::HasSubstr;
using testing::Not;

PlotFigure TwoPanels() {
  PlotFigure figure{"forces", "Drive", {}};
  figure.panels.push_back({"time [s]", "force [N]", {{"a.csv", 1, 5, "dbd"}}});
  figure.panels.push_back({"frequency [Hz]", "amplitude [m]", {{"b.csv", 1, 2, "dbd"}}, 30});
  return figure;
}

TEST(PlotScript, DrawsEveryPanelInBothFormats) {
  const std::string script = PlotScript(TwoPanels());
  EXPECT_THAT(script, HasSubstr("set output 'forces.png'"));
  EXPECT_THAT(script, HasSubstr("set output 'forces.svg'"));
  EXPECT_THAT(script, HasSubstr("set multiplot layout 2,1 title 'Drive'"));
  EXPECT_THAT(script, HasSubstr("set ylabel 'force [N]'"));
  EXPECT_THAT(script, HasSubstr("plot 'a.csv' using 1:5 with lines"));
  EXPECT_THAT(script, HasSubstr("set xrange [0:30]\nplot 'b.csv' using 1:2"));
}

TEST(PlotScript, DrawsTheReferenceFirstAndBroader) {
  PlotFigure figure = TwoPanels();
  figure.panels.resize(1);
  figure.panels[0].curves.insert(figure.panels[0].curves.begin(),
                                 {"r.csv", 1, 5, "reference", true});
  const std::string script = PlotScript(figure);
  const std::size_t reference = script.find(
      "plot 'r.csv' using 1:5 with lines linecolor '#f4a261' linewidth 4 title 'reference', \\\n   "
      "  'a.csv'");
  EXPECT_NE(reference, std::string::npos) << script;
}

TEST(PlotScript, TextsAreNotExpanded) {
  PlotFigure figure = TwoPanels();
  figure.title = "Joe's `touch x`\nset output 'y'";
  const std::string script = PlotScript(figure);
  EXPECT_THAT(script, HasSubstr("title 'Joe''s `touch x` set output ''y'''\n"));
  EXPECT_THAT(script, Not(HasSubstr("\nset output 'y'")));
}

}  // namespace
}  // namespace dbd
