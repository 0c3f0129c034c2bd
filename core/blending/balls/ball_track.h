// SPDX-License-Identifier: LGPL-2.1-or-later
// The path of a ball that rolls along two surfaces and touches both.
//
// Notation: S_i the surfaces, n_i = S_u x S_v / |S_u x S_v|, s_i = +-1 the side the ball is on,
// r its radius, c its centre, p_i = S_i(chart_i) the contacts. The ball touches both where
//
//   c = S_1 + s_1 r n_1 = S_2 + s_2 r n_2:
//
// three equations for the four chart parameters, a curve that is regular wherever the images of
// the two offsets' derivatives span space.
//
// In the place of a surface there may be an edge E(u) that the ball leans on: its contact is E(u),
// and for n_i there is the unit vector m(u, v) at the angle v about the edge,
//
//   m = cos v e_1 + sin v e_2,   e_1 = the part of a across E', unit,   e_2 = E' x e_1 / |E'|,
//
// with a direction a(u) that is nowhere along E'. The offset E + r m is the pipe round the edge.

#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/blending/balls/chart_cell.h"
#include "core/blending/balls/radius_law.h"
#include "core/forms/evaluation.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

class BallSystem;
struct ChartPlane;

/// A rectangle of a surface's own parameters.
struct ChartRectangle {
  Interval u, v;
};

/// One of the surfaces that a ball rolls on, or an edge.
///
/// Normals have to be continuous in the part. Across a closed direction whose whole range the part
/// has, the ball goes on: charts then leave the range by whole periods and stay continuous.
struct BallSupport {
  const BezierSurface* surface = nullptr;  ///< must outlive what is made from the support
  ChartRectangle part;                     ///< inside the knots' range
  int side = 1;                            ///< +1 or -1: the centre is at S + side r n
  /// The surface then is E(u) + v a(u), and v in charts is the angle: radians.
  bool is_edge = false;
};

/// The support on all of a surface.
BallSupport whole_support(const BezierSurface& surface, int side);

/// The support on an edge: E(u) + v a(u) as a surface whose v has the angles that the ball may get
/// to.
BallSupport edge_support(const BezierSurface& ruled);

/// The guide of a variable radius: the ball of parameter x has its centre in the plane across the
/// guide at x.
struct BallGuide {
  std::function<CurveJet(double)> curve;  ///< G with two derivatives by x, model units
  Interval range;
  std::vector<double> knots{};  ///< inside of the range, where the curve's third derivative jumps
};

/// How a ball touches one of the surfaces.
struct BallContact {
  Vec2 chart;       ///< the surface's own parameters
  Vec2 chart_rate;  ///< derivative by the track's parameter
  Vec3 point;
  Vec3 rate;    ///< of the point
  Vec3 normal;  ///< unit, from the contact to the centre

  /// Determinant and trace of I - s r W, W the shape operator. The ball lies locally on its side,
  /// and the contact does not stop, if and only if both are positive: then 1 - s r k > 0 for both
  /// principal curvatures. On an edge k is its curvature in the direction of the centre, and there
  /// is only one.
  double determinant = 1;
  double trace = 2;
};

/// Of a contact alone: see BallContact.
struct BallBend {
  double determinant = 1;
  double trace = 2;
};

/// A ball on a track.
struct BallPoint {
  double parameter = 0;
  Vec3 centre;
  Vec3 centre_rate;  ///< by the parameter
  double radius = 0;
  double radius_rate = 0;
  std::array<BallContact, 2> contacts;
};

/// Why a track ends.
enum class TrackEnd {
  Closed,  ///< it does not: it is a loop
  Cut,     ///< it is a loop that was cut open there
  Border,  ///< a contact is on the border of its support's part
  Guide,   ///< the guide's range is over
  Lost,    ///< the two conditions stop being independent: the surfaces touch, say
};

const char* to_string(TrackEnd end);

/// A ball's whole path from border to border.
///
/// Parameter: of a constant radius the rolling length, ds^2 = (|dp_1|^2 + |dp_2|^2) / 2, to about
/// 1e-9 of it; of a variable one the guide's. `at` solves the equations anew for each parameter, so
/// its points are on the exact offsets to rounding.
class BallTrack {
 public:
  /// One node: the four chart parameters (u_1, v_1, u_2, v_2) with two derivatives, which may jump
  /// where a contact passes a knot line.
  struct Node {
    double parameter = 0;
    Vec4 chart;
    std::array<Vec4, 2> first;   ///< before and after
    std::array<Vec4, 2> second;  ///< likewise
    bool is_break = false;       ///< a contact is on a knot line, or a law or guide has a knot
  };

  /// Made by `track_through` and by the search for all tracks.
  ///
  /// nodes   at least 2, parameters increasing
  /// cells   of both contacts between each two nodes
  BallTrack(std::shared_ptr<const BallSystem> system, std::vector<Node> nodes,
            std::vector<std::array<ChartCell, 2>> cells, const std::array<TrackEnd, 2>& ends,
            const std::array<int, 2>& end_supports);

  const std::array<BallSupport, 2>& supports() const;
  const RadiusLaw& law() const;
  Interval domain() const { return {nodes_.front().parameter, nodes_.back().parameter}; }
  bool closed() const { return ends_[0] == TrackEnd::Closed; }
  const std::array<TrackEnd, 2>& ends() const { return ends_; }

  /// Which support's border an end is on: 0, 1, or -1 for no border.
  const std::array<int, 2>& end_supports() const { return end_supports_; }

  /// Increasing; first and last those of the domain. Between two of them all is analytic.
  std::vector<double> breaks() const;
  const std::vector<Node>& nodes() const { return nodes_; }

  /// The ball at a parameter of the domain. At a break, `after` tells from which side its rates and
  /// curvatures are.
  BallPoint at(double parameter, bool after = true) const;

  /// Only the determinant and the trace of a contact, from what is interpolated between the nodes,
  /// whose charts are off by about 1e-10 of their extents: a fraction of the work of `at`.
  BallBend bend_near(std::size_t support, double parameter, bool after = true) const;

  /// The parameter of the ball whose centre is nearest to a point, found from the nearest node.
  double nearest(const Vec3& centre) const { return nearest(centre, domain()); }

  /// The same within a part of the track, which may come back to where it was.
  double nearest(const Vec3& centre, const Interval& part) const;

  /// A loop as a track that begins and ends in that one of its nodes which is nearest to a
  /// parameter.
  BallTrack cut_open(double parameter) const;

 private:
  std::size_t interval_at(double parameter, bool after) const;
  Vec4 solution_near(std::size_t interval, double parameter, const Vec4& chart,
                     const ChartPlane& plane) const;

  std::shared_ptr<const BallSystem> system_;
  std::vector<Node> nodes_;
  std::vector<std::array<ChartCell, 2>> cells_;
  std::array<TrackEnd, 2> ends_{};
  std::array<int, 2> end_supports_{-1, -1};
};

/// The track through the ball next to a guess, both ways until it ends.
///
/// start     charts of both contacts, roughly: Newton's method starts there
/// returns   nothing if it finds no ball of that radius in both parts, or the track has no length
/// throws    InvalidInput if a surface is not well formed, a side is not +-1, a part is empty or
///           leaves its surface, or the radius is not positive and finite
std::optional<BallTrack> track_through(const BallSupport& a, const BallSupport& b, double radius,
                                       const std::array<Vec2, 2>& start);

/// The charts of the ball that touches both surfaces in the plane across their common edge at a
/// point: followed from radius 0 there, so it is the edge's own one, not one of another branch.
///
/// edge      charts of that point of the edge on both surfaces
/// returns   nothing where the ball pinches, or leaves a part, before it has the radius
/// throws    InvalidInput as `track_through`
/// Source: the two conditions differentiated by r, c' = s_1 n_1 + O_u u' + O_v v'.
std::optional<std::array<Vec2, 2>> ball_beside_edge(const BallSupport& a, const BallSupport& b,
                                                    double radius, const std::array<Vec2, 2>& edge);

/// As `track_through`, with a radius by a law along a guide; the track's parameter is the guide's.
///
/// parameter   of the guide, where the track is started
std::optional<BallTrack> track_through(const BallSupport& a, const BallSupport& b,
                                       const RadiusLaw& law, const BallGuide& guide,
                                       double parameter, const std::array<Vec2, 2>& start);

}  // namespace blossom
