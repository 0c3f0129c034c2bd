// SPDX-License-Identifier: LGPL-2.1-or-later
// How deep pieces of a body's boundary lie inside of another body.

#pragma once

#include <functional>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/distance.h"

namespace blossom::occt {

/// The depth of a penetration between bounds, model units.
struct Depth {
  double lower = 0;  ///< taken at `deepest`
  double upper = 0;  ///< proven
  Vec3 deepest;
};

/// The largest distance of a point of the pieces from the boundary of the body that they lie in.
///
/// Cells of the pieces are halved, those first that may lie deepest, until the bounds agree to a
/// hundredth or kDepthCells cells were looked at. No point of a cell is deeper than its middle by
/// more than the cell's radius; nor farther from the boundary than from a face that all its feet
/// lie on, which may hold of a whole piece in a plane; nor than s, if the cell moved by s lies
/// outside of the body, since every point crosses the boundary on that way.
///
/// pieces     faces within the body or on its boundary
/// boundary   of a closed solid
/// tolerance  model units
/// known      the least that is of interest, model units; nothing below is looked for
/// stop       asked often; true leaves the bounds as they are by then
/// throws     BadModel if a piece cannot be converted
Depth depth_of(const std::vector<TopoDS_Face>& pieces, const MeasuredShape& boundary,
               double tolerance, double known = 0, const std::function<bool()>& stop = {});

inline constexpr int kDepthCells = 20'000;
inline constexpr double kDepthAccuracy = 0.01;  ///< relative

}  // namespace blossom::occt
