// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solid_trim.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>

#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include "adapters/occt/area.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/solid_pieces.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

// A face as it bounds a result, with the volume of its cone.
struct BoundingFace {
  SolidFace of;
  double volume = 0;
};

struct Shell {
  TopoDS_Shell shape;
  double volume = 0;
};

// One piece of a solid and what its cone adds.
struct Measured {
  SolidPiece piece;
  double volume = 0;
};

BoundingFace bounding(const Measured& measured, bool of_tool, bool reversed) {
  const SolidPiece& piece = measured.piece;
  if (!reversed) return {{piece.face, of_tool, piece.from}, measured.volume};
  return {{TopoDS::Face(piece.face.Reversed()), of_tool, piece.from}, -measured.volume};
}

std::vector<Measured> measured(const std::vector<SolidPiece>& pieces, const Vec3& apex) {
  std::vector<Measured> all;
  for (const SolidPiece& piece : pieces) all.push_back({piece, cone_volume(piece.face, apex)});
  return all;
}

// The faces of one side of a, and of one side of b, perhaps turned round.
std::vector<BoundingFace> chosen(const std::vector<Measured>& a, ToolSide side_a,
                                 const std::vector<Measured>& b, ToolSide side_b, bool reversed) {
  std::vector<BoundingFace> faces;
  for (const Measured& each : a)
    if (each.piece.side == side_a) faces.push_back(bounding(each, false, false));
  for (const Measured& each : b)
    if (each.piece.side == side_b) faces.push_back(bounding(each, true, reversed));
  return faces;
}

double sum(const std::vector<BoundingFace>& faces) {
  return std::accumulate(
      faces.begin(), faces.end(), 0.0,
      [](double so_far, const BoundingFace& face) { return so_far + face.volume; });
}

double volume_of(const TrimTool& solid, const Vec3& apex) {
  double volume = 0;
  for (const TopoDS_Face& face : solid.faces) volume += cone_volume(face, apex);
  return volume;
}

// Uses of an edge by the faces of a result, and one face for each direction.
struct EdgeUse {
  int forward = 0;
  int reversed = 0;
  std::size_t first = 0;
};

// Faces that hang together have one number; none if an edge is not used once in each direction.
std::vector<std::size_t> connected(const std::vector<BoundingFace>& faces, int& open_edges) {
  std::vector<std::size_t> parent(faces.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  TopTools_IndexedMapOfShape edges;
  std::vector<EdgeUse> uses;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (TopExp_Explorer it(faces[i].of.face, TopAbs_EDGE); it.More(); it.Next()) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
      const auto number = static_cast<std::size_t>(edges.Add(it.Current())) - 1;
      if (number == uses.size()) uses.push_back({0, 0, i});
      ++(it.Current().Orientation() == TopAbs_FORWARD ? uses[number].forward
                                                      : uses[number].reversed);
      parent[root(i)] = root(uses[number].first);
    }
  open_edges = static_cast<int>(std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) {
    return use.forward != 1 || use.reversed != 1;
  }));
  std::vector<std::size_t> groups;
  for (std::size_t i = 0; i < faces.size(); ++i) groups.push_back(root(i));
  return groups;
}

std::vector<Shell> shells_of(const std::vector<BoundingFace>& faces, std::string& obstacle) {
  int open_edges = 0;
  const std::vector<std::size_t> groups = connected(faces, open_edges);
  if (open_edges > 0) {
    obstacle = "the shell does not close at " + std::to_string(open_edges) + " edges";
    return {};
  }
  std::map<std::size_t, Shell> shells;
  const BRep_Builder builder;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Shell& shell = shells[groups[i]];
    if (shell.shape.IsNull()) builder.MakeShell(shell.shape);
    builder.Add(shell.shape, faces[i].of.face);
    shell.volume += faces[i].volume;
  }
  std::vector<Shell> all;
  for (auto& [group, shell] : shells) {
    shell.shape.Closed(Standard_True);
    all.push_back(std::move(shell));
  }
  return all;
}

// The smallest outer shell round a void; the number of shells if there is none.
std::size_t around(const Shell& hollow, const std::vector<Shell>& shells) {
  const auto point =
      point_inside(TopoDS::Face(TopExp_Explorer(hollow.shape, TopAbs_FACE).Current()));
  std::size_t best = shells.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; point && i < shells.size(); ++i) {
    if (shells[i].volume <= -hollow.volume || shells[i].volume >= least) continue;
    TopoDS_Solid solid;
    BRep_Builder().MakeSolid(solid);
    BRep_Builder().Add(solid, shells[i].shape);
    const BRepClass3d_SolidClassifier classifier(solid, *point, Precision::Confusion());
    if (classifier.State() != TopAbs_IN) continue;
    best = i;
    least = shells[i].volume;
  }
  return best;
}

std::vector<TopoDS_Solid> solids_of(const std::vector<BoundingFace>& faces, std::string& obstacle) {
  const std::vector<Shell> shells = shells_of(faces, obstacle);
  const BRep_Builder builder;
  std::vector<TopoDS_Solid> by_shell(shells.size());
  for (std::size_t i = 0; i < shells.size(); ++i)
    if (shells[i].volume > 0) {
      builder.MakeSolid(by_shell[i]);
      builder.Add(by_shell[i], shells[i].shape);
    }
  for (const Shell& shell : shells) {
    if (shell.volume > 0) continue;
    const std::size_t outer = around(shell, shells);
    if (outer == shells.size()) {
      obstacle = "a shell is turned inwards, but no solid is round it";
      return {};
    }
    builder.Add(by_shell[outer], shell.shape);
  }
  std::vector<TopoDS_Solid> solids;
  for (const TopoDS_Solid& solid : by_shell) {
    if (solid.IsNull()) continue;
    if (!BRepCheck_Analyzer(solid).IsValid()) obstacle = "a solid is not valid by BRepCheck";
    solids.push_back(solid);
  }
  return solids;
}

void add_solids(const std::vector<BoundingFace>& faces, SolidTrimResult& result) {
  std::string obstacle;
  const std::vector<TopoDS_Solid> solids =
      guarded("making solids", [&] { return solids_of(faces, obstacle); });
  if (!obstacle.empty()) result.obstacles.push_back(obstacle);
  result.solids.insert(result.solids.end(), solids.begin(), solids.end());
  for (const BoundingFace& face : faces) result.faces.push_back(face.of);
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
  const std::vector<Measured> a = measured(pieces.a, apex), b = measured(pieces.b, apex);
  const auto cut = chosen(a, ToolSide::Above, b, ToolSide::Below, true);
  const auto common = chosen(a, ToolSide::Below, b, ToolSide::Below, false);
  const auto fuse = chosen(a, ToolSide::Above, b, ToolSide::Above, false);
  result.volumes = {volume_of(part, apex), volume_of(tool, apex), sum(cut), sum(common), sum(fuse)};
  if (operation == SolidOperation::Cut || operation == SolidOperation::Split)
    add_solids(cut, result);
  if (operation == SolidOperation::Common || operation == SolidOperation::Split)
    add_solids(common, result);
  if (operation == SolidOperation::Fuse) add_solids(fuse, result);
  if (!(std::max(result.volumes.cut_error(), result.volumes.fuse_error()) <= kVolumeError))
    result.obstacles.emplace_back("the volumes do not add up");
  if (!result.obstacles.empty()) {
    result.solids.clear();
    result.faces.clear();
  }
  return result;
}

}  // namespace blossom::occt
