// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and derivatives anywhere on a chain of certified arcs.
//
// Inside a certified cell pair the arc is a graph over one parameter: for each of its values
// there is exactly one point, which Newton's method finds. So tracing needs no marching and
// cannot jump to another branch.

#pragma once

#include <vector>

#include "core/intersection/arc_chains.h"
#include "core/intersection/pair_search.h"

namespace blossom {

/// A point of an intersection curve with derivatives by arc length.
struct CurvePoint {
  Vec3 point;  ///< in space
  Vec3 first;  ///< unit tangent
  Vec3 second;
  Vec2 a, a_first, a_second;  ///< in the surfaces' own parameters
  Vec2 b, b_first, b_second;
  double sine = 0;  ///< of the angle between the surfaces; 1 where they touch along the curve
};

class ChainTracer {
 public:
  ChainTracer(const PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, const Vec3& origin,
              const Chain& chain);

  /// Rough length of the chain, and where each link begins on it: links + 1 values, from 0.
  const std::vector<double>& stations() const { return stations_; }

  /// The point at a rough length. At a station shared by two links, `after` chooses the link
  /// that starts there.
  CurvePoint at(double station, bool after) const;

 private:
  CurvePoint on_link(std::size_t link, double fraction) const;
  Point4 parameters_on(const FoundArc& arc, double fraction) const;
  CurvePoint differentiate(const FoundArc& arc, const Point4& x, bool forward) const;
  CurvePoint differentiate_iso(const FoundArc& arc, const Point4& x, bool forward) const;
  CurvePoint differentiate_valley(const FoundArc& arc, const Point4& x, bool forward) const;

  const PairSearchResult& found_;
  SurfaceCells& a_;
  SurfaceCells& b_;
  Vec3 origin_;
  const Chain& chain_;
  std::vector<double> stations_;
};

}  // namespace blossom
