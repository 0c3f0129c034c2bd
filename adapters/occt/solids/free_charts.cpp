// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/free_charts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_Circle.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/faces/elementary_faces.h"
#include "adapters/occt/faces/face_groups.h"

namespace blossom::occt {
namespace {

using std::numbers::pi;

using Ancestors = TopTools_IndexedDataMapOfShapeListOfShape;

// What meets where in a model.
struct Neighbourhood {
  Ancestors faces_of_edge, edges_of_vertex;
};

Neighbourhood neighbourhood_of(const std::vector<TopoDS_Face>& faces) {
  Neighbourhood all;
  for (const TopoDS_Face& face : faces) {
    TopExp::MapShapesAndAncestors(face, TopAbs_EDGE, TopAbs_FACE, all.faces_of_edge);
    TopExp::MapShapesAndAncestors(face, TopAbs_VERTEX, TopAbs_EDGE, all.edges_of_vertex);
  }
  return all;
}

// Of a surface that goes round an axis.
std::optional<gp_Ax3> frame_of(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, false);
  switch (surface.GetType()) {
    case GeomAbs_Cylinder: return surface.Cylinder().Position();
    case GeomAbs_Cone: return surface.Cone().Position();
    case GeomAbs_Sphere: return surface.Sphere().Position();
    case GeomAbs_Torus: return surface.Torus().Position();
    case GeomAbs_SurfaceOfRevolution:
      return gp_Ax2(surface.AxeOfRevolution().Location(), surface.AxeOfRevolution().Direction());
    default: return std::nullopt;
  }
}

// How far apart two axes may be to count as one. A choice: a hundredth of the least tolerance, so
// that what turns about one of them stays where it is.
const double kOneAxis = Precision::Confusion() / 100;

bool is_one_axis(const gp_Ax1& a, const gp_Ax1& b) {
  return a.Direction().IsParallel(b.Direction(), Precision::Angular()) &&
         gp_Lin(a).Distance(b.Location()) <= kOneAxis;
}

bool is_plane(const TopoDS_Face& face) {
  return BRepAdaptor_Surface(face, false).GetType() == GeomAbs_Plane;
}

TopTools_IndexedMapOfShape seams_in(const TopoDS_Face& face) {
  TopTools_IndexedMapOfShape seams;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (!BRep_Tool::Degenerated(edge) && BRep_Tool::IsClosed(edge, face)) seams.Add(edge);
  }
  return seams;
}

// Whether an edge is a circle about an axis from a corner of a face to the same.
bool is_rim(const TopoDS_Edge& edge, const gp_Ax1& axis,
            const TopTools_IndexedMapOfShape& corners) {
  const TopoDS_Vertex from = TopExp::FirstVertex(edge);
  const BRepAdaptor_Curve curve(edge);
  return !from.IsNull() && from.IsSame(TopExp::LastVertex(edge)) && corners.Contains(from) &&
         curve.GetType() == GeomAbs_Circle && is_one_axis(curve.Circle().Axis(), axis);
}

// Whether a face goes all round an axis, and all else that bounds it are rims.
bool goes_round(const TopoDS_Face& face) {
  const std::optional<gp_Ax3> frame = frame_of(face);
  if (!frame) return false;
  const TopTools_IndexedMapOfShape seams = seams_in(face);
  TopTools_IndexedMapOfShape corners;
  for (int i = 1; i <= seams.Extent(); ++i) TopExp::MapShapes(seams(i), TopAbs_VERTEX, corners);
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (!BRep_Tool::Degenerated(edge) && !seams.Contains(edge) &&
        !is_rim(edge, frame->Axis(), corners))
      return false;
  }
  return !seams.IsEmpty();
}

// Whether nothing but planes meets the faces of a group, and that in rims alone.
bool can_turn(const std::vector<TopoDS_Face>& group, const Neighbourhood& all) {
  TopTools_IndexedMapOfShape faces, edges, vertices;
  for (const TopoDS_Face& face : group) {
    faces.Add(face);
    TopExp::MapShapes(face, TopAbs_EDGE, edges);
    TopExp::MapShapes(face, TopAbs_VERTEX, vertices);
  }
  for (int i = 1; i <= edges.Extent(); ++i)
    for (const TopoDS_Shape& face : all.faces_of_edge.FindFromKey(edges(i)))
      if (!faces.Contains(face) && !is_plane(TopoDS::Face(face))) return false;
  for (int i = 1; i <= vertices.Extent(); ++i)
    for (const TopoDS_Shape& edge : all.edges_of_vertex.FindFromKey(vertices(i)))
      if (!edges.Contains(edge)) return false;
  const gp_Ax3 first = *frame_of(group.front());
  return std::ranges::all_of(group, [&](const TopoDS_Face& face) {
    return is_one_axis(frame_of(face)->Axis(), first.Axis());
  });
}

gp_Trsf transformation_into(const gp_Ax3& frame) {
  gp_Trsf made;
  made.SetTransformation(frame);
  return made;
}

// The seams of a face as they are; nothing if one is no line or circle.
std::optional<std::vector<Seam>> seams_of(const TopoDS_Face& face, const gp_Trsf& into) {
  const auto surface = elementary_of(BRep_Tool::Surface(TopoDS::Face(face.Moved(into, false))));
  const TopTools_IndexedMapOfShape edges = seams_in(face);
  TopTools_IndexedMapOfShape poles;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
      TopExp::MapShapes(it.Current(), TopAbs_VERTEX, poles);
  std::vector<Seam> seams;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
    Seam seam;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, seam.range.from, seam.range.to);
    if (curve.IsNull()) return std::nullopt;
    seam.curve = Handle(Geom_Curve)::DownCast(curve->Transformed(into));
    const GeomAdaptor_Curve kind(seam.curve);
    if (kind.GetType() != GeomAbs_Line && kind.GetType() != GeomAbs_Circle) return std::nullopt;
    seam.speed = kind.GetType() == GeomAbs_Line ? 1 : kind.Circle().Radius();
    seam.surface = surface;
    seam.at_pole = {poles.Contains(TopExp::FirstVertex(edge)),
                    poles.Contains(TopExp::LastVertex(edge))};
    seams.push_back(seam);
  }
  return seams;
}

ChartKind kind_of(const std::vector<TopoDS_Face>& group) {
  const TopoDS_Face& face = group.front();
  TopTools_IndexedMapOfShape edges;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) edges.Add(it.Current());
  if (edges.Extent() > seams_in(face).Extent()) return ChartKind::Turned;
  switch (BRepAdaptor_Surface(face, false).GetType()) {
    case GeomAbs_Sphere: return ChartKind::Ball;
    case GeomAbs_Torus: return ChartKind::Ring;
    default: return ChartKind::Turned;
  }
}

double from_axis(const gp_Pnt& point) { return std::hypot(point.X(), point.Y()); }

std::optional<FreeChart> chart_of(const std::vector<TopoDS_Face>& group) {
  const gp_Ax3 own = *frame_of(group.front());
  FreeChart made{kind_of(group), gp_Ax3(own.Location(), own.Direction(), own.XDirection())};
  made.faces = group;
  for (const TopoDS_Face& face : group) {
    const auto seams = seams_of(face, transformation_into(made.frame));
    if (!seams) return std::nullopt;
    for (const Seam& seam : *seams)
      for (const double part : {0.0, 0.5, 1.0})
        made.size = std::max(made.size, from_axis(seam.point(at(seam.range, part))));
    made.seams.insert(made.seams.end(), seams->begin(), seams->end());
  }
  return made;
}

gp_Trsf turn_within(const gp_Ax3& frame, const ChartMove& move) {
  const gp_XYZ axis = move.about.X() * frame.XDirection().XYZ() +
                      move.about.Y() * frame.YDirection().XYZ() +
                      move.about.Z() * frame.Direction().XYZ();
  gp_Trsf made;
  made.SetRotation(gp_Ax1(frame.Location(), gp_Dir(axis)), move.angle);
  return made;
}

// The same torus with its corner elsewhere in its chart, and the seams through it.
TopoDS_Face with_seams_at(const TopoDS_Face& face, double u, double v) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const double tolerance = BRep_Tool::MaxTolerance(face, TopAbs_EDGE);
  const BRep_Builder builder;
  TopoDS_Face made;
  builder.MakeFace(made, surface, BRep_Tool::Tolerance(face));
  TopoDS_Vertex corner;
  builder.MakeVertex(corner, surface->Value(u, v), BRep_Tool::MaxTolerance(face, TopAbs_VERTEX));
  const auto seam = [&](const Handle(Geom_Curve) & curve, double from, const gp_Pnt2d& forward,
                        const gp_Pnt2d& backward, const gp_Dir2d& along) {
    TopoDS_Edge edge;
    builder.MakeEdge(edge, curve, tolerance);
    builder.UpdateEdge(edge, new Geom2d_Line(forward, along), new Geom2d_Line(backward, along),
                       made, tolerance);
    builder.Continuity(edge, made, made, GeomAbs_CN);
    builder.Add(edge, corner.Oriented(TopAbs_FORWARD));
    builder.Add(edge, corner.Oriented(TopAbs_REVERSED));
    builder.Range(edge, from, from + 2 * pi);
    return edge;
  };
  const TopoDS_Edge round = seam(surface->VIso(v), u, {0, v}, {0, v + 2 * pi}, gp_Dir2d(1, 0));
  const TopoDS_Edge over = seam(surface->UIso(u), v, {u + 2 * pi, 0}, {u, 0}, gp_Dir2d(0, 1));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Shape& edge :
       {TopoDS_Shape(round), TopoDS_Shape(over), round.Reversed(), over.Reversed()})
    builder.Add(wire, edge);
  wire.Closed(true);
  builder.Add(made, wire);
  return TopoDS::Face(made.Oriented(face.Orientation()));
}

TopoDS_Face moved_ring(const FreeChart& chart, const ChartMove& move) {
  const TopoDS_Face& face = chart.faces.front();
  const bool is_mirrored = !frame_of(face)->Direct();  // longitudes are counted the other way
  return with_seams_at(face, is_mirrored ? -move.angle : move.angle, move.along_tube);
}

}  // namespace

std::vector<FreeChart> free_charts(const std::vector<TopoDS_Face>& faces) {
  std::vector<TopoDS_Shape> round;
  for (const TopoDS_Face& face : faces)
    if (goes_round(face)) round.push_back(face);
  if (round.empty()) return {};
  const Neighbourhood all = neighbourhood_of(faces);
  std::vector<FreeChart> charts;
  for (const FaceGroup& places : groups_over_edges(round, [](const auto&) { return false; })) {
    std::vector<TopoDS_Face> group;
    for (const std::size_t place : places) group.push_back(TopoDS::Face(round[place]));
    if (!can_turn(group, all)) continue;
    if (auto chart = chart_of(group)) charts.push_back(*std::move(chart));
  }
  return charts;
}

std::vector<Seam> moved_seams(const FreeChart& chart, const ChartMove& move) {
  if (chart.kind == ChartKind::Ring)
    return *seams_of(moved_ring(chart, move), transformation_into(chart.frame));
  std::vector<Seam> moved = chart.seams;
  const gp_Trsf turn = turn_within(gp_Ax3(), move);
  for (Seam& seam : moved) seam.curve = Handle(Geom_Curve)::DownCast(seam.curve->Transformed(turn));
  return moved;
}

void move_chart(const FreeChart& chart, const ChartMove& move, BRepTools_ReShape& into) {
  if (chart.kind == ChartKind::Ring) {
    into.Replace(chart.faces.front(), moved_ring(chart, move));
    return;
  }
  const TopoDS_Shape all = compound_of(chart.faces);
  BRepBuilderAPI_Transform turned(all, turn_within(chart.frame, move), true);
  for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_FACE}) {
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(all, kind, shapes);
    for (int i = 1; i <= shapes.Extent(); ++i)
      into.Replace(shapes(i), turned.ModifiedShape(shapes(i)).Oriented(shapes(i).Orientation()));
  }
}

}  // namespace blossom::occt
