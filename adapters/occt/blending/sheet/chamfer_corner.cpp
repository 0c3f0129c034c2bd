// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners in which all edges have chamfers, whose borders cross, each one that of the next: every
// strip ends between two crossings, in the plane through all of them if there is one, else along a
// line in its own parameters, and a fill closes the hole. Where edges of both kinds leave a face
// more than half a circle between two of them, borders do not cross: a line in the face goes from
// the one strip's end to the other's.
#include <array>
#include <cmath>
#include <map>
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

// The plane through the corners of a polygon, as near as they lie in one, its normal to where they
// run against the clock. Nothing where the polygon has no area beyond that of the tolerance.
std::optional<TopoDS_Face> plane_round(const std::vector<TopoDS_Vertex>& corners,
                                       double tolerance) {
  const Vec3 first = point_of(corners.front());
  Vec3 area{};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += cross(point_of(corners[i]) - first, point_of(corners[i + 1]) - first);
  if (!(norm(area) > tolerance * tolerance)) return std::nullopt;
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_Plane(pnt(first), dir(unit(area))),
                          Precision::Confusion());
  return face;
}

// An edge with a chart in a plane.
void add_chart_in(const TopoDS_Face& plane, const TopoDS_Edge& edge, double tolerance) {
  const SurfaceProjector on(plane, Precision::Confusion());
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  add_chart(edge, image_of(curve, range, on, std::nullopt, tolerance).chart, plane);
}

}  // namespace

// Where the left border of a strip crosses the right one of the next in the face between them:
// parameters of both. Nothing where they do not cross.
std::optional<std::array<double, 2>> BlendSheet::border_crossing(const Ring& ring,
                                                                 std::size_t sector) {
  const DirectedEdge half = ring[sector].half, next = ring[(sector + 1) % ring.size()].half;
  return contacts_cross(body_, strip_of(half).strip, left_side(half), end_t(half),
                        strip_of(next).strip, right_side(next), end_t(next));
}

// Ends every strip where its borders cross those of the next ones. Those on either side of a face
// that turns by more than half a circle, which edges of both kinds leave, do not: there a strip
// ends as far from the vertex as on its other side. False, and nothing is done, where that tells no
// end.
bool BlendSheet::borders_cross(const Ring& ring) {
  const std::size_t count = ring.size();
  for (const VertexSector& each : ring)
    if (!is_filleted(each.half.edge)) return false;
  std::vector<std::optional<std::array<double, 2>>> crossings(count);  // by sector
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_narrow(body_, ring[i], ring[(i + 1) % count].half)) continue;
    crossings[i] = border_crossing(ring, i);
    if (!crossings[i]) return false;
  }
  for (std::size_t i = 0; i < count; ++i)
    if (!crossings[i] && !crossings[(i + count - 1) % count]) return false;
  const auto end_on = [&](const DirectedEdge& half, std::size_t side, double t) {
    end_of(half).t[side] = t;
    end_of(half).vertices[side] =
        new_vertex(vec(strip_of(half).strip.contacts[side].curve->Value(t).XYZ()));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const DirectedEdge half = ring[i].half, next = ring[(i + 1) % count].half;
    const auto &before = crossings[(i + count - 1) % count], &after = crossings[(i + 1) % count];
    end_on(half, left_side(half), crossings[i] ? (*crossings[i])[0] : (*before)[1]);
    end_on(next, right_side(next), crossings[i] ? (*crossings[i])[1] : (*after)[0]);
    if (crossings[i])
      end_of(next).vertices[right_side(next)] = end_of(half).vertices[left_side(half)];
  }
  return true;
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

// A line in a plane corner and in a face of the body that is a plane, too.
TopoDS_Edge BlendSheet::line_across(const TopoDS_Face& plane, int face, const TopoDS_Vertex& from,
                                    const TopoDS_Vertex& to) const {
  const Vec3 start = point_of(from), way = point_of(to) - start;
  const TopoDS_Edge edge =
      edge_on(new Geom_Line(pnt(start), dir(unit(way))), {0, norm(way)}, from, to);
  for (const TopoDS_Face& of : {body_.face(face), plane}) add_chart_in(of, edge, tolerance_);
  return edge;
}

// A plane corner between the ends of all strips; false, and nothing is done, if they lie in none,
// or a strip or a face that it comes to does not go through it.
bool BlendSheet::flat_corner(const Ring& ring) {
  const std::size_t count = ring.size();
  std::vector<TopoDS_Vertex> round;  // against the clock, as seen from outside
  for (const VertexSector& each : ring)
    for (const std::size_t side : {right_side(each.half), left_side(each.half)})
      if (const TopoDS_Vertex& next = end_of(each.half).vertices[side];
          round.empty() || !next.IsSame(round.back()))
        round.push_back(next);
  BlendPatch patch;
  const auto plane = plane_round(round, tolerance_);
  if (!plane) return false;
  patch.face = *plane;
  const SurfaceProjector feet(patch.face, Precision::Confusion());
  for (const TopoDS_Vertex& each : round)
    if (std::abs(feet.height(point_of(each))) > tolerance_) return false;
  std::map<int, std::vector<TopoDS_Edge>> across;  // by face
  std::vector<TopoDS_Edge> ends;
  for (std::size_t i = 0; i < count; ++i) {
    const DirectedEdge half = ring[i].half, next = ring[(i + 1) % count].half;
    const TopoDS_Vertex& left = end_of(half).vertices[left_side(half)];
    const auto edge = flat_end(half, patch.face, left, end_of(half).vertices[right_side(half)]);
    if (!edge) return false;
    ends.push_back(*edge);
    patch.edges.push_back(TopoDS::Edge(edge->Reversed()));
    const TopoDS_Vertex& beyond = end_of(next).vertices[right_side(next)];
    if (left.IsSame(beyond)) continue;
    if (Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(body_.face(ring[i].face))).IsNull())
      return false;
    patch.edges.push_back(line_across(patch.face, ring[i].face, left, beyond));
    across[ring[i].face].push_back(TopoDS::Edge(patch.edges.back().Reversed()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool forward = ends[i].Orientation() == TopAbs_FORWARD;
    end_of(ring[i].half).path = {{TopoDS::Edge(ends[i].Oriented(TopAbs_FORWARD)), forward}};
    turn_path(ring[i].half);
  }
  for (const auto& [face, edges] : across)
    added_[face].insert(added_[face].end(), edges.begin(), edges.end());
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
  if (!borders_cross(ring)) return false;
  std::map<std::size_t, SetbackSide> across;  // by sector
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const DirectedEdge half = ring[i].half, next = ring[(i + 1) % ring.size()].half;
    const TopoDS_Vertex& left = end_of(half).vertices[left_side(half)];
    if (left.IsSame(end_of(next).vertices[right_side(next)])) continue;
    SetbackSide& path = across[i] = path_side(ring, i, {});
    check_room(ring, i, path);
    path.from = left;
  }
  if (flat_corner(ring)) return true;
  std::vector<SetbackSide> sides;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sides.push_back(slanted_side(ring[i].half));
    if (const auto path = across.find(i); path != across.end()) sides.push_back(path->second);
  }
  fill_corner(ring, sides);
  return true;
}

}  // namespace blossom::occt
