// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners in which the borders of chamfers of one kind cross, each one that of the next: every
// strip ends between two crossings, in the plane through all of them if there is one, else along a
// line in its own parameters, and a fill closes the hole.
#include <algorithm>
#include <optional>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/hole_side.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

bool is_plane(const RolledStrip& strip) {
  return !Handle(Geom_Plane)::DownCast(strip.surface).IsNull();
}

// An edge with a chart in a plane.
void add_chart_in(const TopoDS_Face& plane, const TopoDS_Edge& edge, double tolerance) {
  const SurfaceProjector on(plane, Precision::Confusion());
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  add_chart(edge, image_of(curve, range, on, std::nullopt, tolerance).chart, plane);
}

}  // namespace

// Where the left border of each strip crosses the right one of the next; nothing where one does
// not, or the strips are of both kinds.
std::optional<std::vector<TopoDS_Vertex>> BlendSheet::borders_cross(const Ring& ring) {
  const std::size_t count = ring.size();
  for (const VertexSector& each : ring)
    if (!is_filleted(each.half.edge) ||
        strip_of(each.half).strip.concave != strip_of(ring.front().half).strip.concave)
      return std::nullopt;
  std::vector<TopoDS_Vertex> places(count);
  for (std::size_t i = 0; i < count; ++i) {
    const DirectedEdge half = ring[i].half, next = ring[(i + 1) % count].half;
    const RolledStrip &of = strip_of(half).strip, &after = strip_of(next).strip;
    const auto crossing = contacts_cross(body_, of, left_side(half), end_t(half), after,
                                         right_side(next), end_t(next));
    if (!crossing) return std::nullopt;
    end_of(half).t[left_side(half)] = (*crossing)[0];
    end_of(next).t[right_side(next)] = (*crossing)[1];
    places[i] = new_vertex(vec(of.contacts[left_side(half)].curve->Value((*crossing)[0]).XYZ()));
    end_of(half).vertices[left_side(half)] = places[i];
    end_of(next).vertices[right_side(next)] = places[i];
  }
  return places;
}

// The edge in which a strip ends in a plane, with its charts; the strip walks it from the one
// vertex to the other.
std::optional<TopoDS_Edge> BlendSheet::flat_end(const DirectedEdge& half, const TopoDS_Face& plane,
                                                const TopoDS_Vertex& from,
                                                const TopoDS_Vertex& to) {
  const RolledStrip& strip = strip_of(half).strip;
  const Vec3 start = point_of(from), way = point_of(to) - start;
  if (is_plane(strip)) {
    const TopoDS_Edge edge =
        edge_on(new Geom_Line(pnt(start), dir(unit(way))), {0, norm(way)}, from, to);
    for (const TopoDS_Face& face : {strip.bare_face(), plane}) add_chart_in(face, edge, tolerance_);
    return edge;
  }
  const double reach =
      kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(from), BRep_Tool::Tolerance(to)});
  const auto curve =
      curve_between(strip, part_near(half, end_of(half).t), plane, start, point_of(to), reach);
  if (!curve) return std::nullopt;
  const TopoDS_Edge edge =
      edge_on(curve->curve, curve->range, curve->forward ? from : to, curve->forward ? to : from);
  add_chart(edge, curve->on_strip, strip.bare_face());
  add_chart(edge, curve->on_face, plane);
  return TopoDS::Edge(edge.Oriented(curve->forward ? TopAbs_FORWARD : TopAbs_REVERSED));
}

// A plane corner between the places where borders cross; false, and nothing is done, if they lie
// in none, or a strip does not go through it.
bool BlendSheet::flat_corner(const Ring& ring, const std::vector<TopoDS_Vertex>& places) {
  const std::size_t count = ring.size();
  BlendPatch patch;
  // Seen from outside the edges are met against the clock.
  patch.face = plane_face(point_of(places[0]), point_of(places[1]), point_of(places[count - 1]));
  const SurfaceProjector feet(patch.face, Precision::Confusion());
  for (const TopoDS_Vertex& each : places)
    if (std::abs(feet.height(point_of(each))) > tolerance_) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const auto edge =
        flat_end(ring[i].half, patch.face, places[i], places[(i + count - 1) % count]);
    if (!edge) return false;
    patch.edges.push_back(TopoDS::Edge(edge->Reversed()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool forward = patch.edges[i].Orientation() == TopAbs_REVERSED;
    end_of(ring[i].half).path = {{TopoDS::Edge(patch.edges[i].Oriented(TopAbs_FORWARD)), forward}};
    turn_path(ring[i].half);
  }
  patches_.push_back(std::move(patch));
  return true;
}

// From the right to the left, as seen by who walks away from the vertex: smoothly, but for
// chamfers.
BlendSheet::SetbackSide BlendSheet::slanted_side(const DirectedEdge& half) {
  const RolledStrip& strip = strip_of(half).strip;
  const StripEnd& end = end_of(half);
  TColgp_Array1OfPnt2d poles(1, 2);
  for (const bool on_left : {false, true}) {
    const std::size_t side = on_left ? left_side(half) : right_side(half);
    const Vec2 place = strip.chart(end.t[side], strip.contacts[side].w);
    poles(on_left ? 2 : 1) = {place[0], place[1]};
  }
  SetbackSide made;
  made.chart = new Geom2d_BezierCurve(poles);
  made.from = end.vertices[right_side(half)];
  made.half = half;
  TopoDS_Edge edge;
  const BRep_Builder builder;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, made.chart, strip.bare_face(), Precision::Confusion());
  builder.Range(edge, 0, 1);
  const auto side_of = [&](const TopoDS_Face& face, FillContinuity continuity) {
    return fitted_hole_side({half.edge, edge, face, false}, continuity, {.point = tolerance_}).side;
  };
  if (is_chamfer_) {
    made.side = side_of({}, FillContinuity::G0);
    return made;
  }
  // The strip lies to the right of the way, seen from outside.
  edge.Orientation(TopAbs_REVERSED);
  const TopoDS_Shape face =
      strip.bare_face().Oriented(strip.outward ? TopAbs_FORWARD : TopAbs_REVERSED);
  made.side = side_of(TopoDS::Face(face), FillContinuity::G1);
  return made;
}

// False, and nothing is done, where borders do not cross.
bool BlendSheet::crossed_corner(const Ring& ring) {
  const auto places = borders_cross(ring);
  if (!places) return false;
  if (flat_corner(ring, *places)) return true;
  std::vector<SetbackSide> sides;
  for (const VertexSector& each : ring) sides.push_back(slanted_side(each.half));
  fill_corner(ring, sides);
  return true;
}

}  // namespace blossom::occt
