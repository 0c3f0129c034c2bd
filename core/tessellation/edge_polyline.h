// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges as polylines within a proven distance. All faces of an edge take the same one.

#pragma once

#include <cstddef>
#include <vector>

#include "core/forms/curve_spans.h"
#include "core/math/vec.h"
#include "core/tessellation/facet_options.h"

namespace blossom {

/// A curve, and the polyline that stands for it. Points of the polyline are spread by
///
///   sigma(t) = integral of max(sqrt(k / (8 e)), k / a, 1 / l) ds
///
/// with k the curvature, e a part of the deviation, a and l the wanted angle and length: arcs of
/// circles get equal parts, and no point more than they need. What the proof refuses is halved.
/// Curls and corners within a thousandth of the deviation get no points of their own.
class EdgePolyline {
 public:
  EdgePolyline() = default;  ///< no points
  /// closed   both ends are one vertex: at least three segments
  EdgePolyline(const CurveSpans& curve, bool closed, const FacetOptions& options);

  const std::vector<double>& parameters() const { return parameters_; }
  const std::vector<Vec3>& points() const { return points_; }
  std::size_t segments() const { return points_.empty() ? 0 : points_.size() - 1; }

  /// A bound on the distance of the curve from the polyline and of that from the curve.
  double distance() const { return distance_; }

  /// Puts a point into the middle of segments; numbers increase. The bound stays one.
  void split(const std::vector<std::size_t>& segments);

 private:
  void make(bool closed, double fine);
  void flatten(const CurveSpan& span, bool first, double fine);
  void drop_close_kinks();
  void spread(bool closed);
  void breaks_between(std::size_t from, std::size_t to, int least);
  double distance_of(double from, const Vec3& a, double to, const Vec3& b) const;
  void halve(const std::vector<std::size_t>& segments);
  void prove();

  CurveSpans curve_;
  FacetOptions options_;
  // A finer polyline, between two points of which the curve is within `thickness_` of the chord.
  std::vector<double> fine_parameters_;
  std::vector<Vec3> fine_points_;
  std::vector<double> sigma_;
  std::vector<std::size_t> kinks_;  // of the finer polyline, with both ends
  double thickness_ = 0;
  std::vector<double> parameters_;
  std::vector<Vec3> points_;
  double distance_ = 0;
};

}  // namespace blossom
