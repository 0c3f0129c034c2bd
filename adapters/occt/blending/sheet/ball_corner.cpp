// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners that one ball fills: it touches all faces round a vertex, and the strips of its radius
// end in great circles of it.
//
// Smooth edges in the vertex part faces that go on in each other: the ball touches what they part
// on one side of them, or on them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <gp_Ax3.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/blending/strips/ball_walker.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

constexpr int kSecantSteps = 60;
constexpr int kCapSteps = 256;  // the middle is within about 1 / 256 then
constexpr int kAxes = 24;       // directions in half a turn that a sphere's axis is chosen from

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

// The middle of the smallest cap of the unit sphere that holds some directions: ever smaller steps
// towards the farthest one (Badoiu and Clarkson 2003). Of normals that one half-space holds it has
// them all within a right angle, which their sum need not.
Vec3 middle_of(const std::vector<Vec3>& directions) {
  Vec3 sum{};
  for (const Vec3& each : directions) sum += each;
  Vec3 middle = unit(sum);
  for (int i = 1; i <= kCapSteps; ++i) {
    const Vec3 farthest = *std::ranges::min_element(
        directions, {}, [&](const Vec3& each) { return dot(each, middle); });
    middle = unit(middle + (1.0 / (i + 1)) * (farthest - middle));
  }
  return middle;
}

// The axis across the middle of a spherical polygon whose poles are as far from it as can be.
Vec3 axis_apart(const Vec3& middle, const std::vector<Vec3>& corners) {
  const Vec3 a = unit(cross(middle, corners.front())), b = cross(middle, a);
  Vec3 best = a;
  double least = 1;
  for (int i = 0; i < kAxes; ++i) {
    const double angle = i * std::numbers::pi / kAxes;
    const Vec3 axis = std::cos(angle) * a + std::sin(angle) * b;
    double nearest = 0;  // by the cosine, over corners and middles of sides
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3& corner = corners[k];
      const Vec3 half = unit(corner + corners[(k + 1) % corners.size()]);
      nearest = std::max({nearest, std::abs(dot(axis, corner)), std::abs(dot(axis, half))});
    }
    if (nearest >= least) continue;
    least = nearest;
    best = axis;
  }
  return best;
}

}  // namespace

// The strips that meet in a vertex, by sector, if they are of one radius and kind and all other
// edges there are smooth; else none.
std::vector<std::size_t> BlendSheet::alike_strips(const Ring& ring) const {
  std::vector<std::size_t> strips;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const DirectedEdge& half = ring[i].half;
    double angle = 0;
    if (!is_filleted(half.edge)) {
      if (edge_kind(body_, half.edge, angle) != EdgeKind::Smooth) return {};
      continue;
    }
    strips.push_back(i);
    const RolledStrip &of = strip_of(half).strip,
                      &first = strip_of(ring[strips.front()].half).strip;
    if (!of.is_ball || of.concave != first.concave || of.radius != first.radius) return {};
  }
  return strips;
}

// The strips of a walk, from a vertex on.
std::vector<BlendSheet::WalkPlace> BlendSheet::walk_from(const DirectedEdge& half) {
  EndPlace end = ends_at_.at({half.edge, half.at_start});
  std::vector<WalkPlace> places;
  const Joint* behind = nullptr;
  for (double ends = end_t(half);;) {
    const auto joint = std::ranges::find_if(joints_, [&](const Joint& each) {
      return &each != behind && (each.before.strip == end.strip || each.after.strip == end.strip);
    });
    places.push_back({end.strip, end.end == 0 ? 1.0 : -1.0, ends, std::nullopt});
    if (joint == joints_.end()) return places;
    const WalkJoint& walked = joint->walked;
    const bool is_before = joint->before.strip == end.strip;
    places.back().goes_on = is_before ? walked.before : walked.after;
    ends = is_before ? walked.after : walked.before;
    end = is_before ? joint->after : joint->before;
    behind = &*joint;
  }
}

// Where the ball of one of the strips touches a face that does not lie beside it.
std::optional<Vec3> BlendSheet::corner_centre(const Ring& ring,
                                              const std::vector<std::size_t>& strips) {
  for (std::size_t i = 0; i < strips.size(); ++i)
    for (const WalkPlace& each : walk_from(ring[strips[i]].half)) {
      const RolledStrip& strip = strips_[each.strip].strip;
      const auto sector = [&](std::size_t after) { return strips[(i + after) % strips.size()]; };
      for (std::size_t k = sector(1); k != sector(2); k = (k + 1) % ring.size())
        if (const auto t = touches(strip, body_.face(ring[k].face), each.ends, each.inwards))
          return vec(strip.spine->Value(*t).XYZ());
    }
  return std::nullopt;
}

// Where a strip's ball is at a place: in the last strip of the walk, or in one before it, if that
// one begins beyond the place.
std::optional<BlendSheet::BallEnd> BlendSheet::ball_end(const DirectedEdge& half,
                                                        const Vec3& centre) {
  int left_out = 0;
  for (const WalkPlace& each : walk_from(half)) {
    const RolledStrip& strip = strips_[each.strip].strip;
    const double t = nearest_on(strip.spine, strip.range, centre);
    const double speed = strip.spine->DN(t, 1).Magnitude(), reach = kSamePlace * tolerance_;
    const bool is_there = distance(vec(strip.spine->Value(t).XYZ()), centre) <= reach;
    if (is_there && (!each.goes_on || each.inwards * (*each.goes_on - t) * speed > reach))
      return BallEnd{left_out, each.strip, t};
    ++left_out;
  }
  return std::nullopt;
}

// Where a ball touches what is between two strips that end beside each other: in a face, or on a
// smooth edge between two.
std::optional<BlendSheet::BallFoot> BlendSheet::ball_foot(const Ring& ring, const BallSide& from,
                                                          const BallSide& to) const {
  const auto contact = [&](const BallSide& of, bool on_left) -> const RolledContact& {
    const DirectedEdge& half = ring[of.sector].half;
    return strips_[of.end.strip].strip.contacts[on_left ? left_side(half) : right_side(half)];
  };
  const RolledContact &a = contact(from, true), &b = contact(to, false);
  BallFoot found{vec(a.curve->Value(from.end.t)), std::nullopt, 0};
  if (distance(found.point, vec(b.curve->Value(to.end.t))) > kSamePlace * tolerance_)
    return std::nullopt;
  if (a.face == b.face) return found;
  const std::size_t count = ring.size();
  for (std::size_t i = (from.sector + 1) % count; i != to.sector; i = (i + 1) % count) {
    if (ring[(i + count - 1) % count].face != a.face || ring[i].face != b.face) continue;
    found.sector = i;
    found.parameter = nearest_on_edge(body_, ring[i].half.edge, found.point);
    const Vec3 there = body_.corner(body_.use(ring[i].half.edge, true), found.parameter).point;
    if (distance(there, found.point) <= kSamePlace * tolerance_) return found;
  }
  return std::nullopt;
}

// The vertex there. A smooth edge on which it lies stays beyond it.
TopoDS_Vertex BlendSheet::ball_vertex(const Ring& ring, const BallFoot& foot, const DirectedEdge& a,
                                      const DirectedEdge& b) {
  if (!foot.sector) return new_vertex(foot.point);
  const VertexSector& smooth = ring[*foot.sector];
  end_of(a).over[left_side(a)] = end_of(b).over[right_side(b)] = smooth.half.edge;
  const TopoDS_Vertex vertex = cut_edge(smooth.half, foot.parameter, body_.face(smooth.face));
  cover(vertex, foot.point, Precision::Confusion());
  return vertex;
}

// A part of the ball's sphere whose poles are far from it.
BlendPatch BlendSheet::ball_patch(const RolledStrip& strip, const Vec3& centre,
                                  const std::vector<TopoDS_Vertex>& feet) {
  std::vector<Vec3> towards;
  for (const TopoDS_Vertex& foot : feet) towards.push_back(unit(point_of(foot) - centre));
  const Vec3 x = middle_of(towards);
  BlendPatch patch;
  const gp_Ax3 frame(pnt(centre), dir(axis_apart(x, towards)), dir(x));
  BRep_Builder().MakeFace(patch.face, new Geom_SphericalSurface(frame, strip.radius),
                          Precision::Confusion());
  patch.face.Orientation(strip.concave ? TopAbs_REVERSED : TopAbs_FORWARD);
  return patch;
}

// The great circle in which a strip ends, for the strip and for the ball.
void BlendSheet::end_in_circle(const DirectedEdge& half, BlendPatch& patch) {
  const PlacedStrip& of = strip_of(half);
  StripEnd& end = end_of(half);
  const TopoDS_Edge arc = section(of, end);
  const bool forward = of.strip.contacts[0].w < of.strip.contacts[1].w;
  end.path = {{arc, forward}};
  add_chart(arc, of.strip.section_line(end.t[0]), of.strip.bare_face());
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(arc, range.from, range.to);
  const SurfaceProjector on_ball(patch.face, Precision::Confusion());
  add_chart(arc, image_of(curve, range, on_ball, Vec2{0, 0}, tolerance_).chart, patch.face);
  // The strip walks from left to right of the vertex, the ball back.
  const bool strip_forward = is_low_end(half) ? forward : !forward;
  patch.edges.push_back(
      TopoDS::Edge(arc.Oriented(strip_forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
}

// Where all sharp edges at a vertex have strips of one radius and kind, and one ball touches all
// faces there: the strips end in great circles of it. False, and nothing is done, where none does.
bool BlendSheet::ball_corner(const Ring& ring) {
  const std::vector<std::size_t> strips = alike_strips(ring);
  const std::size_t count = strips.size();
  if (count < 3) return false;
  const auto centre = corner_centre(ring, strips);
  if (!centre) return false;
  std::vector<BallSide> sides;
  for (const std::size_t sector : strips) {
    const auto end = ball_end(ring[sector].half, *centre);
    if (!end) return false;
    sides.push_back({sector, *end});
  }
  std::vector<BallFoot> feet;  // to the left of each
  for (std::size_t i = 0; i < count; ++i) {
    const auto foot = ball_foot(ring, sides[i], sides[(i + 1) % count]);
    if (!foot) return false;
    feet.push_back(*foot);
  }
  for (const BallSide& each : sides)
    for (int i = 0; i < each.end.left_out; ++i)
      if (!leave_out_last(ring[each.sector].half)) return false;
  std::vector<TopoDS_Vertex> vertices;
  for (std::size_t i = 0; i < count; ++i) {
    const DirectedEdge half = ring[sides[i].sector].half,
                       next = ring[sides[(i + 1) % count].sector].half;
    end_of(half).t = {sides[i].end.t, sides[i].end.t};
    vertices.push_back(ball_vertex(ring, feet[i], half, next));
    end_of(half).vertices[left_side(half)] = end_of(next).vertices[right_side(next)] =
        vertices.back();
  }
  BlendPatch patch = ball_patch(strip_of(ring[strips[0]].half).strip, *centre, vertices);
  for (const std::size_t sector : strips) end_in_circle(ring[sector].half, patch);
  patches_.push_back(std::move(patch));
  return true;
}

}  // namespace blossom::occt
