// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces that Open CASCADE cannot sew.

#pragma once

#include <BRep_Builder.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::testing {

/// The same face with edges that have no ends.
inline TopoDS_Shape without_vertices(const TopoDS_Shape& shape) {
  const BRep_Builder builder;
  TopoDS_Shape made = shape.EmptyCopied();
  if (shape.ShapeType() == TopAbs_EDGE) return made;
  for (TopoDS_Iterator it(shape, false); it.More(); it.Next())
    builder.Add(made, without_vertices(it.Value()));
  return made;
}

}  // namespace blossom::testing
