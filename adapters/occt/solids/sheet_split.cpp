// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/sheets.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include <BRep_Tool.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/piece_edges.h"
#include "adapters/occt/solids/solid_shells.h"

namespace blossom::occt {
namespace {

// How often pieces use each edge.
class EdgeUses {
 public:
  void add(const std::vector<SolidPiece>& pieces) {
    for (const SolidPiece& piece : pieces)
      for (TopExp_Explorer it(piece.face, TopAbs_EDGE); it.More(); it.Next()) {
        if (!bounds_piece(it.Current())) continue;
        if (int* const count = uses_.ChangeSeek(it.Current()))
          ++*count;
        else
          uses_.Bind(it.Current(), 1);
      }
  }
  bool has_free(const SolidPiece& piece) const {
    for (TopExp_Explorer it(piece.face, TopAbs_EDGE); it.More(); it.Next())
      if (bounds_piece(it.Current()) && uses_.Find(it.Current()) == 1) return true;
    return false;
  }

 private:
  NCollection_DataMap<TopoDS_Shape, int, TopTools_ShapeMapHasher> uses_;
};

// Leaves out what ends freely, and what ends freely without that.
void leave_out_free(const std::vector<SolidPiece>& part, std::vector<SolidPiece>& sheet) {
  std::size_t before = 0;
  do {
    before = sheet.size();
    EdgeUses uses;
    uses.add(part);
    uses.add(sheet);
    std::erase_if(sheet, [&](const SolidPiece& piece) { return uses.has_free(piece); });
  } while (sheet.size() < before);
}

// The pieces of the part, and both sides of each piece of the sheet, one after the other.
std::vector<BoundingFace> bounding_faces(const std::vector<SolidPiece>& part,
                                         const std::vector<SolidPiece>& sheet, ConeVolumes& cones) {
  std::vector<BoundingFace> faces;
  const auto add = [&](const TopoDS_Face& face) { faces.push_back({face, cones.of(face)}); };
  for (const SolidPiece& piece : part) add(piece.face);
  for (const SolidPiece& piece : sheet) {
    add(piece.face);
    add(TopoDS::Face(piece.face.Reversed()));
  }
  return faces;
}

// Leaves out what has the same body on both sides; false if there is nothing of the kind.
bool leave_out_inner(const std::vector<std::size_t>& bodies, std::size_t part,
                     std::vector<SolidPiece>& sheet) {
  std::vector<SolidPiece> kept;
  for (std::size_t i = 0; i < sheet.size(); ++i)
    if (bodies[part + 2 * i] != bodies[part + 2 * i + 1]) kept.push_back(sheet[i]);
  const bool any = kept.size() < sheet.size();
  sheet = std::move(kept);
  return any;
}

std::vector<SolidFace> origins_of(const std::vector<SolidPiece>& part,
                                  const std::vector<SolidPiece>& sheet) {
  std::vector<SolidFace> origins;
  for (const SolidPiece& piece : part) origins.push_back({piece.face, -1, piece.from});
  for (const SolidPiece& piece : sheet) {
    origins.push_back({piece.face, 0, piece.from});
    origins.push_back({TopoDS::Face(piece.face.Reversed()), 0, piece.from});
  }
  return origins;
}

void give_out_whole(const TrimTool& part, SolidTrimResult& result) {
  result.solids = part.solids;
  for (std::size_t i = 0; i < part.faces.size(); ++i)
    result.faces.push_back({part.faces[i], -1, static_cast<int>(i)});
}

double sum_of(const std::vector<BoundingFace>& faces) {
  double sum = 0;
  for (const BoundingFace& face : faces) sum += face.volume;
  return sum;
}

}  // namespace

void divide_by_sheet(const SolidPieces& pieces, const TrimTool& part, ConeVolumes& cones,
                     const WorkLimit& limit, SolidTrimResult& result) {
  std::vector<SolidPiece> sheet;
  std::ranges::copy_if(pieces.b, std::back_inserter(sheet),
                       [](const SolidPiece& piece) { return piece.side == SolidSide::Inside; });
  std::string obstacle;
  std::vector<BoundingFace> faces;
  for (bool again = true; again;) {
    leave_out_free(pieces.a, sheet);
    faces = bounding_faces(pieces.a, sheet, cones);
    const std::vector<std::size_t> bodies = bodies_of(faces, obstacle, &limit);
    again = !bodies.empty() && leave_out_inner(bodies, pieces.a.size(), sheet);
  }
  double of_part = 0;
  for (const TopoDS_Face& face : part.faces) of_part += cones.of(face);
  const double divided = sum_of(faces);
  const SolidVolumes volumes{of_part, 0, divided, 0, divided};
  result.volumes.push_back(volumes);
  if (sheet.empty()) {
    give_out_whole(part, result);
  } else {
    result.solids = guarded("making solids", [&] { return solids_of(faces, obstacle, &limit); });
    result.faces = origins_of(pieces.a, sheet);
  }
  if (!obstacle.empty()) result.obstacles.push_back(obstacle);
  if (!(volumes.cut_error() <= kVolumeError + pieces.between / volumes.part))
    result.obstacles.emplace_back("the volumes do not add up");
}

}  // namespace blossom::occt
