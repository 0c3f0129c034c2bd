// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/equal_degrees.h"

#include <cstddef>
#include <variant>
#include <vector>

#include "core/forms/algebra/degree.h"
#include "core/math/index.h"

namespace blossom {
void raise_degrees(WatertightPieces& pieces) {
  std::vector<int> degree;
  for (const WatertightSide& side : pieces.sides) degree.push_back(side.curve.degree());
  bool changed = true;
  const auto raise = [&](int& low, int to) {
    if (low >= to) return;
    low = to;
    changed = true;
  };
  std::vector<int> wanted(pieces.pieces.size(), 0);
  while (changed) {
    changed = false;
    for (std::size_t p = 0; p < pieces.pieces.size(); ++p) {
      const auto* triangle = std::get_if<BezierTriangle>(&pieces.pieces[p].form);
      if (!triangle) continue;
      raise(wanted[p], triangle->degree);
      for (const int side : pieces.pieces[p].sides) {
        if (pieces.sides[index(side)].edge < 0 || degree[index(side)] < 0) continue;
        raise(degree[index(side)], wanted[p]);
        raise(wanted[p], degree[index(side)]);
      }
    }
  }
  for (std::size_t p = 0; p < pieces.pieces.size(); ++p)
    if (auto* triangle = std::get_if<BezierTriangle>(&pieces.pieces[p].form))
      *triangle = elevated(*triangle, wanted[p]);
  for (std::size_t s = 0; s < pieces.sides.size(); ++s) {
    WatertightSide& side = pieces.sides[s];
    if (side.edge < 0 || side.curve.points.empty()) continue;
    side.curve = elevated(side.curve, degree[s]);
    side.curve.points.front() = pieces.vertices[index(side.from)];
    side.curve.points.back() = pieces.vertices[index(side.to)];
  }
}

}  // namespace blossom
