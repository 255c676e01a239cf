#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "map_style.h"

using cairo_t = struct _cairo;

namespace dbd {

// Drawing on a cairo context, in pixels. A few shapes that maps are made of.

enum class TextAlign { kLeft, kCenter, kRight };

void SetColor(cairo_t* context, const Color& color, double alpha = 1);

/// `at`: on the base line.
void DrawText(cairo_t* context, const Eigen::Vector2d& at, double size, bool bold,
              const std::string& text, TextAlign align = TextAlign::kLeft);
double TextWidth(cairo_t* context, double size, bool bold, const std::string& text);

struct Stroke {
  Color color;
  double width = 1;
  double alpha = 1;
  double casing = 0;  ///< width of a white edge on each side
};
void DrawPolyline(cairo_t* context, const std::vector<Eigen::Vector2d>& points,
                  const Stroke& stroke);

void DrawStartSymbol(cairo_t* context, const Eigen::Vector2d& at, double radius);

/// A flag whose pole stands at the place.
void DrawGoalSymbol(cairo_t* context, const Eigen::Vector2d& at, double radius);
void DrawCrossSymbol(cairo_t* context, const Eigen::Vector2d& at, double radius,
                     const Color& color);
void DrawDot(cairo_t* context, const Eigen::Vector2d& at, double radius, const Color& color);
void DrawNorthArrow(cairo_t* context, const Eigen::Vector2d& center, double radius);

/// A bar of a round length at most `max_width` pixels long, right end at `right`.
void DrawScaleBar(cairo_t* context, const Eigen::Vector2d& right, double max_width,
                  double pixel_size);

/// The largest of 1, 2, 5 times a power of ten that is at most `length`.
double RoundLength(double length);

}  // namespace dbd
