// SPDX-License-Identifier: LGPL-2.1-or-later
// Models against themselves: a copy turned about the middle of the model's box and moved.

#pragma once

#include <TopoDS_Shape.hxx>

#include "core/math/vec.h"

namespace blossom::bench {

struct Sized {
  Vec3 middle;
  double size = 0;  ///< diagonal of the box
};

/// By the box of the shape's geometry.
Sized sized_by_box(const TopoDS_Shape& shape);

/// A copy turned by so many degrees about an axis through the middle of the shape's box, then moved
/// by a part of its size.
TopoDS_Shape moved_copy(const TopoDS_Shape& shape, double degrees, double part,
                        const Vec3& axis = {0.3, 0.5, 0.81});

}  // namespace blossom::bench
