// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips that run over holes and notches: their borders go round them, along the walls.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/blending/strips/notches.h"
#include "adapters/occt/faces/surface_projector.h"

namespace blossom::occt {
namespace {

constexpr int kRimSamples = 8;  // of a rim, whose feet on the spine bound what is looked at
// Of that: how far beyond it the strip is looked at. A rim that is a whole circle goes at most
// 1 - cos(pi / 8) of its radius past 8 samples, 0.04 of its length; the rest is for feet that are
// not exact.
constexpr double kNotchRoom = 0.1;
constexpr double kSameShare = 1e-9;  // of the way across a strip
constexpr int kInsideSamples = 6;    // of a curve on a wall, to see whether it stays there

Vec3 outward_normal(const RolledStrip& strip, double t, double w) {
  const SurfaceJet frame = frame_at(strip.surface, strip.chart(t, w));
  return (strip.outward ? 1.0 : -1.0) * cross(frame.du, frame.dv);
}

// The part of a strip beside the rims that its contact goes over.
Interval part_beside(const BodyEdges& body, const RolledStrip& strip, const Notch& notch) {
  Interval part{notch.leaves.t, notch.enters.t};
  for (const EdgeUseInFace* use : {notch.leaves.use, notch.enters.use}) {
    Interval range;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(use->edge), range.from, range.to);
    for (int i = 0; i <= kRimSamples; ++i) {
      const Vec3 point = vec(curve->Value(at(range, i / double{kRimSamples})).XYZ());
      const double t = nearest_on(strip.spine, strip.range, point);
      part = {std::min(part.from, t), std::max(part.to, t)};
    }
  }
  const double room = kNotchRoom * length(part);
  return {std::max(strip.range.from, part.from - room), std::min(strip.range.to, part.to + room)};
}

// Whether a place across a strip is between its contacts, to rounding.
bool is_between(const RolledStrip& strip, double w) {
  const double share = (w - strip.contacts[0].w) / (strip.contacts[1].w - strip.contacts[0].w);
  return share > -kSameShare && share < 1 + kSameShare;
}

// Whether a curve keeps to the trims of a wall, or, if that grows, out of them, and to a strip
// between its contacts.
bool stays_where(const RolledStrip& strip, const FaceTrims& trims, const EndCurve& curve,
                 bool grows) {
  for (int i = 1; i < kInsideSamples; ++i) {
    const double x = at(curve.range, i / double{kInsideSamples});
    const gp_Pnt2d there = curve.on_strip->Value(x), uv = curve.on_face->Value(x);
    if (!is_between(strip, strip.along_u ? there.Y() : there.X())) return false;
    if (is_inside_by_periods(trims, {uv.X(), uv.Y()}) == grows) return false;
  }
  return true;
}

}  // namespace

// The border of the strip on a wall: to where it comes out of the notch, if that is there, or over
// another edge of the wall. A wall that rises from the face on the ball's side of it, or one that
// a strip of a concave edge covers, grows to the strip; only one wall can.
std::optional<BlendSheet::WallWay> BlendSheet::wall_way(const PlacedStrip& of, const Interval& part,
                                                        int face, int entered,
                                                        const TopoDS_Vertex& from,
                                                        const TopoDS_Vertex* enters, bool grows) {
  const double reach = kSamePlace * std::max(tolerance_, BRep_Tool::Tolerance(from));
  const auto way_to = [&](const Vec3& point, double room) {
    const Vec3 start = point_of(from);
    const double off = std::max(reach, room);
    auto curve = grows ? curve_between(of.strip, part, body_.face(face), start, point, off)
                       : curve_in_face(of.strip, part, body_.face(face), start, point, off);
    if (curve && !stays_where(of.strip, body_.trims(face), *curve, grows)) curve.reset();
    return curve;
  };
  if (enters)
    if (auto curve = way_to(point_of(*enters), kSamePlace * BRep_Tool::Tolerance(*enters)))
      return WallWay{nullptr, {}, *std::move(curve)};
  if (grows) return std::nullopt;
  for (const EdgeUseInFace& use : body_.uses(face)) {
    if (use.coedge->degenerated || use.edge == entered || is_filleted(use.edge)) continue;
    for (const EdgeThrough& each : edge_through(of.strip, part, body_, use.edge)) {
      if (!is_between(of.strip, each.w)) continue;
      if (auto curve = way_to(each.point, kSamePlace * use.coedge->tolerance))
        return WallWay{&use, each, *std::move(curve)};
    }
  }
  return std::nullopt;
}

// Where the border of a strip goes over an edge between two walls. What stays of the edge is below
// the strip at a convex edge, above it at a concave one.
TopoDS_Vertex BlendSheet::cut_wall(const PlacedStrip& of, const WallWay& way, int face) {
  const TopoDS_Edge edge = body_.edge(way.use->edge);
  const int split = splits_.add(edge, way.through.edge_parameter, body_.face(face));
  const BodyEdges::Corner corner = body_.corner(*way.use, way.through.edge_parameter);
  const double rise = dot(corner.along, outward_normal(of.strip, way.through.t, way.through.w));
  border_.cuts.push_back({way.use->edge, split, (rise > 0) == of.strip.concave});
  return splits_.vertex(edge, split);
}

// The way over the walls of a notch, from where the contact leaves its face to where it comes back.
std::vector<PathEdge> BlendSheet::notch_path(const PlacedStrip& of, std::size_t side,
                                             const Notch& notch, const TopoDS_Vertex& leaves,
                                             const TopoDS_Vertex& enters) {
  const Interval part = part_beside(body_, of.strip, notch);
  const auto behind = [&](const EdgeUseInFace& use) {
    return body_.use(use.edge, !use.forward).face;
  };
  std::vector<PathEdge> path;
  int face = behind(*notch.leaves.use), entered = notch.leaves.use->edge;
  const int last = behind(*notch.enters.use);
  double angle = 0;
  const bool is_rise = edge_kind(body_, entered, angle) == EdgeKind::Concave;
  const bool grows = is_rise != of.strip.concave;
  TopoDS_Vertex from = leaves;
  for (int count = 0; count < kMaxFacesInARow; ++count) {
    const auto way =
        wall_way(of, part, face, entered, from, face == last ? &enters : nullptr, grows);
    if (!way) break;
    const TopoDS_Vertex to = way->use ? cut_wall(of, *way, face) : enters;
    add_wall(of, side, face, *way, from, to, path);
    if (!way->use) return path;
    from = to;
    entered = way->use->edge;
    face = behind(*way->use);
  }
  throw FilletRefused({FilletFault::LeavesFace,
                       of.strip.edge,
                       contact_words() + " on face " +
                           std::to_string(of.strip.contacts[side].face) + " goes over edge " +
                           std::to_string(notch.leaves.use->edge) + " and back, and the strip " +
                           "does not cross face " + std::to_string(face) + " there from border " +
                           "to border",
                       std::nullopt,
                       point_of(leaves),
                       {}});
}

// The notches between the ends of a strip.
void BlendSheet::cut_notches(PlacedStrip& of, std::size_t side, const std::vector<Notch>& all) {
  const TopoDS_Face& face = body_.face(of.strip.contacts[side].face);
  std::vector<Cut>& cuts = of.seams[side];
  for (const Notch& notch : all) {
    if (notch.leaves.t <= of.ends[0].t[side] || notch.enters.t >= of.ends[1].t[side]) continue;
    Cut leaves{notch.leaves.t, cut_edge(notch.leaves, face)};
    const Cut enters{notch.enters.t, cut_edge(notch.enters, face)};
    leaves.round = notch_path(of, side, notch, leaves.vertex, enters.vertex);
    cuts.push_back(std::move(leaves));
    cuts.push_back(enters);
  }
  std::ranges::sort(cuts, {}, &Cut::t);
}

// Along one wall, as the contact goes. The wall takes the place of the face along the contact.
void BlendSheet::add_wall(const PlacedStrip& of, std::size_t side, int face, const WallWay& way,
                          const TopoDS_Vertex& from, const TopoDS_Vertex& to,
                          std::vector<PathEdge>& path) {
  for (const PathEdge& each : edges_along(of.strip, way.curve, face, from, to)) {
    const bool as_it_runs = each.forward == (side == 0);
    added_[face].push_back(
        TopoDS::Edge(each.edge.Oriented(as_it_runs ? TopAbs_FORWARD : TopAbs_REVERSED)));
    path.push_back(each);
  }
}

}  // namespace blossom::occt
