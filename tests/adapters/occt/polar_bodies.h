// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies whose only face goes from pole to pole, and holes in them.

#pragma once

#include <vector>

#include <TopoDS_Shape.hxx>

namespace blossom::testing {

struct PolarBody {
  const char* name;
  TopoDS_Shape shape;
};

/// A ball and an egg round the z axis, as they are and as splines.
std::vector<PolarBody> polar_bodies();

/// With a hole of radius 2 from the origin on, in a direction by its angles round the z axis and
/// above the xy plane.
TopoDS_Shape bored(const TopoDS_Shape& body, double angle, double up);

/// Of all faces.
double area_of(const TopoDS_Shape& shape);

}  // namespace blossom::testing
