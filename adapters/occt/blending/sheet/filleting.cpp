// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/filleting.h"

#include <algorithm>
#include <optional>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/sheet/blend_check.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/blending/sheet/fillet_order.h"
#include "adapters/occt/blending/strips/ball_walk.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/solids/solid_shells.h"

namespace blossom::occt {

void Filleting::find_parts(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces, solids;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  for (int i = 1; i <= faces.Extent(); ++i) faces_given_.push_back(TopoDS::Face(faces(i)));
  if (body_.edge_count() > 0) {
    const gp_Pnt p = BRep_Tool::Pnt(body_.vertex({1, true}));
    apex_ = {p.X(), p.Y(), p.Z()};
  }
  for (int i = 1; i <= solids.Extent(); ++i) {
    SolidPart part;
    part.solid = TopoDS::Solid(solids(i));
    for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next()) {
      const int number = faces.FindIndex(it.Current());
      part.faces.insert(number);
      part.volume += cone_volume(TopoDS::Face(it.Current()), apex_);
    }
    parts_.push_back(std::move(part));
  }
}

const SolidPart& Filleting::part_of(int edge) const {
  const int face = body_.use(edge, true).face;
  const auto found = std::ranges::find_if(
      parts_, [face](const SolidPart& part) { return part.faces.count(face) > 0; });
  if (found == parts_.end())
    throw FilletRefused({FilletFault::Edge, edge, "it belongs to no solid", {}, {}, {}});
  if (found->volume <= 0)
    throw FilletRefused({FilletFault::Edge, edge, "its solid is turned inside out", {}, {}, {}});
  return *found;
}

FilletedSolid Filleting::closed(const SolidPart& part, const std::vector<TrimmedFace>& faces,
                                const FilletEdges& edges) const {
  FilletedSolid made;
  std::vector<BoundingFace> bounding;
  for (const TrimmedFace& each : faces) {
    if (each.from > 0 && part.faces.count(each.from) == 0) continue;
    bounding.push_back({each.face, cone_volume(each.face, apex_)});
    made.volume += bounding.back().volume;
    made.faces.push_back({each.face, each.from, each.edge});
  }
  std::string obstacle;
  const std::vector<TopoDS_Solid> solids = solids_of(bounding, obstacle);
  if (!obstacle.empty() || solids.size() != 1)
    throw FilletRefused({FilletFault::Result,
                         edges.begin()->first,
                         obstacle.empty() ? "the solid would fall apart" : obstacle,
                         {},
                         {},
                         {}});
  made.solid = solids.front();
  return made;
}

// Edges of one group, into a solid of the shape.
Grouped Filleting::with_group(const SolidPart& part, const FilletEdges& edges) {
  const auto tick = [this] { check_limit(limit_.get(), kFilleting); };
  const double tolerance = options_.intersection.tolerances.point;
  WalkOptions walking{options_, tolerance, {}, tick};
  for (const auto& [edge, concave] : edges) walking.filleted.insert(edge);
  BlendSheet sheet(body_, tolerance, options_.chamfer.has_value());
  for (const EdgeRun& run : edge_runs(body_, edges)) sheet.add(ball_walk(body_, run, walking));
  tick();
  sheet.build();
  tick();
  TrimmedBody trimmed = trimmed_by_sheet(body_, sheet, tolerance);
  notes_.insert(notes_.end(), sheet.notes().begin(), sheet.notes().end());
  Grouped grouped{closed(part, trimmed.faces, edges), std::move(trimmed.edges)};
  check_blended(body_, part.solid, part.volume, grouped.made, edges);
  check_apart(grouped.made, options_.intersection, tick);
  return grouped;
}

// The edges of a group in a solid that other fillets were put into, and the numbers that they had.
Filleting::Renamed Filleting::renamed(const Filleting& next, const Grouped& done,
                                      const FilletEdges& group) const {
  Renamed renamed;
  TopTools_IndexedMapOfShape numbers;
  TopExp::MapShapes(done.made.solid, TopAbs_EDGE, numbers);
  for (const auto& [edge, concave] : group) {
    std::vector<TopoDS_Edge> left{body_.edge(edge)};
    if (const auto known = done.edges.find(edge); known != done.edges.end()) left = known->second;
    for (const TopoDS_Edge& each : left) {
      const int number = numbers.FindIndex(each);
      if (number == 0)
        throw FilletRefused({FilletFault::EdgeConsumed,
                             edge,
                             "fillets of other edges take it away",
                             std::nullopt,
                             std::nullopt,
                             {}});
      renamed.of.emplace(number, edge);
    }
  }
  for (const auto& [number, edge] : renamed.of)
    renamed.edges.merge(smooth_chain(next.body(), number));
  return renamed;
}

// A group into a solid that other groups were put into.
FilletedSolid Filleting::with_next(const Grouped& done, const FilletEdges& group) {
  Filleting next(done.made.solid, options_, limit_);
  Renamed in_next = renamed(next, done, group);
  const auto old_number = [&](int number) {
    const auto known = in_next.of.find(number);
    return known == in_next.of.end() ? 0 : known->second;
  };
  FilletedSolid made;
  try {
    made = next.made(in_next.edges).front();
  } catch (const FilletRefused& refusal) {
    FilletRefusal why = refusal.why();
    why.edge = old_number(why.edge);
    if (why.edge == 0) why.edge = group.begin()->first;
    throw FilletRefused(why);
  }
  notes_.insert(notes_.end(), next.notes_.begin(), next.notes_.end());
  for (FilletFace& face : made.faces) {
    if (face.from == 0) {
      face.edge = old_number(face.edge);
      continue;
    }
    const TopoDS_Face& before = next.face_given(face.from);
    const auto origin = std::ranges::find_if(
        done.made.faces, [&](const FilletFace& each) { return each.face.IsSame(before); });
    face.from = origin->from;
    face.edge = origin->edge;
  }
  return made;
}

std::vector<FilletedSolid> Filleting::made(const FilletEdges& edges) {
  std::vector<FilletedSolid> all;
  notes_.clear();
  for (const SolidPart& part : parts_) {
    FilletEdges own;
    for (const auto& [edge, concave] : edges)
      if (&part_of(edge) == &part) own.emplace(edge, concave);
    if (own.empty()) {
      FilletedSolid kept{part.solid, {}, part.volume};
      for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next())
        kept.faces.push_back({TopoDS::Face(it.Current()), 0, 0});
      std::size_t next = 0;
      for (const int number : part.faces) kept.faces[next++].from = number;
      all.push_back(std::move(kept));
      continue;
    }
    const std::vector<FilletEdges> groups = fillet_order(body_, own);
    Grouped done = with_group(part, groups.front());
    if (groups.size() > 1) {
      FilletEdges others;
      for (std::size_t i = 1; i < groups.size(); ++i)
        others.insert(groups[i].begin(), groups[i].end());
      done.made = with_next(done, others);
    }
    all.push_back(std::move(done.made));
  }
  return all;
}

}  // namespace blossom::occt
