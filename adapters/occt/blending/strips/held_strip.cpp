// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/held_strip.h"

#include <array>
#include <cstddef>
#include <vector>

#include <BRep_Tool.hxx>
#include <Precision.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"

namespace blossom::occt {
namespace {

// The edge across a face that has no more than four, which the two beside it join; its use in the
// face. Null unless it is sharp and of the other kind.
const EdgeUseInFace* far_edge(const BodyEdges& body, const EdgeUseInFace& own, bool concave) {
  const std::vector<EdgeUseInFace>& uses = body.uses(own.face);
  if (uses.size() != 4) return nullptr;
  const auto at = [&](int place) -> const EdgeUseInFace& {
    return uses[static_cast<std::size_t>(place)];
  };
  const EdgeUseInFace& far = at(at(own.next).next);
  if (&at(at(own.previous).previous) != &far || &far == &own || far.coedge->degenerated ||
      far.edge == own.edge)
    return nullptr;
  if (body.use(far.edge, !far.forward).face == far.face) return nullptr;
  double angle = 0;
  const EdgeKind kind = edge_kind(body, far.edge, angle);
  return kind == (concave ? EdgeKind::Convex : EdgeKind::Concave) ? &far : nullptr;
}

// A far edge at its middle, with the face between.
struct FarEdge {
  const EdgeUseInFace* use = nullptr;
  BodyEdges::Corner near, beyond;  ///< of the face between, and of the one behind the edge
};

std::optional<FarEdge> far_edge_at(const BodyEdges& body, int edge, bool forward, bool concave) {
  const EdgeUseInFace* const use = far_edge(body, body.use(edge, forward), concave);
  if (use == nullptr) return std::nullopt;
  double first = 0, last = 0;
  BRep_Tool::Range(body.edge(use->edge), first, last);
  const double middle = 0.5 * (first + last);
  return FarEdge{use, body.corner(*use, middle),
                 body.corner(body.use(use->edge, !use->forward), middle)};
}

// Where a curve of a strip comes nearest to a point.
Vec3 beside(const Handle(Geom_Curve) & curve, const RolledStrip& strip, const Vec3& point) {
  return vec(curve->Value(nearest_on(curve, strip.range, point)).XYZ());
}

// How far the contact lies on the face's side of its far edge.
double room(const RolledStrip& strip, std::size_t side, const FarEdge& far) {
  const Vec3 foot = beside(strip.contacts[side].curve, strip, far.near.point);
  return dot(foot - far.near.point, far.near.inwards);
}

// Whether the ball that leans on an edge keeps clear of the faces at it: its centre is between
// their normals.
bool leans_on(const RolledStrip& strip, const FarEdge& far) {
  const Vec3 way = beside(strip.spine, strip, far.near.point) - far.near.point;
  return dot(way, far.near.inwards) <= 0 && dot(way, far.beyond.inwards) <= 0;
}

using FarEdges = std::array<std::optional<FarEdge>, 2>;

// The strip that leans on these edges, if each holds the ball and other contacts keep to their
// faces.
std::optional<RolledStrip> leaning_strip(const BodyEdges& body, const RolledStrip& like,
                                         const std::array<int, 2>& held, const FarEdges& far) try {
  auto strip = swept_strip(body, like.edge, like.concave, like.radius, held);
  for (const std::size_t side : {0U, 1U}) {
    if (!strip || !far[side]) continue;
    if (held[side] > 0 ? !leans_on(*strip, *far[side]) : room(*strip, side, *far[side]) < 0)
      return std::nullopt;
  }
  return strip;
} catch (const FilletRefused&) {
  return std::nullopt;
}

}  // namespace

std::optional<RolledStrip> swept_or_held_strip(const BodyEdges& body, int edge, bool concave,
                                               double radius) {
  auto free = swept_strip(body, edge, concave, radius);
  if (!free) return free;
  FarEdges far;
  std::array<int, 2> beyond{};
  for (const std::size_t side : {0U, 1U}) {
    far[side] = far_edge_at(body, edge, side == 0, concave);
    if (far[side] && room(*free, side, *far[side]) < -Precision::Confusion())
      beyond[side] = far[side]->use->edge;
  }
  const std::array<std::array<int, 2>, 3> choices{{{beyond[0], 0}, {0, beyond[1]}, beyond}};
  for (const std::array<int, 2>& held : choices)
    if (held != std::array<int, 2>{})
      if (auto strip = leaning_strip(body, *free, held, far)) return strip;
  return free;
}

std::string held_text(const RolledStrip& strip) {
  std::string text;
  const auto add = [&](int edge, const std::string& why) {
    text += (text.empty() ? "edge " + std::to_string(strip.edge) + ": the ball leans on edge "
                          : " and on edge ") +
            std::to_string(edge) + why;
  };
  for (const std::size_t side : {0U, 1U}) {
    if (strip.held[side] > 0)
      add(strip.held[side],
          ", as face " + std::to_string(strip.contacts[side].face) + " is too narrow for it");
    if (strip.bend[side] > 0) add(strip.bend[side], ", as the face before it is too narrow");
  }
  return text;
}

}  // namespace blossom::occt
