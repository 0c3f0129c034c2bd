// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/border_numbers.h"

#include <TopExp.hxx>

namespace blossom::occt {

BorderNumbers::BorderNumbers(const TopoDS_Shape& shape) {
  TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
}

BorderNumber BorderNumbers::of(const TopoDS_Shape& on, int face) const {
  if (on.IsNull()) return {"face", face};
  if (on.ShapeType() == TopAbs_EDGE) return {"edge", edges_.FindIndex(on)};
  return {"vertex", vertices_.FindIndex(on)};
}

}  // namespace blossom::occt
