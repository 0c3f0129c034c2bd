// SPDX-License-Identifier: LGPL-2.1-or-later
// Borders along which a surface touches a plane, as the lip of an inlet or the rim of a dish does.
//
// Let r be the distance of a parameter to the border's. The height over the plane is r^2 h there.
// Lines across may leave the border in any direction of the plane, along the border, too, or not at
// all: there the surface is singular, and the directions of its derivatives prove nothing. But if
// h > 0, points with one image have one r sqrt(h), so that the map which has this in place of the
// height has one image for them, too; and its derivatives do not vanish at the border.

#pragma once

#include <optional>
#include <vector>

#include "core/cells/direction_cones.h"
#include "core/cells/surface_cells.h"

namespace blossom {

class FlatBorder {
 public:
  /// Nothing for rational surfaces, borders that are straight, and those that the surface leaves
  /// across the plane.
  /// tolerance   control points that are as near to the plane count as in it, model units
  static std::optional<FlatBorder> of(SurfaceCells& cells, PoleSide side, double tolerance);

  /// Heights of control points that count as in the plane, model units: what is proven holds for
  /// the surface that has them there.
  double within() const { return within_; }

  /// Cones of the map over a rectangle of the surface; nothing where h is not seen to be positive,
  /// and for rectangles that reach beyond the patches at the border or over several of them. To be
  /// joined with those at this border alone.
  /// nets    of all patches
  /// u, v    numbers of spans plus local parameters
  std::optional<DirectionCones> cones(const std::vector<SlopeNets>& nets, const Interval& u,
                                      const Interval& v) const;

 private:
  // h, and its differences along u and v without the degrees; the first coordinate counts.
  struct Heights {
    RationalBezierPatch whole, by_u = {}, by_v = {};
    double rounding = 0;
  };

  FlatBorder(PoleSide side, int rows, int columns) : side_(side), rows_(rows), columns_(columns) {}

  bool across_u() const { return side_ == PoleSide::LowU || side_ == PoleSide::HighU; }
  bool is_low() const { return side_ == PoleSide::LowU || side_ == PoleSide::LowV; }
  // The place of a patch along the border; nothing if it is not one at the border.
  std::optional<int> place_of(int span_u, int span_v) const;
  std::optional<DirectionCones> cones_in(const SlopeNets& nets, int place, const Interval& u,
                                         const Interval& v) const;
  int degree_across(const RationalBezierPatch& patch) const;
  Vec3 point(const RationalBezierPatch& patch, int inwards, int along) const;
  std::vector<Vec3> points_in_rows(SurfaceCells& cells, int first, int last) const;
  bool find_plane(const std::vector<Vec3>& points, double tolerance);
  Heights heights_of(const RationalBezierPatch& patch) const;
  VectorBounds bounds(const RationalBezierPatch& slope, const SlopeNets& nets,
                      const Interval& third) const;

  PoleSide side_;
  int rows_, columns_;  // of patches
  Vec3 in_plane_;
  Axes axes_{};  // the third one is the plane's normal
  double within_ = 0;
  std::vector<Heights> heights_;  // of the patches along the border
};

}  // namespace blossom
