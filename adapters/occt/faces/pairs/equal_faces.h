// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of two shapes that are one and the same, as those of a model and of its copy.
//
// Such faces coincide without any search, and a face meets the copies of its neighbours just as it
// meets these: along the edges it shares with them.

#pragma once

#include <map>
#include <utility>
#include <vector>

#include "adapters/occt/faces/face_list.h"
#include "adapters/occt/faces/pairs/shared_edges.h"
#include "core/topology/face_match.h"

namespace blossom::occt {

/// The faces of one list that are copies of faces of another.
class FaceCopies {
 public:
  /// pairs      of the lists' faces, converted, among which copies are looked for
  /// tolerance  of the answer; faces that differ by a thousandth of it are copies, if what their
  ///            surfaces are approximated within leaves them as near as it
  FaceCopies(const FaceList& a, const FaceList& b, const std::vector<std::pair<int, int>>& pairs,
             double tolerance);

  /// Null if the faces are none.
  const FaceMatch* between(int a, int b) const;

  /// The same question with the lists exchanged: of a face p and a copy of q, that of q and the
  /// copy of p, if both copies have the same numbers. Else the pair itself.
  std::pair<int, int> exchanged(const std::pair<int, int>& pair) const;

  /// The edges that a face of the first list shares with a face of the second, or with that of its
  /// own list which this is a copy of. Parameters are those of the very faces.
  std::vector<SharedEdge> shared(int a, int b) const;

 private:
  const FaceList& a_;
  const FaceList& b_;
  std::map<std::pair<int, int>, FaceMatch> matches_;
  std::vector<int> originals_;  // of the faces of b, in a; -1: none
  // The same if all numbers agree, and the other way round.
  std::vector<int> exact_originals_, exact_copies_;
};

}  // namespace blossom::occt
