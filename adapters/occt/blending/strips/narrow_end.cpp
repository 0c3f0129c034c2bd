// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips that narrow to a point in a vertex in which the faces beside their edge meet smoothly.
#include <algorithm>
#include <array>
#include <cmath>

#include <BRep_Tool.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/strips/end_curves.h"
#include "adapters/occt/convert/curves.h"

namespace blossom::occt {
namespace {

constexpr double kTurnAt = 1e-3;  // of an edge: so far from its end the turn of its faces is taken

// How far the faces beside an edge are apart at a place of it, across them.
double gap_at(const BodyEdges& body, int edge, double parameter) {
  std::array<Vec3, 2> on;
  for (const bool forward : {true, false}) {
    const EdgeUseInFace& use = body.use(edge, forward);
    const Vec2 chart = point_at(use.coedge->curve, parameter), scale = body.trims(use.face).scale;
    const gp_Pnt point =
        BRep_Tool::Surface(body.face(use.face))->Value(chart[0] / scale[0], chart[1] / scale[1]);
    on[forward ? 0 : 1] = {point.X(), point.Y(), point.Z()};
  }
  return std::abs(dot(on[0] - on[1], body.corner(body.use(edge, true), parameter).normal));
}

}  // namespace

// With x along the edge and y across it, the faces at its end turn against each other by a x, so
// that offsets of theirs are a x y apart, to within e: the tolerance, or what the faces are apart
// there. Where that is 0 may be sqrt(2 e / a) beside the vertex, and at most at the middle of the
// edge: beyond it is its other end. At a distance d the faces turn by a d.
std::optional<NarrowEnd> narrow_end(const BodyEdges& body, const RolledStrip& strip,
                                    const DirectedEdge& half, double tolerance) {
  double first = 0, last = 0;
  BRep_Tool::Range(body.edge(half.edge), first, last);
  const double end = half.at_start ? first : last;
  const double beside = std::lerp(end, half.at_start ? last : first, kTurnAt);
  const auto turn = [&](double x) {
    const Vec3 a = body.corner(body.use(half.edge, true), x).normal;
    const Vec3 b = body.corner(body.use(half.edge, false), x).normal;
    return std::atan2(norm(cross(a, b)), dot(a, b));
  };
  if (turn(end) >= kSmoothEdge) return std::nullopt;
  const TopoDS_Vertex vertex = body.vertex(half);
  const Vec3 place = point_of(vertex);
  const double rate =
      turn(beside) / distance(body.corner(body.use(half.edge, true), beside).point, place);
  const double apart = std::max(tolerance, gap_at(body, half.edge, end));
  NarrowEnd found;
  found.t = nearest_on(strip.contacts[0].curve, strip.range, place);
  const double half_way = 0.5 * edge_length(body.edge(half.edge));
  found.room = std::max(BRep_Tool::Tolerance(vertex),
                        std::min(half_way, std::sqrt(2 * kSamePlace * apart / rate)));
  const auto contact = [&](std::size_t side) {
    return vec(strip.contacts[side].curve->Value(found.t));
  };
  found.off = std::max(distance(contact(0), place), distance(contact(1), place));
  const double most = kSamePlace * apart + strip.radius * rate * found.off;
  if (!(found.off <= found.room) || distance(contact(0), contact(1)) > most) return std::nullopt;
  return found;
}

}  // namespace blossom::occt
