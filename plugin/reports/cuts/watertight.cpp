// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/cuts/watertight.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace blossom::reports {

std::size_t triangle_count(const WatertightPieces& pieces) {
  return static_cast<std::size_t>(
      std::ranges::count_if(pieces.pieces, [](const WatertightPiece& piece) {
        return std::holds_alternative<BezierTriangle>(piece.form);
      }));
}

std::size_t common_count(const WatertightPieces& pieces) {
  std::vector<int> uses(pieces.sides.size(), 0);
  for (const WatertightPiece& piece : pieces.pieces)
    for (const int side : piece.sides) ++uses[static_cast<std::size_t>(side)];
  std::size_t count = 0;
  for (std::size_t k = 0; k < uses.size(); ++k)
    count += pieces.sides[k].edge >= 0 && uses[k] > 1 ? 1 : 0;
  return count;
}

std::set<int> folded_faces(const WatertightPieces& pieces) {
  std::set<int> faces;
  for (const int piece : pieces.turned)
    faces.insert(pieces.pieces[static_cast<std::size_t>(piece)].face + 1);
  return faces;
}

Json to_json(const WatertightPieces& pieces) {
  const std::size_t triangles = triangle_count(pieces);
  Json open = Json::array();
  for (const int face : pieces.open) open.push_back(face + 1);
  return {{"patches", pieces.pieces.size() - triangles},
          {"triangles", triangles},
          {"common_sides", common_count(pieces)},
          {"deviation", pieces.deviation},
          {"may_fold", folded_faces(pieces)},
          {"open", open}};
}

}  // namespace blossom::reports
