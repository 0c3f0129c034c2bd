// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a face's surface near points in space.

#pragma once

#include <vector>

#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/vec.h"
#include "core/topology/chart_projector.h"

namespace blossom::occt {

SurfaceJet frame_at(const Handle(Geom_Surface) & surface, const Vec2& uv);

/// The second derivatives at a point of a surface.
struct SurfaceBend {
  Vec3 uu, uv, vv;
};

SurfaceBend bend_at(const Handle(Geom_Surface) & surface, const Vec2& uv);

/// The poles of a surface: its borders without length, and tips of cones wherever they are.
std::vector<SurfacePole> poles_of(const Handle(Geom_Surface) & surface);

/// The nearest points of a face's surface, trims left out.
class SurfaceProjector : public ChartProjector {
 public:
  /// tolerance, limit   as ChartProjector has them
  SurfaceProjector(const TopoDS_Face& face, double tolerance, PolledLimit* limit = nullptr);

  /// Of a spline that goes on beyond its bounds as its last pieces do, by a part of its range in
  /// each direction in which it does not close; not beyond a pole. Its feet are found from the
  /// nearest of some points: for points that are on the surface, or that it does not matter for
  /// where they are. All other surfaces are as they are.
  static SurfaceProjector going_on(const TopoDS_Face& face, double tolerance, double beyond);

  const Handle(Geom_Surface) & surface() const { return surface_; }

 private:
  SurfaceProjector(Handle(Geom_Surface) surface, ProjectedSurface projected, double tolerance,
                   PolledLimit* limit);

  Handle(Geom_Surface) surface_;
};

}  // namespace blossom::occt
