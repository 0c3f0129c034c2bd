// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and derivatives anywhere on a chain of certified arcs.
//
// Inside a certified cell pair the arc is a graph over one parameter: for each of its values
// there is exactly one point, which Newton's method finds. So tracing needs no marching and
// cannot jump to another branch.

#pragma once

#include <optional>
#include <vector>

#include "core/cells/surface_cells.h"
#include "core/results/result.h"
#include "core/surfaces/branches/arc_chains.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// A point of an intersection curve with derivatives by arc length.
struct TracePoint {
  Vec3 point;  ///< in space
  Vec3 first;  ///< unit tangent
  Vec3 second;
  Vec2 a, a_first, a_second;  ///< in the surfaces' own parameters
  Vec2 b, b_first, b_second;
  double sine = 0;  ///< of the angle between the surfaces; 1 where they touch along the curve
};

/// A point of an intersection curve, and the sine of the angle between the surfaces there.
struct CrossingPoint {
  SurfacePoint point;
  double sine;
};

class ChainTracer {
 public:
  ChainTracer(const PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, const Vec3& origin,
              const Chain& chain);

  /// Rough length of the chain, and where each link begins on it: links + 1 values, from 0.
  const std::vector<double>& stations() const { return stations_; }

  /// Points that are known, in order: of the middle of each link, and where two links meet.
  const std::vector<Vec3>& known_points() const { return known_points_; }

  /// The point at a rough length. At a station shared by two links, `after` chooses the link
  /// that starts there.
  TracePoint at(double station, bool after) const;

  /// The point of the link at a station beside one that is nearly on it, in the plane across the
  /// curve: by Newton's method from there, which a step or two settle.
  ///
  /// settled   model units: so short a step is the last one where the surfaces are perpendicular
  /// returns   nothing where the link is no crossing at an angle, or the steps do not become short
  std::optional<CrossingPoint> beside(double station, const SurfacePoint& start,
                                      double settled) const;

 private:
  std::size_t link_at(double station, bool after) const;
  TracePoint on_link(std::size_t link, double fraction) const;
  Point4 parameters_on(const FoundArc& arc, double fraction) const;
  TracePoint differentiate(const FoundArc& arc, const Point4& x, bool forward) const;
  TracePoint differentiate_straight(const FoundArc& arc, const Point4& x, bool forward) const;
  TracePoint differentiate_valley(const FoundArc& arc, const Point4& x, bool forward) const;

  const PairSearchResult& found_;
  SurfaceCells& a_;
  SurfaceCells& b_;
  Vec3 origin_;
  const Chain& chain_;
  std::vector<double> stations_;
  std::vector<Vec3> known_points_;
};

}  // namespace blossom
