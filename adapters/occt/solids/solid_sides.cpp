// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/solid_sides.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/piece_edges.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/faces/face_groups.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/queries/solid_rays.h"
#include "adapters/occt/solids/limits.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/limits.h"

namespace blossom::occt {
namespace {

constexpr const char* kFindingSides = "finding sides";

std::string piece_name(const SplitSolid& of, const SolidPiece& piece) {
  return "a piece of " +
         face_name(*of.solid, static_cast<std::size_t>(piece.from), std::string("the ") + of.name);
}

// --- pieces that coincide

// The numbers of the edges that bound a piece, in increasing order. Seams are none of them: where
// a closed surface begins is a matter of taste.
using Border = std::vector<int>;

Border border_of(const TopoDS_Face& face, TopTools_IndexedMapOfShape& edges) {
  std::map<int, int> uses;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (bounds_piece(it.Current())) ++uses[edges.Add(it.Current())];
  Border border;
  for (const auto& [edge, count] : uses)
    if (count == 1) border.push_back(edge);
  return border;
}

Vec3 oriented_normal(const TopoDS_Face& face, const SurfaceJet& at) {
  const Vec3 normal = cross(at.du, at.dv);
  return face.Orientation() == TopAbs_REVERSED ? -1.0 * normal : normal;
}

struct Lying {
  SolidSide side = SolidSide::Unknown;
  double gap = 0;  // model units
};

// How the second piece lies under a point of the first one; nothing if it does not.
std::optional<Lying> lying_on(const SolidPiece& piece, const gp_Pnt& point, const SolidPiece& other,
                              double tolerance) {
  const SurfaceProjector own(piece.face, tolerance), feet(other.face, tolerance);
  const Vec3 p = vec(point);
  const SurfaceJet at = frame_at(own.surface(), own.foot(p, {}));
  const SurfaceJet under = frame_at(feet.surface(), feet.foot(p, {}));
  const double gap = distance(p, under.point);
  if (gap > kLiesReach * tolerance) return std::nullopt;
  const double cosine = dot(oriented_normal(piece.face, at), oriented_normal(other.face, under));
  return Lying{cosine > 0 ? SolidSide::Same : SolidSide::Opposite, gap};
}

constexpr double kWithin = 2;    // tolerances of points: what is no farther apart is one surface
constexpr double kApart = 1e-3;  // likewise: what is nearer is one but for rounding
constexpr double kTilt = 2;      // of the gap in one point: what it may be elsewhere

// What vanishes between two pieces that count as one.
std::string thin_text(const SplitSolid& a, const SolidPiece& piece, const SplitSolid& b,
                      const SolidPiece& other, double gap) {
  std::ostringstream text;
  text << piece_name(a, piece) << " and " << piece_name(b, other) << " are " << gap
       << " apart and count as one";
  return text.str();
}

// Where the intersection says nothing of an overlap, only what lies within the tolerance coincides:
// a thin cap has the border of the disc below it, too.
void match_pieces(SplitSolid& a, SplitSolid& b, const std::vector<std::vector<std::size_t>>& over_a,
                  double tolerance, const WorkLimit* limit, SidesTold& told) {
  TopTools_IndexedMapOfShape edges;
  std::multimap<Border, std::size_t> of_b;
  for (std::size_t i = 0; i < b.pieces.size(); ++i)
    of_b.emplace(border_of(b.pieces[i].face, edges), i);
  for (SolidPiece& piece : a.pieces) {
    const auto [first, last] = of_b.equal_range(border_of(piece.face, edges));
    if (first == last) continue;
    check_limit(limit, kFindingSides);
    const std::optional<gp_Pnt> point = point_inside(piece.face);
    for (auto it = first; point && it != last; ++it) {
      SolidPiece& other = b.pieces[it->second];
      const auto& over = over_a[static_cast<std::size_t>(piece.from)];
      const bool overlaps =
          std::ranges::find(over, static_cast<std::size_t>(other.from)) != over.end();
      // A circle bounds both parts of a sphere.
      if (!lies_on(piece.face, other.face, (overlaps ? kLiesReach : kWithin) * tolerance)) continue;
      const std::optional<Lying> lying = lying_on(piece, *point, other, tolerance);
      if (!lying) continue;
      piece.side = other.side = lying->side;
      if (lying->gap <= kApart * tolerance) continue;
      told.between += kTilt * lying->gap * area(piece.face);
      if (!overlaps) told.merged.push_back(thin_text(a, piece, b, other, lying->gap));
    }
  }
}

bool is_on(SolidSide side) { return side == SolidSide::Same || side == SolidSide::Opposite; }

// Pieces of faces that coincide somewhere have to coincide as a whole or not at all.
void check_unmatched(const SplitSolid& of, const std::vector<std::vector<std::size_t>>& over,
                     const SplitSolid& other, double tolerance, const WorkLimit* limit,
                     std::vector<std::string>& obstacles) {
  for (const SolidPiece& piece : of.pieces) {
    if (is_on(piece.side)) continue;
    check_limit(limit, kFindingSides);
    const auto& faces = over[static_cast<std::size_t>(piece.from)];
    for (const std::size_t face : faces)
      if (lies_on(piece.face, other.solid->faces[face], kLiesReach * tolerance))
        obstacles.push_back(piece_name(of, piece) + " coincides with " +
                            face_name(*other.solid, face, std::string("the ") + other.name) +
                            " only in part");
  }
}

// --- all others

// The pieces that hang together over edges that the other solid does not cross.
std::vector<FaceGroup> regions_of(const SplitSolid& of, const SplitSolid& other) {
  TopTools_IndexedMapOfShape shared;
  for (const SolidPiece& piece : other.pieces) TopExp::MapShapes(piece.face, TopAbs_EDGE, shared);
  std::vector<TopoDS_Shape> faces;
  for (const SolidPiece& piece : of.pieces) faces.push_back(piece.face);
  return groups_over_edges(faces, [&](const TopoDS_Shape& edge) {
    return !bounds_piece(edge) || shared.Contains(edge) || of.crossed.Contains(edge);
  });
}

// The side that all known ones of a region agree on; nothing if they do not.
std::optional<SolidSide> known_side(const SplitSolid& of, const FaceGroup& region) {
  SolidSide known = SolidSide::Unknown;
  for (const std::size_t i : region) {
    const SolidSide side = of.pieces[i].side;
    if (side == SolidSide::Unknown) continue;
    if (known != SolidSide::Unknown && side != known) return std::nullopt;
    known = side;
  }
  return known;
}

// Pieces at both ends and in the middle of the region first.
FaceGroup spread(FaceGroup region) {
  if (region.size() > 2) {
    std::swap(region[1], region.back());
    std::swap(region[2], region[region.size() / 2]);
  }
  return region;
}

// A point inside of a piece, which direction is the next one for a ray from there, and which told.
struct SamplePoint {
  std::optional<gp_Pnt> point;
  std::size_t next = 0;
  std::array<bool, kRayDirections.size()> told{};
};

// Rays about a region, and what they agree on with what was known before.
struct Agreement {
  SolidSide side = SolidSide::Unknown;
  int rays = 0;
  bool broken = false;

  bool is_open() const { return !broken && rays < kAgreeing; }
};

// Adds up to `most` rays that are certain.
void look(SamplePoint& from, int most, RayMeans means, SolidRays& rays, Agreement& all) {
  if (!from.point) return;
  for (int found = 0; all.is_open() && found < most && from.next < kRayDirections.size();) {
    const std::size_t ray = from.next++;
    if (from.told[ray]) continue;
    const auto inside = rays.is_inside(vec(*from.point), kRayDirections[ray], means);
    if (!inside) continue;
    from.told[ray] = true;
    const SolidSide side = *inside ? SolidSide::Inside : SolidSide::Outside;
    if (all.side == SolidSide::Unknown) all.side = side;
    all.broken = side != all.side;
    ++all.rays;
    ++found;
  }
}

// Sets the side that is known of a region and that rays agree with, from up to three of its pieces
// where those can tell, else from any. Returns why none can be trusted; empty if one can.
std::string settle(SplitSolid& of, const FaceGroup& region, SolidRays& rays) {
  const std::string name = piece_name(of, of.pieces[region.front()]);
  const std::optional<SolidSide> known = known_side(of, region);
  if (!known) return name + ": its side is not certain";
  const int pieces = static_cast<int>(std::min<std::size_t>(region.size(), kAgreeing));
  Agreement all{*known};
  std::vector<SamplePoint> lookouts;
  const FaceGroup order = spread(region);
  for (const RayMeans means : {RayMeans::ClosedForms, RayMeans::All}) {
    for (SamplePoint& from : lookouts) from.next = 0;
    for (std::size_t i = 0; i < order.size() && all.is_open(); ++i) {
      if (i == lookouts.size()) lookouts.push_back({point_inside(of.pieces[order[i]].face)});
      look(lookouts[i], (kAgreeing + pieces - 1) / pieces, means, rays, all);
    }
    for (SamplePoint& from : lookouts) look(from, kAgreeing, means, rays, all);
  }
  if (all.broken) return name + ": its side is not certain";
  if (all.rays < kAgreeing) return name + ": rays cannot tell its side";
  for (const std::size_t k : region) of.pieces[k].side = all.side;
  return {};
}

void check_sides(SplitSolid& of, const SplitSolid& other, double tolerance, const WorkLimit* limit,
                 std::vector<std::string>& obstacles) {
  SolidRays rays(other.solid->faces, tolerance);
  for (const FaceGroup& region : regions_of(of, other)) {
    if (is_on(of.pieces[region.front()].side)) continue;
    check_limit(limit, kFindingSides);
    if (const std::string cause = settle(of, region, rays); !cause.empty())
      obstacles.push_back(cause);
  }
}

}  // namespace

SidesTold find_sides(SplitSolid& a, SplitSolid& b,
                     const std::vector<std::pair<std::size_t, std::size_t>>& overlaps,
                     double tolerance, const WorkLimit* limit) {
  SidesTold told;
  std::vector<std::vector<std::size_t>> over_a(a.solid->faces.size()),
      over_b(b.solid->faces.size());
  for (const auto& [face_a, face_b] : overlaps) {
    over_a[face_a].push_back(face_b);
    over_b[face_b].push_back(face_a);
  }
  match_pieces(a, b, over_a, tolerance, limit, told);
  check_unmatched(a, over_a, b, tolerance, limit, told.obstacles);
  check_unmatched(b, over_b, a, tolerance, limit, told.obstacles);
  if (!told.obstacles.empty()) return told;
  if (b.solid->is_solid()) check_sides(a, b, tolerance, limit, told.obstacles);
  if (a.solid->is_solid()) check_sides(b, a, tolerance, limit, told.obstacles);
  return told;
}

}  // namespace blossom::occt
