// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/solid_validity.h"

#include <algorithm>

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepCheck_Solid.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/solids/polygon_faces.h"

namespace blossom::occt {
namespace {

bool has_none(const BRepCheck_ListOfStatus& problems) {
  return std::all_of(problems.begin(), problems.end(),
                     [](BRepCheck_Status status) { return status == BRepCheck_NoError; });
}

// Faces of planes whose edges keep their curves in its parameters: where they do not, BRepCheck
// projects each one anew some seven times. Everything else is as in the originals.
class FacesToCheck {
 public:
  FacesToCheck() { builder_.MakeCompound(all_); }

  const TopoDS_Compound& all() const { return all_; }

  void add(const TopoDS_Face& face) {
    const TopoDS_Face copy = TopoDS::Face(copy_of(face));
    builder_.NaturalRestriction(copy, BRep_Tool::NaturalRestriction(face));
    keep_chart_curves(copy);
    builder_.Add(all_, copy);
  }

 private:
  // Vertices are shared, copies of edges as the edges are.
  TopoDS_Shape copy_of(const TopoDS_Shape& shape) {
    if (shape.ShapeType() == TopAbs_VERTEX) return shape;
    const TopoDS_Shape bare = shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
    if (!copies_.IsBound(bare)) {
      TopoDS_Shape copy = bare.EmptyCopied();
      for (TopoDS_Iterator part(bare, Standard_False, Standard_False); part.More(); part.Next())
        builder_.Add(copy, copy_of(part.Value()));
      copy.Closed(bare.Closed());
      copies_.Bind(bare, copy);
    }
    return copies_(bare).Located(shape.Location()).Oriented(shape.Orientation());
  }

  void keep_chart_curves(const TopoDS_Face& face) {
    TopLoc_Location place;
    const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
    if (!surface->IsKind(STANDARD_TYPE(Geom_Plane))) return;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (keeps_chart_curve(edge, face)) continue;
      Interval range;
      const Handle(Geom2d_Curve) curve = chart_curve_of(edge, face, range);
      if (curve.IsNull()) continue;
      builder_.UpdateEdge(edge, curve, surface, place, BRep_Tool::Tolerance(edge));
      builder_.Range(edge, surface, place, range.from, range.to);
    }
  }

  BRep_Builder builder_;
  TopoDS_Compound all_;
  TopTools_DataMapOfShapeShape copies_;
};

bool new_faces_are_valid(const TopoDS_Solid& solid, const TopTools_MapOfShape& known) {
  FacesToCheck faces;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    if (!known.Contains(it.Current()) && !is_sound_polygon(TopoDS::Face(it.Current())))
      faces.add(TopoDS::Face(it.Current()));
  return faces.all().NbChildren() == 0 || BRepCheck_Analyzer(faces.all()).IsValid();
}

bool shells_are_valid(const TopoDS_Solid& solid) {
  for (TopoDS_Iterator it(solid); it.More(); it.Next()) {
    if (it.Value().ShapeType() != TopAbs_SHELL) continue;
    const Handle(BRepCheck_Shell) shell = new BRepCheck_Shell(TopoDS::Shell(it.Value()));
    shell->InContext(solid);
    if (!has_none(shell->Status()) || !has_none(shell->StatusOnShape(solid))) return false;
  }
  return true;
}

}  // namespace

bool is_valid(const TopoDS_Solid& solid, const TopTools_MapOfShape& known) {
  const Handle(BRepCheck_Solid) whole = new BRepCheck_Solid(solid);
  return has_none(whole->Status()) && shells_are_valid(solid) && new_faces_are_valid(solid, known);
}

}  // namespace blossom::occt
