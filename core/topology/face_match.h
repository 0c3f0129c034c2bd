// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether two faces are one and the same.

#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/forms/surface_match.h"
#include "core/topology/face_data.h"

namespace blossom {

/// Two faces with one surface and one set of wires.
struct FaceMatch {
  ChartMap map;    ///< from the parameters of the first face to those of the second
  double gap = 0;  ///< bound on what surfaces and wires differ by, model units; 0: the same numbers
  bool same_tolerances = true;             ///< of the edges
  std::vector<std::pair<int, int>> edges;  ///< numbers in both, each once; poles are none
};

/// Whether two faces are one, told by their numbers: control points of the surfaces over the boxes
/// of the trims (`core/forms/surface_match.h`) and of the wires in the charts. Orientations do not
/// matter, nor the directions in which edges run.
///
/// within    largest difference that counts as none, model units; where the surfaces are
///           approximations, their `error` comes on top and is in the match's gap
/// returns   nothing too of equal faces that are described in different ways
std::optional<FaceMatch> match(const FaceData& a, const FaceData& b, double within);

}  // namespace blossom
