// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/narrowed_vertices.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_parts.h"
#include "adapters/occt/repair/edge_tolerances.h"
#include "adapters/occt/soundness.h"
#include "core/base/sampled_margin.h"
#include "core/math/vec.h"

namespace blossom::occt {
namespace {

// Those that would be far too wide if they needed no more than Open CASCADE's confusion. No vertex
// needs less, so others are not far too wide whatever they need, which takes long to measure.
std::vector<TopoDS_Vertex> wide_vertices(const std::vector<TopoDS_Solid>& solids) {
  TopTools_IndexedMapOfShape all;
  for (const TopoDS_Solid& solid : solids) TopExp::MapShapes(solid, TopAbs_VERTEX, all);
  std::vector<TopoDS_Vertex> wide;
  for (int i = 1; i <= all.Extent(); ++i) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(all(i));
    const double given = BRep_Tool::Tolerance(vertex);
    if (NeededTolerance{given, Precision::Confusion()}.is_far_too_large()) wide.push_back(vertex);
  }
  return wide;
}

TopoDS_Compound together(const std::vector<TopoDS_Solid>& solids,
                         const std::vector<const TrimTool*>& inputs) {
  TopoDS_Compound all = compound_of(solids);
  for (const TrimTool* input : inputs)
    for (const TopoDS_Face& face : input->faces) BRep_Builder().Add(all, face);
  return all;
}

// How far from a vertex wires of the faces round it meet, which it has to cover; 0 if nowhere, none
// if there is something wrong that it cannot cover, or what bounds a face cannot be followed.
std::optional<double> farthest_meeting(const TopoDS_Vertex& vertex,
                                       const TopTools_ListOfShape& faces) try {
  return guarded("checking wires", [&]() -> std::optional<double> {
    const gp_Pnt point = BRep_Tool::Pnt(vertex);
    double farthest = 0;
    for (const TopoDS_Shape& face : faces)
      for (const Problem& problem : wire_problems(TopoDS::Face(face))) {
        if (!problem.place) return {};
        const Vec3& p = *problem.place;
        farthest = std::max(farthest, point.Distance(gp_Pnt(p[0], p[1], p[2])));
      }
    if (farthest > 0) return farthest;
    const bool valid = std::ranges::all_of(
        faces, [](const TopoDS_Shape& face) { return BRepCheck_Analyzer(face).IsValid(); });
    return valid ? std::optional(0.0) : std::nullopt;
  });
} catch (const std::runtime_error&) {
  return {};
}

// What the ends of its edges need, and no less than these state.
NeededTolerance needed_of_ends(const TopoDS_Vertex& vertex, const SharedParts& parts,
                               NeededTolerances& needs) {
  NeededTolerance own = needs.of(vertex);
  for (const TopoDS_Shape& edge : parts.edges_of_vertices.FindFromKey(vertex))
    own.needed = std::max(own.needed, BRep_Tool::Tolerance(TopoDS::Edge(edge)));
  return own;
}

void narrow(const TopoDS_Vertex& vertex, double needed, const TopTools_ListOfShape& faces) {
  const Handle(BRep_TVertex) data = Handle(BRep_TVertex)::DownCast(vertex.TShape());
  const double given = data->Tolerance();
  while (needed < given) {
    data->Tolerance(needed);
    const std::optional<double> beside = farthest_meeting(vertex, faces);
    if (beside == 0) return;
    if (!beside || kSampledMargin * *beside <= needed) break;
    needed = kSampledMargin * *beside;
  }
  data->Tolerance(given);
}

}  // namespace

void narrow_vertices(const std::vector<TopoDS_Solid>& solids,
                     const std::vector<const TrimTool*>& inputs) {
  const std::vector<TopoDS_Vertex> wide = wide_vertices(solids);
  if (wide.empty()) return;
  guarded("narrowing vertices", [&] {
    const SharedParts parts(together(solids, inputs));
    NeededTolerances needs(parts, {});
    for (const TopoDS_Vertex& vertex : wide)
      if (const NeededTolerance own = needed_of_ends(vertex, parts, needs); own.is_far_too_large())
        narrow(vertex, own.needed, parts.faces_of_vertices.FindFromKey(vertex));
  });
}

}  // namespace blossom::occt
