// SPDX-License-Identifier: LGPL-2.1-or-later
// The equations of a ball that touches two surfaces, and how their solutions move.
//
//   F(x) = S_1 + r m_1 - S_2 - r m_2 = 0,   x = (u_1, v_1, u_2, v_2),   m_i = s_i n_i
//
// and one more for a point of the curve: a plane in the space of x, or, if the radius changes, a
// plane in space that the centre is in.

#pragma once

#include <array>
#include <functional>
#include <optional>

#include "core/blending/balls/ball_track.h"
#include "core/blending/balls/chart_cell.h"

namespace blossom {

/// A surface and its offset at a point, O = S + r m; an edge and its pipe.
struct OffsetJet {
  Vec3 point, u, v;         ///< S, S_u, S_v; E, E', 0
  Vec3 normal;              ///< m, unit
  Vec3 offset, by_u, by_v;  ///< O, O_u, O_v
  double determinant = 1;   ///< of I - s r W
  double trace = 2;
  Vec2 sizes{};  ///< lengths that derivatives of the offset are compared with, none 0
};

/// Nothing where S_u x S_v vanishes.
std::optional<OffsetJet> offset_jet(const BezierSurface& surface, const ChartCell& cell,
                                    const Vec2& uv, int side, double radius);

/// Likewise of a support; of an edge nothing where the direction a is along it, or it stands still.
std::optional<OffsetJet> offset_jet(const BallSupport& support, const ChartCell& cell,
                                    const Vec2& uv, double radius);

/// A plane that moves: points of it are those with (X - point).normal = 0.
struct MovingPlane {
  Vec3 point, point_rate, normal, normal_rate;
};

/// A condition row.x = value.
struct ChartPlane {
  Vec4 row;
  double value = 0;
};

using BallCells = std::array<ChartCell, 2>;

inline Vec2 chart_of(const Vec4& x, int support) { return {x[2 * support], x[2 * support + 1]}; }

class BallSystem {
 public:
  /// planes   where the centre is by the parameter; empty for a constant radius
  BallSystem(const std::array<BallSupport, 2>& supports, RadiusLaw law,
             std::function<MovingPlane(double)> planes);

  const std::array<BallSupport, 2>& supports() const { return supports_; }
  const RadiusLaw& law() const { return law_; }
  bool is_driven() const { return static_cast<bool>(planes_); }

  /// The lengths of both parts in each coordinate.
  const Vec4& extents() const { return extents_; }

  /// Both offsets.
  std::optional<std::array<OffsetJet, 2>> jets(const Vec4& x, const BallCells& cells,
                                               double radius) const;

  /// dx by the parameter: at rolling length 1, or as the planes drive it. Nothing where F' loses
  /// its rank, to kMinMinor of what it can be.
  std::optional<Vec4> rate(const Vec4& x, const BallCells& cells, double parameter) const;
  std::optional<Vec4> rate(const std::array<OffsetJet, 2>& jets, double parameter) const;

  /// The solution next to x by Newton's method; `plane` is used if the system is not driven.
  std::optional<Vec4> solved(Vec4 x, const BallCells& cells, double parameter,
                             const ChartPlane& plane) const;

  /// Likewise the solution that is nearest in charts relative to their extents, for a constant
  /// radius: cells are those of each iterate.
  std::optional<Vec4> nearest(Vec4 x) const;

  /// The ball at a solution, by the offsets there.
  BallPoint ball(const Vec4& x, const Vec4& x_rate, const std::array<OffsetJet, 2>& jets,
                 double parameter) const;

 private:
  bool shortest_step(std::array<Vec3, 4> columns, Vec3 f, Vec4& step) const;

  std::array<BallSupport, 2> supports_;
  RadiusLaw law_;
  std::function<MovingPlane(double)> planes_;
  Vec4 extents_;
};

/// Throws InvalidInput as `track_through`.
void validate(const BallSupport& support, const char* name);
void validate_radius(double radius);

}  // namespace blossom
