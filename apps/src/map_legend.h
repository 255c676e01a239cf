#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "map_canvas.h"

namespace dbd {

/// One entry: a swatch drawn round a centre, and what it means.
struct LegendEntry {
  std::function<void(cairo_t*, const Eigen::Vector2d& center)> draw;
  std::string label;
};

LegendEntry LineEntry(const Stroke& stroke, const std::string& label);
LegendEntry AreaEntry(const Color& color, const std::string& label);

/// Entries laid out in rows, left to right, as many in a row as fit.
class Legend {
 public:
  explicit Legend(std::vector<LegendEntry> entries) : entries_(std::move(entries)) {}

  /// Height in pixels when laid out in rows of at most `width`.
  double Height(cairo_t* context, double width) const;
  void Draw(cairo_t* context, const Eigen::Vector2d& top_left, double width) const;

 private:
  /// Row and left edge of every entry.
  struct Place {
    int row = 0;
    double left = 0;
  };
  std::vector<Place> Layout(cairo_t* context, double width) const;

  std::vector<LegendEntry> entries_;
};

}  // namespace dbd
