// SPDX-License-Identifier: LGPL-2.1-or-later
// How far the curves of an edge are apart, measured.
//
// An edge has a curve in space, C, and on each of its faces a curve P in the parameters of the
// surface S. They should be one: the image S(P) lies on C, and at the same parameter.

#pragma once

#include <optional>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace blossom::occt {

/// Model units; infinite where a number of the geometry is not finite. Measured at samples between
/// all knots, refined at the largest: lower bounds of the true maxima.
struct EdgeGaps {
  bool has_curve = true;        ///< in space; degenerated edges need none
  bool has_pcurve = true;       ///< on the face
  double same_parameter = 0;    ///< max |C(t) - S(P(t))|
  double gap = 0;               ///< max distance of S(P(t)) from the points of C near it
  double vertex_gap = 0;        ///< of the end that misses its vertex the most, in tolerances
  double vertex_tolerance = 0;  ///< of that vertex
};

/// The gaps of an edge on a face, as oriented in its wire: a seam has two curves there. Of a
/// degenerated edge the gap is that to its vertex.
EdgeGaps edge_gaps(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// Of these the largest, `same_parameter`, alone; none if the edge lacks a curve.
/// least   a gap of arcs on elementary surfaces that samples show to be less is not refined; model
///         units
std::optional<double> same_parameter_gap(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                         double least);

}  // namespace blossom::occt
