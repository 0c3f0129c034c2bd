// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/sheet_ends.h"

#include <BRep_Tool.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace blossom::occt {
namespace {

using ShapeCount = NCollection_DataMap<TopoDS_Shape, int, TopTools_ShapeMapHasher>;

void count_one(const TopoDS_Shape& shape, ShapeCount& counts) {
  if (int* const count = counts.ChangeSeek(shape))
    ++*count;
  else
    counts.Bind(shape, 1);
}

ShapeCount edge_uses(const std::vector<TopoDS_Face>& pieces) {
  ShapeCount uses;
  for (const TopoDS_Face& piece : pieces)
    for (TopExp_Explorer it(piece, TopAbs_EDGE); it.More(); it.Next())
      if (it.Current().Orientation() != TopAbs_INTERNAL &&
          !BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
        count_one(it.Current(), uses);
  return uses;
}

// The vertices of edges that one piece has alone.
TopTools_MapOfShape border_vertices(const std::vector<TopoDS_Face>& pieces) {
  TopTools_MapOfShape vertices;
  const ShapeCount uses = edge_uses(pieces);
  for (ShapeCount::Iterator it(uses); it.More(); it.Next())
    if (it.Value() == 1)
      for (TopoDS_Iterator end(it.Key()); end.More(); end.Next()) vertices.Add(end.Value());
  return vertices;
}

// How many edges of cuts end in each vertex.
ShapeCount cut_ends(const std::vector<CurveEdges>& cuts) {
  ShapeCount ends;
  TopTools_MapOfShape counted;
  for (const CurveEdges& cut : cuts)
    for (const auto* edges : {&cut.made, &cut.along})
      for (const CurveEdge& each : *edges)
        if (counted.Add(each.edge))
          for (TopoDS_Iterator end(each.edge); end.More(); end.Next()) count_one(end.Value(), ends);
  return ends;
}

}  // namespace

bool end_with_sheet(const std::vector<TopoDS_Face>& pieces, const std::vector<CurveEdges>& cuts) {
  const TopTools_MapOfShape border = border_vertices(pieces);
  const ShapeCount ends = cut_ends(cuts);
  for (ShapeCount::Iterator it(ends); it.More(); it.Next())
    if (it.Value() == 1 && !border.Contains(it.Key())) return false;
  return true;
}

}  // namespace blossom::occt
