// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges without a curve in the parameters of a face that uses them.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// Whether an edge has a curve in the parameters of a face, or the face is a plane, on which any
/// edge with a curve in space has one.
bool has_curve_on(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// The use of an edge by a face in whose parameters it has no curve.
struct MissingCurve {
  TopoDS_Face face;
  TopoDS_Edge edge;
};

std::vector<MissingCurve> missing_curves(const TopoDS_Shape& shape);

/// Makes those curves where it can, from the curves in space. Changes the shape's edges.
void add_missing_curves(const TopoDS_Shape& shape);

}  // namespace blossom::occt
