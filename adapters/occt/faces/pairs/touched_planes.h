// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges along which faces touch planes of another shape, as a neighbour of theirs lies in the same
// plane: such a face and the plane have a contact that is known before any search.
//
// Where surfaces touch but for what one of them was approximated by, they cross to and fro within
// far less than the tolerance, and a search would find every crossing.

#pragma once

#include <array>
#include <utility>
#include <vector>

#include "adapters/occt/faces/face_list.h"
#include "core/results/result.h"
#include "core/topology/clipping/clipped_result.h"
#include "core/topology/shared.h"

namespace blossom::occt {

class TouchedPlanes {
 public:
  /// pairs       of the lists' faces, converted, which are asked about
  /// tolerance   of the answer; planes are one by `one_within`
  TouchedPlanes(const FaceList& a, const FaceList& b, const std::vector<std::pair<int, int>>& pairs,
                double tolerance);

  /// Edges of a face of either list that it shares with faces in the plane of the other one and at
  /// which it goes on smoothly into them: all of them, also where the other one's trims end.
  /// Their number is -1 in the plane's trims, what planes differ by is in their gaps, and their
  /// parameters are arc length on average.
  ///
  /// smooth   the largest angle that counts as smooth, radians
  /// returns  none if both faces are elementary: closed forms decide these
  std::vector<SharedEdge> of(int a, int b, double smooth) const;

 private:
  std::array<const FaceList*, 2> lists_;
  double tolerance_;
  // By list and face that is not elementary: the planes of its list that have an edge with it.
  std::array<std::vector<std::vector<int>>, 2> neighbours_;
};

/// Adds what of such edges of one pair lies within the trims of the plane's face: as curves, and
/// where they only touch these trims.
void add_touching(const FaceData& a, const FaceData& b, const std::vector<SharedEdge>& edges,
                  double tolerance, SurfaceIntersection& found, std::vector<Touch>& touches);

}  // namespace blossom::occt
