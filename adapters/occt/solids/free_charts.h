// SPDX-License-Identifier: LGPL-2.1-or-later
// Charts of faces of revolution that can be moved while the faces stay where they are as sets of
// points.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include <BRepTools_ReShape.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>

#include "core/forms/elementary.h"
#include "core/math/interval.h"

namespace blossom::occt {

/// Where a chart is moved to, in its own frame: turned, and the seam of a ring about its axis moved
/// along the tube. Radians.
struct ChartMove {
  gp_Dir about = gp::DZ();
  double angle = 0;
  double along_tube = 0;
};

/// A seam in the frame of its chart.
struct Seam {
  Handle(Geom_Curve) curve;  ///< a line or a circle
  Interval range;
  double speed = 1;                   ///< length for each unit of the parameter
  std::optional<Elementary> surface;  ///< that it lies on, if it is elementary
  std::array<bool, 2> at_pole;        ///< whether the chart is singular where it begins, and ends

  gp_Pnt point(double at) const { return curve->Value(at); }
};

/// A Ball is a whole sphere, which may be turned about any axis through its centre. A Ring is a
/// whole torus. Turned are cylinders, cones, parts of spheres and tori, and surfaces of revolution
/// of lines and circles, that go round one axis and meet in rims, closed edges that begin and end
/// in a seam: all turn together. What else has these rims is plane, and the corners have no other
/// edges.
enum class ChartKind { Ball, Ring, Turned };

/// Faces with the seams that are moved together.
struct FreeChart {
  ChartKind kind = ChartKind::Turned;
  gp_Ax3 frame{};   ///< right-handed, z along the axis
  double size = 0;  ///< the largest distance of a seam from the axis; model units
  std::vector<TopoDS_Face> faces{};
  std::vector<Seam> seams{};  ///< as they are
};

/// All charts of a model's faces that can be moved.
std::vector<FreeChart> free_charts(const std::vector<TopoDS_Face>& faces);

std::vector<Seam> moved_seams(const FreeChart& chart, const ChartMove& move);

/// Says what takes the place of the chart's faces, and of the rims in the planes beside them.
void move_chart(const FreeChart& chart, const ChartMove& move, BRepTools_ReShape& into);

}  // namespace blossom::occt
