// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/validity/sound_faces.h"

#include <algorithm>
#include <exception>

#include <BRepCheck_Edge.hxx>
#include <BRepCheck_Face.hxx>
#include <BRepCheck_Vertex.hxx>
#include <BRepCheck_Wire.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/check_words.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/faces/face_trims.h"
#include "core/topology/simple_loops.h"

namespace blossom::occt {
namespace {

// Parameters. BRepCheck takes curves as near as 1e-10 for one.
constexpr double kCheckMargin = 2e-10;
// Of the chart's size: what is rounded in the conversion of curves is far below.
constexpr double kSizeMargin = 1e-11;

bool is_fine(const Handle(BRepCheck_Result) & check, const TopoDS_Shape& in) {
  check->Blind();
  check->InContext(in);
  return finds_nothing(check->Status()) && finds_nothing(check->StatusOnShape(in));
}

// Charts that are converted to the last bits.
bool has_exact_chart(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  Interval range;
  Handle(Geom2d_Curve) curve = chart_curve_of(edge, face, range);
  if (const auto part = Handle(Geom2d_TrimmedCurve)::DownCast(curve); !part.IsNull())
    curve = part->BasisCurve();
  return !curve.IsNull() && (curve->IsKind(STANDARD_TYPE(Geom2d_Line)) ||
                             curve->IsKind(STANDARD_TYPE(Geom2d_Circle)) ||
                             curve->IsKind(STANDARD_TYPE(Geom2d_Ellipse)) ||
                             curve->IsKind(STANDARD_TYPE(Geom2d_BSplineCurve)) ||
                             curve->IsKind(STANDARD_TYPE(Geom2d_BezierCurve)));
}

TopTools_IndexedMapOfShape parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, kind, parts);
  return parts;
}

bool is_directed(const TopoDS_Shape& part) {
  return part.Orientation() == TopAbs_FORWARD || part.Orientation() == TopAbs_REVERSED;
}

// No vertices, no edges within or outside of it, which are in no loop.
bool has_only_loops(const TopoDS_Face& face) {
  for (TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next()) {
    if (wire.Value().ShapeType() != TopAbs_WIRE || !is_directed(wire.Value())) return false;
    for (TopoDS_Iterator edge(wire.Value()); edge.More(); edge.Next())
      if (!is_directed(edge.Value())) return false;
  }
  return true;
}

bool is_fine_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  const Handle(BRepCheck_Edge) check = new BRepCheck_Edge(edge);
  return is_fine(check, face) && check->CheckPolygonOnTriangulation(edge) == BRepCheck_NoError;
}

bool edges_are_fine(const TopoDS_Face& face) {
  const TopTools_IndexedMapOfShape edges = parts_of(face, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    if (!has_exact_chart(edge, face) || !is_fine_edge(edge, face)) return false;
    const TopTools_IndexedMapOfShape vertices = parts_of(edge, TopAbs_VERTEX);
    for (int k = 1; k <= vertices.Extent(); ++k) {
      const Handle(BRepCheck_Vertex) vertex = new BRepCheck_Vertex(TopoDS::Vertex(vertices(k)));
      if (!is_fine(vertex, edge) || !is_fine(vertex, face)) return false;
    }
  }
  return true;
}

bool wires_are_fine(const TopoDS_Face& face) {
  const TopTools_IndexedMapOfShape wires = parts_of(face, TopAbs_WIRE);
  for (int i = 1; i <= wires.Extent(); ++i) {
    const Handle(BRepCheck_Wire) wire = new BRepCheck_Wire(TopoDS::Wire(wires(i)));
    if (!finds_nothing(wire->Status()) || wire->Closed() != BRepCheck_NoError ||
        wire->Orientation(face) != BRepCheck_NoError || wire->Closed2d(face) != BRepCheck_NoError)
      return false;
  }
  const Handle(BRepCheck_Face) whole = new BRepCheck_Face(face);
  return finds_nothing(whole->Status());
}

Nesting nesting_of(const TopoDS_Face& face) try {
  if (!has_only_loops(face)) return Nesting::InDoubt;
  const FaceTrims trims = face_trims(face);
  const double margin = std::max(kCheckMargin * std::max(trims.scale[0], trims.scale[1]),
                                 kSizeMargin * distance(trims.box.low, trims.box.high));
  return blossom::nesting_of(trims, margin);
} catch (const Standard_Failure&) {  // BRepCheck has its own words for what is no geometry
  return Nesting::InDoubt;
} catch (const std::exception&) {
  return Nesting::InDoubt;
}

}  // namespace

bool loops_are_simple(const TopoDS_Face& face) { return nesting_of(face) == Nesting::Sound; }

bool has_hole_astray(const TopoDS_Face& face) { return nesting_of(face) == Nesting::HoleAstray; }

bool is_sound_face(const TopoDS_Face& face) try {
  return loops_are_simple(face) && edges_are_fine(face) && wires_are_fine(face);
} catch (const Standard_Failure&) {
  return false;
} catch (const std::exception&) {
  return false;
}

}  // namespace blossom::occt
