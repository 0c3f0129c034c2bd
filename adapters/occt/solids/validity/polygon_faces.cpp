// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/validity/polygon_faces.h"

#include <array>
#include <optional>

#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/solids/validity/sound_faces.h"
#include "core/math/vec.h"

namespace blossom::occt {
namespace {

Vec2 in_plane(const Vec3& p) { return {p[0], p[1]}; }

// Coordinates in a plane, with the height above it as the third one.
class PlaneFrame {
 public:
  explicit PlaneFrame(const gp_Ax3& axes) : axes_(axes) {}

  Vec3 at(const gp_Pnt& point) const {
    const gp_Vec off(axes_.Location(), point);
    return {off.Dot(axes_.XDirection()), off.Dot(axes_.YDirection()), off.Dot(axes_.Direction())};
  }

 private:
  gp_Ax3 axes_;
};

struct VertexPlace {
  Vec3 place;  // in the frame
  double tolerance = 0;
};

bool is_rigid(const TopLoc_Location& place) {
  return place.IsIdentity() || place.Transformation().ScaleFactor() == 1;
}

std::optional<VertexPlace> corner_of(const TopoDS_Shape& shape, const PlaneFrame& frame) {
  const TopoDS_Vertex& vertex = TopoDS::Vertex(shape);
  const auto* record = static_cast<const BRep_TVertex*>(vertex.TShape().get());
  if (!record->Points().IsEmpty() || !is_rigid(vertex.Location())) return std::nullopt;
  return VertexPlace{frame.at(BRep_Tool::Pnt(vertex)), record->Tolerance()};
}

// Whether a corner holds an end of an edge, in space and by the curve in the plane.
bool holds(const VertexPlace& corner, const Vec3& end, const Vec2& chart_end) {
  const Vec3 off = corner.place - Vec3{chart_end[0], chart_end[1], 0};
  return norm(corner.place - end) <= corner.tolerance && norm(off) <= corner.tolerance;
}

class StraightEdges {
 public:
  StraightEdges(const Handle(Geom_Surface) & surface, const TopLoc_Location& place,
                const PlaneFrame& frame)
      : surface_(surface), place_(place), frame_(frame) {}

  // Whether an edge and its vertices hold each other; no edge of another kind does, nor one that is
  // in no loop.
  bool are_held(const TopoDS_Edge& edge) const;

 private:
  struct Stored {
    int curves = 0;                 // in space
    const BRep_GCurve* chart = {};  // on this surface
    bool others = false;            // of unknown kinds
  };

  Stored stored_of(const TopoDS_Edge& edge, const BRep_TEdge& record) const {
    Stored stored;
    const TopLoc_Location place = place_.Predivided(edge.Location());
    for (BRep_ListIteratorOfListOfCurveRepresentation it(record.Curves()); it.More(); it.Next()) {
      const BRep_CurveRepresentation& each = *it.Value();
      if (each.IsCurve3D()) {
        ++stored.curves;
      } else if (!each.IsCurveOnSurface()) {
        stored.others = stored.others || !each.IsRegularity();
      } else if (each.IsCurveOnSurface(surface_, place)) {
        stored.others = stored.others || stored.chart != nullptr || each.IsCurveOnClosedSurface();
        stored.chart = static_cast<const BRep_GCurve*>(&each);
      }
    }
    return stored;
  }

  Handle(Geom_Surface) surface_;
  TopLoc_Location place_;
  PlaneFrame frame_;
};

bool StraightEdges::are_held(const TopoDS_Edge& edge) const {
  const auto& record = static_cast<const BRep_TEdge&>(*edge.TShape());
  const TopAbs_Orientation way = edge.Orientation();
  if ((way != TopAbs_FORWARD && way != TopAbs_REVERSED) || record.Degenerated() ||
      !record.SameParameter() || !record.SameRange() || !is_rigid(edge.Location()))
    return false;
  const Stored stored = stored_of(edge, record);
  if (stored.others || stored.curves != 1) return false;
  TopLoc_Location move;
  double from = 0, to = 0;
  const auto line = Handle(Geom_Line)::DownCast(BRep_Tool::Curve(edge, move, from, to));
  if (line.IsNull() || !is_rigid(move) || !(to - from > Precision::PConfusion())) return false;
  const double tolerance = record.Tolerance();
  std::array<Vec3, 2> ends;
  for (const bool last : {false, true})
    ends[last] = frame_.at(line->Value(last ? to : from).Transformed(move.Transformation()));
  std::array<Vec2, 2> chart{in_plane(ends[0]), in_plane(ends[1])};
  if (stored.chart != nullptr) {
    const auto pcurve = Handle(Geom2d_Line)::DownCast(stored.chart->PCurve());
    if (pcurve.IsNull() || stored.chart->First() != from || stored.chart->Last() != to)
      return false;
    for (const bool last : {false, true}) {
      const gp_Pnt2d point = pcurve->Value(last ? to : from);
      chart[last] = {point.X(), point.Y()};
    }
  }
  for (const bool last : {false, true})
    if (!(norm(ends[last] - Vec3{chart[last][0], chart[last][1], 0}) <= tolerance)) return false;
  std::array<std::optional<VertexPlace>, 2> corners;
  for (TopoDS_Iterator it(edge.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
    const TopAbs_Orientation end = it.Value().Orientation();
    if (end != TopAbs_FORWARD && end != TopAbs_REVERSED) return false;
    auto& corner = corners[end == TopAbs_REVERSED];
    if (corner) return false;
    corner = corner_of(it.Value(), frame_);
    if (!corner) return false;
  }
  for (const bool last : {false, true})
    if (!corners[last] || !holds(*corners[last], ends[last], chart[last])) return false;
  return true;
}

}  // namespace

bool is_held_polygon(const TopoDS_Face& face) {
  TopLoc_Location place;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
  const auto plane = Handle(Geom_Plane)::DownCast(surface);
  if (plane.IsNull() || !is_rigid(place)) return false;
  const PlaneFrame frame(plane->Position().Transformed(place.Transformation()));
  const StraightEdges edges(surface, place, frame);
  for (TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next()) {
    const TopAbs_Orientation way = wire.Value().Orientation();
    if (wire.Value().ShapeType() != TopAbs_WIRE ||
        (way != TopAbs_FORWARD && way != TopAbs_REVERSED))
      return false;
    for (TopoDS_Iterator edge(wire.Value()); edge.More(); edge.Next())
      if (!edges.are_held(TopoDS::Edge(edge.Value()))) return false;
  }
  return true;
}

bool is_sound_polygon(const TopoDS_Face& face) {
  return is_held_polygon(face) && loops_are_simple(face);
}

}  // namespace blossom::occt
