// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips that end in a plane across them, where the faces at their end do not close them.
#include <optional>
#include <sstream>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/blend_sheet.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

constexpr double kSamePlace = 10;  // in tolerances

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

// Whether a contact at a parameter lies inside of its face.
bool lies_inside(const BodyEdges& body, const RolledContact& contact, double t) {
  const FaceTrims& trims = body.trims(contact.face);
  const gp_Pnt2d uv = contact.chart->Value(t);
  return is_inside(trims, {uv.X() * trims.scale[0], uv.Y() * trims.scale[1]});
}

TopoDS_Face plane_across(const Handle(Geom_Curve) & spine, double t) {
  gp_Pnt centre;
  gp_Vec along;
  spine->D1(t, centre, along);
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_Plane(centre, gp_Dir(along)), Precision::Confusion());
  return face;
}

}  // namespace

// The wall across the strip at the vertex: between the arc of the ball and both faces. False, and
// nothing is done, if the contacts have left their faces there, or the plane misses the faces.
bool BlendSheet::blunt(const Ring& ring) {
  const HalfEdge half = ring.front().half;
  PlacedStrip& of = strip_of(half);
  const RolledStrip& strip = of.strip;
  const double t = end_t(half);
  const std::array<int, 2> faces{strip.contacts[0].face, strip.contacts[1].face};
  const std::size_t left = left_side(half), right = right_side(half);
  if (!lies_inside(body_, strip.contacts[0], t) || !lies_inside(body_, strip.contacts[1], t))
    return false;
  const TopoDS_Vertex corner = body_.vertex(half);
  BlendPatch wall{plane_across(strip.spine, t), {}, strip.edge};
  std::array<TopoDS_Vertex, 2> ends;
  std::array<std::optional<EndCurve>, 2> down;
  const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(corner));
  for (const std::size_t side : {0U, 1U}) {
    const Vec3 contact = vec(strip.contacts[side].curve->Value(t).XYZ());
    down[side] =
        plane_curve_between(wall.face, body_.face(faces[side]), contact, point_of(corner), reach);
    if (!down[side]) return false;
    ends[side] = new_vertex(contact);
  }
  StripEnd& end = end_of(half);
  end.t = {t, t};
  end.vertices = ends;
  const TopoDS_Edge arc = section(of, end);
  const bool forward = strip.contacts[0].w < strip.contacts[1].w;
  add_chart(arc, strip.section_line(t), strip.bare_face());
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(arc, range.from, range.to);
  const SurfaceProjector feet(wall.face, Precision::Confusion());
  add_chart(arc, image_of(curve, range, feet, std::nullopt, reach).chart, wall.face);
  end.path = {{arc, forward}};
  // The strip walks from left to right of the vertex, the wall back, down to the vertex and up.
  const bool strip_forward = half.at_start ? forward : !forward;
  wall.edges.push_back(
      TopoDS::Edge(arc.Oriented(strip_forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
  for (const std::size_t side : {left, right}) {
    const EndCurve& to_corner = *down[side];
    const TopoDS_Edge edge =
        edge_on(to_corner.curve, to_corner.range, to_corner.forward ? ends[side] : corner,
                to_corner.forward ? corner : ends[side]);
    add_chart(edge, to_corner.on_strip, wall.face);
    add_chart(edge, to_corner.on_face, body_.face(faces[side]));
    const bool wall_forward = to_corner.forward == (side == left);
    wall.edges.push_back(
        TopoDS::Edge(edge.Oriented(wall_forward ? TopAbs_FORWARD : TopAbs_REVERSED)));
    added_[faces[side]].push_back(
        TopoDS::Edge(edge.Oriented(wall_forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
  }
  gp_Pnt centre;
  gp_Vec along;
  strip.spine->D1(t, centre, along);
  // Outwards is where material was taken away, or where none was added.
  const double ahead = dot(direction_at(body_, half), Vec3{along.X(), along.Y(), along.Z()});
  wall.face.Orientation((ahead > 0) != strip.concave ? TopAbs_FORWARD : TopAbs_REVERSED);
  patches_.push_back(std::move(wall));
  const Vec3 place = point_of(corner);
  std::ostringstream note;
  note << "edge " << strip.edge << ": its strip ends in a plane across it at (" << place[0] << ", "
       << place[1] << ", " << place[2] << "), where the faces at its end do not close it";
  notes_.push_back(note.str());
  return true;
}

}  // namespace blossom::occt
