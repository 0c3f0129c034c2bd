// SPDX-License-Identifier: LGPL-2.1-or-later
// Proof that two trimmed faces meet in nothing but the edges and vertices they share.
//
// What two faces share they have in common, whatever the bits of their surfaces say within the
// edge's tolerance; so nothing there has to be searched. What has to be proven is that they meet
// nowhere else. Cells of both are halved until each pair of them is
//   outside of the trims, or apart by a box or a plane, or
//   within the tolerance of a common vertex, or
//   beside a common edge, where paths prove it (`core/surfaces/adjacency/path_reach.h`): in the
//   chart of each face a parameter line leads from every point of the cell to the edge, or
//   beside a common edge along which one of them touches the other one's plane, cylinder or sphere
//   and stays on one side of all of it (`core/surfaces/pairs/elementary_side.h`), or
//   such that one touches the other one's surface in that way along a line that ends in a common
//   vertex, where the other one begins.
// That holds for smooth neighbours, too, as fillets and what they round, whose surfaces come as
// near to each other as one likes and nearly parallel, and for parts of one surface. Faces that
// share nothing are farther apart than the tolerance or not.

#pragma once

#include <vector>

#include "core/base/work_limit.h"
#include "core/results/result.h"
#include "core/topology/face_data.h"
#include "core/topology/shared.h"

namespace blossom {

struct NeighbourProof {
  bool proven = false;
  Certificate certificate;  ///< of a proof: pairs of cells that are apart
};

/// edges       that both faces share; nothing is proven where a face has one of them twice
/// vertices    that both faces have
/// tolerance   of points, model units. What the faces have in common lies no farther from a common
///             edge or vertex than four times the larger one of this and its own tolerance; where
///             they are tangent, it lies beside the edge where the gap is less than this. Where
///             they are nearly tangent and each of them is as near to the edge as the larger
///             tolerance, they may cross beside the edge, within `kEdgeStrip`: as deep as the
///             borders are apart
/// limit       nothing is proven once it is reached
/// cost        no more than some 30,000 pairs of cells for each pair of patches whose boxes meet;
///             the first place where nothing is proven ends it
NeighbourProof meet_in_shared_only(const FaceData& a, const FaceData& b,
                                   const std::vector<SharedEdge>& edges,
                                   const std::vector<SharedVertex>& vertices, double tolerance,
                                   const WorkLimit& limit);

}  // namespace blossom
