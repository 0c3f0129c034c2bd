// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a surface near points in space.

#pragma once

#include <optional>
#include <vector>

#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "core/base/work_limit.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/topology/face_trims.h"

namespace blossom::occt {

SurfaceJet frame_at(const Handle(Geom_Surface) & surface, const Vec2& uv);

/// The steps of u and v along the tangent plane that come nearest to a step in space.
Vec2 chart_step(const SurfaceJet& at, const Vec3& step);

/// The second derivatives at a point of a surface.
struct SurfaceBend {
  Vec3 uu, uv, vv;
};

SurfaceBend bend_at(const Handle(Geom_Surface) & surface, const Vec2& uv);

/// A line of the chart that is one point of the surface: a pole of a sphere, the tip of a cone.
struct SurfacePole {
  Vec3 point;
  int fixed = 1;     ///< the parameter that is the same all along it: 0 u, 1 v
  double value = 0;  ///< of that parameter
};

/// The poles of a surface: its borders without length, and tips of cones wherever they are.
std::vector<SurfacePole> poles_of(const Handle(Geom_Surface) & surface);

/// Thrown by SurfaceProjector when its limit is reached.
struct LimitReached {};

/// The nearest points of a face's surface, trims left out.
class SurfaceProjector {
 public:
  /// tolerance   model units, of the search that Newton's method then sharpens
  /// limit       asked at each foot, has to live as long; null: none
  SurfaceProjector(const TopoDS_Face& face, double tolerance, PolledLimit* limit = nullptr);

  const Handle(Geom_Surface) & surface() const { return surface_; }

  /// The parameters of the nearest point; near others, as far as periods and seams leave a choice.
  /// Where the surface has the point within tolerance beside these others, it is found from there
  /// at once. throws   LimitReached
  Vec2 foot(const Vec3& point, const std::optional<Vec2>& near) const;

  /// The distance of a point from that at some parameters.
  double gap(const Vec3& point, const Vec2& uv) const;

  /// How far a foot is from the border of the surface, model units; 0 or less on the border: then
  /// how far past it the point is along the tangent plane.
  double clearance(const Vec3& point, const Vec2& uv) const;

  /// The pole within tolerance of a point; null if there is none.
  const SurfacePole* pole_at(const Vec3& point) const;
  const std::vector<SurfacePole>& poles() const { return poles_; }

  /// Distance from the nearest point, positive on the side of du x dv.
  double height(const Vec3& point) const;

 private:
  struct Sharpened {
    Vec2 uv;
    double gap = 0;
  };
  Sharpened sharpened(const Vec3& point, Vec2 uv, int steps) const;
  Vec2 bounded(Vec2 uv) const;

  Handle(Geom_Surface) surface_;
  Handle(Geom_Plane) plane_;  // null if it is another surface
  Handle(ShapeAnalysis_Surface) finder_;
  double tolerance_;
  PolledLimit* limit_;
  Vec2 period_;
  Vec2 low_, high_;  // bounds of the parameters
  Vec2 closed_;      // where they meet without a period: the distance between them
  std::vector<SurfacePole> poles_;
};

}  // namespace blossom::occt
