// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the intersection of two solids breaks off, for those who have to mend a model.
//
// In a face of a closed solid the curves along which another one crosses it are closed, or go from
// border to border: where one ends, at an edge of the other solid, the next begins. It does not
// where that edge is off its faces by more than the curve is long there.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <TopoDS_Edge.hxx>

#include "adapters/occt/trim_tool.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// Where the first and the last point of an intersection curve are, and the faces that it lies in.
struct CrossingCurve {
  std::array<Vec3, 2> ends;
  std::array<std::size_t, 2> faces;  ///< of the part, of the tool
};

struct CrossedSolid {
  std::string name;
  const TrimTool* solid = nullptr;
  /// By face: edges of the other solid that lie in it, which curves may go on with.
  const std::vector<std::vector<TopoDS_Edge>>* lying = nullptr;
};

/// A sentence for each end with which nothing goes on, naming the faces, the point and the edge.
///
/// solids   the part, the tool
std::vector<std::string> loose_ends(const std::vector<CrossingCurve>& curves,
                                    const std::array<CrossedSolid, 2>& solids);

}  // namespace blossom::occt
