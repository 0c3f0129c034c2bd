// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/shape_numbers.h"

#include <TopExp.hxx>

namespace blossom::cli {

ShapeNumbers::ShapeNumbers(const TopoDS_Shape& shape) {
  TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
}

Json ShapeNumbers::place(const TopoDS_Shape& on, int face) const {
  if (on.IsNull()) return {{"kind", "face"}, {"number", face}};
  const bool edge = on.ShapeType() == TopAbs_EDGE;
  return {{"kind", edge ? "edge" : "vertex"},
          {"number", edge ? edges_.FindIndex(on) : vertices_.FindIndex(on)}};
}

std::string ShapeNumbers::text(const TopoDS_Shape& on, int face) const {
  const Json where = place(on, face);
  return where["kind"].get<std::string>() + " " + std::to_string(where["number"].get<int>());
}

}  // namespace blossom::cli
