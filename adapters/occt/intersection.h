// SPDX-License-Identifier: LGPL-2.1-or-later
// All intersections of two shapes, face by face, written back as Open CASCADE curves.

#pragma once

#include <utility>
#include <vector>

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "core/self_intersection.h"
#include "core/surface_intersection.h"
#include "core/surfaces/branches/seam_chains.h"

namespace blossom::occt {

/// An intersection curve as Open CASCADE takes it; the three share their parameter.
struct EdgeCurves {
  /// A line, circle, ellipse, parabola or hyperbola where the curve is one, else a B-spline.
  /// Trimmed to its range, but for a whole circle or ellipse that begins at 0.
  Handle(Geom_Curve) curve;
  Handle(Geom2d_BSplineCurve) pcurve_a;
  Handle(Geom2d_BSplineCurve) pcurve_b;
  double tolerance = 0;  ///< for the edge: max(1e-7, 1.1 x deviation), model units
};

/// What of the faces' borders a point is on: a vertex or an edge, null inside of the face.
struct BorderPlace {
  TopoDS_Shape on_a;
  TopoDS_Shape on_b;
};

/// The intersection of one face with another. Numbers are indices into the callers' lists.
struct FaceIntersection {
  int face_a = 0;
  int face_b = 0;
  SurfaceIntersection found;         ///< clipped to the trims of both faces
  std::vector<EdgeCurves> edges;     ///< one for each of found.curves
  std::vector<CurveChain> chains;    ///< of found.curves: pieces between seams that are one curve
  std::vector<BorderPlace> borders;  ///< one for each of found.points
  /// Where the faces are equal, and so the whole of them is their only common region: the edges
  /// round it, as each of them has them. Empty otherwise.
  std::vector<std::pair<TopoDS_Edge, TopoDS_Edge>> equal_edges;
};

/// What of a face's surface is searched. Results are clipped to the trims in any case.
enum class Extent {
  Trims,     ///< the rectangle of the trims; it goes on a little where the trims are no rectangle
  Extended,  ///< a little more wherever the surface goes on, so that what lies along a border, or
             ///< within tolerance of it, is found like all else
};

struct ShapeIntersection {
  Status status = Status::Complete;     ///< the weakest of all pairs
  std::vector<FaceIntersection> pairs;  ///< only pairs with something to tell
  Certificate certificate;              ///< summed over all pairs
  long face_pairs = 0;                  ///< pairs whose boxes met
  double tolerance = 0;                 ///< of points, that was asked for
  double time_limit = 0;                ///< likewise, seconds; 0: none
};

/// Intersects every face of one list with every face of the other. Faces are converted where the
/// hulls of others come near them. Faces that are described by the same numbers are told to
/// coincide as a whole without a search (where such a face meets itself, `self_intersect` tells),
/// and meet the neighbours of each other in the edges that those share with them. A face that goes
/// on smoothly into a plane meets other planes that are one with it in the edges between the two.
///
/// Planes, cylinders, cones, spheres and tori that are one by `one_within` (core/base/tolerances.h)
/// over all that two faces may have in common are one: their overlaps, the edges along which they
/// lie side by side and the corners that touch follow from their outlines. Planes that cross do so
/// in a line. Where curves run along edges, or only touch them, within the same distance, that is
/// decided, too. The certificate counts what is taken for one, and how far apart it is at most.
/// throws   BadModel if a face cannot be converted; the message has the face's place in its list
ShapeIntersection intersect(const std::vector<TopoDS_Face>& a, const std::vector<TopoDS_Face>& b,
                            const IntersectionOptions& options = {},
                            Extent extent = Extent::Extended);

/// What of a shape is compared with itself.
enum class SelfScope {
  EachFace,  ///< every face with itself
  AllFaces,  ///< also different faces with each other
};

/// Intersects faces of one shape with themselves, as core/self_intersection.h does; pairs of a face
/// with itself have its number twice, others the lower one first. The seam of a closed face is no
/// intersection, nor are edges and vertices that two faces share.
/// throws   BadModel likewise
ShapeIntersection self_intersect(const std::vector<TopoDS_Face>& faces, SelfScope scope,
                                 const IntersectionOptions& options = {});

}  // namespace blossom::occt
