// SPDX-License-Identifier: LGPL-2.1-or-later
// How far patches, and pieces of planes, are at most from a face that is part of a plane, cylinder
// or sphere.

#pragma once

#include <array>
#include <optional>

#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>

#include "adapters/occt/faces/face_trims.h"
#include "core/forms/elementary.h"
#include "core/forms/patch.h"

namespace blossom::occt {

class FeetOnFace {
 public:
  /// face   of a plane, cylinder or sphere; of any other surface nothing is bounded
  explicit FeetOnFace(const TopoDS_Face& face);

  /// A bound on the distances of all points of the patch from the face, model units; nothing unless
  /// the foot of each is proven to lie within the trims.
  ///
  /// The squared distance from an axis or a centre is a quotient of two forms of twice the degree,
  /// and lies between the least and the largest quotient of their Bezier coefficients: exactly so
  /// where the patch is an arc about the same axis.
  ///
  /// within   feet so near to the border need not be proven to lie on this side of it, model units;
  ///          twice as much is added to the bound
  std::optional<double> farthest(const RationalBezierPatch& patch, double within) const;

  /// The same of a face in a plane, from a face of a plane or cylinder, by its edges alone.
  ///
  /// In the plane the distance r from an axis across it is convex, with its minimum on the axis: so
  /// r - radius is largest on an edge, and so is radius - r unless the axis meets the piece.
  /// Heights over a plane are linear.
  std::optional<double> farthest_in_plane(const TopoDS_Face& face, const FaceTrims& piece,
                                          double within) const;

 private:
  using Range = std::array<Interval, 2>;
  std::optional<Range> feet_of(const RationalBezierPatch& patch) const;
  double distance_bound(const Grid<Vec4>& net) const;
  bool axis_meets(const TopoDS_Face& face, const FaceTrims& piece) const;
  bool are_inside(const Range& feet, double within) const;
  bool is_range_inside(const Range& rest, double within) const;

  std::optional<ElementaryKind> kind_;
  gp_Ax3 frame_;
  double radius_ = 0;
  FaceTrims trims_;
};

}  // namespace blossom::occt
