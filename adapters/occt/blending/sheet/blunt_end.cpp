// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips that end in a plane across them, where the faces at their end do not close them.
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

// Of the strip's width: how far before a contact leaves its face a strip stops, so that something
// of the face is left between the wall and the border.
constexpr double kClearance = 0.25;
constexpr int kWallSteps = 40;

TopoDS_Face plane_across(const Handle(Geom_Curve) & spine, double t) {
  gp_Pnt centre;
  gp_Vec along;
  spine->D1(t, centre, along);
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_Plane(centre, gp_Dir(along)), Precision::Confusion());
  return face;
}

// How fast contacts run along a strip, both taken together: the one may stop where the other runs.
double rolling_speed(const RolledStrip& strip, double t) {
  double sum = 0;
  for (const RolledContact& contact : strip.contacts)
    sum += contact.curve->DN(t, 1).SquareMagnitude();
  return std::sqrt(0.5 * sum);
}

// Whether a ball might roll on over an edge.
bool is_bend(const BodyEdges& body, const ContactCrossing& over) {
  const Vec3 here = body.corner(*over.use, over.edge_parameter).normal;
  const Vec3 behind = body.corner(body.behind(*over.use), over.edge_parameter).normal;
  return dot(here, behind) > std::cos(kMaxBend);
}

// Along an edge from a point of it to its end, model units.
double length_left(const BodyEdges& body, const DirectedEdge& half, const Vec3& from) {
  const BRepAdaptor_Curve curve(body.edge(half.edge));
  const Interval range{curve.FirstParameter(), curve.LastParameter()};
  Interval own;
  const double at =
      nearest_on(BRep_Tool::Curve(body.edge(half.edge), own.from, own.to), range, from);
  return curve_length(curve, half.at_start ? Interval{range.from, at} : Interval{at, range.to});
}

}  // namespace

// Where a strip ends in a wall: at the vertex, or before a contact leaves its face beside it or
// over a bend elsewhere, or comes to that of another strip, or the ball has to turn round. Over a
// sharp border elsewhere the ball is too large for the face.
double BlendSheet::wall_t(const Ring& ring) {
  const DirectedEdge half = ring.front().half;
  const PlacedStrip& placed = strip_of(half);
  const RolledStrip& strip = placed.strip;
  const double inwards = is_low_end(half) ? 1 : -1;
  const VertexSector& last = ring.back();
  const std::array<const EdgeUseInFace*, 2> uses{
      &arriving(ring, 0), &body_.uses(last.face)[static_cast<std::size_t>(last.use)]};
  double t = end_t(half);
  const auto before = [&](double end) {
    return end + inwards * kClearance * strip.radius / rolling_speed(strip, end);
  };
  const auto stop_before = [&](double end) {
    const double stop = before(end);
    if (inwards * (stop - t) > 0) t = stop;
  };
  if (strip.over && t == (is_low_end(half) ? strip.most.from : strip.most.to)) t = before(t);
  for (const std::size_t side : {left_side(half), right_side(half)}) {
    if (ring.size() < 2) break;
    const bool on_left = side == left_side(half);
    const DirectedEdge& beside = on_left ? ring[1].half : last.half;
    std::optional<double> end;
    if (is_filleted(beside.edge)) {
      const std::size_t other = on_left ? right_side(beside) : left_side(beside);
      if (const auto crossing = contacts_cross(body_, strip, side, end_t(half),
                                               strip_of(beside).strip, other, end_t(beside)))
        end = (*crossing)[0];
    } else if (const auto meeting =
                   meeting_with(body_, strip, side, *uses[on_left ? 0 : 1], end_t(half))) {
      end = meeting->t;
    }
    // What is met beyond the strip's middle belongs to its other end.
    if (end && inwards * (placed.inside - *end) > 0) stop_before(*end);
    if (const auto over = way_out(half, side); over && is_bend(body_, *over)) stop_before(over->t);
  }
  return t;
}

// The vertex of the body at the end of the strip, or a new one on the edge, in the plane across the
// strip at t, from which the edge stays as it was.
std::optional<TopoDS_Vertex> BlendSheet::wall_foot(const DirectedEdge& half, double t) {
  const RolledStrip& strip = strip_of(half).strip;
  if (t == end_t(half)) return body_.vertex(half);
  if (t <= strip.edge_range.from || t >= strip.edge_range.to) return std::nullopt;
  const TopoDS_Edge edge = body_.edge(half.edge);
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  gp_Pnt centre;
  gp_Vec along;
  strip.spine->D1(t, centre, along);
  const auto off = [&](double x) { return gp_Vec(centre, curve->Value(x)).Dot(along); };
  double x = nearest_on(curve, range, vec(centre.XYZ())),
         last = half.at_start ? range.from : range.to;
  double f = off(x), f_last = off(last);
  for (int i = 0; i < kWallSteps && f != 0 && f != f_last; ++i) {
    const double next = x - f * (x - last) / (f - f_last);
    last = x;
    f_last = f;
    x = next;
    if (x <= range.from || x >= range.to) return std::nullopt;
    f = off(x);
  }
  const TopoDS_Vertex vertex = body_.vertex(half);
  const double left = distance(vec(curve->Value(x).XYZ()), point_of(vertex));
  if (left <= BRep_Tool::Tolerance(vertex)) return vertex;  // nothing of the edge would be left
  const int split = splits_.add(edge, x, body_.face(strip.contacts[0].face));
  if (split == EdgeSplits::kFirst || split == EdgeSplits::kLast) return std::nullopt;
  border_.cuts.push_back({half.edge, split, !half.at_start});
  return splits_.vertex(edge, split);
}

// One of a wall's borders on the faces, from a contact down to the edge, as the wall uses it, which
// walks down the left one and up the right one.
TopoDS_Edge BlendSheet::wall_border(const EndCurve& down, const TopoDS_Vertex& contact,
                                    const TopoDS_Vertex& corner, bool on_left, int face) {
  const TopoDS_Edge edge = edge_on(down.curve, down.range, down.forward ? contact : corner,
                                   down.forward ? corner : contact);
  add_chart(edge, chart_near_face(down.on_face, at(down.range, 0.5), body_, face),
            body_.face(face));
  const bool forward = down.forward == on_left;
  added_[face].push_back(TopoDS::Edge(edge.Oriented(forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
  return TopoDS::Edge(edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
}

// The wall across the strip at the vertex: between the arc of the ball and both faces; `why` there
// has to be one is told. False if the contacts have left their faces there, or the plane misses the
// faces.
bool BlendSheet::is_walled(const Ring& ring, const std::string& why) {
  const DirectedEdge half = ring.front().half;
  PlacedStrip& of = strip_of(half);
  const RolledStrip& strip = of.strip;
  const double t = wall_t(ring);
  if (t < strip.range.from || t > strip.range.to) return false;
  const std::array<int, 2> faces{strip.contacts[0].face, strip.contacts[1].face};
  const std::size_t left = left_side(half), right = right_side(half);
  if (!lies_inside(body_, strip.contacts[0], t) || !lies_inside(body_, strip.contacts[1], t))
    return false;
  const auto foot = wall_foot(half, t);
  if (!foot) return false;
  const TopoDS_Vertex corner = *foot;
  BlendPatch wall{plane_across(strip.spine, t), {}, strip.edge};
  std::array<TopoDS_Vertex, 2> ends;
  std::array<std::optional<EndCurve>, 2> down;
  const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(corner));
  for (const std::size_t side : {0U, 1U}) {
    const Vec3 contact = vec(strip.contacts[side].curve->Value(t).XYZ());
    down[side] =
        wall_curve_between(wall.face, body_.face(faces[side]), contact, point_of(corner), reach);
    if (!down[side]) return false;
    ends[side] = new_vertex(contact);
  }
  StripEnd& end = end_of(half);
  end.t = {t, t};
  end.vertices = ends;
  border_.vertices.push_back(corner);
  const TopoDS_Edge arc = section(of, end);
  const bool forward = strip.contacts[0].w < strip.contacts[1].w;
  add_chart(arc, strip.section_line(t), strip.bare_face());
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(arc, range.from, range.to);
  const SurfaceProjector feet(wall.face, Precision::Confusion());
  add_chart(arc, image_of(curve, range, feet, std::nullopt, reach).chart, wall.face);
  end.path = {{arc, forward}};
  // The strip walks from left to right of the vertex, the wall back, down to the vertex and up.
  const bool strip_forward = is_low_end(half) ? forward : !forward;
  wall.edges.push_back(
      TopoDS::Edge(arc.Oriented(strip_forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
  for (const std::size_t side : {left, right}) {
    wall.edges.push_back(wall_border(*down[side], ends[side], corner, side == left, faces[side]));
    add_chart(TopoDS::Edge(wall.edges.back().Oriented(TopAbs_FORWARD)), down[side]->on_strip,
              wall.face);
  }
  gp_Pnt centre;
  gp_Vec along;
  strip.spine->D1(t, centre, along);
  // Outwards is where material was taken away, or where none was added.
  const double ahead = dot(direction_at(body_, half), Vec3{along.X(), along.Y(), along.Z()});
  wall.face.Orientation((ahead > 0) != strip.concave ? TopAbs_FORWARD : TopAbs_REVERSED);
  patches_.push_back(std::move(wall));
  const Vec3 place = point_of(corner);
  const double rest = length_left(body_, half, place);
  std::ostringstream note;
  note << "edge " << strip.edge << ": its strip ends in a plane across it at " << told_place(place)
       << ", where the faces at its end do not close it: " << why;
  if (rest > tolerance_) note << "; the last " << rest << " mm of the edge stay as they were";
  is_tolerant_ = is_tolerant_ || rest > tolerance_;
  notes_.push_back(note.str());
  return true;
}

// The last strip of a walk, where another one goes on in it: that one ends the walk then. False,
// and nothing is done, if there is none.
bool BlendSheet::leave_out_last(const DirectedEdge& half) {
  EndPlace& end = ends_at_.at({half.edge, half.at_start});
  const auto is_of = [&](const EndPlace& place) { return place.strip == end.strip; };
  const auto joint = std::ranges::find_if(
      joints_, [&](const Joint& each) { return is_of(each.before) || is_of(each.after); });
  PlacedStrip& last = strips_[end.strip];
  if (joint == joints_.end() || last.strip.bend != std::array<int, 2>{}) return false;
  last.left_out = true;
  end = is_of(joint->before) ? joint->after : joint->before;
  joints_.erase(joint);
  return true;
}

// A wall across the last strip on which there can be one. A ball that has rolled on past the vertex
// may have left the edge's faces before.
bool BlendSheet::blunt(const Ring& ring, const std::string& why) {
  do {
    const SheetBorder border = border_;
    const EdgeSplits splits = splits_;
    if (is_walled(ring, why)) return true;
    border_ = border;  // where it was begun
    splits_ = splits;
  } while (leave_out_last(ring.front().half));
  return false;
}

}  // namespace blossom::occt
