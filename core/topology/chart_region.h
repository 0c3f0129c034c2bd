// SPDX-License-Identifier: LGPL-2.1-or-later
// Which points of a chart lie inside the trims of a face: at once for nearly all of them.
//
// A grid over the trims knows which of its squares no wire comes near; those are inside or outside
// as a whole. Points in other squares are decided one by one, by `is_inside`.

#pragma once

#include <vector>

#include "core/topology/face_trims.h"

namespace blossom {

class ChartRegion {
 public:
  enum class Place : unsigned char { Outside, Inside, Near };

  explicit ChartRegion(const FaceTrims& trims);

  /// Which side a rectangle lies on; Near if a wire meets it. Proven but for the roundings of
  /// halving: pieces of wires are looked at by the boxes of their control points.
  Place place(const FaceTrims& trims, const PlanarBox& rectangle) const;

  /// Near says that a wire runs through this square or one beside it; nothing else is sure then.
  Place place(const Vec2& point) const;

 private:
  void mark(const PlanarBezier& curve, int depth);
  void mark_box(const PlanarBox& box);
  void fill(const FaceTrims& trims);
  int column(double x) const;
  int row(double y) const;
  Place& at_cell(int i, int j);

  PlanarBox box_;
  Vec2 per_cell_;  // squares per chart length
  bool natural_ = false;
  std::vector<Place> cells_;
};

}  // namespace blossom
