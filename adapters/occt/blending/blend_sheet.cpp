// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/blend_sheet.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"

namespace blossom::occt {
namespace {

// Of a strip's width: how far beyond its ends it is looked at.
constexpr double kPartRoom = 2;
// In tolerances: what meets at one place may be so far apart.
constexpr double kSamePlace = 10;

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

Vec3 contact_point(const RolledStrip& strip, std::size_t side, double t) {
  return vec(strip.contacts[side].curve->Value(t).XYZ());
}

}  // namespace

BlendSheet::BlendSheet(const BodyEdges& body, double tolerance)
    : body_(body), tolerance_(tolerance), splits_(tolerance) {}

void BlendSheet::add(RolledStrip strip) {
  strip_at_[strip.edge] = strips_.size();
  border_.filleted.push_back(strip.edge);
  strips_.push_back({std::move(strip), {}});
}

PlacedStrip& BlendSheet::strip_of(const HalfEdge& half) { return strips_[strip_at_.at(half.edge)]; }

StripEnd& BlendSheet::end_of(const HalfEdge& half) {
  return strip_of(half).ends[half.at_start ? 0 : 1];
}

double BlendSheet::end_t(const HalfEdge& half) {
  const Interval& range = strip_of(half).strip.edge_range;
  return half.at_start ? range.from : range.to;
}

void BlendSheet::refuse(const HalfEdge& half, FilletFault fault, const std::string& cause) const {
  double first = 0, last = 0;
  BRep_Tool::Range(body_.edge(half.edge), first, last);
  throw FilletRefused(
      {fault, half.edge, cause, half.at_start ? first : last, point_of(body_.vertex(half)), {}});
}

// The edge that ends a sector, as the sector's face uses it on its way to the vertex.
const EdgeUseInFace& BlendSheet::arriving(const Ring& ring, std::size_t sector) const {
  const HalfEdge& half = ring[(sector + 1) % ring.size()].half;
  return body_.use(half.edge, !half.at_start);
}

void BlendSheet::build() {
  for (const PlacedStrip& of : strips_)
    for (const bool at_start : {true, false}) {
      const HalfEdge half{of.strip.edge, at_start};
      if (std::find(done_.begin(), done_.end(), half) == done_.end()) end_at(half);
    }
  for (PlacedStrip& of : strips_) finish(of);
}

void BlendSheet::end_at(const HalfEdge& half) {
  Ring ring = body_.round(half);
  std::vector<std::size_t> filleted;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (is_filleted(ring[i].half.edge)) filleted.push_back(i);
  for (const std::size_t i : filleted) done_.push_back(ring[i].half);
  if (filleted.size() == 1) {
    const SheetBorder border = border_;
    const std::map<int, std::vector<TopoDS_Edge>> added = added_;
    try {
      return cap(ring);
    } catch (const FilletRefused&) {
      border_ = border;
      added_ = added;
      end_of(half).path.clear();
      if (!blunt(ring)) throw;
    }
    return;
  }
  if (filleted.size() == 2) {
    const HalfEdge& other = ring[filleted[1]].half;
    const Vec3 a = direction_at(body_, half), b = -direction_at(body_, other);
    if (std::atan2(norm(cross(a, b)), dot(a, b)) < kSmoothJoint) return joint(ring, filleted[1]);
    if (ring.size() != 3)
      refuse(half, FilletFault::Corner,
             "it meets edge " + std::to_string(other.edge) + " at a vertex of " +
                 std::to_string(ring.size()) +
                 " edges, where two fillets and the faces beside them cannot be joined yet");
    if (filleted[1] == 2) std::rotate(ring.begin(), ring.begin() + 2, ring.end());
    return mitre(ring);
  }
  if (filleted.size() != ring.size())
    refuse(half, FilletFault::Corner,
           "of " + std::to_string(ring.size()) + " edges at its end " +
               std::to_string(filleted.size()) +
               " have fillets: all but one or all of them can be joined");
  corner(ring);
}

TopoDS_Vertex BlendSheet::cut_edge(const HalfEdge& cut, double parameter,
                                   const TopoDS_Face& asking) {
  const TopoDS_Edge edge = body_.edge(cut.edge);
  const int split = splits_.add(edge, parameter, asking);
  border_.cuts.push_back({cut.edge, split, cut.at_start});
  return splits_.vertex(edge, split);
}

// Either the face ends before the contact could meet the edge, or it turns away from it.
void BlendSheet::refuse_miss(const HalfEdge& half, std::size_t side, const EdgeUseInFace& use,
                             const HalfEdge& cut) const {
  double first = 0, last = 0;
  BRep_Tool::Range(body_.edge(half.edge), first, last);
  const BodyEdges::Corner corner =
      body_.corner(body_.use(half.edge, side == 0), half.at_start ? first : last);
  const std::string miss = "the ball's contact on face " + std::to_string(use.face) +
                           " does not meet edge " + std::to_string(use.edge);
  if (dot(direction_at(body_, cut), corner.inwards) <= 0)
    refuse(half, FilletFault::End,
           miss + ", which turns away from it: how the strip ends there cannot be built yet");
  refuse(half, FilletFault::LeavesFace,
         miss + ", which bounds it at this end: the radius is too large");
}

BlendSheet::Cut BlendSheet::cut_by_contact(const HalfEdge& half, std::size_t side,
                                           const EdgeUseInFace& use, const HalfEdge& cut) {
  const RolledStrip& strip = strip_of(half).strip;
  const auto meeting = meeting_with(body_, strip, side, use, end_t(half));
  if (!meeting) refuse_miss(half, side, use, cut);
  return {meeting->t, cut_edge(cut, meeting->edge_parameter, body_.face(use.face))};
}

Interval BlendSheet::part_near(const HalfEdge& half, const std::array<double, 2>& t) {
  const RolledStrip& strip = strip_of(half).strip;
  gp_Pnt point;
  gp_Vec rate;
  strip.contacts[0].curve->D1(t[0], point, rate);
  const double width = distance(contact_point(strip, 0, t[0]), contact_point(strip, 1, t[1]));
  const double room = kPartRoom * std::max(width, strip.radius) / rate.Magnitude();
  return {std::max(strip.range.from, std::min(t[0], t[1]) - room),
          std::min(strip.range.to, std::max(t[0], t[1]) + room)};
}

// Across one of the faces at the end of a strip, from its left to its right.
void BlendSheet::cap_face(const HalfEdge& half, const Interval& part, int face,
                          const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
  const RolledStrip& strip = strip_of(half).strip;
  const double reach =
      kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(from), BRep_Tool::Tolerance(to)});
  const auto curve =
      curve_between(strip, part, body_.face(face), point_of(from), point_of(to), reach);
  if (!curve)
    refuse(
        half, FilletFault::End,
        "the strip does not cross face " + std::to_string(face) + " at its end from side to side");
  const TopoDS_Edge edge =
      edge_on(curve->curve, curve->range, curve->forward ? from : to, curve->forward ? to : from);
  add_chart(edge, curve->on_strip, strip.bare_face());
  add_chart(edge, curve->on_face, body_.face(face));
  // Seen from the vertex the face lies beyond the strip's end: it walks from right to left.
  added_[face].push_back(
      TopoDS::Edge(edge.Oriented(curve->forward ? TopAbs_REVERSED : TopAbs_FORWARD)));
  end_of(half).path.push_back({edge, curve->forward});
}

// One strip ends among faces that have no other.
void BlendSheet::cap(const Ring& ring) {
  const HalfEdge half = ring.front().half;
  if (ring.size() < 3)
    refuse(half, FilletFault::End,
           ring.size() == 1 ? std::string("no face is at its end")
                            : "it ends where only edge " + std::to_string(ring[1].half.edge) +
                                  " goes on, between the same faces");
  StripEnd& end = end_of(half);
  const VertexSector& last = ring.back();
  const Cut left = cut_by_contact(half, left_side(half), arriving(ring, 0), ring[1].half);
  const Cut right = cut_by_contact(
      half, right_side(half), body_.uses(last.face)[static_cast<std::size_t>(last.use)], last.half);
  end.t[left_side(half)] = left.t;
  end.t[right_side(half)] = right.t;
  end.vertices[left_side(half)] = left.vertex;
  end.vertices[right_side(half)] = right.vertex;
  const Interval part = part_near(half, end.t);
  TopoDS_Vertex from = left.vertex;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    TopoDS_Vertex to = right.vertex;
    if (i + 2 < ring.size()) {
      const HalfEdge& beside = ring[i + 1].half;
      const auto through = edge_through(strip_of(half).strip, part, body_, beside);
      if (!through)
        refuse(half, FilletFault::End,
               "edge " + std::to_string(beside.edge) + " at its end does not go through the strip");
      to = cut_edge(beside, *through, body_.face(ring[i].face));
    }
    cap_face(half, part, ring[i].face, from, to);
    from = to;
  }
  if (left_side(half) == 1) {
    std::reverse(end.path.begin(), end.path.end());
    for (PathEdge& each : end.path) each.forward = !each.forward;
  }
}

// The arc of the ball at the end of a strip.
TopoDS_Edge BlendSheet::section(const PlacedStrip& of, const StripEnd& end) {
  const RolledStrip& strip = of.strip;
  const double t = 0.5 * (end.t[0] + end.t[1]);
  const bool forward = strip.contacts[0].w < strip.contacts[1].w;
  const Handle(Geom_Curve) arc = strip.along_u ? strip.surface->UIso(t) : strip.surface->VIso(t);
  const Interval range{strip.contacts[forward ? 0 : 1].w, strip.contacts[forward ? 1 : 0].w};
  return edge_on(arc, range, end.vertices[forward ? 0 : 1], end.vertices[forward ? 1 : 0]);
}

TopoDS_Vertex BlendSheet::new_vertex(const Vec3& point) {
  for (const TopoDS_Vertex& known : made_)
    if (distance(point_of(known), point) <= tolerance_) return known;
  made_.push_back(vertex_at(point));
  return made_.back();
}

BlendSheet::Gap BlendSheet::gap_beside(const HalfEdge& half, std::size_t side, const Ring& ring,
                                       std::size_t first, std::size_t last) {
  if (first == last) return {};
  if (last - first > 1)
    refuse(half, FilletFault::Corner, "more than one edge is beside the fillet where it goes on");
  const VertexSector& before = ring[last - 1];
  Gap gap{&ring[first].half, side == left_side(half)
                                 ? &arriving(ring, first - 1)
                                 : &body_.uses(before.face)[static_cast<std::size_t>(before.use)]};
  gap.meeting = meeting_with(body_, strip_of(half).strip, side, *gap.use, end_t(half));
  if (!gap.meeting)
    refuse(half, FilletFault::Corner,
           "its contact on face " + std::to_string(gap.use->face) + " does not go over edge " +
               std::to_string(gap.use->edge) + ", where it goes on");
  return gap;
}

// Where a strip ends that another one goes on from: at the edge that a contact goes over there.
double BlendSheet::joint_t(const HalfEdge& half, const Gap& left, const Gap& right) {
  const RolledStrip& strip = strip_of(half).strip;
  if (!left.meeting && !right.meeting) return end_t(half);
  const double t = left.meeting ? left.meeting->t : right.meeting->t;
  if (!left.meeting || !right.meeting) return t;
  const std::size_t side = right_side(half);
  const double off =
      distance(contact_point(strip, side, t), contact_point(strip, side, right.meeting->t));
  if (off > kSamePlace * std::max(tolerance_, right.use->coedge->tolerance))
    refuse(half, FilletFault::Corner,
           "its contacts go over edges " + std::to_string(left.use->edge) + " and " +
               std::to_string(right.use->edge) +
               " at different places: such a joint cannot be built yet");
  return t;
}

// On the edge that the contacts of two strips go over; a new one where the face is the same.
TopoDS_Vertex BlendSheet::joint_vertex(const HalfEdge& half, std::size_t side, double t,
                                       const Gap& gap) {
  const Vec3 point = contact_point(strip_of(half).strip, side, t);
  if (gap.beside == nullptr) return new_vertex(point);
  const TopoDS_Vertex vertex =
      cut_edge(*gap.beside, gap.meeting->edge_parameter, body_.face(gap.use->face));
  cover(vertex, point, Precision::Confusion());
  return vertex;
}

// Two strips go on in one another, or a closed one in itself.
void BlendSheet::joint(const Ring& ring, std::size_t other) {
  const HalfEdge half = ring.front().half, next = ring[other].half;
  const RolledStrip& after = strip_of(next).strip;
  StripEnd &end = end_of(half), &next_end = end_of(next);
  const std::size_t left = left_side(half), right = right_side(half);
  const Gap left_gap = gap_beside(half, left, ring, 1, other);
  const Gap right_gap = gap_beside(half, right, ring, other + 1, ring.size());
  const bool closed = half.edge == next.edge;
  const double t = closed ? end_t(half) : joint_t(half, left_gap, right_gap);
  end.t = {t, t};
  end.vertices[left] = joint_vertex(half, left, t, left_gap);
  end.vertices[right] = joint_vertex(half, right, t, right_gap);
  const Vec3 centre = vec(strip_of(half).strip.spine->Value(t).XYZ());
  const double t_after = closed ? end_t(next) : nearest_on(after.spine, after.range, centre);
  next_end.t = {t_after, t_after};
  next_end.vertices[right_side(next)] = end.vertices[left];
  next_end.vertices[left_side(next)] = end.vertices[right];
  const double claimed = BRep_Tool::Tolerance(body_.vertex(half));
  for (const std::size_t side : {left_side(next), right_side(next)}) {
    const TopoDS_Vertex& vertex = next_end.vertices[side];
    const double reach = kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(vertex), claimed});
    const double gap = distance(contact_point(after, side, t_after), point_of(vertex));
    if (gap > reach) {
      std::ostringstream cause;
      cause << "the next strip, of edge " << next.edge << ", begins " << gap << " away from it";
      refuse(half, FilletFault::Corner, cause.str());
    }
  }
  join_section(half, next);
}

// The arc in which two strips go on in one another.
void BlendSheet::join_section(const HalfEdge& half, const HalfEdge& next) {
  const RolledStrip &strip = strip_of(half).strip, &after = strip_of(next).strip;
  StripEnd &end = end_of(half), &next_end = end_of(next);
  const TopoDS_Edge arc = section(strip_of(half), end);
  const bool forward = strip.contacts[0].w < strip.contacts[1].w;
  end.path = {{arc, forward}};
  // Seen from the vertex the two walk across it in opposite directions.
  next_end.path = {{arc, (left_side(half) == right_side(next)) == forward}};
  if (&strip == &after) {
    // The strip lies to the left of the forward arc at one of its ends.
    const Handle(Geom2d_Curve) first = strip.section_line(strip.edge_range.from);
    const Handle(Geom2d_Curve) last = strip.section_line(strip.edge_range.to);
    const bool forward_at_start = forward == strip.outward;
    add_seam_charts(arc, forward_at_start ? first : last, forward_at_start ? last : first,
                    strip.bare_face());
    return;
  }
  add_chart(arc, strip.section_line(end.t[0]), strip.bare_face());
  const SurfaceProjector feet(after.bare_face(), Precision::Confusion());
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(arc, range.from, range.to);
  const Vec2 near = after.chart(next_end.t[0], 0.5 * (after.contacts[0].w + after.contacts[1].w));
  const double apart =
      std::max({tolerance_, BRep_Tool::Tolerance(end.vertices[0]),
                BRep_Tool::Tolerance(end.vertices[1]), BRep_Tool::Tolerance(body_.vertex(half))});
  add_chart(arc, image_of(curve, range, feet, near, kSamePlace * apart).chart, after.bare_face());
}

// The contact edges and the face of a strip whose ends are known.
void BlendSheet::finish(PlacedStrip& of) {
  const RolledStrip& strip = of.strip;
  const TopoDS_Face face = strip.bare_face();
  std::array<TopoDS_Edge, 2> contacts;
  for (const std::size_t side : {0U, 1U}) {
    const Interval range{of.ends[0].t[side], of.ends[1].t[side]};
    const double speed = strip.contacts[side].curve->DN(at(range, 0.5), 1).Magnitude();
    const bool is_point = std::abs(length(range)) * speed <= tolerance_ &&
                          of.ends[0].vertices[side].IsSame(of.ends[1].vertices[side]);
    if (is_point) continue;
    if (length(range) * speed < tolerance_)
      refuse({strip.edge, true}, FilletFault::EdgeConsumed,
             "what is at its two ends meets: no strip is left between them");
    check_contact(of, side);
    contacts[side] = edge_on(strip.contacts[side].curve, range, of.ends[0].vertices[side],
                             of.ends[1].vertices[side]);
    add_chart(contacts[side], strip.contact_line(strip.contacts[side].w), face);
    add_chart(contacts[side], strip.contacts[side].chart, body_.face(strip.contacts[side].face));
    added_[strip.contacts[side].face].push_back(
        TopoDS::Edge(contacts[side].Oriented(side == 0 ? TopAbs_FORWARD : TopAbs_REVERSED)));
  }
  BlendPatch patch{face, {}, strip.edge};
  patch.face.Orientation(strip.outward ? TopAbs_FORWARD : TopAbs_REVERSED);
  const auto use = [&](const TopoDS_Edge& edge, bool forward) {
    patch.edges.push_back(TopoDS::Edge(edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED)));
  };
  if (!contacts[0].IsNull()) use(contacts[0], false);
  for (const PathEdge& each : of.ends[0].path) use(each.edge, each.forward);
  if (!contacts[1].IsNull()) use(contacts[1], true);
  for (const PathEdge& each : of.ends[1].path) use(each.edge, !each.forward);
  patches_.push_back(std::move(patch));
}

void BlendSheet::check_contact(const PlacedStrip& of, std::size_t side) const {
  const RolledContact& contact = of.strip.contacts[side];
  const Interval between{of.ends[0].t[side], of.ends[1].t[side]};
  for (const EdgeUseInFace& use : body_.uses(contact.face)) {
    ContactMeeting where;
    if (use.coedge->degenerated || is_filleted(use.edge) ||
        !goes_over(body_, of.strip, side, use, between, where))
      continue;
    throw FilletRefused({FilletFault::LeavesFace,
                         of.strip.edge,
                         "the ball's contact on face " + std::to_string(contact.face) +
                             " goes over edge " + std::to_string(use.edge) +
                             ": the radius is too large there",
                         std::nullopt,
                         vec(contact.curve->Value(where.t).XYZ()),
                         {}});
  }
}

}  // namespace blossom::occt
