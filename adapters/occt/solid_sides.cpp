// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solid_sides.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/common_edges.h"
#include "adapters/occt/edge_images.h"
#include "adapters/occt/ray_casting.h"

namespace blossom::occt {
namespace {

// Rays that have to agree about a piece, and how many may be tried for that: some hit edges.
constexpr int kAgreeing = 3;
constexpr std::array<Vec3, 9> kDirections{{{0.577, 0.211, 0.789},
                                           {-0.381, 0.907, 0.179},
                                           {0.131, -0.617, -0.776},
                                           {-0.709, -0.503, 0.494},
                                           {0.887, -0.337, 0.316},
                                           {0.271, 0.653, -0.707},
                                           {-0.953, 0.283, -0.109},
                                           {-0.163, -0.941, 0.296},
                                           {0.449, 0.097, -0.888}}};

Vec3 vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

std::string piece_name(const SplitSolid& of, const SolidPiece& piece) {
  return "a piece of face " + std::to_string(piece.from + 1) + " of the " + of.name;
}

// --- pieces that coincide

// The numbers of a piece's edges, in increasing order; seams are there twice.
using Border = std::vector<int>;

Border border_of(const TopoDS_Face& face, TopTools_IndexedMapOfShape& edges) {
  Border border;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().Orientation() != TopAbs_INTERNAL &&
        !BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
      border.push_back(edges.Add(it.Current()));
  std::sort(border.begin(), border.end());
  return border;
}

Vec3 oriented_normal(const TopoDS_Face& face, const SurfaceFrame& at) {
  const Vec3 normal = cross(at.du, at.dv);
  return face.Orientation() == TopAbs_REVERSED ? -1.0 * normal : normal;
}

// How the second piece lies under a point of the first one; nothing if it does not.
std::optional<SolidSide> side_on(const SolidPiece& piece, const gp_Pnt& point,
                                 const SolidPiece& other, double tolerance) {
  const SurfaceFeet own(piece.face, tolerance), feet(other.face, tolerance);
  const Vec3 p = vec(point);
  const SurfaceFrame at = frame_at(own.surface(), own.foot(p, {}));
  const SurfaceFrame under = frame_at(feet.surface(), feet.foot(p, {}));
  if (distance(p, under.point) > kLiesReach * tolerance) return std::nullopt;
  const double cosine = dot(oriented_normal(piece.face, at), oriented_normal(other.face, under));
  return cosine > 0 ? SolidSide::Same : SolidSide::Opposite;
}

void match_pieces(SplitSolid& a, SplitSolid& b, double tolerance) {
  TopTools_IndexedMapOfShape edges;
  std::multimap<Border, std::size_t> of_b;
  for (std::size_t i = 0; i < b.pieces.size(); ++i)
    of_b.emplace(border_of(b.pieces[i].face, edges), i);
  for (SolidPiece& piece : a.pieces) {
    const auto [first, last] = of_b.equal_range(border_of(piece.face, edges));
    if (first == last) continue;
    const std::optional<gp_Pnt> point = point_inside(piece.face);
    for (auto it = first; point && it != last; ++it) {
      SolidPiece& other = b.pieces[it->second];
      const std::optional<SolidSide> side = side_on(piece, *point, other, tolerance);
      if (side) piece.side = other.side = *side;
    }
  }
}

bool is_on(SolidSide side) { return side == SolidSide::Same || side == SolidSide::Opposite; }

// Pieces of faces that coincide somewhere have to coincide as a whole or not at all.
void check_unmatched(const SplitSolid& of, const std::vector<std::vector<std::size_t>>& over,
                     const SplitSolid& other, double tolerance,
                     std::vector<std::string>& obstacles) {
  for (const SolidPiece& piece : of.pieces) {
    if (is_on(piece.side)) continue;
    const auto& faces = over[static_cast<std::size_t>(piece.from)];
    for (const std::size_t face : faces)
      if (lies_on(piece.face, other.solid->faces[face], kLiesReach * tolerance))
        obstacles.push_back(piece_name(of, piece) + " coincides with face " +
                            std::to_string(face + 1) + " of the " + other.name + " only in part");
  }
}

// --- all others

// Whether a ray leaves the solid's faces as often as it has to from inside; nothing if it meets an
// edge or is tangent, or a hit is not proven.
std::optional<bool> is_inside(ShapeRayQuery& rays, const gp_Pnt& point, const Vec3& direction) {
  const auto hits = rays.all_hits({{point.X(), point.Y(), point.Z()}, direction});
  for (const ShapeHit& hit : hits)
    if (hit.hit.status != Status::Complete || hit.hit.grazing || !hit.on.IsNull() ||
        hit.hit.first != hit.hit.last)
      return std::nullopt;
  return hits.size() % 2 == 1;
}

// Compares the side with what rays from a point inside say, or takes it from them when the cuts
// left it open. Returns why it cannot be trusted; empty if it can.
std::string objection(SolidPiece& piece, ShapeRayQuery& rays) {
  const std::optional<gp_Pnt> point = point_inside(piece.face);
  if (!point) return "no point is found inside of it";
  int agreeing = 0;
  for (const Vec3& direction : kDirections) {
    const std::optional<bool> inside = is_inside(rays, *point, direction);
    if (!inside) continue;
    const SolidSide side = *inside ? SolidSide::Inside : SolidSide::Outside;
    if (piece.side == SolidSide::Unknown) piece.side = side;
    if (side != piece.side) return "its side is not certain";
    if (++agreeing == kAgreeing) return {};
  }
  return "rays cannot tell its side";
}

void check_sides(SplitSolid& of, const SplitSolid& other, double tolerance,
                 std::vector<std::string>& obstacles) {
  const ShapeRays rays(other.solid->faces, tolerance);
  ShapeRayQuery query(rays);
  for (SolidPiece& piece : of.pieces) {
    if (is_on(piece.side)) continue;
    if (const std::string cause = objection(piece, query); !cause.empty())
      obstacles.push_back(piece_name(of, piece) + ": " + cause);
  }
}

}  // namespace

void find_sides(SplitSolid& a, SplitSolid& b,
                const std::vector<std::pair<std::size_t, std::size_t>>& overlaps, double tolerance,
                std::vector<std::string>& obstacles) {
  std::vector<std::vector<std::size_t>> over_a(a.solid->faces.size()),
      over_b(b.solid->faces.size());
  for (const auto& [face_a, face_b] : overlaps) {
    over_a[face_a].push_back(face_b);
    over_b[face_b].push_back(face_a);
  }
  match_pieces(a, b, tolerance);
  check_unmatched(a, over_a, b, tolerance, obstacles);
  check_unmatched(b, over_b, a, tolerance, obstacles);
  if (!obstacles.empty()) return;
  check_sides(a, b, tolerance, obstacles);
  check_sides(b, a, tolerance, obstacles);
}

}  // namespace blossom::occt
