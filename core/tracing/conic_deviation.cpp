// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/conic_deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "core/base/unbounded.h"
#include "core/math/roundoff.h"
#include "core/tracing/spline_fit.h"

namespace blossom {
namespace {

constexpr double kUnknown = kInfinity;
// Of the coordinates and lengths that a bound is summed from: some fifty roundings in a row.
constexpr double kLawRounding = 64 * kUnitRoundoff;

constexpr auto kPiece = static_cast<std::size_t>(kFitDegree);

bool is_bezier(const auto& spline, const std::vector<double>& knots) {
  const auto& times = spline.multiplicities;
  return spline.degree == kFitDegree && spline.knots == knots && times.size() == knots.size() &&
         times.size() > 1 && spline.points.size() == kPiece * (knots.size() - 1) + 1 &&
         std::all_of(times.begin() + 1, times.end() - 1, [](int n) { return n == kFitDegree; });
}

// How far the spline in space is from the conic.
double off_conic(const Spline& spline, const Conic& conic) {
  const auto jet = [&](double t) {
    return std::array{point_at(conic, t), derivative_at(conic, t), second_derivative_at(conic, t)};
  };
  double off = 0;
  auto start = jet(spline.knots.front());
  for (std::size_t i = 0; i + 1 < spline.knots.size(); ++i) {
    const Interval place{spline.knots[i], spline.knots[i + 1]};
    const auto stop = jet(place.to);
    const auto exact = hermite_points(start, stop, length(place));
    double gap = 0;
    for (std::size_t k = 0; k < exact.size(); ++k)
      gap = std::max(gap, distance(exact[k], spline.points[kPiece * i + k]));
    off = std::max(off,
                   gap + sixth_derivative_bound(conic, place) * std::pow(length(place), 6) / 46080);
    start = stop;
  }
  return off;
}

// The parameters at which the control points of t itself lie.
std::vector<double> places_of_poles(const std::vector<double>& knots) {
  std::vector<double> places{knots.front()};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (int k = 1; k <= kFitDegree; ++k)
      places.push_back(at({knots[i], knots[i + 1]}, static_cast<double>(k) / kFitDegree));
  return places;
}

// P + p cos t + q sin t, or P + t p.
struct Course {
  Vec3 centre, p, q;
};

// The value and how far a coordinate is off it, or off a law with it.
struct Coordinate {
  double value = 0;
  double off = 0;
  double sign = 0;  // of the rate at which it runs; 0 if it is fixed
};

class ImageLaw {
 public:
  ImageLaw(const ElementaryChart& surface, const IntersectionCurve& curve, const Spline2& chart,
           const std::vector<double>& places, double off)
      : surface_(surface),
        curve_(curve),
        conic_(*curve.conic),
        chart_(chart),
        places_(places),
        off_conic_(off) {}

  double bound() const {
    if (surface_.kind == ElementaryKind::Plane) return off_plane() + rounding();
    if (!is_course()) return kUnknown;
    const std::size_t along = runs_along();
    std::array<Coordinate, 2> at;
    at[along] = running(along);
    at[1 - along] = slants() ? height() : fixed(1 - along);
    const auto [u, v] = at;
    return difference(at, along) + speed_u(v) * u.off + speed_v() * v.off + rounding();
  }

 private:
  // Of the other surfaces only lines on ruled ones, circles and ellipses can follow a law.
  bool is_course() const {
    if (conic_.kind != ConicKind::Line) return conic_.is_closed();
    return surface_.kind == ElementaryKind::Cylinder || surface_.kind == ElementaryKind::Cone;
  }

  bool slants() const {
    return surface_.kind == ElementaryKind::Cylinder && conic_.kind == ConicKind::Ellipse;
  }

  // The parameter that runs: what is an angle cannot run along a line.
  std::size_t runs_along() const {
    if (conic_.kind == ConicKind::Line) return 1;
    if (surface_.kind == ElementaryKind::Cylinder || surface_.kind == ElementaryKind::Cone)
      return 0;
    return range(0) > range(1) ? 0 : 1;
  }

  double range(std::size_t d) const { return 2 * fixed(d).off; }

  Coordinate fixed(std::size_t d) const {
    double low = kUnknown, high = -kUnknown;
    for (const Vec2& pole : chart_.points) {
      low = std::min(low, pole.coordinates[d]);
      high = std::max(high, pole.coordinates[d]);
    }
    return {0.5 * (low + high), 0.5 * (high - low)};
  }

  // The value is that at the parameter 0.
  Coordinate running(std::size_t d) const {
    const double first = chart_.points.front().coordinates[d];
    const double last = chart_.points.back().coordinates[d];
    const double sign = last < first ? -1 : 1;
    const double middle = std::midpoint(places_.front(), places_.back());
    Coordinate found{std::midpoint(first, last) - sign * middle, 0, sign};
    for (std::size_t k = 0; k < places_.size(); ++k)
      found.off = std::max(
          found.off, std::abs(chart_.points[k].coordinates[d] - found.value - sign * places_[k]));
    return found;
  }

  // Along the axis of a cylinder, as the conic has it.
  Coordinate height() const {
    double off = 0;
    for (std::size_t k = 0; k < places_.size(); ++k)
      off = std::max(off, std::abs(chart_.points[k][1] - dot(surface_.z, arm(k))));
    return {0, off + off_conic_};
  }

  double off_plane() const {
    double off = 0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const auto [u, v] = chart_.points[k].coordinates;
      off = std::max(off, distance(u * surface_.x + v * surface_.y, arm(k)));
    }
    return off + off_conic_;
  }

  Vec3 arm(std::size_t pole) const { return curve_.curve.points[pole] - surface_.origin; }

  // Between the conic and the image of the law, where its charts follow it exactly.
  double difference(const std::array<Coordinate, 2>& at, std::size_t along) const {
    const bool line = conic_.kind == ConicKind::Line;
    const Course image = line ? ruling(at) : along == 0 ? parallel(at) : meridian(at);
    Vec3 centre = image.centre - conic_.centre;
    Vec3 p = image.p - (line ? 1 : conic_.major) * conic_.x;
    Vec3 q = image.q - (line ? 0 : conic_.minor) * conic_.y;
    if (line)
      return std::max(norm(centre + places_.front() * p), norm(centre + places_.back() * p));
    if (slants())
      for (Vec3* part : {&centre, &p, &q}) *part = across(*part, surface_.z);
    return norm(centre) + std::hypot(norm(p), norm(q));
  }

  Vec3 radial(double u) const { return std::cos(u) * surface_.x + std::sin(u) * surface_.y; }

  // Round an axis: an angle that runs from a value at 0 gives cos (value + sign t), and the sine.
  static Course turning(const Vec3& centre, double radius, const Coordinate& angle, const Vec3& x,
                        const Vec3& y) {
    const double c = radius * std::cos(angle.value), s = radius * std::sin(angle.value);
    return {centre, c * x + s * y, angle.sign * (c * y - s * x)};
  }

  Course ruling(const std::array<Coordinate, 2>& at) const {
    const Vec3 out = radial(at[0].value);
    const Vec3 along = std::sin(surface_.angle) * out + std::cos(surface_.angle) * surface_.z;
    return {surface_.origin + surface_.radius * out + at[1].value * along, at[1].sign * along, {}};
  }

  Course parallel(const std::array<Coordinate, 2>& at) const {
    return turning(surface_.origin + rise(at[1].value) * surface_.z, reach(at[1].value), at[0],
                   surface_.x, surface_.y);
  }

  Course meridian(const std::array<Coordinate, 2>& at) const {
    const Vec3 out = radial(at[0].value);
    const bool ball = surface_.kind == ElementaryKind::Sphere;
    const Vec3 centre = ball ? surface_.origin : surface_.origin + surface_.radius * out;
    return turning(centre, ball ? surface_.radius : surface_.minor, at[1], out, surface_.z);
  }

  // Of the parallel at a parameter v: its height, and its radius.
  double rise(double v) const {
    switch (surface_.kind) {
      case ElementaryKind::Cylinder: return v;
      case ElementaryKind::Cone: return v * std::cos(surface_.angle);
      case ElementaryKind::Sphere: return surface_.radius * std::sin(v);
      case ElementaryKind::Torus: return surface_.minor * std::sin(v);
      default: return 0;
    }
  }
  double reach(double v) const {
    switch (surface_.kind) {
      case ElementaryKind::Cone: return surface_.radius + v * std::sin(surface_.angle);
      case ElementaryKind::Sphere: return surface_.radius * std::cos(v);
      case ElementaryKind::Torus: return surface_.radius + surface_.minor * std::cos(v);
      default: return surface_.radius;
    }
  }

  // The largest lengths of the derivatives; where a line runs on a cone, v is anywhere on it.
  double speed_u(const Coordinate& v) const {
    if (surface_.kind != ElementaryKind::Cone) return surface_.radius + surface_.minor;
    const double start = v.value + v.sign * places_.front();
    const double stop = v.value + v.sign * places_.back();
    return std::max(std::abs(reach(start)), std::abs(reach(stop))) + v.off;
  }
  double speed_v() const {
    if (surface_.kind == ElementaryKind::Sphere) return surface_.radius;
    return surface_.kind == ElementaryKind::Torus ? surface_.minor : 1;
  }

  double rounding() const {
    double largest = 1;  // of parameters
    for (const Vec2& pole : chart_.points) largest = std::max(largest, max_norm(pole));
    for (const double t : {places_.front(), places_.back()})
      largest = std::max(largest, std::abs(t));
    const double size =
        norm(surface_.origin) + norm(conic_.centre) +
        (1 + surface_.radius + surface_.minor + conic_.major + conic_.minor) * largest;
    return kLawRounding * size;
  }

  const ElementaryChart& surface_;
  const IntersectionCurve& curve_;
  const Conic& conic_;
  const Spline2& chart_;
  const std::vector<double>& places_;
  double off_conic_;
};

}  // namespace

std::optional<Deviation> conic_deviation(const IntersectionCurve& curve, const ElementaryChart& a,
                                         const ElementaryChart& b, double within) {
  const std::vector<double>& knots = curve.curve.knots;
  if (!is_bezier(curve.curve, knots) || !is_bezier(curve.chart_a, knots) ||
      !is_bezier(curve.chart_b, knots))
    return {};
  const double off = off_conic(curve.curve, *curve.conic);
  const std::vector<double> places = places_of_poles(knots);
  const double on_a = ImageLaw(a, curve, curve.chart_a, places, off).bound();
  const double on_b = ImageLaw(b, curve, curve.chart_b, places, off).bound();
  if (!(std::max(on_a, on_b) <= within)) return {};
  return Deviation{on_a, on_b, on_a + on_b, true, off};
}

}  // namespace blossom
