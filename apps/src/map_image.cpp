#include "map_image.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "map_canvas.h"
#include "map_legend.h"
#include "map_view.h"
#include "png_file.h"
#include "relief.h"
#include "text.h"

namespace dbd {
namespace {

constexpr double kPadding = 22;
constexpr double kScaleWidth = 300;  // of the strip's part with scale bar and north arrow
constexpr double kLeastFooter = 70;
constexpr std::size_t kMostMaterialEntries = 8;
constexpr Stroke kRouteStroke{kRouteColor, 5.5, 1, 2.5};

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

Surface MakeSurface(int width, int height) {
  return {cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), &cairo_surface_destroy};
}

Context MakeContext(const Surface& surface) {
  return {cairo_create(surface.get()), &cairo_destroy};
}

std::vector<Eigen::Vector2d> PointsOfInterest(const MapContent& content) {
  std::vector<Eigen::Vector2d> points = content.route;
  for (const MapLine& line : content.candidates) {
    points.insert(points.end(), line.points.begin(), line.points.end());
  }
  for (const auto& place : {content.start, content.goal, content.blocked}) {
    if (place) points.push_back(*place);
  }
  return points;
}

std::string OutcomeLabel(Outcome outcome, int count) {
  std::string label = OutcomeName(outcome);
  std::replace(label.begin(), label.end(), '_', ' ');
  return Format("%s (%d)", label.c_str(), count);
}

Stroke CandidateStroke(Outcome outcome) { return {OutcomeColor(outcome), 1.8, 0.85, 0}; }

void AddLineEntries(const MapContent& content, std::vector<LegendEntry>* entries) {
  if (!content.route.empty()) entries->push_back(LineEntry(kRouteStroke, "driven route"));
  std::map<Outcome, int> counts;
  for (const MapLine& line : content.candidates) ++counts[line.outcome];
  for (const auto& [outcome, count] : counts) {
    Stroke stroke = CandidateStroke(outcome);
    stroke.width = 3;
    entries->push_back(LineEntry(stroke, OutcomeLabel(outcome, count)));
  }
}

void AddPlaceEntries(const MapContent& content, std::vector<LegendEntry>* entries) {
  if (content.start) {
    entries->push_back(
        {[](cairo_t* c, const Eigen::Vector2d& p) { DrawStartSymbol(c, p, 7); }, "start"});
  }
  if (content.goal) {
    entries->push_back({[](cairo_t* c, const Eigen::Vector2d& p) {
                          DrawGoalSymbol(c, p + Eigen::Vector2d(-4, 9), 7);
                        },
                        "goal"});
  }
  if (content.blocked) {
    entries->push_back(
        {[](cairo_t* c, const Eigen::Vector2d& p) { DrawCrossSymbol(c, p, 6, kBlockedColor); },
         "blocked here"});
  }
}

void AddGroundEntries(const Terrain& terrain, const ReliefImage& relief,
                      std::vector<LegendEntry>* entries) {
  if (!terrain.obstacles().empty()) entries->push_back(AreaEntry(kObstacleColor, "obstacle"));
  for (std::size_t i = 0; i < std::min(relief.materials.size(), kMostMaterialEntries); ++i) {
    const Material& material = *relief.materials[i];
    entries->push_back(AreaEntry(MaterialTint(material, i), material.name));
  }
  if (terrain.heights().unknown_share() > 0) {
    entries->push_back(AreaEntry(kUnknownColor, "unknown"));
  }
  if (relief.contour_interval > 0) {
    const Stroke stroke{Hex(0x8a7662), 1.2, 1, 0};
    entries->push_back(LineEntry(stroke, Format("contour, %g m", relief.contour_interval)));
  }
}

Legend MakeLegend(const Terrain& terrain, const MapContent& content, const ReliefImage& relief) {
  std::vector<LegendEntry> entries;
  AddLineEntries(content, &entries);
  AddPlaceEntries(content, &entries);
  AddGroundEntries(terrain, relief, &entries);
  return Legend(std::move(entries));
}

void DrawRelief(cairo_t* context, ReliefImage* relief) {
  auto* bytes = reinterpret_cast<unsigned char*>(relief->pixels.data());
  const Surface surface(
      cairo_image_surface_create_for_data(bytes, CAIRO_FORMAT_RGB24, relief->width, relief->height,
                                          relief->width * 4),
      &cairo_surface_destroy);
  cairo_set_source_surface(context, surface.get(), 0, 0);
  cairo_paint(context);
}

std::vector<Eigen::Vector2d> ToPixels(const MapView& view,
                                      const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> pixels;
  pixels.reserve(points.size());
  for (const Eigen::Vector2d& point : points) pixels.push_back(view.ToPixel(point));
  return pixels;
}

/// Failures below, successes above, the chosen route on top, symbols last.
void DrawContent(cairo_t* context, const MapView& view, const MapContent& content) {
  for (const bool reached : {false, true}) {
    for (const MapLine& line : content.candidates) {
      if ((line.outcome == Outcome::kReached) != reached) continue;
      DrawPolyline(context, ToPixels(view, line.points), CandidateStroke(line.outcome));
    }
  }
  DrawPolyline(context, ToPixels(view, content.route), kRouteStroke);
  for (const MapLine& line : content.candidates) {
    if (line.outcome == Outcome::kReached) continue;
    DrawDot(context, view.ToPixel(line.end), 3.5, OutcomeColor(line.outcome));
  }
  if (content.start) DrawStartSymbol(context, view.ToPixel(*content.start), 10);
  if (content.goal) DrawGoalSymbol(context, view.ToPixel(*content.goal), 12);
  if (content.blocked) DrawCrossSymbol(context, view.ToPixel(*content.blocked), 11, kBlockedColor);
}

/// The text, shortened at a word with an ellipsis where it is wider than `width`.
std::string Fitted(cairo_t* context, std::string text, double size, bool bold, double width) {
  if (TextWidth(context, size, bold, text) <= width) return text;
  while (!text.empty() && TextWidth(context, size, bold, text + " …") > width) {
    const std::size_t space = text.rfind(' ');
    text.resize(space == std::string::npos ? 0 : space);
  }
  return text + " …";
}

void DrawTitle(cairo_t* context, const MapContent& content, double width) {
  SetColor(context, kInkColor);
  DrawText(context, {kPadding, 36}, 25, true, Fitted(context, content.title, 25, true, width));
  SetColor(context, kInkColor, 0.75);
  DrawText(context, {kPadding, 62}, 15, false, Fitted(context, content.subtitle, 15, false, width));
}

void DrawFooter(cairo_t* context, const MapView& view, const Legend& legend, double height) {
  const double top = kMapTitleHeight + view.height;
  const double legend_width = view.width - kScaleWidth - 3 * kPadding;
  const double legend_height = legend.Height(context, legend_width);
  legend.Draw(context, {kPadding - 6, top + (height - legend_height) / 2}, legend_width);
  const double middle = top + height / 2;
  DrawScaleBar(context, {view.width - kPadding - 46, middle + 13}, kScaleWidth - 70,
               view.pixel_size);
  DrawNorthArrow(context, {view.width - kPadding - 14, middle - 8}, 17);
}

void DrawMap(cairo_t* context, const MapView& view, const MapContent& content,
             ReliefImage* relief) {
  cairo_save(context);
  cairo_translate(context, 0, kMapTitleHeight);
  cairo_rectangle(context, 0, 0, view.width, view.height);
  cairo_clip(context);
  DrawRelief(context, relief);
  DrawContent(context, view, content);
  cairo_restore(context);
}

}  // namespace

MapLayout WriteMapImage(const std::filesystem::path& file, const Terrain& terrain,
                        const MapContent& content) {
  const MapView view = FitView(terrain.heights(), PointsOfInterest(content), kMapImageWidth);
  ReliefImage relief = RenderRelief(terrain, view, content.obstacle_height);
  const Legend legend = MakeLegend(terrain, content, relief);
  const double legend_height =
      legend.Height(MakeContext(MakeSurface(1, 1)).get(), view.width - kScaleWidth - 3 * kPadding);
  const double footer = std::max(kLeastFooter, std::ceil(legend_height + 20));
  const MapLayout layout{view, kMapTitleHeight, view.width,
                         kMapTitleHeight + view.height + static_cast<int>(footer)};
  const Surface surface = MakeSurface(layout.width, layout.height);
  const Context context = MakeContext(surface);
  SetColor(context.get(), kPaperColor);
  cairo_paint(context.get());
  DrawTitle(context.get(), content, view.width - 2 * kPadding);
  DrawMap(context.get(), view, content, &relief);
  DrawFooter(context.get(), view, legend, footer);
  cairo_surface_flush(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  const auto* pixels =
      reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(surface.get()));
  WritePng(file, {layout.width, layout.height, stride / sizeof *pixels, pixels});
  return layout;
}

}  // namespace dbd
