// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips that end in faces of the body: each contact goes over a border of its face, and the strip
// crosses the faces behind, one after the other, from the one border to the other.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"
#include "core/math/functions/sign_change.h"

namespace blossom::occt {
namespace {

constexpr double kSameW = 1e-9;  // of the way across the strip

// Whether the surface of a face has a pole in a vertex. What fills a notch there leaves the face
// all round it, with the pole inside.
bool has_pole_at(const BodyEdges& body, int face, const TopoDS_Vertex& vertex) {
  return std::ranges::any_of(body.uses(face), [&](const EdgeUseInFace& use) {
    return use.coedge->degenerated && TopExp::FirstVertex(body.edge(use.edge)).IsSame(vertex);
  });
}

bool has_seam(const BodyEdges& body, int face) {
  return std::ranges::any_of(body.uses(face), [&](const EdgeUseInFace& use) {
    return !use.coedge->degenerated && body.behind(use).face == face;
  });
}

}  // namespace

// Where a contact goes over the border of its face first, from the middle of its strip to an end.
std::optional<ContactCrossing> BlendSheet::way_out(const DirectedEdge& half, std::size_t side) {
  const PlacedStrip& of = strip_of(half);
  const RolledContact& contact = of.strip.contacts[side];
  const double outwards = is_low_end(half) ? -1 : 1;
  const Interval& beside = of.strip.edge_range;
  const std::vector<ContactCrossing> all = contact_crossings(body_, of.strip, side, filleted_);
  const std::vector<Notch> round = notches(body_, of.strip, side, all);
  const auto is_of_notch = [&](const ContactCrossing& each) {
    return std::ranges::any_of(round, [&](const Notch& notch) {
      return notch.has(each.t) && notch.leaves.t > beside.from && notch.enters.t < beside.to;
    });
  };
  // In a vertex, where it meets two edges at once, the one at the end of the strip.
  const auto is_at_end = [&](const ContactCrossing& each) {
    const TopoDS_Vertex vertex = body_.vertex(half);
    return body_.vertex({each.use->edge, true}).IsSame(vertex) ||
           body_.vertex({each.use->edge, false}).IsSame(vertex);
  };
  std::optional<ContactCrossing> best;
  for (const ContactCrossing& each : all) {
    const double far = outwards * (each.t - of.inside);
    const double speed = contact.curve->DN(each.t, 1).Magnitude();
    const double room = kSamePlace * std::max(tolerance_, each.use->coedge->tolerance);
    if (far * speed < room || is_seam_at(body_, each) || is_of_notch(each)) continue;
    const double nearer = best ? outwards * (best->t - each.t) * speed : 0;
    const bool by_end = best && std::abs(nearer) <= room && is_at_end(each) != is_at_end(*best);
    if (!best || (by_end ? is_at_end(each) : nearer > 0)) best = each;
  }
  return best;
}

// Where a contact leaves its face at an end of its strip, and the face behind.
BlendSheet::Cut BlendSheet::end_cut(const DirectedEdge& half, std::size_t side, int& beyond,
                                    int& edge) {
  const PlacedStrip& of = strip_of(half);
  const RolledContact& contact = of.strip.contacts[side];
  const std::optional<ContactCrossing> best = way_out(half, side);
  if (!best && !lies_inside(body_, contact, of.inside))
    refuse(half, FilletFault::LeavesFace,
           contact_words() + " lies beyond the border of face " + std::to_string(contact.face) +
               " at this end");
  if (!best)
    refuse(half, FilletFault::End,
           contact_words() + " on face " + std::to_string(contact.face) +
               " comes to no border of it at this end");
  edge = best->use->edge;
  beyond = body_.use(edge, !best->use->forward).face;
  return {best->t, cut_edge(*best, body_.face(contact.face))};
}

// The vertex of a face's border at a place, at which the border of the sheet ends then, or a new
// one.
TopoDS_Vertex BlendSheet::vertex_in(int face, const Vec3& place) {
  for (const EdgeUseInFace& use : body_.uses(face))
    for (const bool at_start : {true, false}) {
      const TopoDS_Vertex vertex = body_.vertex({use.edge, at_start});
      if (distance(point_of(vertex), place) > std::max(tolerance_, BRep_Tool::Tolerance(vertex)))
        continue;
      border_.vertices.push_back(vertex);
      return vertex;
    }
  return new_vertex(place);
}

// Whether the border of a face turns back at the end of a strip, so that the contact runs on past
// it inside of the face.
bool BlendSheet::turns_back(const Ring& ring, bool on_left) {
  const DirectedEdge half = ring.front().half;
  const VertexSector& sector = on_left ? ring.front() : ring.back();
  const std::size_t side = on_left ? left_side(half) : right_side(half);
  if (ring.size() < 3 || strip_of(half).strip.contacts[side].face != sector.face) return false;
  // In a pole there is no way across the edge to compare with, and the contact turns round it.
  if (has_pole_at(body_, sector.face, body_.vertex(half))) return false;
  double first = 0, last = 0;
  BRep_Tool::Range(body_.edge(half.edge), first, last);
  const BodyEdges::Corner corner =
      body_.corner(body_.use(half.edge, side == 0), half.at_start ? first : last);
  const DirectedEdge beside = on_left ? ring[1].half : ring.back().half;
  const Vec3 way = direction_at(body_, beside);
  const double across = dot(way, corner.inwards), straight = std::sin(kSmoothJoint);
  // In a cusp of the face both edges leave the vertex the same way.
  const bool is_cusp = std::abs(across) <= straight && dot(way, direction_at(body_, half)) > 0;
  return across <= straight && !is_cusp;
}

// How a face that begins in the vertex at the end of a strip would go on up to one of its contacts.
//
// why   it does not, where it does not
std::optional<BlendSheet::GrownWay> BlendSheet::way_up_to(const Ring& ring, bool on_left,
                                                          int growing, std::string& why) {
  const DirectedEdge half = ring.front().half;
  const RolledStrip& strip = strip_of(half).strip;
  const std::size_t side = on_left ? left_side(half) : right_side(half);
  const RolledContact& contact = strip.contacts[side];
  const double inside = strip_of(half).inside;
  const Interval part =
      is_low_end(half) ? Interval{strip.range.from, inside} : Interval{inside, strip.range.to};
  const auto told = [&](const std::string& cause) {
    return "face " + std::to_string(growing) + " at its end " + cause + " on face " +
           std::to_string(contact.face);
  };
  const auto t = contact_through(strip, side, end_t(half), body_.face(growing), part);
  if (!t || !lies_on(body_, contact, *t)) {
    why = told("would not come, if it went on, to " + contact_words());
    return std::nullopt;
  }
  const TopoDS_Vertex corner = body_.vertex(half);
  const Vec3 place = vec(contact.curve->Value(*t).XYZ());
  const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(corner));
  auto down = wall_curve_between(body_.face(growing), body_.face(contact.face), place,
                                 point_of(corner), reach);
  if (!down) {
    why = told("cannot go on along a curve up to " + contact_words());
    return std::nullopt;
  }
  return GrownWay{growing, *t, place, *std::move(down)};
}

// Where a border turns back, a face that begins in the vertex grows up to the contact and ends the
// strip there: the one behind that border, or else the next one round the vertex that comes to it.
BlendSheet::Cut BlendSheet::grown_cut(const Ring& ring, bool on_left, int& beyond, int& edge) {
  std::string first;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    std::string why;
    const int face = ring[on_left ? i : ring.size() - 1 - i].face;
    if (const auto way = way_up_to(ring, on_left, face, why)) {
      beyond = face;
      edge = i > 1 ? 0 : (on_left ? ring[1] : ring.back()).half.edge;
      return grow_along(ring, on_left, *way);
    }
    if (first.empty()) first = why;
  }
  refuse(ring.front().half, FilletFault::End, first);
}

BlendSheet::Cut BlendSheet::grow_along(const Ring& ring, bool on_left, const GrownWay& way) {
  const DirectedEdge half = ring.front().half;
  const int face = strip_of(half).strip.contacts[on_left ? left_side(half) : right_side(half)].face;
  const TopoDS_Vertex corner = body_.vertex(half), joined = vertex_in(face, way.place);
  const TopoDS_Edge border = wall_border(way.down, joined, corner, on_left, face);
  add_chart(TopoDS::Edge(border.Oriented(TopAbs_FORWARD)),
            chart_near_face(way.down.on_strip, at(way.down.range, 0.5), body_, way.face),
            body_.face(way.face));
  added_[way.face].push_back(border);
  border_.vertices.push_back(corner);
  return {way.t, joined};
}

namespace {

// Of the angle at which a strip meets a face near a point.
double sine_at(const RolledStrip& strip, const TopoDS_Face& face, const Vec3& point) {
  const auto normal = [&](const TopoDS_Face& of) {
    const SurfaceProjector feet(of, Precision::Confusion());
    const SurfaceJet frame = frame_at(feet.surface(), feet.foot(point, std::nullopt));
    return unit(cross(frame.du, frame.dv));
  };
  return norm(cross(normal(strip.bare_face()), normal(face)));
}

}  // namespace

// Across one of the faces at the end of a strip, from its left to its right.
//
// Where both meet at a small angle, as a strip and the face behind a slight bend do, what either is
// off, e, moves their curve by e over its sine: by no more than up to where surfaces that touch,
// with curvatures that differ by 1/r, part by that, sqrt(2 e r).
void BlendSheet::cap_face(const DirectedEdge& half, const Interval& part, int face,
                          const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
  const RolledStrip& strip = strip_of(half).strip;
  if (strip.concave && has_pole_at(body_, face, body_.vertex(half)))
    refuse(half, FilletFault::End,
           "it ends in a pole of face " + std::to_string(face) +
               ", which would have to close round it: this cannot be built yet");
  double reach =
      kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(from), BRep_Tool::Tolerance(to)});
  const double off = kSamePlace * tolerance_;
  for (const TopoDS_Vertex& end : {from, to})
    reach = std::max(reach, std::min(std::sqrt(2 * off * strip.radius),
                                     off / sine_at(strip, body_.face(face), point_of(end))));
  const auto curve =
      curve_between(strip, part, body_.face(face), point_of(from), point_of(to), reach);
  if (!curve)
    refuse(
        half, FilletFault::End,
        "the strip does not cross face " + std::to_string(face) + " at its end from side to side");
  for (const PathEdge& each : edges_along(strip, *curve, face, from, to)) {
    // Seen from the vertex the face lies beyond the strip's end: it walks from right to left.
    added_[face].push_back(
        TopoDS::Edge(each.edge.Oriented(each.forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
    end_of(half).path.push_back(each);
  }
}

// The way in which a strip goes on over a face from where it came to it over an edge. Nothing where
// they touch, or the strip runs along that edge.
std::optional<Vec3> BlendSheet::way_over(const RolledStrip& strip, int face,
                                         const StripPlace& from) const {
  const SurfaceJet frame = frame_at(strip.surface, strip.chart(from.through.t, from.through.w));
  const BodyEdges::Corner corner =
      body_.corner(body_.use_in(from.edge, face), from.through.edge_parameter);
  const Vec3 way = cross(unit(cross(frame.du, frame.dv)), corner.normal);
  const double inwards = dot(way, corner.inwards);
  if (std::abs(inwards) < std::sin(kSmoothJoint)) return std::nullopt;
  return unit(inwards > 0 ? way : -way);
}

// The edge over which a strip leaves a face next, if there is one.
//
// Of the edges ahead it is the first one: from the strip's left to its right, or, where the strip
// goes along itself or back over a face, in the way that it takes there. Over a seam the face goes
// on as the other use has it.
std::optional<BlendSheet::WayOut> BlendSheet::next_way_out(const DirectedEdge& half,
                                                           const Interval& part, int face,
                                                           const StripPlace& from) {
  const RolledStrip& strip = strip_of(half).strip;
  const double w_left = strip.contacts[left_side(half)].w;
  const double span = strip.contacts[right_side(half)].w - w_left;
  const auto way = from.is_contact ? std::nullopt : way_over(strip, face, from);
  const SurfaceJet frame = frame_at(strip.surface, strip.chart(from.through.t, from.through.w));
  const Vec3 across = (span > 0 ? 1 : -1) * unit(strip.along_u ? frame.dv : frame.du);
  const bool by_w = !way || dot(*way, across) > std::sin(kSmoothJoint);
  const double room = by_w ? kSameW : kSamePlace * tolerance_;
  const auto ahead = [&](const EdgeThrough& each) {
    return by_w ? (each.w - from.through.w) / span : dot(each.point - from.through.point, *way);
  };
  std::optional<WayOut> best;
  for (const EdgeUseInFace& use : body_.uses(face)) {
    if (use.coedge->degenerated || use.edge == from.edge || is_filleted(use.edge)) continue;
    const bool is_seam = body_.behind(use).face == face;
    for (const EdgeThrough& each : edge_through(strip, part, body_, use.edge)) {
      if (ahead(each) <= room || (best && ahead(each) >= ahead(best->through))) continue;
      if (is_seam && dot(body_.corner(use, each.edge_parameter).inwards, across) > 0) continue;
      best = WayOut{each, &use, is_seam, (each.w - w_left) / span};
    }
  }
  return best;
}

// To the edge over which the strip leaves a face; returns the face behind it.
int BlendSheet::cross_face(const Ring& ring, const Interval& part, int face, StripPlace& from,
                           TopoDS_Vertex& start) {
  const DirectedEdge half = ring.front().half;
  const auto best = next_way_out(half, part, face, from);
  if (!best) return cross_grown(ring, part, face, from, start);
  const EdgeUseInFace& over = *best->use;
  const TopoDS_Edge edge = body_.edge(over.edge);
  const int split = splits_.add(edge, best->through.edge_parameter, body_.face(face));
  // What stays of the face is to the right of the way out of it, and so is what stays of the edge:
  // all that the face's border comes along before.
  border_.cuts.push_back({over.edge, split, !over.forward});
  const TopoDS_Vertex to = splits_.vertex(edge, split);
  cap_face(half, part, face, start, to);
  start = to;
  from = {best->through, over.edge, false};
  return body_.behind(over).face;
}

// Where the faces on both sides of an edge grow up to the strip, so does the edge, past the vertex:
// over it the strip comes to the face behind.
int BlendSheet::cross_grown(const Ring& ring, const Interval& part, int face, StripPlace& from,
                            TopoDS_Vertex& start) {
  const DirectedEdge half = ring.front().half;
  const auto sector = std::ranges::find(ring, face, &VertexSector::face);
  const auto refuse_growing = [&] {
    refuse(half, FilletFault::End,
           "no edge of face " + std::to_string(face) +
               " goes through the strip at its end, over which it would come to its other side");
  };
  if (sector == ring.end() || sector + 1 == ring.end()) refuse_growing();
  const VertexSector& next = *(sector + 1);
  const TopoDS_Vertex corner = body_.vertex(half);
  const auto met = grown_through(strip_of(half).strip, part, body_.face(face),
                                 body_.face(next.face), point_of(corner));
  if (!met) refuse_growing();
  const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(corner));
  const auto down = wall_curve_between(body_.face(next.face), body_.face(face), met->point,
                                       point_of(corner), reach);
  if (!down) refuse_growing();
  const TopoDS_Vertex to = new_vertex(met->point);
  const TopoDS_Edge border = wall_border(*down, to, corner, true, face);
  add_chart(TopoDS::Edge(border.Oriented(TopAbs_FORWARD)),
            chart_near_face(down->on_strip, at(down->range, 0.5), body_, next.face),
            body_.face(next.face));
  added_[next.face].push_back(border);
  border_.vertices.push_back(corner);
  cap_face(half, part, face, start, to);
  start = to;
  from = {*met, next.half.edge, false};
  return next.face;
}

// Behind a strip faces grow at edges of the other kind. Where the border of one, up to where the
// strip comes to it, lies on the surface of another, as of two pieces of one plane, the other takes
// all that is added, and that border becomes their common edge; so does a smooth one, behind which
// nothing grows. False, and nothing is done, if it does not.
bool BlendSheet::takes_over(const Ring& ring, int taking, int giving, int edge,
                            const TopoDS_Vertex& cut) {
  const DirectedEdge half = ring.front().half;
  const TopoDS_Vertex corner = body_.vertex(half);
  const auto beside =
      std::ranges::find_if(ring, [&](const VertexSector& each) { return each.half.edge == edge; });
  if (beside == ring.end() || cut.IsSame(corner)) return false;
  const EdgeKind kind = kind_at(body_, beside->half);
  const EdgeKind other = strip_of(half).strip.concave ? EdgeKind::Convex : EdgeKind::Concave;
  if (kind != other && kind != EdgeKind::Smooth) return false;
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body_.edge(edge), range.from, range.to);
  const bool at_start = beside->half.at_start;
  const double place = nearest_on(curve, range, point_of(cut));
  const Interval piece = at_start ? Interval{range.from, place} : Interval{place, range.to};
  const double reach =
      kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(cut), BRep_Tool::Tolerance(corner)});
  if (distance(vec(curve->Value(place)), point_of(cut)) > reach) return false;
  Handle(Geom2d_Curve) on_taking;
  try {
    const SurfaceProjector feet(body_.face(taking), Precision::Confusion());
    // First, as an image that is fitted to a curve which lies elsewhere takes long.
    if (!CurveBeside(curve, piece, feet).is_one_run(reach, reach)) return false;
    const ChartImage image = image_of(curve, piece, feet, std::nullopt, reach);
    if (image.deviation > reach) return false;
    on_taking = image.chart;
  } catch (const LimitFailure&) {
    throw;
  } catch (const Failure&) {
    return false;  // it lies elsewhere
  }
  const bool forward = body_.use(edge, true).face == giving;
  Interval chart_range;
  const Handle(Geom2d_Curve) on_giving =
      chart_curve_of(body_.edge(edge), body_.face(giving), chart_range);
  const TopoDS_Edge border =
      edge_on(curve, piece, at_start ? corner : cut, at_start ? cut : corner);
  add_chart(border, on_giving, body_.face(giving));
  add_chart(border, chart_near_face(on_taking, at(piece, 0.5), body_, taking), body_.face(taking));
  added_[giving].push_back(
      TopoDS::Edge(border.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED)));
  added_[taking].push_back(
      TopoDS::Edge(border.Oriented(forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
  border_.vertices.push_back(corner);
  return true;
}

// One strip ends among faces that have no other.
void BlendSheet::cap(const Ring& ring) {
  const DirectedEdge half = ring.front().half;
  StripEnd& end = end_of(half);
  int face = 0, last = 0, entered = 0, left_at = 0;
  const Cut left = turns_back(ring, true) ? grown_cut(ring, true, face, entered)
                                          : end_cut(half, left_side(half), face, entered);
  const Cut right = turns_back(ring, false) ? grown_cut(ring, false, last, left_at)
                                            : end_cut(half, right_side(half), last, left_at);
  end.t[left_side(half)] = left.t;
  end.t[right_side(half)] = right.t;
  end.vertices[left_side(half)] = left.vertex;
  end.vertices[right_side(half)] = right.vertex;
  const Interval part = part_near(half, end.t);
  TopoDS_Vertex from = left.vertex;
  if (face != last && !turns_back(ring, true) && !turns_back(ring, false)) {
    // Of a face over which the ball leans on an edge nothing is left here, nor of its border.
    const std::array<int, 2>& bend = strip_of(half).strip.bend;
    const int on_left = bend[left_side(half)] > 0 ? ring[1].half.edge : entered;
    const int on_right = bend[right_side(half)] > 0 ? ring.back().half.edge : left_at;
    for (const bool is_left : {true, false})
      if (bend[is_left ? left_side(half) : right_side(half)] > 0)
        border_.filleted.push_back(is_left ? on_left : on_right);
    if (takes_over(ring, face, last, on_right, right.vertex))
      last = face;
    else if (takes_over(ring, last, face, on_left, left.vertex))
      face = last;
  }
  const double w_left = strip_of(half).strip.contacts[left_side(half)].w;
  StripPlace place{{0, left.t, w_left, point_of(from)}, entered, true};
  // Over a seam the strip comes to the same face again.
  const auto goes_on = [&] {
    if (face != last) return true;
    if (!has_seam(body_, face)) return false;
    const auto next = next_way_out(half, part, face, place);
    return next && next->is_seam && next->share < 1 - kSameW;
  };
  for (int count = 0; goes_on(); ++count) {
    if (count == kMaxFacesInARow) refuse(half, FilletFault::End, "too many faces are at its end");
    face = cross_face(ring, part, face, place, from);
  }
  cap_face(half, part, face, from, right.vertex);
  turn_path(half);
}

}  // namespace blossom::occt
