#include <dbd/core/error.h>
#include <dbd/core/internal/clamp_index.h>
#include <dbd/terrain/tin_surface.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace dbd {
namespace {

using Triangle = TinSurface::Triangle;

// Twice the area seen from above, positive when counter-clockwise [m^2].
double TwiceArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Smaller than this is a wall or a sliver [m^2].
constexpr double kLeastTwiceArea = 1e-8;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Edges that belong to one triangle only.
std::vector<Edge> BoundaryEdges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) edges.push_back(std::minmax({t[k], t[(k + 1) % 3]}));
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> boundary;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    if (next == i + 1) boundary.push_back(edges[i]);
    i = next;
  }
  return boundary;
}

// Groups of edges that hang together by their ends.
std::size_t CountConnected(const std::vector<Edge>& edges) {
  std::map<std::uint32_t, std::uint32_t> parent;
  const auto root = [&](std::uint32_t vertex) {
    while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
  };
  for (const auto& [a, b] : edges) {
    parent.try_emplace(a, a);
    parent.try_emplace(b, b);
    parent[root(a)] = root(b);
  }
  return static_cast<std::size_t>(std::count_if(
      parent.begin(), parent.end(), [](const auto& entry) { return entry.first == entry.second; }));
}

LinearFunction<float> Function(const Eigen::Vector2d& gradient, double constant) {
  return {static_cast<float>(gradient.x()), static_cast<float>(gradient.y()),
          static_cast<float>(constant)};
}

// Of counter-clockwise corners.
GroundFacet MakeFacet(const std::array<Eigen::Vector3d, 3>& p, std::uint32_t triangle) {
  GroundFacet facet;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d d = (p[(k + 1) % 3] - p[k]).head<2>();
    const Eigen::Vector2d inward = Eigen::Vector2d(-d.y(), d.x()).normalized();
    facet.edges[k] = Function(inward, -inward.dot(p[k].head<2>()));
  }
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
  const Eigen::Vector2d gradient = -normal.head<2>() / normal.z();
  facet.height = Function(gradient, p[0].z() - gradient.dot(p[0].head<2>()));
  facet.triangle = triangle;
  return facet;
}

}  // namespace

TinSurface::TinSurface(std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> triangles) {
  const std::size_t given = triangles.size();
  std::erase_if(triangles, [&](const Triangle& t) {
    return std::abs(TwiceArea(vertices[t[0]], vertices[t[1]], vertices[t[2]])) < kLeastTwiceArea;
  });
  if (triangles.empty()) throw InputError("no triangle of the mesh has an area seen from above");
  report_.vertical = given - triangles.size();
  report_.triangles = triangles.size();
  for (Triangle& t : triangles) {
    if (TwiceArea(vertices[t[0]], vertices[t[1]], vertices[t[2]]) < 0) std::swap(t[1], t[2]);
  }
  Measure(vertices, triangles);
  const std::vector<std::uint32_t> in_bins = MakeBins(vertices, triangles);
  FindHighest(vertices, triangles, in_bins);
  FillBins(vertices, triangles, in_bins);
  FindRims(vertices, triangles);
  SampleOverlaps();
}

void TinSurface::Measure(const std::vector<Eigen::Vector3d>& vertices,
                         const std::vector<Triangle>& triangles) {
  Eigen::Vector3d low = vertices[triangles[0][0]];
  Eigen::Vector3d high = low;
  double area = 0;
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) {
      low = low.cwiseMin(vertices[v]);
      high = high.cwiseMax(vertices[v]);
    }
    area += 0.5 * TwiceArea(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }
  low_ = low.head<2>();
  high_ = high.head<2>();
  base_height_ = std::round(low.z());
  // In a mesh of n triangles there are about n / 2 vertices.
  spacing_ = std::sqrt(2 * area / static_cast<double>(triangles.size()));
}

template <class Visit>
void TinSurface::VisitBins(std::initializer_list<Eigen::Vector3d> places,
                           const Visit& visit) const {
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;
  for (const Eigen::Vector3d& p : places) {
    const Eigen::Array2d place = (p.head<2>() - low_).array();
    low = low.min((place - double{kFacetSeam}) / bin_size_);
    high = high.max((place + double{kFacetSeam}) / bin_size_);
  }
  const int last_column = std::min(bin_columns_ - 1, static_cast<int>(high.x()));
  const int last_row = std::min(bin_rows_ - 1, static_cast<int>(high.y()));
  for (int row = std::max(0, static_cast<int>(low.y())); row <= last_row; ++row) {
    for (int column = std::max(0, static_cast<int>(low.x())); column <= last_column; ++column) {
      visit(static_cast<std::size_t>(row) * bin_columns_ + column);
    }
  }
}

std::vector<std::uint32_t> TinSurface::MakeBins(const std::vector<Eigen::Vector3d>& vertices,
                                                const std::vector<Triangle>& triangles) {
  constexpr double kMostBins = 5e7;
  const Eigen::Vector2d size = high_ - low_;
  bin_size_ = std::max(spacing_, std::sqrt(size.prod() / kMostBins));
  bin_columns_ = static_cast<int>(size.x() / bin_size_) + 1;
  bin_rows_ = static_cast<int>(size.y() / bin_size_) + 1;
  bin_begin_.assign(static_cast<std::size_t>(bin_columns_) * bin_rows_ + 1, 0);
  const auto for_each_bin = [&](const Triangle& t, const auto& visit) {
    VisitBins({vertices[t[0]], vertices[t[1]], vertices[t[2]]}, visit);
  };
  for (const Triangle& t : triangles) for_each_bin(t, [&](std::size_t b) { ++bin_begin_[b + 1]; });
  for (std::size_t b = 1; b < bin_begin_.size(); ++b) bin_begin_[b] += bin_begin_[b - 1];
  std::vector<std::uint32_t> in_bins(bin_begin_.back());
  std::vector<std::uint32_t> next(bin_begin_.begin(), bin_begin_.end() - 1);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for_each_bin(triangles[i],
                 [&](std::size_t b) { in_bins[next[b]++] = static_cast<std::uint32_t>(i); });
  }
  return in_bins;
}

// Relative to the corner of the bin, so that floats are exact to a micrometre on any extent.
void TinSurface::FillBins(const std::vector<Eigen::Vector3d>& vertices,
                          const std::vector<Triangle>& triangles,
                          const std::vector<std::uint32_t>& in_bins) {
  bin_facets_.reserve(in_bins.size());
  for (std::size_t b = 0; b + 1 < bin_begin_.size(); ++b) {
    const auto column = static_cast<double>(b % static_cast<std::size_t>(bin_columns_));
    const auto row = static_cast<double>(b / static_cast<std::size_t>(bin_columns_));
    const Eigen::Vector3d corner(low_.x() + column * bin_size_, low_.y() + row * bin_size_,
                                 base_height_);
    for (std::uint32_t i = bin_begin_[b]; i < bin_begin_[b + 1]; ++i) {
      const Triangle& t = triangles[in_bins[i]];
      bin_facets_.push_back(MakeFacet(
          {vertices[t[0]] - corner, vertices[t[1]] - corner, vertices[t[2]] - corner}, in_bins[i]));
    }
  }
}

void TinSurface::FindHighest(const std::vector<Eigen::Vector3d>& vertices,
                             const std::vector<Triangle>& triangles,
                             const std::vector<std::uint32_t>& in_bins) {
  const auto none = -std::numeric_limits<float>::infinity();
  const auto bin_at = [this](int column, int row) {
    return static_cast<std::size_t>(row) * bin_columns_ + column;
  };
  std::vector<float> highest(bin_begin_.size() - 1, none);
  for (std::size_t b = 0; b < highest.size(); ++b) {
    for (std::uint32_t i = bin_begin_[b]; i < bin_begin_[b + 1]; ++i) {
      for (const std::uint32_t v : triangles[in_bins[i]]) {
        highest[b] = std::max(highest[b], static_cast<float>(vertices[v].z() - base_height_));
      }
    }
  }
  highest_nearby_.assign(highest.size(), none);
  for (int row = 0; row < bin_rows_; ++row) {
    for (int column = 0; column < bin_columns_; ++column) {
      float& best = highest_nearby_[bin_at(column, row)];
      for (int r = std::max(0, row - 1); r <= std::min(bin_rows_ - 1, row + 1); ++r) {
        for (int c = std::max(0, column - 1); c <= std::min(bin_columns_ - 1, column + 1); ++c) {
          best = std::max(best, highest[bin_at(c, r)]);
        }
      }
    }
  }
}

double TinSurface::HighestWithin(double radius, double x, double y) const {
  // Each bin answers for its neighbours too, so one less ring is read.
  const double rings = std::clamp(std::ceil(radius / bin_size_) - 1.0, 0.0, 1e6);
  const auto bin_of = [this](double distance, int count) {
    return static_cast<int>(internal::ClampIndex(distance / bin_size_, count - 1.0));
  };
  const int reach = static_cast<int>(rings);
  const int column = bin_of(x - low_.x(), bin_columns_);
  const int row = bin_of(y - low_.y(), bin_rows_);
  float highest = -std::numeric_limits<float>::infinity();
  for (int r = std::max(0, row - reach); r <= std::min(bin_rows_ - 1, row + reach); ++r) {
    for (int c = std::max(0, column - reach); c <= std::min(bin_columns_ - 1, column + reach);
         ++c) {
      highest = std::max(highest, highest_nearby_[static_cast<std::size_t>(r) * bin_columns_ + c]);
    }
  }
  return base_height_ + double{highest};
}

void TinSurface::FindRims(const std::vector<Eigen::Vector3d>& vertices,
                          const std::vector<Triangle>& triangles) {
  const std::vector<Edge> boundary = BoundaryEdges(triangles);
  report_.boundary_edges = boundary.size();
  const std::size_t rims = CountConnected(boundary);
  report_.holes = rims > 0 ? rims - 1 : 0;
  bin_has_rim_.assign(bin_begin_.size() - 1, 0);
  for (const Edge& edge : boundary) {
    VisitBins({vertices[edge.first], vertices[edge.second]},
              [this](std::size_t bin) { bin_has_rim_[bin] = 1; });
  }
}

void TinSurface::SampleOverlaps() {
  constexpr int kAcross = 200;
  int covered = 0;
  int several = 0;
  for (int row = 0; row < kAcross; ++row) {
    for (int column = 0; column < kAcross; ++column) {
      const Eigen::Array2d share = Eigen::Array2d(column + 0.5, row + 0.5) / kAcross;
      const Eigen::Array2d place = low_.array() + share * (high_ - low_).array();
      const int sheets = CountSheets(place.x(), place.y());
      covered += sheets > 0;
      several += sheets > 1;
    }
  }
  report_.overlap_share = covered > 0 ? static_cast<double>(several) / covered : 0;
}

template <class Visit>
void TinSurface::VisitHeights(double x, double y, float seam, const Visit& visit) const {
  const double u = x - low_.x();
  const double v = y - low_.y();
  const bool inside = u >= 0 && v >= 0 && x <= high_.x() && y <= high_.y();
  if (!inside) return;
  const auto column = static_cast<std::int64_t>(u / bin_size_);
  const auto row = static_cast<std::int64_t>(v / bin_size_);
  const double east = u - static_cast<double>(column) * bin_size_;
  const double north = v - static_cast<double>(row) * bin_size_;
  const auto e = static_cast<float>(east), n = static_cast<float>(north);
  const auto is_on = [&](const LinearFunction<float>& edge) {
    return edge.a * e + edge.b * n + edge.c >= -seam;
  };
  const std::uint32_t* bin = bin_begin_.data() + row * bin_columns_ + column;
  for (std::uint32_t i = bin[0]; i < bin[1]; ++i) {
    const GroundFacet& facet = bin_facets_[i];
    if (!is_on(facet.edges[0]) || !is_on(facet.edges[1]) || !is_on(facet.edges[2])) continue;
    const LinearFunction<float>& h = facet.height;
    visit(double{h.a} * east + double{h.b} * north + double{h.c});
  }
}

bool TinSurface::FindHeight(double x, double y, double* z) const {
  double lowest = std::numeric_limits<double>::infinity();
  VisitHeights(x, y, kFacetSeam, [&](double height) { lowest = std::min(lowest, height); });
  if (!std::isfinite(lowest)) return false;
  *z = base_height_ + lowest;
  return true;
}

// Distinct heights, so that places on a seam do not count twice.
int TinSurface::CountSheets(double x, double y) const {
  double lowest = 0;
  if (!FindHeight(x, y, &lowest)) return 0;
  bool others = false;
  VisitHeights(x, y, 0.0F,
               [&](double height) { others = others || base_height_ + height > lowest + 0.05; });
  return others ? 2 : 1;
}

GroundFacets TinSurface::View() const {
  return {bin_columns_, bin_rows_,         low_.x(),           low_.y(),           bin_size_,
          base_height_, bin_begin_.data(), bin_facets_.data(), bin_has_rim_.data()};
}

std::size_t TinSurface::memory_bytes() const {
  return bin_facets_.size() * sizeof(GroundFacet) + bin_begin_.size() * sizeof(std::uint32_t) +
         highest_nearby_.size() * sizeof(float);
}

}  // namespace dbd
