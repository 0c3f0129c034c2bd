// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/shared_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/forms/algebra/products.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/curve_subdivision.h"

namespace blossom {
namespace {

constexpr double kMinPart = 1e-3;        // of a or b; shorter common parts are contacts
constexpr double kSameDirection = 1e-4;  // sine above which directions are not the same
constexpr double kSameEnd = 1e-12;       // a foot this near an end is the end: rounding
constexpr int kSampleFootSteps = 8;

// t = t0 + p (s - s0) / (1 + q (s - s0)), by value and two derivatives at one point.
struct LocalMap {
  double s0, t0, p, q;

  double operator()(double s) const { return t0 + p * (s - s0) / (1 + q * (s - s0)); }

  // Where the value is t; nothing beyond the pole.
  std::optional<double> inverse(double t) const {
    const double rest = p - q * (t - t0);
    if (!(rest * p > 0)) return std::nullopt;
    return s0 + (t - t0) / rest;
  }
};

std::optional<LocalMap> local_map(const RationalBezierCurve& a, const RationalBezierCurve& b,
                                  double s, double t) {
  const CurveJet ja = jet_at(a, s), jb = jet_at(b, t);
  const double square = dot(jb.first, jb.first);
  if (!(square > 0) || !(dot(ja.first, ja.first) > 0)) return std::nullopt;
  if (norm(cross(unit(ja.first), unit(jb.first))) > kSameDirection) return std::nullopt;
  const double p = dot(ja.first, jb.first) / square;
  const double second = dot(ja.second - jb.second * (p * p), jb.first) / square;
  return LocalMap{s, t, p, -second / (2 * p)};
}

// The part of a that the map takes into b.
std::optional<Interval> common_part(const LocalMap& map) {
  Interval part{0, 1};
  for (const double end : {0.0, 1.0}) {
    const auto s = map.inverse(end);
    if (!s) continue;  // the pole is nearer than the end, and a ends before the pole or not at all
    if ((end > map.t0) == (map.p > 0))
      part.to = std::min(part.to, *s);
    else
      part.from = std::max(part.from, *s);
  }
  const double low = 1 + map.q * (part.from - map.s0), high = 1 + map.q * (part.to - map.s0);
  if (!(low > 0 && high > 0 && part.from < part.to)) return std::nullopt;
  const bool is_long =
      length(part) > kMinPart || std::abs(map(part.to) - map(part.from)) > kMinPart;
  return is_long ? std::optional(part) : std::nullopt;
}

// The parameter in [0, 1] whose point is nearest, from a start.
double foot(const RationalBezierCurve& b, const Vec3& point, double t) {
  constexpr double kBeyondEnd = 1e-6;      // part of the curve: the start is near, so is the foot
  constexpr double kLastFootStep = 1e-16;  // part of the curve: half a rounding of 1
  for (int k = 0; k < kSampleFootSteps; ++k) {
    const CurveJet jet = jet_at(b, t);
    const double square = dot(jet.first, jet.first);
    if (!(square > 0)) break;
    const double step = dot(point - jet.point, jet.first) / square;
    t = std::clamp(t + step, -kBeyondEnd, 1 + kBeyondEnd);
    if (std::abs(step) < kLastFootStep) break;
  }
  if (std::abs(t - std::round(t)) <= kSameEnd) return std::clamp(std::round(t), 0.0, 1.0);
  return std::clamp(t, 0.0, 1.0);
}

struct Homogeneous {
  BezierFunction weight;
  BezierCurve point;
  double largest_weight = 0, least_weight = kUnbounded, largest_point = 0;
};

Homogeneous parts_of(const RationalBezierCurve& curve) {
  Homogeneous parts;
  for (const Vec4& p : curve.points) {
    parts.weight.points.push_back(p[3]);
    parts.point.points.push_back({p[0], p[1], p[2]});
    parts.largest_weight = std::max(parts.largest_weight, p[3]);
    parts.least_weight = std::min(parts.least_weight, p[3]);
    parts.largest_point = std::max(parts.largest_point, max_norm(parts.point.points.back()));
  }
  return parts;
}

}  // namespace

double distance_bound(const RationalBezierCurve& a, const RationalBezierCurve& b, double error) {
  const Homogeneous p = parts_of(a), q = parts_of(b);
  if (!(p.least_weight > 0 && q.least_weight > 0)) return kUnbounded;
  const BezierCurve left = product(q.weight, p.point), right = product(p.weight, q.point);
  const BezierFunction weight = product(p.weight, q.weight);
  double worst = 0, least = kUnbounded;
  for (std::size_t i = 0; i < left.points.size(); ++i) {
    worst = std::max(worst, norm(left.points[i] - right.points[i]));
    least = std::min(least, weight.points[i]);
  }
  const double scale = q.largest_weight * p.largest_point + p.largest_weight * q.largest_point;
  error += product_error(0, std::min(a.degree(), b.degree()));
  return (worst + 2 * error * scale) / least;
}

double distance_bound(const RationalBezierCurve& a, const RationalBezierCurve& b,
                      const LinearRational& map) {
  RationalBezierCurve piece = sub_curve(b, map.to);
  const int n = piece.degree();
  for (int i = 0; i <= n; ++i)
    piece.points[static_cast<std::size_t>(i)] *= std::pow(map.ratio, n - i);
  const double error = curve_subdivision_error(a.degree()) + curve_subdivision_error(n) +
                       0x1p-51;  // powers of the ratio
  return distance_bound(sub_curve(a, map.from), piece, error);
}

std::optional<SharedCurve> shared_curve(const RationalBezierCurve& a, const RationalBezierCurve& b,
                                        double s, double t, double tolerance) {
  const auto local = local_map(a, b, s, t);
  if (!local) return std::nullopt;
  auto part = common_part(*local);
  if (!part) return std::nullopt;
  // Ends that b sets are feet of its ends: derivatives at one point do not tell them as well.
  for (double* end : {&part->from, &part->to})
    if (*end > 0 && *end < 1)
      *end = foot(a, jet_at(b, std::round(std::clamp((*local)(*end), 0.0, 1.0))).point, *end);
  std::array<double, 3> feet{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = at(*part, 0.5 * static_cast<double>(i));
    const Vec3 point = jet_at(a, x).point;
    feet[i] = foot(b, point, std::clamp((*local)(x), 0.0, 1.0));
    if (distance(point, jet_at(b, feet[i]).point) > tolerance) return std::nullopt;
  }
  const double along = (feet[1] - feet[0]) / (feet[2] - feet[0]);
  if (!(along > 0 && along < 1)) return std::nullopt;
  SharedCurve shared{{*part, {feet[0], feet[2]}, (1 - along) / along}, 0};
  shared.gap = distance_bound(a, b, shared.map);
  if (!(shared.gap <= tolerance)) return std::nullopt;
  return shared;
}

}  // namespace blossom
