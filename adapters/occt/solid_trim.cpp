// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solid_trim.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/area.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/solid_pieces.h"
#include "adapters/occt/solid_shells.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

// One piece of a solid and what its cone adds.
struct Measured {
  SolidPiece piece;
  double volume = 0;
};

// The faces of a result, with what is told about each.
struct Chosen {
  std::vector<BoundingFace> faces;
  std::vector<SolidFace> origins;

  double volume() const {
    return std::accumulate(
        faces.begin(), faces.end(), 0.0,
        [](double so_far, const BoundingFace& face) { return so_far + face.volume; });
  }
};

std::vector<Measured> measured(const std::vector<SolidPiece>& pieces, const Vec3& apex) {
  std::vector<Measured> all;
  for (const SolidPiece& piece : pieces) all.push_back({piece, cone_volume(piece.face, apex)});
  return all;
}

enum class Turn { AsItIs, Round };

void add(const std::vector<Measured>& pieces, bool of_tool, SolidSide side, Turn turn,
         Chosen& chosen) {
  for (const auto& [piece, volume] : pieces) {
    if (piece.side != side) continue;
    const bool round = turn == Turn::Round;
    const TopoDS_Face face = round ? TopoDS::Face(piece.face.Reversed()) : piece.face;
    chosen.faces.push_back({face, round ? -volume : volume});
    chosen.origins.push_back({face, of_tool, piece.from});
  }
}

// What bounds the part without the tool, what they have in common, and both together. Where they
// coincide with material on the same side, the part's faces stand for both.
struct Results {
  Chosen cut, common, fuse;
};

Results results_of(const std::vector<Measured>& part, const std::vector<Measured>& tool) {
  Results made;
  add(part, false, SolidSide::Outside, Turn::AsItIs, made.cut);
  add(part, false, SolidSide::Opposite, Turn::AsItIs, made.cut);
  add(tool, true, SolidSide::Inside, Turn::Round, made.cut);
  add(part, false, SolidSide::Inside, Turn::AsItIs, made.common);
  add(part, false, SolidSide::Same, Turn::AsItIs, made.common);
  add(tool, true, SolidSide::Inside, Turn::AsItIs, made.common);
  add(part, false, SolidSide::Outside, Turn::AsItIs, made.fuse);
  add(part, false, SolidSide::Same, Turn::AsItIs, made.fuse);
  add(tool, true, SolidSide::Outside, Turn::AsItIs, made.fuse);
  return made;
}

double volume_of(const TrimTool& solid, const Vec3& apex) {
  double volume = 0;
  for (const TopoDS_Face& face : solid.faces) volume += cone_volume(face, apex);
  return volume;
}

void add_solids(const Chosen& chosen, SolidTrimResult& result) {
  std::string obstacle;
  const std::vector<TopoDS_Solid> solids =
      guarded("making solids", [&] { return solids_of(chosen.faces, obstacle); });
  if (!obstacle.empty()) result.obstacles.push_back(obstacle);
  result.solids.insert(result.solids.end(), solids.begin(), solids.end());
  result.faces.insert(result.faces.end(), chosen.origins.begin(), chosen.origins.end());
}

// All cones have their apex at a vertex of the part, so that volumes keep their digits.
Vec3 apex_of(const TrimTool& part) {
  const TopExp_Explorer vertex(part.faces.front(), TopAbs_VERTEX);
  if (!vertex.More()) throw BadModel("a face has no vertex");
  const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
  return {point.X(), point.Y(), point.Z()};
}

}  // namespace

double SolidVolumes::cut_error() const { return std::abs(cut + common - part) / part; }

double SolidVolumes::fuse_error() const {
  return std::abs(fuse + common - part - tool) / (part + tool);
}

SolidTrimResult trim_solids(const TrimTool& part, const TrimTool& tool, SolidOperation operation,
                            const IntersectionOptions& options) {
  if (!part.is_solid() || !tool.is_solid())
    throw InvalidInput(std::string("trim: the ") + (part.is_solid() ? "tool" : "part") +
                       " is no closed solid");
  const SolidPieces pieces = solid_pieces(part, tool, options);
  SolidTrimResult result{pieces.status, pieces.certificate, {}, {}, {}, pieces.obstacles};
  if (!result.obstacles.empty()) return result;
  const Vec3 apex = apex_of(part);
  const Results made = results_of(measured(pieces.a, apex), measured(pieces.b, apex));
  result.volumes = {volume_of(part, apex), volume_of(tool, apex), made.cut.volume(),
                    made.common.volume(), made.fuse.volume()};
  if (operation == SolidOperation::Cut || operation == SolidOperation::Split)
    add_solids(made.cut, result);
  if (operation == SolidOperation::Common || operation == SolidOperation::Split)
    add_solids(made.common, result);
  if (operation == SolidOperation::Fuse) add_solids(made.fuse, result);
  if (!(std::max(result.volumes.cut_error(), result.volumes.fuse_error()) <= kVolumeError))
    result.obstacles.emplace_back("the volumes do not add up");
  if (!result.obstacles.empty()) {
    result.solids.clear();
    result.faces.clear();
  }
  return result;
}

}  // namespace blossom::occt
