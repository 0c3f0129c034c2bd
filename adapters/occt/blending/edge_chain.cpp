// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/edge_chain.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"

namespace blossom::occt {
namespace {

const char* cause_of(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::Smooth: return "its faces go on smoothly across it, nothing is to be rounded";
    case EdgeKind::Mixed: return "it is convex, concave or smooth in turns";
    case EdgeKind::Seam: return "it is the seam of one face";
    case EdgeKind::Open: return "it bounds one face only: edges of closed solids are rounded";
    case EdgeKind::Degenerate: return "it is a point";
    default: return "more than two faces use it, or two in one direction";
  }
}

// Radians: edges that bend by less at a vertex are one to the eye.
constexpr double kSlightBend = 0.1;

int count_of_uses(const BodyEdges& body, int edge) {
  int count = 0;
  for (int face = 1; face <= body.face_count(); ++face)
    count += static_cast<int>(std::ranges::count(body.uses(face), edge, &EdgeUseInFace::edge));
  return count;
}

EdgeKind kind_of(const BodyEdges& body, int edge) {
  if (BRep_Tool::Degenerated(body.edge(edge))) return EdgeKind::Degenerate;
  try {
    if (body.use(edge, true).face == body.use(edge, false).face) return EdgeKind::Seam;
    double angle = 0;
    return edge_kind(body, edge, angle);
  } catch (const BadModel&) {
    return count_of_uses(body, edge) < 2 ? EdgeKind::Open : EdgeKind::Crowded;
  }
}

Vec3 middle_of(const BodyEdges& body, int edge) {
  const BRepAdaptor_Curve curve(body.edge(edge));
  const gp_Pnt p = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
  return {p.X(), p.Y(), p.Z()};
}

bool is_concave(const BodyEdges& body, int edge) {
  const EdgeKind kind = kind_of(body, edge);
  if (kind == EdgeKind::Convex || kind == EdgeKind::Concave) return kind == EdgeKind::Concave;
  std::optional<Vec3> point;
  if (kind != EdgeKind::Degenerate) point = middle_of(body, edge);
  const bool nothing =
      kind == EdgeKind::Smooth || kind == EdgeKind::Seam || kind == EdgeKind::Degenerate;
  throw FilletRefused({nothing ? FilletFault::Nothing : FilletFault::Edge,
                       edge,
                       cause_of(kind),
                       std::nullopt,
                       point,
                       {}});
}

// As the body has it; no edge can end where it has none.
std::vector<VertexSector> ring_at(const BodyEdges& body, const DirectedEdge& half) {
  try {
    return body.round(half);
  } catch (const BadModel& error) {
    throw FilletRefused({FilletFault::Edge,
                         half.edge,
                         std::string("the faces at its end do not close there, ") + error.what() +
                             ": edges of closed solids are rounded",
                         std::nullopt,
                         point_of(body.vertex(half)),
                         {}});
  }
}

// The one sharp edge in which another one goes on at an end; 0 if there is none, or several.
//
// bend   of their directions at most, radians
int next_of(const BodyEdges& body, const DirectedEdge& half, bool concave, double bend) {
  const Vec3 back = -direction_at(body, half);
  int found = 0;
  const std::vector<VertexSector> ring = ring_at(body, half);
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const DirectedEdge& other = ring[i].half;
    if (other.edge == half.edge) continue;
    const Vec3 ahead = direction_at(body, other);
    if (std::atan2(norm(cross(back, ahead)), dot(back, ahead)) > bend) continue;
    const EdgeKind kind = kind_of(body, other.edge);
    if (kind != (concave ? EdgeKind::Concave : EdgeKind::Convex)) continue;
    if (found > 0) return 0;
    found = other.edge;
  }
  return found;
}

// A chain with all edges in which it goes on.
FilletEdges grown_chain(const BodyEdges& body, FilletEdges chain, double bend) {
  std::vector<int> open;
  for (const auto& [edge, concave] : chain) open.push_back(edge);
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    const bool concave = chain.at(at);
    for (const bool at_start : {true, false}) {
      const int next = next_of(body, {at, at_start}, concave, bend);
      if (next > 0 && chain.emplace(next, concave).second) open.push_back(next);
    }
  }
  return chain;
}

}  // namespace

FilletEdges smooth_chain(const BodyEdges& body, int edge) {
  return grown_chain(body, {{edge, is_concave(body, edge)}}, kSmoothJoint);
}

FilletEdges bent_chain(const BodyEdges& body, const FilletEdges& chain) {
  return grown_chain(body, chain, kSlightBend);
}

namespace {

// Whether edges between two halves of a ring are creases of the faces beside them.
bool is_creased(const BodyEdges& body, const std::vector<VertexSector>& ring, std::size_t from,
                std::size_t to) {
  for (std::size_t i = from + 1; i < to; ++i) {
    const EdgeKind kind = kind_of(body, ring[i].half.edge);
    if (kind == EdgeKind::Convex || kind == EdgeKind::Concave) return true;
  }
  return false;
}

// The half of a filleted edge in which another one goes on at its end, if any. Where the faces on
// both sides are creased there, two strips meet instead.
std::optional<DirectedEdge> next_half(const BodyEdges& body, const DirectedEdge& half,
                                      const FilletEdges& edges) {
  std::vector<DirectedEdge> others;
  const std::vector<VertexSector> ring = body.round(half);
  std::size_t place = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (edges.count(ring[i].half.edge) == 0) continue;
    others.push_back(ring[i].half);
    place = i;
  }
  if (others.size() != 1 || edges.at(others.front().edge) != edges.at(half.edge))
    return std::nullopt;
  const Vec3 a = direction_at(body, half), b = -direction_at(body, others.front());
  if (std::atan2(norm(cross(a, b)), dot(a, b)) >= kSmoothJoint) return std::nullopt;
  if (is_creased(body, ring, 0, place) && is_creased(body, ring, place, ring.size()))
    return std::nullopt;
  return others.front();
}

}  // namespace

std::vector<EdgeRun> edge_runs(const BodyEdges& body, const FilletEdges& edges) {
  std::vector<EdgeRun> runs;
  FilletEdges open = edges;
  while (!open.empty()) {
    EdgeRun run{{{open.begin()->first, true}}, false, open.begin()->second};
    open.erase(open.begin());
    while (const auto next = next_half(body, run.last(), edges)) {
      run.closed = *next == run.first();
      if (run.closed) break;
      run.edges.push_back({next->edge, next->at_start});
      open.erase(next->edge);
    }
    while (!run.closed) {
      const auto before = next_half(body, run.first(), edges);
      if (!before) break;
      run.edges.insert(run.edges.begin(), RunEdge{before->edge, !before->at_start});
      open.erase(before->edge);
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace blossom::occt
