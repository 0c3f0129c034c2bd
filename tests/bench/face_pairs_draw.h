// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of free-form faces of a model, drawn by a seed.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::bench {

struct FacePair {
  std::string kind;  ///< "nb": neighbours; "c1", "c2", "c3": a face and another one of a moved copy
  TopoDS_Face a, b;
};

/// Up to `most` pairs of each kind: neighbours along an edge, and faces of the model with faces of
/// a copy turned by 23, 2 and 0.05 degrees about a random axis through the middle of the model
/// and moved by 6, 0.4 and 0.01 % of its size. The boxes of the faces of a pair meet. Free-form are
/// B-spline and Bezier surfaces.
std::vector<FacePair> draw_pairs(const TopoDS_Shape& model, std::uint64_t seed, int most);

/// Writes a pair to a file of the folder that is named after the model and the pair; says so if
/// that cannot be done.
void keep(const std::string& folder, const std::string& name, const FacePair& faces,
          std::size_t number);

}  // namespace blossom::bench
