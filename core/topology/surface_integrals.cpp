// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/surface_integrals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/not_zero.h"
#include "core/base/unbounded.h"
#include "core/forms/iso_line.h"
#include "core/math/functions/bisection.h"
#include "core/math/functions/quadrature.h"
#include "core/surfaces/retry/near_origin.h"

namespace blossom {
namespace {

// Of the rough integral; the integrals' error estimates exceed their errors by far.
constexpr double kRelativeTolerance = 1e-11;
constexpr double kCoordinateRounding = 1e-15;
// Of the size of values: the integral of noise cannot be had any better, and cells as small as a
// thousandth of the tolerance are not to see it.
constexpr double kValueRounding = 1e-12;
// Of the height of the trims: gaps as low as this are the rounding of coordinates. What they add is
// below the tolerance unless the density there is a thousand times its mean.
constexpr double kNoHeight = 1e-14;

// How many halvings all integrals along lines of a face share, and all along its wires, of which
// each takes fifteen of the former at least. Choices: of the faces of real models in the tests none
// takes more than 40 000 and 28; noise would take 2^40 of each.
constexpr long kHalvingsOfLines = 1L << 18;
constexpr long kHalvingsOfWires = 1L << 10;

constexpr int kCrossingHalvings = 50;  // of a part of a span: up to rounding of its parameters
constexpr int kDensityCells = 4;       // each way: where a density is looked at to see its size

// Some numbers that are integrated together, and what the rounding of each is relative to: more,
// where it is a difference.
template <int Count>
struct Sample {
  using Values = Vec<double, Count>;
  Values values;
  Values sizes;
};

// What is integrated over the chart: by point and normal S_u x S_v.
template <int Count>
using Integrand = std::function<Sample<Count>(const Vec3&, const Vec3&)>;

template <int Count>
Vec<double, Count> largest(Vec<double, Count> a, const Vec<double, Count>& b) {
  for (int i = 0; i < Count; ++i) a[i] = std::max(a[i], b[i]);
  return a;
}

// Whether what is integrated is an area or the volume of a cone, which run along a surface's own
// lines as DensityLines says.
enum class Runs { AlongLines, Freely };

// A line of the surface along x at a constant y, over the span round some x.
class AreaLine {
 public:
  AreaLine(const IntegrandSurface& surface, Along along, double y, double x)
      : surface_(surface), along_(along), y_(y) {
    const BezierSurface& spans = surface.spans;
    if (spans.patches.empty()) return;
    const bool u = along == Along::U;
    const Span of_u(spans.u_knots, spans.u_law, u ? x : y);
    const Span of_v(spans.v_knots, spans.v_law, u ? y : x);
    const Span& across = u ? of_v : of_u;
    x_ = u ? of_u : of_v;
    y_rate_ = across.rate(across.local(y));
    line_.emplace(spans.patches(of_u.number, of_v.number), along, across.local(y));
  }

  template <int Count>
  Sample<Count> sample(const Integrand<Count>& integrand, double x) const {
    if (line_) {
      const double t = x_.local(x);
      const PatchJet jet = line_->jet(t);
      return integrand(jet.point, (x_.rate(t) * y_rate_) * cross(jet.u, jet.v));
    }
    const SurfaceJet jet = surface_.jet(along_ == Along::U ? Vec2{x, y_} : Vec2{y_, x});
    return integrand(jet.point, cross(jet.du, jet.dv));
  }

 private:
  // A span of the knots; the nearest one, as it goes on, for a parameter outside of all.
  struct Span {
    Interval range;
    ParameterLaw law = ParameterLaw::Linear;
    int number = 0;

    Span() = default;
    Span(const std::vector<double>& knots, ParameterLaw of, double parameter) : law(of) {
      const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
      range = {*(after - 1), *after};
      number = static_cast<int>(after - knots.begin()) - 1;
    }
    double local(double parameter) const { return local_parameter(law, range, parameter); }
    // Of the local parameter by the surface's own one.
    double rate(double t) const { return 1 / parameter_derivative(law, range, t); }
  };

  const IntegrandSurface& surface_;
  Along along_;
  double y_;
  Span x_;
  double y_rate_ = 1;
  std::optional<IsoLine> line_;
};

// The surface over the box of the trims. The inner integral runs along the direction called x, that
// of which the density is known or that with fewer spans; the other one is y.
template <int Count>
class Density {
 public:
  using Values = Vec<double, Count>;

  Density(const IntegrandSurface& surface, const FaceTrims& trims, Integrand<Count> integrand,
          Runs runs, double enough = 0)
      : integrand_(std::move(integrand)),
        low_{trims.box.low[0] / trims.scale[0], trims.box.low[1] / trims.scale[1]},
        high_{trims.box.high[0] / trims.scale[0], trims.box.high[1] / trims.scale[1]},
        surface_(surface) {
    const std::vector<double>&u = surface_.u_knots, &v = surface_.v_knots;
    if (runs == Runs::AlongLines) lines_ = surface_.lines;
    inner_ =
        lines_ == DensityLines::Turning || (lines_ == DensityLines::Any && u.size() <= v.size())
            ? 0
            : 1;
    x_knots_ = inner_ == 0 ? u : v;
    y_knots_ = inner_ == 0 ? v : u;
    // What rounding is relative to is not constant: at the apex of a cone it is 0.
    const int cells = is_constant() ? 2 : kDensityCells;
    Values rough, size;
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j) {
        const Sample<Count> sample = sample_in_cell(i, j, cells);
        rough += absolute(sample.values) * (1.0 / (cells * cells));
        size += sample.sizes * (1.0 / (cells * cells));
      }
    Values rounding = kCoordinateRounding * rough;
    for (int k = 0; k < 2; ++k) {
      rough *= high_[k] - low_[k];
      size *= high_[k] - low_[k];
      rounding *= std::max(std::abs(low_[k]), std::abs(high_[k]));
    }
    tolerance_ = largest(largest(kRelativeTolerance * rough, kValueRounding * size), rounding);
    for (double& each : tolerance_.coordinates) each = std::max(each, enough);
  }

  int inner() const { return inner_; }
  bool is_constant() const { return lines_ == DensityLines::Constant; }
  /// What is left of `kHalvingsOfWires`.
  long& halvings() const { return halvings_of_wires_; }
  /// For the whole integral: no sum can be better than the coordinates of the trims.
  const Values& tolerance() const { return tolerance_; }
  const std::vector<double>& y_knots() const { return y_knots_; }
  double height() const { return high_[1 - inner_] - low_[1 - inner_]; }

  // F: the integral along x from the left end to `x`, at y. One of the strips that are added up
  // over `height` in y: the lower that is, the less exact it has to be. Where a surface has a span
  // of rounding's width its normals are noise, of which no accuracy can be had. Trims may stray
  // over its border, beyond which there is nothing.
  Values strip(double x, double y, double height, int cells) const {
    const Values tolerance = tolerance_ * (1 / std::max(height, kNotZero));
    Values sum;
    if (y < y_knots_.front() || y > y_knots_.back()) return sum;
    x = std::clamp(x, x_knots_.front(), x_knots_.back());
    if (x == x_knots_.front()) return sum;
    if (lines_ == DensityLines::Even || lines_ == DensityLines::Constant)
      return (x - x_knots_.front()) * sample_at(x, y).values;
    if (lines_ == DensityLines::Turning) return turning_strip(x, y);
    for (std::size_t i = 0; i + 1 < x_knots_.size(); ++i) {
      const double to = i + 2 == x_knots_.size() ? x : std::min(x_knots_[i + 1], x);
      if (i > 0 && x_knots_[i] >= x) break;
      const AreaLine line(surface_, along(), y, 0.5 * (x_knots_[i] + x_knots_[i + 1]));
      auto density = [&](double s) { return line.sample(integrand_, s).values; };
      for (int k = 0; k < cells; ++k) {
        const double from = x_knots_[i], step = (to - from) / cells;
        sum +=
            integral(density, from + k * step, from + (k + 1) * step, tolerance, halvings_of_lines_)
                .value;
      }
    }
    return sum;
  }

 private:
  Along along() const { return inner_ == 0 ? Along::U : Along::V; }
  // a + b cos + c sin of the angle from the left end, by three values a third of a turn apart.
  Values turning_strip(double x, double y) const {
    constexpr double kThird = 2 * std::numbers::pi / 3;
    const double left = x_knots_.front(), angle = x - left;
    const Values at_left = sample_at(left, y).values, second = sample_at(left + kThird, y).values,
                 third = sample_at(left + 2 * kThird, y).values;
    const Values a = (at_left + second + third) * (1.0 / 3), b = at_left - a,
                 c = (second - third) * std::numbers::inv_sqrt3;
    return a * angle + b * std::sin(angle) + c * (1 - std::cos(angle));
  }
  Sample<Count> sample_at(double x, double y) const {
    return AreaLine(surface_, along(), y, x).sample(integrand_, x);
  }
  // In the middle of one of so many cells each way.
  Sample<Count> sample_in_cell(int i, int j, int cells) const {
    const Vec2 at = low_ + Vec2{(i + 0.5) / cells * (high_[0] - low_[0]),
                                (j + 0.5) / cells * (high_[1] - low_[1])};
    return sample_at(at[inner_], at[1 - inner_]);
  }

  Integrand<Count> integrand_;
  Vec2 low_, high_;
  const IntegrandSurface& surface_;
  std::vector<double> x_knots_, y_knots_;  // of the surface inside the box, the box's ends too
  int inner_ = 0;
  DensityLines lines_ = DensityLines::Any;
  Values tolerance_;
  mutable long halvings_of_lines_ = kHalvingsOfLines;
  mutable long halvings_of_wires_ = kHalvingsOfWires;
};

// What a straight way adds where the density is constant: strips grow evenly along it.
template <int Count>
Vec<double, Count> straight(const Vec2& from, const Vec2& to, const FaceTrims& trims,
                            const Density<Count>& density) {
  const int x = density.inner(), y = 1 - x;
  const Vec2 middle = 0.5 * (from + to);
  return density.strip(middle[x] / trims.scale[x], middle[y] / trims.scale[y], density.height(),
                       1) *
         ((to[y] - from[y]) / trims.scale[y]);
}

// What a straight way adds, forward along it: gaps that tolerances leave in the wires.
template <int Count>
Vec<double, Count> across(const Vec2& from, const Vec2& to, const FaceTrims& trims,
                          const Density<Count>& density) {
  const int x = density.inner(), y = 1 - x;
  const double dy = (to[y] - from[y]) / trims.scale[y];
  if (std::abs(dy) <= kNoHeight * density.height()) return {};
  auto rate = [&](double t) {
    const Vec2 point = (1 - t) * from + t * to;
    return density.strip(point[x] / trims.scale[x], point[y] / trims.scale[y], std::abs(dy), 1) *
           dy;
  };
  return integral(rate, 0, 1, density.tolerance(), density.halvings()).value;
}

// Local parameters of a span at which it crosses a knot line of the surface, with 0 and 1: there
// the integrand is less than smooth. Found between samples; a pair of crossings that none lies
// between is left to the halving of cells.
std::vector<double> breaks(const PlanarBezier& curve, int y, double scale,
                           const std::vector<double>& knots) {
  double lowest = kInfinity, highest = -lowest;
  for (const Vec3& p : curve.points) {
    lowest = std::min(lowest, p[y] / (p[2] * scale));
    highest = std::max(highest, p[y] / (p[2] * scale));
  }
  std::vector<double> at{0, 1};
  const auto is_between = [&](double knot) { return lowest < knot && knot < highest; };
  if (std::ranges::none_of(knots, is_between)) return at;
  const int samples = 4 * curve.degree();
  const auto height = [&](double t) { return jet_at(curve, t).point[y] / scale; };
  for (int i = 0; i < samples; ++i) {
    const double from = static_cast<double>(i) / samples, to = (i + 1.0) / samples;
    const double at_from = height(from), at_to = height(to);
    for (const double knot : knots) {
      if ((at_from < knot) == (at_to < knot)) continue;
      const auto is_before = [&](double t) { return (height(t) < knot) == (at_from < knot); };
      at.push_back(bisected({from, to}, kCrossingHalvings, is_before).to);
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

// Along the coedge as the wire walks it, from corner to corner.
template <int Count>
Vec<double, Count> along(const Coedge& coedge, const FaceTrims& trims,
                         const Density<Count>& density, int cells) {
  using Values = Vec<double, Count>;
  const int x = density.inner(), y = 1 - x;
  const Values tolerance = density.tolerance();
  Values sum;
  for (const PlanarSpan& span : coedge.curve.spans) {
    if (density.is_constant() && span.curve.degree() == 1) {
      const Vec2 from = jet_at(span.curve, 0).point, to = jet_at(span.curve, 1).point;
      sum += straight(from, to, trims, density);
      continue;
    }
    auto rate = [&](double t) {
      const PlanarJet jet = jet_at(span.curve, t);
      const double dy = jet.first[y] / trims.scale[y];
      if (dy == 0) return Values{};
      return density.strip(jet.point[x] / trims.scale[x], jet.point[y] / trims.scale[y],
                           density.height(), cells) *
             dy;
    };
    const std::vector<double> ends = breaks(span.curve, y, trims.scale[y], density.y_knots());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      for (int k = 0; k < cells; ++k)
        sum +=
            integral(rate, at({ends[i], ends[i + 1]}, static_cast<double>(k) / cells),
                     at({ends[i], ends[i + 1]}, (k + 1.0) / cells), tolerance, density.halvings())
                .value;
  }
  const auto corner = [&](int i) { return trims.corners[static_cast<std::size_t>(i)]; };
  const Values gaps = across(corner(coedge.from), end_point(coedge, false), trims, density) +
                      across(end_point(coedge, true), corner(coedge.to), trims, density);
  // A region on the left of its border has the integral of F dv, but minus that of F du.
  return ((coedge.reversed ? -sum : sum) + gaps) * (x == 0 ? 1 : -1);
}

template <int Count>
Vec<double, Count> integral_within(const FaceTrims& trims, const Density<Count>& density,
                                   int cells = 1) {
  Vec<double, Count> sum;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) sum += along(coedge, trims, density, cells);
  return sum;
}

// The entries of s s^T.
Vec<double, 6> squares_of(const Vec3& s) {
  return {s[0] * s[0], s[1] * s[1], s[2] * s[2], s[0] * s[1], s[0] * s[2], s[1] * s[2]};
}

struct MovedSurface {
  IntegrandSurface surface;
  Vec3 origin;
};

// Normals are sums of differences of control points, with roundings of the coordinates. A surface
// whose coordinates round to more than kValueRounding of it, or of its width, is moved to the
// origin by one of its points; nothing for others.
std::optional<MovedSurface> near_origin(const IntegrandSurface& surface) {
  if (surface.spans.patches.empty()) return std::nullopt;
  const Grid<Vec4>& points = surface.spans.patches(0, 0).points;
  const Vec3 origin = projected(points(0, 0));
  const double size = std::min(distance(origin, projected(points(points.rows() - 1, 0))),
                               distance(origin, projected(points(0, points.columns() - 1))));
  if (max_norm(origin) * std::numeric_limits<double>::epsilon() <= kValueRounding * size)
    return std::nullopt;
  MovedSurface moved{surface, origin};
  moved.surface.spans = seen_from(origin, std::move(moved.surface.spans));
  return moved;
}

}  // namespace

double trimmed_area(const IntegrandSurface& given, const FaceTrims& trims, int cells) {
  const std::optional<MovedSurface> moved = near_origin(given);
  const IntegrandSurface& surface = moved ? moved->surface : given;
  const Integrand<1> density = [](const Vec3&, const Vec3& normal) {
    return Sample<1>{{norm(normal)}, {}};
  };
  return integral_within(trims, Density(surface, trims, density, Runs::AlongLines), cells)[0];
}

double trimmed_cone_volume(const IntegrandSurface& given, const FaceTrims& trims,
                           const Vec3& given_apex, double enough) {
  const std::optional<MovedSurface> moved = near_origin(given);
  const IntegrandSurface& surface = moved ? moved->surface : given;
  const Vec3 apex = moved ? given_apex - moved->origin : given_apex;
  const Integrand<1> volume = [&](const Vec3& point, const Vec3& normal) {
    const double reach = norm(point) + norm(apex);
    return Sample<1>{{dot(point - apex, normal) / 3}, {reach * norm(normal) / 3}};
  };
  return integral_within(trims, Density(surface, trims, volume, Runs::AlongLines, enough))[0];
}

ConeMoments& ConeMoments::operator+=(const ConeMoments& other) {
  volume += other.volume;
  first += other.first;
  second += other.second;
  return *this;
}

ConeMoments cone_density(const Vec3& point, const Vec3& normal, const Vec3& apex) {
  const Vec3 s = point - apex;
  const double volume = dot(s, normal) / 3;
  ConeMoments density{volume, {}, {}};
  for (int i = 0; i < 3; ++i) density.first[i] = volume * (0.75 * s[i]);
  const Vec<double, 6> squares = squares_of(s);
  for (int i = 0; i < 6; ++i) density.second[i] = volume * (0.6 * squares[i]);
  return density;
}

ConeMoments trimmed_cone_moments(const IntegrandSurface& surface, const FaceTrims& trims,
                                 const Vec3& apex) {
  constexpr int kCount = 1 + 3 + 6;
  const Integrand<kCount> moments = [&](const Vec3& point, const Vec3& normal) {
    const ConeMoments density = cone_density(point, normal, apex);
    const double length = norm(point - apex);
    const double size = (norm(point) + norm(apex)) * norm(normal) / 3;
    Sample<kCount> sample;
    for (int i = 0; i < kCount; ++i) {
      sample.values[i] = i == 0  ? density.volume
                         : i < 4 ? density.first[i - 1]
                                 : density.second[i - 4];
      sample.sizes[i] = size * (i == 0 ? 1 : i < 4 ? length : length * length);
    }
    return sample;
  };
  const Vec<double, kCount> sums =
      integral_within(trims, Density(surface, trims, moments, Runs::Freely));
  ConeMoments result{sums[0], {sums[1], sums[2], sums[3]}, {}};
  for (int k = 0; k < 6; ++k) result.second[k] = sums[4 + k];
  return result;
}

Vec3 trimmed_area_moment(const IntegrandSurface& surface, const FaceTrims& trims,
                         const Vec3& origin) {
  const Integrand<3> moments = [&](const Vec3& point, const Vec3& normal) {
    const double area = norm(normal), size = (norm(point) + norm(origin)) * area;
    return Sample<3>{(point - origin) * area, {size, size, size}};
  };
  return integral_within(trims, Density(surface, trims, moments, Runs::Freely));
}

double polygon_area(const std::function<SurfaceJet(const Vec2& uv)>& jet,
                    std::span<const Vec2> polygon) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 from = polygon[i] - polygon[0], to = polygon[i + 1] - polygon[0];
    const Vec2 middle = (from + to) * 0.5;
    // The triangle is thin: along its other direction, the middle stands for all.
    const auto along_middle = [&](double s) {
      const SurfaceJet at = jet(polygon[0] + middle * s);
      return s * norm(cross(at.du, at.dv));
    };
    const double doubled = from[0] * to[1] - from[1] * to[0];
    sum += doubled * quadrature::cell(along_middle, 0, 1).value;
  }
  return std::abs(sum);
}

}  // namespace blossom
