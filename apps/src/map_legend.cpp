#include "map_legend.h"

#include <cairo.h>

namespace dbd {
namespace {

constexpr double kRowHeight = 26;
constexpr double kTextSize = 14.5;
constexpr double kSwatchWidth = 34;
constexpr double kGap = 24;

}  // namespace

LegendEntry LineEntry(const Stroke& stroke, const std::string& label) {
  return {[stroke](cairo_t* context, const Eigen::Vector2d& center) {
            const Eigen::Vector2d half(kSwatchWidth / 2 - 3, 0);
            DrawPolyline(context, {center - half, center + half}, stroke);
          },
          label};
}

LegendEntry AreaEntry(const Color& color, const std::string& label) {
  return {[color](cairo_t* context, const Eigen::Vector2d& center) {
            cairo_rectangle(context, center.x() - 11, center.y() - 7, 22, 14);
            SetColor(context, color);
            cairo_fill_preserve(context);
            SetColor(context, kInkColor, 0.5);
            cairo_set_line_width(context, 1);
            cairo_stroke(context);
          },
          label};
}

double Legend::Height(cairo_t* context, double width) const {
  return entries_.empty() ? 0 : (Layout(context, width).back().row + 1) * kRowHeight;
}

void Legend::Draw(cairo_t* context, const Eigen::Vector2d& top_left, double width) const {
  const std::vector<Place> places = Layout(context, width);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Eigen::Vector2d center = top_left + Eigen::Vector2d(places[i].left + kSwatchWidth / 2,
                                                              (places[i].row + 0.5) * kRowHeight);
    entries_[i].draw(context, center);
    SetColor(context, kInkColor);
    DrawText(context, center + Eigen::Vector2d(kSwatchWidth / 2 + 6, 0.36 * kTextSize), kTextSize,
             false, entries_[i].label);
  }
}

std::vector<Legend::Place> Legend::Layout(cairo_t* context, double width) const {
  std::vector<Place> places;
  Place next;
  for (const LegendEntry& entry : entries_) {
    const double entry_width = kSwatchWidth + 6 + TextWidth(context, kTextSize, false, entry.label);
    if (next.left > 0 && next.left + entry_width > width) next = {next.row + 1, 0};
    places.push_back(next);
    next.left += entry_width + kGap;
  }
  return places;
}

}  // namespace dbd
