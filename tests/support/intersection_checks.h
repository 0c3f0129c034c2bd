// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures of an intersection, and whether a point belongs to it.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "core/results/result.h"

namespace blossom::testing {

/// Length of a curve's projection to the x-y plane, by Simpson's rule on its spline.
inline double projected_length(const IntersectionCurve& curve) {
  double sum = 0;
  const auto& knots = curve.curve.knots;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    constexpr int kParts = 8;
    const double h = (knots[i + 1] - knots[i]) / kParts;
    for (int k = 0; k < kParts; ++k)
      for (const auto& [t, weight] : {std::pair{0.0, 1.0}, {0.5, 4.0}, {1.0, 1.0}}) {
        const Vec3 d = derivative_at(curve.curve, knots[i] + (k + t) * h);
        sum += weight * h / 6 * std::hypot(d[0], d[1]);
      }
  }
  return sum;
}

inline double total_projected_length(const SurfaceIntersection& found) {
  double sum = 0;
  for (const IntersectionCurve& curve : found.curves) sum += projected_length(curve);
  return sum;
}

/// Lengths of the curves over a scale, increasing.
inline std::vector<double> sorted_lengths(const SurfaceIntersection& found, double scale) {
  std::vector<double> all;
  for (const IntersectionCurve& curve : found.curves) all.push_back(curve.length / scale);
  std::sort(all.begin(), all.end());
  return all;
}

/// In the box of some place, `slack` model units around it included.
inline bool in_some_place(const SurfaceIntersection& found, const Vec3& p, double slack) {
  return std::any_of(found.places.begin(), found.places.end(), [&](const Place& place) {
    for (int k = 0; k < 3; ++k)
      if (p[k] < place.box_low[k] - slack || p[k] > place.box_high[k] + slack) return false;
    return true;
  });
}

/// Within `slack` model units of the chords between some curve's samples.
inline bool on_some_curve(const SurfaceIntersection& found, const Vec3& p, double slack) {
  for (const IntersectionCurve& curve : found.curves)
    for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i) {
      const Vec3 from = curve.samples[i].point, step = curve.samples[i + 1].point - from;
      const double t = std::clamp(dot(p - from, step) / dot(step, step), 0.0, 1.0);
      if (distance(p, from + step * t) <= slack) return true;
    }
  return false;
}

/// Distances to the curves of an intersection: from the nearest of many chords, by Gauss-Newton.
class CurveDistance {
 public:
  explicit CurveDistance(const SurfaceIntersection& found) : found_(found) {
    constexpr int kParts = 8;
    for (std::size_t c = 0; c < found.curves.size(); ++c) {
      const auto& knots = found.curves[c].curve.knots;
      for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        for (int k = 0; k < kParts; ++k) {
          const Interval span{knots[i], knots[i + 1]};
          const Interval part{at(span, double(k) / kParts), at(span, (k + 1.0) / kParts)};
          chords_.push_back({c, part, point_at(found.curves[c].curve, part.from),
                             point_at(found.curves[c].curve, part.to)});
        }
    }
  }

  double to(const Vec3& p) const {
    double least = std::numeric_limits<double>::infinity(), nearest = 0;
    const Chord* best = nullptr;
    for (const Chord& chord : chords_) {
      const Vec3 step = chord.end - chord.start;
      const double t = std::clamp(dot(p - chord.start, step) / dot(step, step), 0.0, 1.0);
      const double far = distance(p, chord.start + step * t);
      if (far < least) least = far, nearest = at(chord.part, t), best = &chord;
    }
    return best == nullptr ? least : refined(found_.curves[best->curve].curve, nearest, p);
  }

 private:
  struct Chord {
    std::size_t curve;
    Interval part;
    Vec3 start, end;
  };

  static double refined(const Spline& spline, double t, const Vec3& p) {
    constexpr int kSteps = 4;
    double least = distance(p, point_at(spline, t));
    for (int step = 0; step < kSteps; ++step) {
      const Vec3 off = p - point_at(spline, t), d = derivative_at(spline, t);
      t = std::clamp(t + dot(off, d) / dot(d, d), spline.knots.front(), spline.knots.back());
      least = std::min(least, distance(p, point_at(spline, t)));
    }
    return least;
  }

  const SurfaceIntersection& found_;
  std::vector<Chord> chords_;
};

}  // namespace blossom::testing
