#include "map_canvas.h"

#include <cairo.h>

#include <cmath>
#include <numbers>

#include "text.h"

namespace dbd {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

void SelectFont(cairo_t* context, double size, bool bold) {
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
}

void TracePolyline(cairo_t* context, const std::vector<Eigen::Vector2d>& points) {
  cairo_new_path(context);
  for (const Eigen::Vector2d& point : points) cairo_line_to(context, point.x(), point.y());
}

/// Fills and edges the current path, so that a symbol stands out from any ground.
void FillWithEdge(cairo_t* context, const Color& fill, double edge_width) {
  cairo_set_line_width(context, edge_width);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  SetColor(context, kPaperColor);
  cairo_stroke_preserve(context);
  SetColor(context, fill);
  cairo_fill(context);
}

}  // namespace

void SetColor(cairo_t* context, const Color& color, double alpha) {
  cairo_set_source_rgba(context, color.red, color.green, color.blue, alpha);
}

void DrawText(cairo_t* context, const Eigen::Vector2d& at, double size, bool bold,
              const std::string& text, TextAlign align) {
  const double width = align == TextAlign::kLeft ? 0 : TextWidth(context, size, bold, text);
  const double shift = align == TextAlign::kCenter ? width / 2 : width;
  SelectFont(context, size, bold);
  cairo_move_to(context, at.x() - shift, at.y());
  cairo_show_text(context, text.c_str());
}

double TextWidth(cairo_t* context, double size, bool bold, const std::string& text) {
  SelectFont(context, size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

void DrawPolyline(cairo_t* context, const std::vector<Eigen::Vector2d>& points,
                  const Stroke& stroke) {
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  TracePolyline(context, points);
  if (stroke.casing > 0) {
    SetColor(context, kPaperColor, stroke.alpha);
    cairo_set_line_width(context, stroke.width + 2 * stroke.casing);
    cairo_stroke_preserve(context);
  }
  SetColor(context, stroke.color, stroke.alpha);
  cairo_set_line_width(context, stroke.width);
  cairo_stroke(context);
}

void DrawDot(cairo_t* context, const Eigen::Vector2d& at, double radius, const Color& color) {
  cairo_new_path(context);
  cairo_arc(context, at.x(), at.y(), radius, 0, kFullTurn);
  FillWithEdge(context, color, 0.5 * radius);
}

void DrawStartSymbol(cairo_t* context, const Eigen::Vector2d& at, double radius) {
  DrawDot(context, at, radius, kStartColor);
  cairo_new_path(context);
  cairo_arc(context, at.x(), at.y(), 0.4 * radius, 0, kFullTurn);
  SetColor(context, kPaperColor);
  cairo_fill(context);
}

void DrawGoalSymbol(cairo_t* context, const Eigen::Vector2d& at, double radius) {
  const double pole = 0.18 * radius;
  cairo_new_path(context);
  cairo_move_to(context, at.x() - pole, at.y());
  cairo_rel_line_to(context, 0, -2.6 * radius);
  cairo_rel_line_to(context, 1.9 * radius, 0.6 * radius);
  cairo_rel_line_to(context, -1.9 * radius + 2 * pole, 0.65 * radius);
  cairo_rel_line_to(context, 0, 1.35 * radius);
  cairo_close_path(context);
  FillWithEdge(context, kGoalColor, 0.45 * radius);
  DrawDot(context, at, 0.36 * radius, kGoalColor);
}

void DrawCrossSymbol(cairo_t* context, const Eigen::Vector2d& at, double radius,
                     const Color& color) {
  const Stroke stroke{color, 0.5 * radius, 1, 0};
  const Stroke edge{kPaperColor, 0.95 * radius, 1, 0};
  const Eigen::Vector2d down(radius, radius);
  const Eigen::Vector2d up(radius, -radius);
  for (const Stroke& layer : {edge, stroke}) {
    DrawPolyline(context, {at - down, at + down}, layer);
    DrawPolyline(context, {at - up, at + up}, layer);
  }
}

void DrawNorthArrow(cairo_t* context, const Eigen::Vector2d& center, double radius) {
  cairo_new_path(context);
  cairo_move_to(context, center.x(), center.y() - radius);
  cairo_rel_line_to(context, 0.5 * radius, 1.7 * radius);
  cairo_rel_line_to(context, -0.5 * radius, -0.4 * radius);
  cairo_rel_line_to(context, -0.5 * radius, 0.4 * radius);
  cairo_close_path(context);
  SetColor(context, kInkColor);
  cairo_fill(context);
  DrawText(context, {center.x(), center.y() + 1.65 * radius}, 0.9 * radius, true, "N",
           TextAlign::kCenter);
}

double RoundLength(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= length) return factor * power;
  }
  return power;
}

void DrawScaleBar(cairo_t* context, const Eigen::Vector2d& right, double max_width,
                  double pixel_size) {
  constexpr double kHeight = 8;
  constexpr int kParts = 4;
  const double meters = RoundLength(max_width * pixel_size);
  const double part = meters / pixel_size / kParts;
  const double left = right.x() - kParts * part;
  cairo_new_path(context);
  cairo_rectangle(context, left, right.y() - kHeight, kParts * part, kHeight);
  SetColor(context, kPaperColor);
  cairo_fill_preserve(context);
  SetColor(context, kInkColor);
  cairo_set_line_width(context, 1.2);
  cairo_stroke(context);
  for (int i = 0; i < kParts; i += 2) {
    cairo_rectangle(context, left + i * part, right.y() - kHeight, part, kHeight);
  }
  cairo_fill(context);
  const std::string unit = meters >= 1000 ? Format("%g km", meters / 1000) : Format("%g m", meters);
  DrawText(context, {left, right.y() - kHeight - 6}, 14, false, "0", TextAlign::kCenter);
  DrawText(context, {right.x(), right.y() - kHeight - 6}, 14, false, unit, TextAlign::kRight);
}

}  // namespace dbd
