// SPDX-License-Identifier: LGPL-2.1-or-later
// Where strips meet in a vertex: mitres of two, and which corner more of them make.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/blending/strips/mitre_curve.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

constexpr int kMitreSamples = 8;
constexpr std::size_t kMitredRound = 6;  // edges: of more than three strips no point is common
constexpr int kCommonSteps = 40;
constexpr double kCommonPart = 0.1;     // of the tolerance: how near strips are to a common point
constexpr std::size_t kMitreEdges = 2;  // on one side between strips in a mitre, with a face

// Points of a strip are as far from its spine as the ball's radius.
bool lies_on_ball_strip(const EndCurve& curve, const RolledStrip& strip, double reach) {
  for (int i = 0; i <= kMitreSamples; ++i) {
    const double x = at(curve.range, static_cast<double>(i) / kMitreSamples);
    const Vec3 point = vec(curve.curve->Value(x).XYZ());
    const double t = nearest_on(strip.spine, strip.range, point);
    const double height = distance(vec(strip.spine->Value(t).XYZ()), point);
    if (std::abs(height - strip.radius) > reach) return false;
  }
  return true;
}

bool is_spline(const RolledStrip& strip) {
  return !Handle(Geom_BSplineSurface)::DownCast(strip.surface).IsNull();
}

}  // namespace

// The edge in which two strips run into each other, between two vertices: followed from the one to
// the other where a strip is fitted, else in the plane in which one ball touches all their faces,
// or wherever they meet.
PathEdge BlendSheet::mitre_edge(const DirectedEdge& a, const DirectedEdge& b,
                                const TopoDS_Vertex& from, const TopoDS_Vertex& to, double reach) {
  const RolledStrip &strip = strip_of(a).strip, &other = strip_of(b).strip;
  const Interval part = part_near(a, end_of(a).t), other_part = part_near(b, end_of(b).t);
  const Vec3 place = point_of(from), target = point_of(to);
  const auto made = [&](const EndCurve& curve, const Handle(Geom2d_Curve) & on_other) {
    const TopoDS_Edge edge =
        edge_on(curve.curve, curve.range, curve.forward ? from : to, curve.forward ? to : from);
    add_chart(edge, curve.on_strip, strip.bare_face());
    add_chart(edge, on_other, other.bare_face());
    return PathEdge{edge, curve.forward};
  };
  if (strip.is_ball && other.is_ball && (is_spline(strip) || is_spline(other)))
    if (const auto curve = mitre_curve(strip, other, place, target, tolerance_))
      return made(*curve, curve->on_face);
  if (strip.is_ball && other.is_ball) {
    const Vec3 centre = vec(strip.spine->Value(end_of(a).t[left_side(a)]).XYZ());
    const auto curve =
        curve_between(strip, part, plane_face(place, target, centre), place, target, reach);
    if (curve && lies_on_ball_strip(*curve, other, kSamePlace * tolerance_)) {
      const SurfaceProjector feet(other.bare_face(), Precision::Confusion());
      const double w = 0.5 * (other.contacts[0].w + other.contacts[1].w);
      const Vec2 near = other.chart(end_of(b).t[0], w);
      return made(*curve,
                  image_of(curve->curve, curve->range, feet, near, kSamePlace * tolerance_).chart);
    }
  }
  const auto curve = curve_between(strip, part, other, other_part, place, target, reach);
  if (!curve)
    refuse(a, FilletFault::Corner,
           "its strip and that of edge " + std::to_string(b.edge) + " do not run into each other");
  return made(*curve, curve->on_face);
}

// Where two strips that run into each other do so in a face that both lie on.
BlendSheet::MitreSide BlendSheet::mitre_in_face(const MitreContact& a, const MitreContact& b) {
  const RolledStrip &strip = strip_of(a.half).strip, &other = strip_of(b.half).strip;
  const auto crossing =
      contacts_cross(body_, strip, a.side, end_t(a.half), other, b.side, end_t(b.half));
  if (!crossing)
    refuse(a.half, FilletFault::Corner,
           "its contact does not cross that of edge " + std::to_string(b.half.edge) + " on face " +
               std::to_string(strip.contacts[a.side].face));
  end_of(a.half).t[a.side] = (*crossing)[0];
  end_of(b.half).t[b.side] = (*crossing)[1];
  const TopoDS_Vertex start =
      new_vertex(vec(strip.contacts[a.side].curve->Value((*crossing)[0]).XYZ()));
  end_of(a.half).vertices[a.side] = end_of(b.half).vertices[b.side] = start;
  return {start, {start, start}};
}

// Where two strips that run into each other leave the edge between them. The wider one comes
// further along the edge. The contact of the other one ends in it: before the edge where that is of
// the strips' own kind there, else beyond it, over what the wider strip lays bare, and its face
// grows up to there.
BlendSheet::MitreSide BlendSheet::mitre_at_edge(const MitreContact& a, const MitreContact& b,
                                                const DirectedEdge& between) {
  const auto a_meets = meeting_with(body_, strip_of(a.half).strip, a.side, *a.use, end_t(a.half));
  const auto b_meets = meeting_with(body_, strip_of(b.half).strip, b.side, *b.use, end_t(b.half));
  if (!a_meets && !b_meets) refuse_miss(a.half, a.side, *a.use, between);
  const auto away = [&](const ContactMeeting& at) {
    return between.at_start ? at.edge_parameter : -at.edge_parameter;
  };
  const bool a_wider = !b_meets || (a_meets && away(*a_meets) >= away(*b_meets));
  const ContactMeeting wide = a_wider ? *a_meets : *b_meets;
  const MitreContact &wider = a_wider ? a : b, &narrow = a_wider ? b : a;
  const TopoDS_Vertex foot = cut_edge(between, wide.edge_parameter, body_.face(wider.use->face));
  end_of(wider.half).t[wider.side] = wide.t;
  const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(foot));
  const RolledStrip& thin = strip_of(narrow.half).strip;
  const auto& meets = a_wider ? b_meets : a_meets;
  double t = meets ? meets->t : end_t(narrow.half);
  const auto place = [&] { return vec(thin.contacts[narrow.side].curve->Value(t).XYZ()); };
  TopoDS_Vertex joined = foot;
  if (!meets || distance(place(), point_of(foot)) > reach) {
    const EdgeKind other = thin.concave ? EdgeKind::Convex : EdgeKind::Concave;
    const auto through = contact_through(thin, narrow.side, t, strip_of(wider.half).strip,
                                         part_near(wider.half, end_of(wider.half).t));
    const double outwards = is_low_end(narrow.half) ? -1 : 1;
    const bool is_missed = !meets && kind_at(body_, between.edge, wide.edge_parameter) == other;
    if (!through || is_missed)
      refuse(narrow.half, FilletFault::Corner,
             "its contact does not come to the strip of edge " + std::to_string(wider.half.edge));
    if (meets && outwards * (*through - t) > 0)
      end_of(narrow.half).over[narrow.side] = between.edge;
    t = *through;
    joined = new_vertex(place());
  }
  end_of(narrow.half).t[narrow.side] = t;
  end_of(wider.half).vertices[wider.side] = foot;
  end_of(narrow.half).vertices[narrow.side] = joined;
  const int face = narrow.use->face;
  return {joined, {a_wider ? foot : joined, a_wider ? joined : foot}, {face, face}};
}

// Where two strips that run into each other do so over a face between them, to which each comes
// over an edge of its own.
BlendSheet::MitreSide BlendSheet::mitre_over_face(const MitreContact& a, const MitreContact& b,
                                                  const DirectedEdge& beside_a,
                                                  const DirectedEdge& beside_b, int face) {
  const auto leave = [&](const MitreContact& of, const DirectedEdge& over) {
    const auto meets =
        meeting_with(body_, strip_of(of.half).strip, of.side, *of.use, end_t(of.half));
    if (!meets) refuse_miss(of.half, of.side, *of.use, over);
    const TopoDS_Vertex foot = cut_edge(over, meets->edge_parameter, body_.face(of.use->face));
    end_of(of.half).t[of.side] = meets->t;
    end_of(of.half).vertices[of.side] = foot;
    return foot;
  };
  const TopoDS_Vertex from_a = leave(a, beside_a), from_b = leave(b, beside_b);
  const double reach = kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(from_a),
                                              BRep_Tool::Tolerance(from_b)});
  const auto met = mitre_through(strip_of(a.half).strip, part_near(a.half, end_of(a.half).t),
                                 strip_of(b.half).strip, part_near(b.half, end_of(b.half).t),
                                 body_.face(face), point_of(body_.vertex(a.half)), reach);
  if (!met)
    refuse(a.half, FilletFault::Corner,
           "its strip and that of edge " + std::to_string(b.half.edge) + " do not meet over face " +
               std::to_string(face));
  // The one may come to the face where the other is already.
  for (const TopoDS_Vertex& foot : {from_a, from_b})
    if (distance(point_of(foot), met->point) <= reach)
      return {foot, {from_a, from_b}, {face, face}};
  return {new_vertex(met->point), {from_a, from_b}, {face, face}};
}

// By how many edges are between the strips on that side.
BlendSheet::MitreSide BlendSheet::mitre_side(const Ring& ring, std::size_t other, bool on_left) {
  const DirectedEdge a = ring[0].half, b = ring[other].half;
  const std::size_t last = ring.size() - 1, between = on_left ? other - 1 : last - other;
  const auto leaving = [&](std::size_t sector) {
    return &body_.uses(ring[sector].face)[static_cast<std::size_t>(ring[sector].use)];
  };
  const MitreContact of_a{a, on_left ? left_side(a) : right_side(a),
                          on_left ? &arriving(ring, 0) : leaving(last)};
  const MitreContact of_b{b, on_left ? right_side(b) : left_side(b),
                          on_left ? leaving(other - 1) : &arriving(ring, other)};
  const std::size_t beside_a = on_left ? 1 : last, beside_b = on_left ? other - 1 : other + 1;
  if (between == 0) return mitre_in_face(of_a, of_b);
  if (between == 1) return mitre_at_edge(of_a, of_b, ring[beside_a].half);
  return mitre_over_face(of_a, of_b, ring[beside_a].half, ring[beside_b].half,
                         ring[std::min(beside_a, beside_b)].face);
}

// Two of one kind with at most two edges, and one face, between them on either side.
bool BlendSheet::can_be_mitred(const Ring& ring, std::size_t other) {
  return strip_of(ring[0].half).strip.concave == strip_of(ring[other].half).strip.concave &&
         other <= kMitreEdges + 1 && ring.size() - other <= kMitreEdges + 1;
}

// From where a strip leaves its own face to where it meets the other one, or back, if that is over
// a face between them.
void BlendSheet::path_over(const DirectedEdge& half, const MitreSide& side, std::size_t of,
                           bool inwards) {
  const TopoDS_Vertex& foot = side.feet[of];
  if (side.joined.IsSame(foot)) return;
  cap_face(half, part_near(half, end_of(half).t), side.over[of], inwards ? foot : side.joined,
           inwards ? side.joined : foot);
}

// Two strips run into each other in a curve, from one of their sides to the other. Where an edge is
// between them, the wider one comes further along it, and goes over the face beside the other one
// up to the other's contact.
void BlendSheet::mitre(const Ring& ring, std::size_t other) {
  const DirectedEdge a = ring[0].half, b = ring[other].half;
  if (!can_be_mitred(ring, other))
    refuse(a, FilletFault::Corner,
           "it meets edge " + std::to_string(b.edge) + " at a vertex of " +
               std::to_string(ring.size()) +
               " edges, where two blends and the faces beside them cannot be joined yet");
  end_of(a).t = {end_t(a), end_t(a)};
  end_of(b).t = {end_t(b), end_t(b)};
  const MitreSide left = mitre_side(ring, other, true), right = mitre_side(ring, other, false);
  const double reach = kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(left.joined),
                                              BRep_Tool::Tolerance(right.joined)});
  const PathEdge seam = mitre_edge(a, b, left.joined, right.joined, reach);
  // From left to right of who walks away from the vertex.
  path_over(a, left, 0, true);
  end_of(a).path.push_back(seam);
  path_over(a, right, 0, false);
  path_over(b, right, 1, true);
  end_of(b).path.push_back({seam.edge, !seam.forward});
  path_over(b, left, 1, false);
  turn_path(a);
  turn_path(b);
}

// A path from left to right, as it was made, from the first contact to the second.
void BlendSheet::turn_path(const DirectedEdge& half) {
  if (left_side(half) == 0) return;
  std::vector<PathEdge>& path = end_of(half).path;
  std::reverse(path.begin(), path.end());
  for (PathEdge& each : path) each.forward = !each.forward;
}

// The strips of a vertex in which they alternate with edges of the other kind that have none.
bool BlendSheet::alternate(const Ring& ring) const {
  if (ring.size() != kMitredRound) return false;
  const std::size_t first = is_filleted(ring[0].half.edge) ? 0 : 1;
  const bool concave = strip_of(ring[first].half).strip.concave;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const int edge = ring[i].half.edge;
    const bool is_strip = is_filleted(edge);
    if (is_strip != (i % 2 == first)) return false;
    if (is_strip ? strip_of(ring[i].half).strip.concave != concave
                 : kind_at(body_, ring[i].half) != (concave ? EdgeKind::Convex : EdgeKind::Concave))
      return false;
  }
  return true;
}

// The common point of three strips near a place: by Newton's method on the distances from them.
std::optional<Vec3> BlendSheet::common_point(const std::vector<DirectedEdge>& halves,
                                             const Vec3& near) const {
  std::vector<SurfaceProjector> on;
  for (const DirectedEdge& each : halves)
    on.emplace_back(strip_of(each).strip.bare_face(), Precision::Confusion());
  Vec3 point = near;
  for (int step = 0; step < kCommonSteps; ++step) {
    std::array<Vec3, 3> normals;
    Vec3 heights;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const SurfaceJet frame = frame_at(strip_of(halves[i]).strip.surface, on[i].foot(point, {}));
      normals[i] = unit(cross(frame.du, frame.dv));
      heights[static_cast<int>(i)] = dot(point - frame.point, normals[i]);
    }
    if (norm(heights) <= kCommonPart * tolerance_) return point;
    const double volume = dot(normals[0], cross(normals[1], normals[2]));
    if (std::abs(volume) < std::sin(kSmoothJoint)) return std::nullopt;
    for (std::size_t i = 0; i < normals.size(); ++i)
      point -= (heights[static_cast<int>(i)] / volume) *
               cross(normals[(i + 1) % 3], normals[(i + 2) % 3]);
  }
  return std::nullopt;
}

// Three strips run into each other in three curves that come from the edges between them to one
// point. False, and nothing is done, where they do not alternate with such edges.
bool BlendSheet::mitre_round(const Ring& ring) {
  if (!alternate(ring)) return false;
  const std::size_t count = ring.size() / 2, first = is_filleted(ring[0].half.edge) ? 0 : 1;
  std::vector<DirectedEdge> halves;
  for (std::size_t i = 0; i < count; ++i) halves.push_back(ring[2 * i + first].half);
  for (const DirectedEdge& each : halves) end_of(each).t = {end_t(each), end_t(each)};
  std::vector<MitreSide> sides;  // to the left of each
  Vec3 middle{};
  for (std::size_t i = 0; i < count; ++i) {
    Ring turned = ring;
    std::ranges::rotate(turned, turned.begin() + static_cast<std::ptrdiff_t>(2 * i + first));
    sides.push_back(mitre_side(turned, 2, true));
    middle += (1.0 / static_cast<double>(count)) * point_of(sides.back().joined);
  }
  const auto point = common_point(halves, middle);
  if (!point)
    refuse(halves[0], FilletFault::Corner, "the strips that meet there have no common point");
  const TopoDS_Vertex met = new_vertex(*point);
  std::vector<PathEdge> seams;
  for (std::size_t i = 0; i < count; ++i) {
    const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(sides[i].joined));
    seams.push_back(mitre_edge(halves[i], halves[(i + 1) % count], sides[i].joined, met, reach));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    path_over(halves[i], sides[i], 0, true);
    end_of(halves[i]).path.push_back(seams[i]);
    end_of(halves[i]).path.push_back({seams[before].edge, !seams[before].forward});
    path_over(halves[i], sides[before], 1, false);
    turn_path(halves[i]);
  }
  return true;
}

// Several strips meet in a vertex.
void BlendSheet::corner(const Ring& ring) {
  if (setback_) return set_back(ring);
  if (is_chamfer_ ? crossed_corner(ring) : ball_corner(ring)) return;
  if (is_chamfer_ || !alternate(ring)) return set_back(ring);
  std::vector<DirectedEdge> halves;
  for (const VertexSector& each : ring)
    if (is_filleted(each.half.edge)) halves.push_back(each.half);
  or_else(
      halves, [&] { mitre_round(ring); }, [&](const std::string&) { return is_set_back(ring); });
}

}  // namespace blossom::occt
