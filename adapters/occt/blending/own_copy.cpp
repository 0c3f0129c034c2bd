// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/own_copy.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace blossom::occt {
namespace {

TopoDS_Shape copied(const TopoDS_Shape& shape, TopTools_DataMapOfShapeShape& known) {
  const TopoDS_Shape plain = shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
  if (!known.IsBound(plain)) {
    TopoDS_Shape made = plain.EmptyCopied();
    if (made.ShapeType() == TopAbs_FACE)
      BRep_Builder().NaturalRestriction(TopoDS::Face(made),
                                        BRep_Tool::NaturalRestriction(TopoDS::Face(plain)));
    for (TopoDS_Iterator it(plain, Standard_False, Standard_False); it.More(); it.Next())
      BRep_Builder().Add(made, copied(it.Value(), known));
    made.Closed(plain.Closed());
    made.Infinite(plain.Infinite());
    made.Convex(plain.Convex());
    known.Bind(plain, made);
  }
  return known.Find(plain).Located(shape.Location(), false).Oriented(shape.Orientation());
}

}  // namespace

TopoDS_Shape own_copy(const TopoDS_Shape& shape) {
  TopTools_DataMapOfShapeShape known;
  return copied(shape, known);
}

}  // namespace blossom::occt
