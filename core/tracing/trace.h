// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and derivatives anywhere on a chain of certified arcs.
//
// Inside a certified cell pair the arc is a graph over one parameter: for each of its values
// there is exactly one point, which Newton's method finds. So tracing needs no marching and
// cannot jump to another branch.
//
// In a node the surfaces meet but for rounding. Where they are apart by e the branches beside it
// are hyperbolas: at a distance s they are e / sine off what leads into the node, and turn away
// from it by e / (s sine), the sine being that between the surfaces. So on the way to a node the
// points are such that are apart as those of the node are, ever less with the distance: these lie
// on branches that meet in it.

#pragma once

#include <array>
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
  /// rounding   model units: surfaces that are so far apart in a node meet in it
  ChainTracer(const PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, const Vec3& origin,
              const Chain& chain, double rounding = 0);

  /// Rough length of the chain, and where each link begins on it: links + 1 values, from 0.
  const std::vector<double>& stations() const { return stations_; }

  /// Points that are known, in order: of the middle of each link, and where two links meet.
  const std::vector<Vec3>& known_points() const { return known_points_; }

  /// The point at a rough length. At a station shared by two links, `after` chooses the link
  /// that starts there.
  TracePoint at(double station, bool after) const;

  /// How far the surfaces are apart in the points round a station, near a node.
  double gap_at(double station) const { return norm(apart_at(station).value); }

  /// The point of the link at a station beside one that is nearly on it, in the plane across the
  /// curve: by Newton's method from there, which a step or two settle.
  ///
  /// settled   model units: so short a step is the last one where the surfaces are perpendicular
  /// returns   nothing where the link is no crossing at an angle, or the steps do not become short
  std::optional<CrossingPoint> beside(double station, const SurfacePoint& start,
                                      double settled) const;

 private:
  // The surfaces at an end of the chain that is a node.
  struct Node {
    double station = 0;
    Vec3 apart;        // a - b
    double reach = 0;  // so far from it points are apart, too; rough length
  };

  // What a point is apart, and its derivatives by the length of the chain.
  struct Apart {
    Vec3 value, first, second;
  };

  void find_node(std::size_t side, double rounding);
  Vec3 apart_in(const FoundArc& arc, const Point4& x) const;
  Apart apart_at(double station) const;
  std::size_t link_at(double station, bool after) const;
  TracePoint on_link(std::size_t link, double fraction) const;
  Point4 parameters_on(const FoundArc& arc, double fraction, const Vec3& apart = {}) const;
  TracePoint differentiate(const FoundArc& arc, const Point4& x, bool forward,
                           const Apart& apart) const;
  TracePoint differentiate_straight(const FoundArc& arc, const Point4& x, bool forward) const;
  TracePoint differentiate_valley(const FoundArc& arc, const Point4& x, bool forward) const;

  const PairSearchResult& found_;
  SurfaceCells& a_;
  SurfaceCells& b_;
  Vec3 origin_;
  const Chain& chain_;
  std::vector<double> stations_;
  std::vector<Vec3> known_points_;
  std::array<Node, 2> nodes_;  // by side of the chain
};

}  // namespace blossom
