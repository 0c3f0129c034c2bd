// SPDX-License-Identifier: LGPL-2.1-or-later
// Copies of faces that Open CASCADE's BRepCheck is quick with.

#pragma once

#include <BRep_Builder.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>

namespace blossom::occt {

/// Faces of planes whose edges keep their curves in its parameters: where they do not, BRepCheck
/// projects each one anew some seven times. Everything else is as in the originals.
class FacesToCheck {
 public:
  FacesToCheck() { builder_.MakeCompound(all_); }

  const TopoDS_Compound& all() const { return all_; }

  /// returns   the copy
  TopoDS_Face add(const TopoDS_Face& face);

 private:
  TopoDS_Shape copy_of(const TopoDS_Shape& shape);
  void keep_chart_curves(const TopoDS_Face& face);

  BRep_Builder builder_;
  TopoDS_Compound all_;
  TopTools_DataMapOfShapeShape copies_;
};

}  // namespace blossom::occt
