// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/repair.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/repair/missing_curves.h"

namespace blossom::occt {
namespace {

void set_tolerance(const TopoDS_Edge& edge, double tolerance) {
  Handle(BRep_TEdge)::DownCast(edge.TShape())->Tolerance(tolerance);
}

void set_tolerance(const TopoDS_Vertex& vertex, double tolerance) {
  Handle(BRep_TVertex)::DownCast(vertex.TShape())->Tolerance(tolerance);
}

template <class Visit>
void for_each(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, const Visit& visit) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, kind, parts);
  for (int i = 1; i <= parts.Extent(); ++i) visit(parts(i));
}

}  // namespace

Repairer::Repairer(const TopoDS_Shape& shape, StatedTolerances stated)
    : shape_(shape), stated_(stated), parts_(shape), needs_(parts_, {}) {
  TopExp::MapShapes(shape, TopAbs_FACE, faces_);
  done_.assign(static_cast<std::size_t>(faces_.Extent()) + 1, false);
  lacks_curves_ = !missing_curves(shape_).empty();
}

bool Repairer::is_loose(const TopoDS_Edge& edge) {
  double tolerance = BRep_Tool::Tolerance(edge);
  if (stated_ == StatedTolerances::Raised)
    if (const NeededTolerance& need = needs_.of(edge); need.is_too_small())
      tolerance = std::max(tolerance, need.needed);
  return tolerance > kLooseTolerance;
}

// Those that have a vertex in common with the face.
std::vector<TopoDS_Shape> Repairer::loose_edges_at(const TopoDS_Face& face) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(face, TopAbs_EDGE, edges);  // an edge may have no vertex
  for_each(face, TopAbs_VERTEX, [&](const TopoDS_Shape& vertex) {
    for (const TopoDS_Shape& edge : parts_.edges_of_vertices.FindFromKey(vertex)) edges.Add(edge);
  });
  std::vector<TopoDS_Shape> loose;
  for (int i = 1; i <= edges.Extent(); ++i)
    if (is_loose(TopoDS::Edge(edges(i)))) loose.push_back(edges(i));
  return loose;
}

// The faces that hang together with this one by vertices of loose edges; mostly itself alone.
Repairer::Group Repairer::group_of(int face) {
  std::set<int> group{face};
  std::vector<int> open{face};
  const auto join = [&](const TopTools_ListOfShape& faces) {
    for (const TopoDS_Shape& each : faces)
      if (const int number = faces_.FindIndex(each); group.insert(number).second)
        open.push_back(number);
  };
  TopTools_MapOfShape seen;
  while (!open.empty()) {
    const TopoDS_Face from = TopoDS::Face(faces_(open.back()));
    open.pop_back();
    for (const TopoDS_Shape& edge : loose_edges_at(from)) {
      if (!seen.Add(edge)) continue;
      join(parts_.faces_of_edges.FindFromKey(edge));
      for_each(edge, TopAbs_VERTEX, [&](const TopoDS_Shape& vertex) {
        join(parts_.faces_of_vertices.FindFromKey(vertex));
      });
    }
  }
  return {group.begin(), group.end()};
}

template <class Part>
void Repairer::raise(const Part& part) {
  const NeededTolerance& need = needs_.of(part);
  if (!need.is_too_small() || raised_.Contains(part)) return;
  set_tolerance(part, need.needed);
  raised_.Add(part);
}

void Repairer::repair_group(const Group& group, const Stop& stop) {
  try {
    raise_and_remake(group, stop);
  } catch (const Standard_Failure&) {
    failed_.insert(failed_.end(), group.begin(), group.end());
  }
  for (const int number : group) done_[static_cast<std::size_t>(number)] = true;
}

void Repairer::raise_and_remake(const Group& group, const Stop& stop) {
  std::vector<TopoDS_Face> faces;
  for (const int number : group) faces.push_back(TopoDS::Face(faces_(number)));
  if (stated_ == StatedTolerances::Raised)
    for (const TopoDS_Face& face : faces) {
      for_each(face, TopAbs_EDGE, [this](const TopoDS_Shape& edge) { raise(TopoDS::Edge(edge)); });
      for_each(face, TopAbs_VERTEX,
               [this](const TopoDS_Shape& vertex) { raise(TopoDS::Vertex(vertex)); });
    }
  for (RemadeImage& made : remake_loose_images(faces, parts_, raised_, stop))
    remade_.push_back(std::move(made));
}

void Repairer::add_missing_curves() {
  const std::vector<MissingCurve> missing = missing_curves(shape_);
  occt::add_missing_curves(shape_);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape_, TopAbs_EDGE, edges);
  for (const auto& [face, edge] : missing)
    missing_.push_back({faces_.FindIndex(face), edges.FindIndex(edge), has_curve_on(edge, face)});
  lacks_curves_ = false;
}

// What was changed since the last call.
Repairs Repairer::told() {
  Repairs made;
  made.missing = std::exchange(missing_, {});
  made.failed = std::exchange(failed_, {});
  if (told_ == raised_.Extent() && remade_.empty()) return made;
  TopTools_IndexedMapOfShape edges, vertices;
  TopExp::MapShapes(shape_, TopAbs_EDGE, edges);
  TopExp::MapShapes(shape_, TopAbs_VERTEX, vertices);
  while (told_ < raised_.Extent()) {
    const TopoDS_Shape& part = raised_(++told_);
    if (part.ShapeType() == TopAbs_EDGE)
      made.edges.push_back({edges.FindIndex(part), BRep_Tool::Tolerance(TopoDS::Edge(part))});
    else
      made.vertices.push_back(
          {vertices.FindIndex(part), BRep_Tool::Tolerance(TopoDS::Vertex(part))});
  }
  for (const RemadeImage& each : std::exchange(remade_, {}))
    made.remade.push_back({faces_.FindIndex(each.face), edges.FindIndex(each.edge), each.gap});
  return made;
}

Repairs Repairer::repair(const std::vector<int>& faces, const Stop& stop) {
  if (lacks_curves_ && static_cast<int>(faces.size()) < faces_.Extent()) return repair_all(stop);
  needs_.set_stop(stop);
  for (const int number : faces)
    if (!done_[static_cast<std::size_t>(number)]) repair_group(group_of(number), stop);
  if (lacks_curves_) add_missing_curves();
  return told();
}

Repairs Repairer::repair_all(const Stop& stop) {
  needs_.set_stop(stop);
  if (stated_ == StatedTolerances::Raised)
    for (int i = 1; i <= parts_.edges_of_vertices.Extent(); ++i)
      if (const TopoDS_Shape& vertex = parts_.edges_of_vertices.FindKey(i);
          !parts_.faces_of_vertices.Contains(vertex))
        raise(TopoDS::Vertex(vertex));
  std::vector<int> all(static_cast<std::size_t>(faces_.Extent()));
  std::iota(all.begin(), all.end(), 1);
  return repair(all, stop);
}

}  // namespace blossom::occt
