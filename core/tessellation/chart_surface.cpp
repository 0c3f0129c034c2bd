// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/chart_surface.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"

namespace blossom {
namespace {

// A net of equilateral triangles with sides of sqrt(6 e / k) is within e where both curvatures are
// k. Rows that end at borders are less regular.
constexpr double kSpacing = 4.8;

// So much longer than wide may triangles be that follow the curvature.
constexpr double kMaxAspect = 16;

constexpr double kMinAllowed = 0.5;  // of the deviation, for what facets themselves are off

constexpr int kElementaryCells = 12;  // of a direction in which the density changes

Vec2 wanted(const CurvatureSample& at, const FacetOptions& options) {
  const auto along = [&](double own, double length, double other_length) {
    const double twist = other_length > 0 ? at.uv * length / other_length : 0;
    double facets = std::sqrt((own + twist) / (kSpacing * options.deviation));
    if (options.angle > 0 && length > 0) facets = std::max(facets, own / (length * options.angle));
    if (options.edge_length > 0) facets = std::max(facets, length / options.edge_length);
    return facets;
  };
  Vec2 facets{along(at.uu, at.length_u, at.length_v), along(at.vv, at.length_v, at.length_u)};
  if (options.aspect > 0 && at.length_u > 0 && at.length_v > 0) {
    const double even = at.length_u / at.length_v;
    const double u = facets[0], v = facets[1];
    facets = {std::max(u, v * even / options.aspect), std::max(v, u / even / options.aspect)};
  }
  return facets;
}

// Along both directions equal numbers of facets, as far as these do not become too long for it.
Vec2 scale_of(const Vec2& facets, const Vec2& lengths, double most_long) {
  const double even = lengths[1] > 0 && lengths[0] > 0 ? lengths[0] / lengths[1] : 1;
  const double ratio = facets[0] / facets[1];  // may be infinite or no number
  const double least = even / most_long, most = even * most_long;
  if (!(facets[0] > 0) && !(facets[1] > 0)) return {even, 1};
  return {ratio > most ? most : ratio > least ? ratio : least, 1};
}

FacetDensity filled(std::vector<double> u, std::vector<double> v,
                    const auto& curvature_in,  // of a cell
                    const FacetOptions& options) {
  FacetDensity density{std::move(u), std::move(v), {}, {1, 1}};
  const int rows = static_cast<int>(density.u_ends.size()) - 1;
  const int columns = static_cast<int>(density.v_ends.size()) - 1;
  density.facets = Grid<Vec2>(rows, columns);
  Vec2 facets, lengths;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
      const CurvatureSample at = curvature_in(i, j);
      density.facets(i, j) = wanted(at, options);
      const double area =
          (density.u_ends[k + 1] - density.u_ends[k]) * (density.v_ends[l + 1] - density.v_ends[l]);
      facets += area * density.facets(i, j);
      lengths += area * Vec2{at.length_u, at.length_v};
    }
  density.scale = scale_of(facets, lengths, options.aspect > 0 ? options.aspect : kMaxAspect);
  return density;
}

std::vector<double> even_ends(double low, double high, int count) {
  std::vector<double> ends;
  for (int k = 0; k <= count; ++k) ends.push_back(low + (high - low) * k / count);
  return ends;
}

std::variant<ElementaryChart, SplineChart> made_ready(
    const std::variant<ElementaryChart, BezierSurface>& surface, double fine) {
  if (const auto* elementary = std::get_if<ElementaryChart>(&surface)) return *elementary;
  return SplineChart(std::get<BezierSurface>(surface), fine);
}

}  // namespace

ChartSurface::ChartSurface(const std::variant<ElementaryChart, BezierSurface>& surface,
                           const FacetOptions& options)
    : options_(options), chart_(made_ready(surface, options.deviation)) {}

PointNormal ChartSurface::frame_at(const Vec2& uv) const {
  if (const auto* elementary = std::get_if<ElementaryChart>(&chart_))
    return blossom::frame_at(*elementary, uv);
  return std::get<SplineChart>(chart_).frame_at(uv);
}

double ChartSurface::facet_distance(const std::array<Vec2, 3>& corners, const Vec3& normal) const {
  if (const auto* elementary = std::get_if<ElementaryChart>(&chart_))
    return blossom::facet_distance(*elementary, corners);
  return std::get<SplineChart>(chart_).facet_distance(corners, normal, allowed());
}

double ChartSurface::rough_distance(const std::array<Vec2, 3>& corners, const Vec3& normal) const {
  if (const auto* elementary = std::get_if<ElementaryChart>(&chart_))
    return blossom::facet_distance(*elementary, corners);
  return std::get<SplineChart>(chart_).facet_distance(corners, normal, kUnbounded);
}

FacetDensity ChartSurface::density(const Vec2& low, const Vec2& high) const {
  if (const auto* spline = std::get_if<SplineChart>(&chart_))
    return filled(
        spline->u_cells(), spline->v_cells(),
        [spline](int i, int j) { return spline->curvature(i, j); }, options_);
  const auto& elementary = std::get<ElementaryChart>(chart_);
  const bool changes = elementary.kind == ElementaryKind::Cone ||
                       elementary.kind == ElementaryKind::Sphere ||
                       elementary.kind == ElementaryKind::Torus;
  const std::vector<double> v = even_ends(low[1], high[1], changes ? kElementaryCells : 1);
  return filled(
      {low[0], high[0]}, v,
      [&](int, int j) {
        const auto k = static_cast<std::size_t>(j);
        return curvature_at(elementary, {low[0], 0.5 * (v[k] + v[k + 1])});
      },
      options_);
}

double ChartSurface::allowed() const {
  return std::max(options_.deviation - error(), kMinAllowed * options_.deviation);
}

double ChartSurface::error() const {
  const auto* spline = std::get_if<SplineChart>(&chart_);
  return spline ? spline->error() : 0;
}

}  // namespace blossom
