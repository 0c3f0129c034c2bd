// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/combined_pair.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/solids/clear_charts.h"
#include "adapters/occt/solids/sheets.h"
#include "adapters/occt/solids/solid_divisions.h"
#include "adapters/occt/solids/solid_shells.h"
#include "adapters/occt/solids/validity/solid_validity.h"
#include "core/base/work_limit.h"

namespace blossom::occt {
namespace {

constexpr const char* kMeasuring = "measuring volumes";
constexpr const char* kCoveredFace =
    "a face would be no wider than what the tolerances of its edges cover";

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

// Under all faces of a solid.
double volume_of(const TrimTool& solid, ConeVolumes& cones, const WorkLimit& limit) {
  double volume = 0;
  for (const TopoDS_Face& face : solid.faces) {
    check_limit(&limit, kMeasuring);
    volume += cones.of(face);
  }
  return volume;
}

// What cannot be measured was not divided well: its wires may be open.
double volume_of(const SolidPiece& piece, const TrimTool& of, const char* owner,
                 ConeVolumes& cones) try {
  return cones.of(piece.face);
} catch (const BadModel& error) {
  throw Failure("a piece of " + face_name(of, static_cast<std::size_t>(piece.from), owner) + ": " +
                error.what());
}

std::vector<Measured> measured(const std::vector<SolidPiece>& pieces, const TrimTool& of,
                               const char* owner, ConeVolumes& cones, const WorkLimit& limit) {
  std::vector<Measured> all;
  for (const SolidPiece& piece : pieces) {
    check_limit(&limit, kMeasuring);
    all.push_back({piece, volume_of(piece, of, owner, cones)});
  }
  return all;
}

enum class Turn { AsItIs, Round };

void choose(const std::vector<Measured>& pieces, int tool, SolidSide side, Turn turn,
            Chosen& chosen) {
  for (const auto& [piece, volume] : pieces) {
    if (piece.side != side) continue;
    const bool round = turn == Turn::Round;
    const TopoDS_Face face = round ? TopoDS::Face(piece.face.Reversed()) : piece.face;
    chosen.faces.push_back({face, round ? -volume : volume});
    chosen.origins.push_back({face, tool, piece.from});
    chosen.origins.back().of_both = side == SolidSide::Same;
  }
}

// What bounds the part without the tool, what they have in common, and both together. Where they
// coincide with material on the same side, the part's faces stand for both.
struct Results {
  Chosen cut, common, fuse;
};

Results results_of(const std::vector<Measured>& part, const std::vector<Measured>& tool) {
  Results made;
  choose(part, -1, SolidSide::Outside, Turn::AsItIs, made.cut);
  choose(part, -1, SolidSide::Opposite, Turn::AsItIs, made.cut);
  choose(tool, 0, SolidSide::Inside, Turn::Round, made.cut);
  choose(part, -1, SolidSide::Inside, Turn::AsItIs, made.common);
  choose(part, -1, SolidSide::Same, Turn::AsItIs, made.common);
  choose(tool, 0, SolidSide::Inside, Turn::AsItIs, made.common);
  choose(part, -1, SolidSide::Outside, Turn::AsItIs, made.fuse);
  choose(part, -1, SolidSide::Same, Turn::AsItIs, made.fuse);
  choose(tool, 0, SolidSide::Outside, Turn::AsItIs, made.fuse);
  return made;
}

void tell_left_out(int shells, SolidTrimResult& result) {
  result.merged.push_back((shells == 1 ? "a shell" : std::to_string(shells) + " shells") +
                          std::string(" of no more than what tolerances of edges cover, left out"));
  result.status = weaker(result.status, Status::Tolerance);
}

void add_solids(const Chosen& chosen, const WorkLimit& limit, SolidTrimResult& result) {
  std::string obstacle;
  int left_out = 0;
  const std::vector<TopoDS_Solid> solids = guarded(
      "making solids", [&] { return solids_of(chosen.faces, obstacle, &limit, &left_out); });
  if (!obstacle.empty()) result.obstacles.push_back(obstacle);
  result.solids.insert(result.solids.end(), solids.begin(), solids.end());
  TopTools_MapOfShape kept;
  for (const TopoDS_Solid& solid : solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) kept.Add(it.Current());
  std::ranges::copy_if(chosen.origins, std::back_inserter(result.faces),
                       [&](const SolidFace& face) { return kept.Contains(face.face); });
  if (left_out > 0) tell_left_out(left_out, result);
}

// Measures the results of pieces and makes the solids that are asked for.
void put_together(const SolidPieces& pieces, const TrimTool& part, const TrimTool& tool,
                  SolidOperation operation, ConeVolumes& cones, const WorkLimit& limit,
                  SolidTrimResult& result) {
  const double of_part = volume_of(part, cones, limit), of_tool = volume_of(tool, cones, limit);
  const Results made = results_of(measured(pieces.a, part, "the part", cones, limit),
                                  measured(pieces.b, tool, "the tool", cones, limit));
  const SolidVolumes volumes{of_part, of_tool, made.cut.volume(), made.common.volume(),
                             made.fuse.volume()};
  result.volumes.push_back(volumes);
  if (operation == SolidOperation::Cut || operation == SolidOperation::Split)
    add_solids(made.cut, limit, result);
  if (operation == SolidOperation::Common || operation == SolidOperation::Split)
    add_solids(made.common, limit, result);
  if (operation == SolidOperation::Fuse) add_solids(made.fuse, limit, result);
  if (!(volumes.cut_error() <= kVolumeError + pieces.between / volumes.part) ||
      !(volumes.fuse_error() <= kVolumeError + pieces.between / (volumes.part + volumes.tool)))
    result.obstacles.emplace_back("the volumes do not add up");
}

// What is done with pieces, however they were made.
struct PairJob {
  const TrimTool& part;
  const TrimTool& tool;
  SolidOperation operation;
  ConeVolumes& cones;
  const TopTools_MapOfShape& valid;  // faces that need not be checked
};

SolidTrimResult combined_of(const SolidPieces& pieces, const PairJob& job,
                            const IntersectionOptions& options) {
  const auto& [part, tool, operation, cones, valid] = job;
  const WorkLimit limit(options);
  SolidTrimResult result;
  result.status = pieces.status;
  result.certificate = pieces.certificate;
  result.obstacles = pieces.obstacles;
  result.merged = pieces.merged;
  if (!result.obstacles.empty()) return result;
  try {
    if (!part.is_solid())
      take_sheet_pieces(pieces, part, tool, operation, result);
    else if (tool.is_solid())
      put_together(pieces, part, tool, operation, cones, limit, result);
    else
      divide_by_sheet(pieces, part, cones, limit, result);
    if (result.obstacles.empty() && !are_valid(result.solids, valid, limit) &&
        !(cover_tangent_corners(result.solids, valid) && are_valid(result.solids, valid, limit)))
      result.obstacles.emplace_back(kInvalidSolid);
    if (result.obstacles.empty() && has_covered_face(result.solids, valid))
      result.obstacles.emplace_back(kCoveredFace);
    if (!part.is_solid() && result.obstacles.empty() && !are_valid(result.faces, valid))
      result.obstacles.emplace_back(kInvalidFace);
  } catch (const Failure& error) {
    result.obstacles.emplace_back(error.what());
    if (limit.reached_after_search() != nullptr) result.status = Status::Stopped;
  }
  return result;
}

// In the charts that their faces have: the first division that nothing stands against, else what
// stands against the very first.
SolidTrimResult combined_as_they_are(const PairJob& job, double stated,
                                     const IntersectionOptions& options) {
  const SharedLimit limit(options);
  SolidDivisions divisions(job.part, job.tool, stated, options);
  std::optional<SolidTrimResult> first;
  while (const auto pieces = divisions.next()) {
    SolidTrimResult made = combined_of(*pieces, job, limit.remaining());
    if (made.obstacles.empty()) return made;
    if (!first) first = std::move(made);
  }
  return *std::move(first);
}

}  // namespace

Vec3 cone_apex(const TrimTool& part) {
  const TopExp_Explorer vertex(part.faces.front(), TopAbs_VERTEX);
  if (!vertex.More()) throw BadModel("a face has no vertex");
  const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
  return {point.X(), point.Y(), point.Z()};
}

double SolidVolumes::cut_error() const { return std::abs(cut + common - part) / part; }

double SolidVolumes::fuse_error() const {
  return std::abs(fuse + common - part - tool) / (part + tool);
}

SolidTrimResult combined_pair(const TrimTool& part, const TrimTool& tool, SolidOperation operation,
                              const IntersectionOptions& options, double stated, ConeVolumes& cones,
                              const TopTools_MapOfShape& valid) {
  const ClearCharts of_part = clear_charts(part, tool);
  const ClearCharts of_tool = clear_charts(tool, of_part.solid);
  SolidTrimResult made = combined_as_they_are(
      {of_part.solid, of_tool.solid, operation, cones, valid}, stated, options);
  turn_back(of_part, made);
  turn_back(of_tool, made);
  return made;
}

}  // namespace blossom::occt
