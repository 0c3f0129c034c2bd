// SPDX-License-Identifier: LGPL-2.1-or-later
// Nets of numpy as faces and edges.

#pragma once

#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace blossom::python {

using Net = pybind11::array_t<double>;

/// A direction of a B-spline.
struct KnotVector {
  int degree = 0;
  std::vector<double> knots;        ///< strictly increasing
  std::vector<int> multiplicities;  ///< one for each knot
};

/// The face on a Bezier patch.
/// net      (n + 1, m + 1, 3) points, or (n + 1, m + 1, 4) points x, y, z and weight; rows along u
/// name     what the caller calls the argument, for messages
/// throws   InvalidInput if the shape, a degree, a number or a weight is bad
TopoDS_Face bezier_face(const Net& net, const std::string& name);

/// The same of a B-spline surface.
/// throws   likewise, and if the knots do not go with the number of points
TopoDS_Face spline_face(const Net& net, const KnotVector& u, const KnotVector& v,
                        const std::string& name);

/// The edge on a Bezier or B-spline curve of (n + 1, 3) points, or (n + 1, 4) with weights.
TopoDS_Edge bezier_edge(const Net& net, const std::string& name);
TopoDS_Edge spline_edge(const Net& net, const KnotVector& knots, const std::string& name);

}  // namespace blossom::python
