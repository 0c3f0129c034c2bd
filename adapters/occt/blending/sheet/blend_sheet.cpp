// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/blend_sheet.h"

#include <algorithm>
#include <cmath>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"

namespace blossom::occt {
namespace {

// Of a strip's width: how far beyond its ends it is looked at.
constexpr double kPartRoom = 2;

Vec3 contact_point(const RolledStrip& strip, std::size_t side, double t) {
  return vec(strip.contacts[side].curve->Value(t).XYZ());
}

// An edge without length, with a chart curve alone.
// off   how far it nevertheless gets from the vertex
TopoDS_Edge point_edge(const TopoDS_Vertex& vertex, const Handle(Geom2d_Curve) & chart,
                       const Interval& range, const TopoDS_Face& face, double off) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge);
  builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
  builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
  builder.UpdateEdge(edge, chart, face, std::max(off, Precision::Confusion()));
  builder.Range(edge, range.from, range.to);
  builder.Degenerated(edge, Standard_True);
  return edge;
}

}  // namespace

BlendSheet::BlendSheet(const BodyEdges& body, double tolerance, bool is_chamfer,
                       const std::optional<double>& setback)
    : body_(body),
      tolerance_(tolerance),
      is_chamfer_(is_chamfer),
      setback_(setback),
      splits_(tolerance) {}

void BlendSheet::add(const BallWalk& walk) {
  const std::size_t first = strips_.size(), count = walk.strips.size();
  for (const WalkedStrip& each : walk.strips) {
    strips_.push_back({each.strip, each.inside, {}, {}});
    // The contact takes the place of what the ball leans on.
    for (const int edge : each.strip.bend)
      if (edge > 0) border_.filleted.push_back(edge);
  }
  for (const RunEdge& each : walk.run.edges) {
    filleted_.insert(each.edge);
    border_.filleted.push_back(each.edge);
  }
  for (const PassedEdge& each : walk.passed) {
    filleted_.insert(each.edge);
    border_.filleted.push_back(each.edge);
    passed_.emplace(each.edge, each.why);
  }
  const auto low_if = [](bool low) { return low ? std::size_t{0} : std::size_t{1}; };
  for (std::size_t i = 0; i < walk.joints.size(); ++i) {
    const std::size_t next = (i + 1) % count;
    joints_.push_back({{first + i, low_if(!walk.strips[i].forward)},
                       {first + next, low_if(walk.strips[next].forward)},
                       walk.joints[i]});
  }
  if (walk.joints.size() == count) return;  // closed
  const DirectedEdge start = walk.run.first(), end = walk.run.last();
  // A strip of another edge, or on other faces, has no sections of its own through the run's ends.
  const auto end_by_vertex = [&](std::size_t at, const DirectedEdge& half,
                                 std::size_t low_or_high) {
    if (walk.strips[at].of_edge && walk.strips[at].strip.edge == half.edge) return;
    RolledStrip& strip = strips_[first + at].strip;
    const double t = nearest_on(strip.spine, strip.range, point_of(body_.vertex(half)));
    (low_or_high == 0 ? strip.edge_range.from : strip.edge_range.to) = t;
  };
  end_by_vertex(0, start, low_if(walk.strips.front().forward));
  end_by_vertex(count - 1, end, low_if(!walk.strips.back().forward));
  ends_at_[{start.edge, start.at_start}] = {first, low_if(walk.strips.front().forward)};
  ends_at_[{end.edge, end.at_start}] = {first + count - 1, low_if(!walk.strips.back().forward)};
  open_.push_back(start);
  open_.push_back(end);
}

PlacedStrip& BlendSheet::strip_of(const DirectedEdge& half) {
  return strips_[ends_at_.at({half.edge, half.at_start}).strip];
}

const PlacedStrip& BlendSheet::strip_of(const DirectedEdge& half) const {
  return strips_[ends_at_.at({half.edge, half.at_start}).strip];
}

StripEnd& BlendSheet::end_of(const DirectedEdge& half) {
  const EndPlace& place = ends_at_.at({half.edge, half.at_start});
  return strips_[place.strip].ends[place.end];
}

bool BlendSheet::is_low_end(const DirectedEdge& half) const {
  return ends_at_.at({half.edge, half.at_start}).end == 0;
}

double BlendSheet::end_t(const DirectedEdge& half) {
  const Interval& range = strip_of(half).strip.edge_range;
  return is_low_end(half) ? range.from : range.to;
}

void BlendSheet::refuse(const DirectedEdge& half, FilletFault fault,
                        const std::string& cause) const {
  double first = 0, last = 0;
  BRep_Tool::Range(body_.edge(half.edge), first, last);
  const double end = half.at_start ? first : last;
  const Vec3 a = body_.corner(body_.use(half.edge, true), end).normal;
  const Vec3 b = body_.corner(body_.use(half.edge, false), end).normal;
  const bool is_pointed =
      fault == FilletFault::End && std::atan2(norm(cross(a, b)), dot(a, b)) < kSmoothEdge;
  const std::string more =
      is_pointed
          ? "; the faces beside it meet nearly smoothly there, and the strip, which narrows, "
            "does not come to a point in the vertex"
          : "";
  throw FilletRefused({fault, half.edge, cause + more, end, point_of(body_.vertex(half)), {}});
}

// The edge that ends a sector, as the sector's face uses it on its way to the vertex.
const EdgeUseInFace& BlendSheet::arriving(const Ring& ring, std::size_t sector) const {
  const DirectedEdge& half = ring[(sector + 1) % ring.size()].half;
  return body_.use(half.edge, !half.at_start);
}

void BlendSheet::build() {
  for (const DirectedEdge& half : open_)
    if (std::find(done_.begin(), done_.end(), half) == done_.end()) end_at(half);
  for (const Joint& each : joints_) join(each);
  for (PlacedStrip& of : strips_)
    if (!of.left_out) finish(of);
}

// Another way to end strips where the first one cannot be gone.
void BlendSheet::or_else(const std::vector<DirectedEdge>& halves,
                         const std::function<void()>& ended,
                         const std::function<bool(const std::string& why)>& other) {
  const SheetBorder border = border_;
  const std::map<int, std::vector<TopoDS_Edge>> added = added_;
  const std::size_t patches = patches_.size();
  const EdgeSplits splits = splits_;
  try {
    ended();
  } catch (const FilletRefused& refusal) {
    border_ = border;
    added_ = added;
    splits_ = splits;
    patches_.resize(patches);
    for (const DirectedEdge& each : halves) {
      end_of(each).path.clear();
      end_of(each).over = {};
    }
    if (!other(refusal.why().cause)) throw;
  }
}

// Strips that cannot be ended as they should be end in planes across them, if they can do that.
void BlendSheet::blunt_unless(const std::vector<DirectedEdge>& halves,
                              const std::function<void()>& ended) {
  or_else(halves, ended, [&](const std::string& why) {
    return std::ranges::all_of(
        halves, [&](const DirectedEdge& each) { return blunt(body_.round(each), why); });
  });
}

// Whether strips can be set back from a corner: then they are.
bool BlendSheet::is_set_back(const Ring& ring) {
  try {
    set_back(ring);
    return true;
  } catch (const FilletRefused&) {
    return false;
  } catch (const BadModel&) {
    return false;  // a side of the hole that no polynomial is near enough to
  }
}

void BlendSheet::end_at(const DirectedEdge& half) {
  std::vector<int> passed;
  Ring ring = ring_at(half, passed);
  std::vector<std::size_t> filleted;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (is_filleted(ring[i].half.edge)) filleted.push_back(i);
  std::vector<DirectedEdge> ended;
  for (const std::size_t i : filleted) ended.push_back(ring[i].half);
  done_.insert(done_.end(), ended.begin(), ended.end());
  if (!passed.empty()) return pass(ring, passed);
  if (end_in_point(ended)) return;
  if (filleted.size() == 1) return blunt_unless({half}, [&] { cap(ring); });
  if (filleted.size() == 2) {
    // So that a face which both have in common is to the left of the first.
    const bool turn = filleted[1] + 1 == ring.size() && ring.size() > 2;
    if (turn) std::rotate(ring.begin(), ring.end() - 1, ring.end());
    const std::size_t other = turn ? 1 : filleted[1];
    const std::vector<DirectedEdge> halves{ring[0].half, ring[other].half};
    return blunt_unless(halves, [&] {
      if (!is_chamfer_ && !can_be_mitred(ring, other)) return set_back(ring);
      or_else(
          halves, [&] { mitre(ring, other); },
          [&](const std::string&) { return !is_chamfer_ && is_set_back(ring); });
    });
  }
  corner(ring);
}

TopoDS_Vertex BlendSheet::cut_edge(const DirectedEdge& cut, double parameter,
                                   const TopoDS_Face& asking) {
  const TopoDS_Edge edge = body_.edge(cut.edge);
  const int split = splits_.add(edge, parameter, asking);
  border_.cuts.push_back({cut.edge, split, cut.at_start});
  return splits_.vertex(edge, split);
}

TopoDS_Vertex BlendSheet::cut_edge(const ContactCrossing& crossing, const TopoDS_Face& asking) {
  const TopoDS_Edge edge = body_.edge(crossing.use->edge);
  const int split = splits_.add(edge, crossing.edge_parameter, asking);
  border_.cuts.push_back({crossing.use->edge, split, crossing.keep_after});
  return splits_.vertex(edge, split);
}

// Either the face ends before the contact could meet the edge, or it turns away from it.
void BlendSheet::refuse_miss(const DirectedEdge& half, std::size_t side, const EdgeUseInFace& use,
                             const DirectedEdge& cut) const {
  double first = 0, last = 0;
  BRep_Tool::Range(body_.edge(half.edge), first, last);
  const BodyEdges::Corner corner =
      body_.corner(body_.use(half.edge, side == 0), half.at_start ? first : last);
  const std::string miss = contact_words() + " on face " + std::to_string(use.face) +
                           " does not meet edge " + std::to_string(use.edge);
  if (dot(direction_at(body_, cut), corner.inwards) <= 0)
    refuse(half, FilletFault::End,
           miss + ", which turns away from it: how the strip ends there cannot be built yet");
  refuse(half, FilletFault::LeavesFace, miss + ", which bounds it at this end: " + too_large());
}

Interval BlendSheet::part_near(const DirectedEdge& half, const std::array<double, 2>& t) {
  const RolledStrip& strip = strip_of(half).strip;
  gp_Pnt point;
  gp_Vec rate;
  strip.contacts[0].curve->D1(t[0], point, rate);
  const double width = distance(contact_point(strip, 0, t[0]), contact_point(strip, 1, t[1]));
  const double room = kPartRoom * std::max(width, strip.radius) / rate.Magnitude();
  return {std::max(strip.range.from, std::min(t[0], t[1]) - room),
          std::min(strip.range.to, std::max(t[0], t[1]) + room)};
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

// The places between the ends of a strip where its contact goes over the seam of a face. Other
// edges are too near.
void BlendSheet::cut_seams(PlacedStrip& of, std::size_t side) {
  const Interval between{of.ends[0].t[side], of.ends[1].t[side]};
  const std::vector<ContactCrossing> all = contact_crossings(body_, of.strip, side, filleted_);
  const std::vector<Notch> round = notches(body_, of.strip, side, all);
  const auto is_of_notch = [&](const ContactCrossing& each) {
    return std::ranges::any_of(round, [&](const Notch& notch) {
      return notch.has(each.t) && notch.leaves.t > between.from && notch.enters.t < between.to;
    });
  };
  const RolledContact& contact = of.strip.contacts[side];
  for (const ContactCrossing& each : all) {
    const double speed = contact.curve->DN(each.t, 1).Magnitude();
    const double room = kSamePlace * std::max(tolerance_, each.use->coedge->tolerance) / speed;
    if (each.t <= between.from + room || each.t >= between.to - room) continue;
    if (each.use->edge == of.ends[0].over[side] || each.use->edge == of.ends[1].over[side])
      continue;
    if (is_of_notch(each)) continue;
    if (!is_seam_at(body_, each))
      throw FilletRefused({FilletFault::LeavesFace,
                           of.strip.edge,
                           contact_words() + " on face " + std::to_string(contact.face) +
                               " goes over edge " + std::to_string(each.use->edge) + ": " +
                               too_large() + " there",
                           std::nullopt,
                           vec(contact.curve->Value(each.t).XYZ()),
                           {}});
    std::vector<Cut>& seams = of.seams[side];
    if (!seams.empty() && each.t - seams.back().t <= room) continue;  // its other use
    seams.push_back({each.t, cut_edge(each, body_.face(contact.face))});
  }
  cut_notches(of, side, round);
}

// The edges of one border of a strip.
void BlendSheet::add_contact(PlacedStrip& of, std::size_t side, BlendPatch& patch) {
  const RolledContact& contact = of.strip.contacts[side];
  std::vector<Cut> cuts = of.seams[side];
  cuts.insert(cuts.begin(), {of.ends[0].t[side], of.ends[0].vertices[side]});
  cuts.push_back({of.ends[1].t[side], of.ends[1].vertices[side]});
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    for (const PathEdge& each : cuts[i].round)
      patch.edges.push_back(TopoDS::Edge(
          each.edge.Oriented(each.forward == (side == 0) ? TopAbs_REVERSED : TopAbs_FORWARD)));
    if (!cuts[i].round.empty()) continue;
    const Interval range{cuts[i].t, cuts[i + 1].t};
    const TopoDS_Edge edge = edge_on(contact.curve, range, cuts[i].vertex, cuts[i + 1].vertex);
    add_chart(edge, of.strip.contact_line(contact.w), patch.face);
    add_chart(edge, chart_near_face(contact.chart, at(range, 0.5), body_, contact.face),
              body_.face(contact.face));
    added_[contact.face].push_back(
        TopoDS::Edge(edge.Oriented(side == 0 ? TopAbs_FORWARD : TopAbs_REVERSED)));
    patch.edges.push_back(
        TopoDS::Edge(edge.Oriented(side == 0 ? TopAbs_REVERSED : TopAbs_FORWARD)));
  }
}

// What closes the wire of a strip in its chart where a contact is a point.
TopoDS_Edge BlendSheet::apex_edge(const PlacedStrip& of, std::size_t side,
                                  const TopoDS_Face& face) const {
  const TopoDS_Edge edge =
      point_edge(of.ends[0].vertices[side], of.strip.contact_line(of.strip.contacts[side].w),
                 {of.ends[0].t[side], of.ends[1].t[side]}, face, 0);
  return TopoDS::Edge(edge.Oriented(side == 0 ? TopAbs_REVERSED : TopAbs_FORWARD));
}

// Strips that narrow to a point in their vertex end there, and nothing beside them changes. False,
// and nothing is done, if one of them does not.
bool BlendSheet::end_in_point(const std::vector<DirectedEdge>& halves) {
  std::vector<NarrowEnd> points;
  for (const DirectedEdge& half : halves) {
    const auto point = narrow_end(body_, strip_of(half).strip, half, tolerance_);
    if (!point) return false;
    points.push_back(*point);
  }
  for (std::size_t i = 0; i < halves.size(); ++i) end_in_point(halves[i], points[i]);
  return true;
}

// Where a strip narrows to a point: the vertex of the edge; or, where the faces are so far apart
// that it ends short of that, a new one on the edge, from which the smooth rest stays as it was.
TopoDS_Vertex BlendSheet::narrow_vertex(const DirectedEdge& half, const NarrowEnd& point) {
  const TopoDS_Vertex vertex = body_.vertex(half);
  if (point.off <= std::max(kSamePlace * tolerance_, BRep_Tool::Tolerance(vertex))) return vertex;
  const TopoDS_Edge edge = body_.edge(half.edge);
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  const RolledStrip& strip = strip_of(half).strip;
  const Vec3 contact = contact_point(strip, 0, point.t);
  const double at = nearest_on(curve, range, contact);
  const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(edge));
  if (distance(vec(curve->Value(at).XYZ()), contact) > reach) return vertex;
  const int split = splits_.add(edge, at, body_.face(strip.contacts[0].face));
  if (split == EdgeSplits::kFirst || split == EdgeSplits::kLast) return vertex;
  border_.cuts.push_back({half.edge, split, !half.at_start});
  return splits_.vertex(edge, split);
}

void BlendSheet::end_in_point(const DirectedEdge& half, const NarrowEnd& point) {
  const RolledStrip& strip = strip_of(half).strip;
  const TopoDS_Vertex vertex = narrow_vertex(half, point);
  const Ring ring = body_.round(half);
  StripEnd& end = end_of(half);
  end.t = {point.t, point.t};
  end.vertices = {vertex, vertex};
  end.over[left_side(half)] = ring[1].half.edge;
  end.over[right_side(half)] = ring.back().half.edge;
  for (const std::size_t side : {0U, 1U})
    cover(vertex, contact_point(strip, side, point.t), Precision::Confusion());
  border_.vertices.push_back(vertex);
  const bool forward = strip.contacts[0].w < strip.contacts[1].w;
  const Interval across{strip.contacts[forward ? 0 : 1].w, strip.contacts[forward ? 1 : 0].w};
  end.path = {
      {point_edge(vertex, strip.section_line(point.t), across, strip.bare_face(), point.off),
       forward}};
}

// The contact edges and the face of a strip whose ends are known.
void BlendSheet::finish(PlacedStrip& of) {
  const RolledStrip& strip = of.strip;
  BlendPatch patch{strip.bare_face(), {}, strip.edge};
  patch.face.Orientation(strip.outward ? TopAbs_FORWARD : TopAbs_REVERSED);
  for (const std::size_t side : {0U, 1U}) {
    const Interval range{of.ends[0].t[side], of.ends[1].t[side]};
    const double speed = strip.contacts[side].curve->DN(at(range, 0.5), 1).Magnitude();
    const bool is_point = std::abs(length(range)) * speed <= tolerance_ &&
                          of.ends[0].vertices[side].IsSame(of.ends[1].vertices[side]);
    if (is_point && std::abs(length(range)) > 0 && speed == 0)
      patch.edges.push_back(apex_edge(of, side, patch.face));
    if (is_point) continue;
    if (length(range) * speed < tolerance_) {
      const double whole = length(strip.edge_range);
      throw FilletRefused({FilletFault::EdgeConsumed,
                           strip.edge,
                           "what is at the two ends of its strip meets: nothing is left between",
                           std::nullopt,
                           contact_point(strip, side, range.from),
                           {},
                           false,
                           std::min(1.0, whole / (whole - length(range)))});
    }
    cut_seams(of, side);
    add_contact(of, side, patch);
  }
  const auto use = [&](const TopoDS_Edge& edge, bool forward) {
    patch.edges.push_back(TopoDS::Edge(edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED)));
  };
  for (const PathEdge& each : of.ends[0].path) use(each.edge, each.forward);
  for (const PathEdge& each : of.ends[1].path) use(each.edge, !each.forward);
  patches_.push_back(std::move(patch));
}

}  // namespace blossom::occt
