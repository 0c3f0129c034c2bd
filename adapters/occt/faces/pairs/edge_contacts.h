// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and runs in which the outlines of two faces meet.
//
// Where the surfaces of two faces coincide, no curve of theirs leads to a point that the faces
// alone have in common, as the corners of two squares in one plane, nor to an edge along which they
// lie side by side.

#pragma once

#include <vector>

#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/interval.h"
#include "core/results/result.h"

namespace blossom::occt {

/// An edge as a face uses it.
struct OutlineEdge {
  TopoDS_Edge edge;
  Handle(Geom2d_Curve) chart;  ///< in the face's parameters, with the edge's own parameter
  bool seam = false;           ///< the face lies on both sides of it
};

struct OutlinePoint {
  SurfacePoint at;
  double gap = 0;        ///< distance of the edges there, or of an end from the other edge, model
                         ///< units
  bool crosses = false;  ///< one edge is proven to pass the other one, farther than tolerance from
                         ///< the ends of both
};

struct OutlineRun {
  OutlineEdge a, b;
  Interval at_a;        ///< increasing
  Interval at_b;        ///< the parameters of b at the ends of `at_a`; may decrease
  double gap = 0;       ///< bound on the distance of the edges along it, model units
  bool proven = false;  ///< false: `gap` is the largest of samples
};

struct OutlineContacts {
  std::vector<OutlinePoint> points;  ///< each once
  std::vector<OutlineRun> runs;
  bool complete = true;  ///< false: some place in which edges come near has no point or run here
};

/// What the edges of two faces have in common within tolerance, in space.
///
/// tolerance   model units
/// throws      BadModel if an edge has no curve in space or on its face
OutlineContacts outline_contacts(const TopoDS_Face& a, const TopoDS_Face& b, double tolerance);

}  // namespace blossom::occt
