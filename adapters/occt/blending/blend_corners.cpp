// SPDX-License-Identifier: LGPL-2.1-or-later
// Where strips meet in a vertex: mitres of two, spheres of three or more.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/blend_sheet.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"
#include "core/plane/planar_crossings.h"

namespace blossom::occt {
namespace {

constexpr double kSamePlace = 10;  // in tolerances
constexpr int kSecantSteps = 60;

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
gp_Pnt pnt(const Vec3& p) { return {p[0], p[1], p[2]}; }
gp_Dir dir(const Vec3& d) { return {d[0], d[1], d[2]}; }

// The distance of a point from a face's surface, positive outside of the material.
double height_over(const TopoDS_Face& face, const Vec3& point) {
  const double height = SurfaceProjector(face, Precision::Confusion()).height(point);
  return face.Orientation() == TopAbs_REVERSED ? -height : height;
}

// Where the ball of a strip touches one more face, near an end: a zero by the secant method.
std::optional<double> touches(const RolledStrip& strip, const TopoDS_Face& face, double near,
                              double inwards) {
  const double wanted = strip.concave ? strip.radius : -strip.radius;
  const auto off = [&](double t) {
    return height_over(face, vec(strip.spine->Value(t).XYZ())) - wanted;
  };
  const double speed = strip.contacts[0].curve->DN(near, 1).Magnitude();
  double t = near, last = near + inwards * strip.radius / speed;
  double f = off(t), f_last = off(last);
  for (int i = 0; i < kSecantSteps && f != 0; ++i) {
    if (f == f_last) break;
    const double next =
        std::clamp(t - f * (t - last) / (f - f_last), strip.range.from, strip.range.to);
    last = t;
    f_last = f;
    t = next;
    f = off(t);
    if (t == last) break;
  }
  return std::abs(f) < Precision::Confusion() ? std::optional(t) : std::nullopt;
}

// In the chart of a face: where two contacts cross, nearest to the ends of their strips.
std::optional<std::array<double, 2>> contacts_cross(const BodyEdges& body, const RolledStrip& a,
                                                    std::size_t side_a, double near_a,
                                                    const RolledStrip& b, std::size_t side_b,
                                                    double near_b) {
  const Vec2 scale = body.trims(a.contacts[side_a].face).scale;
  const auto chart = [&](const RolledStrip& of, std::size_t side) {
    return transformed(planar_curve(of.contacts[side].chart, of.range), scale, {});
  };
  std::optional<std::array<double, 2>> best;
  double least = 0;
  for (const PlanarCrossing& each :
       crossings(chart(a, side_a), chart(b, side_b), Precision::Confusion()).points) {
    const double away = std::abs(each.a - near_a) + std::abs(each.b - near_b);
    if (best && away >= least) continue;
    best = {each.a, each.b};
    least = away;
  }
  return best;
}

TopoDS_Face plane_face(const Vec3& a, const Vec3& b, const Vec3& c) {
  TopoDS_Face face;
  const Vec3 normal = cross(b - a, c - a);
  BRep_Builder().MakeFace(face, new Geom_Plane(pnt(a), dir(unit(normal))), Precision::Confusion());
  return face;
}

}  // namespace

// Two strips run into each other in a curve, from where their contacts cross on the face that they
// share to the third edge, where their other contacts meet.
void BlendSheet::mitre(const Ring& ring) {
  const HalfEdge a = ring[0].half, b = ring[1].half, g = ring[2].half;
  const RolledStrip &strip = strip_of(a).strip, &other = strip_of(b).strip;
  StripEnd &end = end_of(a), &other_end = end_of(b);
  if (strip.concave != other.concave || is_filleted(g.edge))
    refuse(a, FilletFault::Corner,
           "it is " + std::string(strip.concave ? "concave" : "convex") + " and meets edge " +
               std::to_string(b.edge) + ", which is not, at a sharp corner");
  const auto crossing =
      contacts_cross(body_, strip, left_side(a), end_t(a), other, right_side(b), end_t(b));
  if (!crossing)
    refuse(a, FilletFault::Corner,
           "its contact does not cross that of edge " + std::to_string(b.edge) + " on face " +
               std::to_string(ring[0].face));
  const Vec3 place = vec(strip.contacts[left_side(a)].curve->Value((*crossing)[0]).XYZ());
  const TopoDS_Vertex start = new_vertex(place);
  const Cut of_other = cut_by_contact(b, left_side(b), arriving(ring, 1), g);
  const Cut own = cut_by_contact(
      a, right_side(a), body_.uses(ring[2].face)[static_cast<std::size_t>(ring[2].use)], g);
  if (!own.vertex.IsSame(of_other.vertex))
    refuse(a, FilletFault::Corner,
           "its contact and that of edge " + std::to_string(b.edge) + " do not meet on edge " +
               std::to_string(g.edge) + ": a corner of different widths cannot be built yet");
  end.t[left_side(a)] = (*crossing)[0];
  end.t[right_side(a)] = own.t;
  end.vertices[left_side(a)] = start;
  end.vertices[right_side(a)] = own.vertex;
  other_end.t[right_side(b)] = (*crossing)[1];
  other_end.t[left_side(b)] = of_other.t;
  other_end.vertices[right_side(b)] = start;
  other_end.vertices[left_side(b)] = own.vertex;
  const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(own.vertex));
  const Vec3 target = point_of(own.vertex), centre = vec(strip.spine->Value((*crossing)[0]).XYZ());
  const auto curve = curve_between(strip, part_near(a, end.t), plane_face(place, target, centre),
                                   place, target, reach);
  if (!curve) refuse(a, FilletFault::Corner, "it has no mitre with edge " + std::to_string(b.edge));
  const TopoDS_Edge edge = edge_on(curve->curve, curve->range, curve->forward ? start : own.vertex,
                                   curve->forward ? own.vertex : start);
  add_chart(edge, curve->on_strip, strip.bare_face());
  const SurfaceProjector feet(other.bare_face(), Precision::Confusion());
  const Vec2 near = other.chart(other_end.t[0], 0.5 * (other.contacts[0].w + other.contacts[1].w));
  try {
    add_chart(edge, image_of(curve->curve, curve->range, feet, near, kSamePlace * tolerance_).chart,
              other.bare_face());
  } catch (const std::exception&) {
    refuse(a, FilletFault::Corner,
           "its mitre with edge " + std::to_string(b.edge) + " is no plane curve");
  }
  end.path = {{edge, curve->forward == (left_side(a) == 0)}};
  other_end.path = {{edge, curve->forward == (right_side(b) == 0)}};
}

// All edges at a vertex have strips, and one ball touches all faces there: the strips end in great
// circles of it.
void BlendSheet::corner(const Ring& ring) {
  const std::size_t count = ring.size();
  const HalfEdge first = ring.front().half;
  const RolledStrip& strip = strip_of(first).strip;
  for (const VertexSector& each : ring)
    if (strip_of(each.half).strip.concave != strip.concave ||
        strip_of(each.half).strip.radius != strip.radius)
      refuse(first, FilletFault::Corner,
             "edges of its corner differ in kind or radius: such a corner cannot be built yet");
  const double inwards = is_low_end(first) ? 1 : -1;
  const auto t = touches(strip, body_.face(ring[1].face), end_t(first), inwards);
  if (!t) refuse(first, FilletFault::Corner, "no ball touches all faces of its corner");
  const Vec3 centre = vec(strip.spine->Value(*t).XYZ());
  std::vector<TopoDS_Vertex> feet(count);
  Vec3 middle{};
  for (std::size_t i = 0; i < count; ++i) {
    const RolledStrip& of = strip_of(ring[i].half).strip;
    StripEnd& end = end_of(ring[i].half);
    const double at = nearest_on(of.spine, of.range, centre);
    end.t = {at, at};
    if (distance(vec(of.spine->Value(at).XYZ()), centre) > kSamePlace * tolerance_)
      refuse(first, FilletFault::Corner, "no ball touches all faces of its corner");
    const Vec3 foot = vec(of.contacts[left_side(ring[i].half)].curve->Value(at).XYZ());
    feet[i] = new_vertex(foot);
    middle += foot - centre;
  }
  const Vec3 x = unit(middle);
  const Vec3 aside = unit(point_of(feet[0]) - centre);
  BlendPatch patch;
  const gp_Ax3 frame(pnt(centre), dir(unit(cross(x, aside))), dir(x));
  BRep_Builder().MakeFace(patch.face, new Geom_SphericalSurface(frame, strip.radius),
                          Precision::Confusion());
  const SurfaceProjector on_ball(patch.face, Precision::Confusion());
  for (std::size_t i = 0; i < count; ++i) {
    const HalfEdge half = ring[i].half;
    PlacedStrip& of = strip_of(half);
    StripEnd& end = end_of(half);
    end.vertices[left_side(half)] = feet[i];
    end.vertices[right_side(half)] = feet[(i + count - 1) % count];
    const TopoDS_Edge arc = section(of, end);
    const bool forward = of.strip.contacts[0].w < of.strip.contacts[1].w;
    end.path = {{arc, forward}};
    add_chart(arc, of.strip.section_line(end.t[0]), of.strip.bare_face());
    Interval range;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(arc, range.from, range.to);
    add_chart(arc, image_of(curve, range, on_ball, Vec2{0, 0}, tolerance_).chart, patch.face);
    // The strip walks from left to right of the vertex, the ball back.
    const bool strip_forward = is_low_end(half) ? forward : !forward;
    patch.edges.push_back(
        TopoDS::Edge(arc.Oriented(strip_forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
  }
  patch.face.Orientation(strip.concave ? TopAbs_REVERSED : TopAbs_FORWARD);
  patches_.push_back(std::move(patch));
}

}  // namespace blossom::occt
