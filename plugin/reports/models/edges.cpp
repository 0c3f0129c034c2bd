// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/edges.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/intersection_edges.h"

namespace blossom::reports {

std::set<int> edge_numbers(const Input& input) {
  TopTools_IndexedMapOfShape all, own;
  TopExp::MapShapes(input.model.shape(), TopAbs_EDGE, all);
  for (const TopoDS_Face& face : input.faces) TopExp::MapShapes(face, TopAbs_EDGE, own);
  std::set<int> numbers(input.edges.begin(), input.edges.end());
  for (int i = 1; i <= own.Extent(); ++i)
    if (const int number = all.FindIndex(own(i)); number > 0) numbers.insert(number);
  return numbers;
}

std::vector<TopoDS_Edge> edges_without_faces(const Input& input) {
  const bool all = static_cast<int>(input.numbers.size()) == input.model.face_count();
  const TopoDS_Shape shape = !input.selected.IsNull() ? input.selected
                             : all                    ? input.shape
                                                      : TopoDS_Shape();
  return occt::loose_edges_of(shape);
}

Json edges_json(const std::vector<occt::EdgeFacts>& edges) {
  Json list = Json::array();
  for (const occt::EdgeFacts& edge : edges)
    list.push_back({{"number", edge.number},
                    {"faces", edge.faces},
                    {"kind", to_string(edge.kind)},
                    {"angle", edge.angle},
                    {"length", edge.length},
                    {"parameters", {edge.from, edge.to}},
                    {"middle", edge.middle.coordinates}});
  return list;
}

}  // namespace blossom::reports
