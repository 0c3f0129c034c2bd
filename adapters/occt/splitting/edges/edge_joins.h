// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges of single faces that run along each other from end to end, as loose faces have them.

#pragma once

#include <vector>

#include <Adaptor3d_CurveOnSurface.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// The curve that an edge's curve in the chart of a face makes on its surface.
class BorderImage {
 public:
  /// throws   BadModel if the edge has no such curve
  BorderImage(const TopoDS_Edge& edge, const TopoDS_Face& face);

  Interval domain() const { return domain_; }
  Vec3 at(double parameter) const;
  /// Point and first derivative.
  void jet_at(double parameter, Vec3& point, Vec3& first) const;

 private:
  Handle(Adaptor3d_CurveOnSurface) curve_;
  Interval domain_;
};

/// Which parameters of two borders name the same points: c2(t) lies in the plane through c1(s)
/// across c1. Both ways round are the same relation, so they undo each other but for rounding.
class BorderRelation {
 public:
  /// The borders run along each other, `second` backwards where `reversed`.
  BorderRelation(BorderImage first, BorderImage second, bool reversed);

  const BorderImage& first() const { return first_; }
  const BorderImage& second() const { return second_; }

  double first_at(double second) const;  ///< s of t
  double second_at(double first) const;  ///< t of s

  /// The largest distance of points that go together, at some samples; model units.
  double apart() const;

 private:
  void sample();

  BorderImage first_, second_;
  bool reversed_;
  std::vector<Vec2> pairs_;  // s and t of samples, s increasing
};

/// The largest distance of two borders at equal parameters, at some samples; model units.
double apart(const BorderImage& a, const BorderImage& b);

/// Two free edges that become one.
struct EdgeJoin {
  TopoDS_Edge kept, given_up;  ///< forward
  bool reversed = false;       ///< whether they run against each other
  BorderRelation relation;     ///< of the images: first is of the edge that is kept
};

/// The free edges of faces that run along each other, at most two and two: each is the nearest to
/// the other one, and their faces are turned alike. No farther apart than the tolerance, or than
/// vertices and edges claim to be uncertain, and much longer than that.
///
/// faces       of each edge
/// tolerance   model units
std::vector<EdgeJoin> edge_joins(const TopTools_IndexedDataMapOfShapeListOfShape& faces,
                                 double tolerance);

}  // namespace blossom::occt
