// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a surface near points in space, for a surface that is known by its values alone.

#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/work_limit.h"
#include "core/math/vec.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// The steps of u and v along the tangent plane that come nearest to a step in space; none where
/// there is no tangent plane.
Vec2 chart_step(const SurfaceJet& at, const Vec3& step);

/// A line of the chart that is one point of the surface: a pole of a sphere, the tip of a cone.
struct SurfacePole {
  Vec3 point;
  int fixed = 1;     ///< the parameter that is the same all along it: 0 u, 1 v
  double value = 0;  ///< of that parameter
};

/// A surface as points are projected to it. Parameters are its own.
struct ProjectedSurface {
  std::function<SurfaceJet(const Vec2& uv)> jet;
  /// Parameters near the nearest point of all. Newton's method goes on from there as for a plane,
  /// so what is left of an error comes down, in each of four steps, to the part of it that the
  /// point's distance is of the radius of curvature.
  std::function<Vec2(const Vec3& point)> search;
  bool exact = false;  ///< `search` is a formula, as for a plane: nothing is sharpened then
  bool rough = false;  ///< `search` looks at some points: Newton's method goes on as long as it helps
  Vec2 low, high;      ///< bounds of the parameters; may be without end
  Vec2 period;         ///< 0 for none
  Vec2 closed;         ///< where bounds meet without a period: the distance between them; else 0
  std::vector<SurfacePole> poles;
};

/// Thrown by a projector when its limit is reached.
struct LimitReached {};

/// The nearest points of a surface.
class ChartProjector {
 public:
  /// tolerance   model units, of the search that Newton's method then sharpens
  /// limit       asked at each foot, has to live as long; null: none
  ChartProjector(ProjectedSurface surface, double tolerance, PolledLimit* limit = nullptr);

  /// The parameters of the nearest point; near others, as far as periods and seams leave a choice.
  /// Where the surface has the point within tolerance beside these others, it is found from there
  /// at once.
  /// throws   LimitReached
  Vec2 foot(const Vec3& point, const std::optional<Vec2>& near) const;

  /// From a parameter of a point to the next one that it has in u or in v: the period, or where the
  /// surface closes without one all its range; 0 where it does not.
  Vec2 turns() const { return surface_.period + surface_.closed; }

  /// The distance of a point from that at some parameters.
  double gap(const Vec3& point, const Vec2& uv) const;

  /// How far a foot is from the border of the surface, model units; 0 or less on the border: then
  /// how far past it the point is along the tangent plane.
  double clearance(const Vec3& point, const Vec2& uv) const;

  /// The pole within tolerance of a point; null if there is none.
  const SurfacePole* pole_at(const Vec3& point) const;
  const std::vector<SurfacePole>& poles() const { return surface_.poles; }

  /// Distance from the nearest point, positive on the side of du x dv.
  double height(const Vec3& point) const;

 private:
  struct Sharpened {
    Vec2 uv;
    double gap = 0;
  };
  Vec2 nearest(const Vec3& point, const std::optional<Vec2>& near) const;
  Sharpened sharpened(const Vec3& point, Vec2 uv, int steps) const;
  Vec2 in_turn_of(const Vec2& near, Vec2 uv) const;
  Vec2 within_half_turns(Vec2 step) const;
  Vec2 bounded(Vec2 uv) const;

  ProjectedSurface surface_;
  double tolerance_;
  PolledLimit* limit_;
};

}  // namespace blossom
