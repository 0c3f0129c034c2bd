// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solid_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/edge_union.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/ray_casting.h"

namespace blossom::occt {
namespace {

// In tolerances of the faces' edges: how long a piece of an intersection may be left out.
constexpr double kMostRest = 10;
constexpr int kChords = 16;
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

// One solid on its way through the work; one entry for each face.
struct Side {
  const char* name = "";
  const TrimTool* solid = nullptr;
  std::vector<std::vector<FaceCut>> cuts;
  std::vector<std::vector<CutSource>> sources;
  std::vector<std::vector<int>> curves;  // number of the intersection curve of each cut
  std::vector<std::unique_ptr<FaceSplitter>> splitters;
  std::vector<FaceSplit> splits;

  Side(const char* word, const TrimTool& of) : name(word), solid(&of) {
    const std::size_t count = of.faces.size();
    cuts.resize(count);
    sources.resize(count);
    curves.resize(count);
    splitters.resize(count);
    splits.resize(count);
  }
  std::string face_name(std::size_t face) const {
    return "face " + std::to_string(face + 1) + " of the " + name;
  }
};

// Where an intersection curve lies among the cuts of both sides.
struct CurveUse {
  std::size_t face_a = 0, cut_a = 0;
  std::size_t face_b = 0, cut_b = 0;
};

bool is_obstacle(PlaceKind kind) { return kind != PlaceKind::Node; }

void add_curves(const FaceIntersection& pair, Side& a, Side& b, std::vector<CurveUse>& uses,
                SolidPieces& result) {
  const auto face_a = static_cast<std::size_t>(pair.face_a);
  const auto face_b = static_cast<std::size_t>(pair.face_b);
  const std::string both = a.face_name(face_a) + " and " + b.face_name(face_b);
  for (const Place& place : pair.found.places)
    if (is_obstacle(place.kind))
      result.obstacles.push_back(both + ": " + to_string(place.kind) +
                                 ", contacts without crossing are not supported");
  for (std::size_t i = 0; i < pair.found.curves.size(); ++i) {
    const IntersectionCurve& curve = pair.found.curves[i];
    if (curve.tangential) {
      result.obstacles.push_back(both + " touch along a curve, which is not supported");
      continue;
    }
    const int number = static_cast<int>(uses.size());
    uses.push_back({face_a, a.cuts[face_a].size(), face_b, b.cuts[face_b].size()});
    const double tolerance = pair.edges[i].tolerance, sine = std::sin(curve.least_angle);
    a.cuts[face_a].push_back({curve.curve, curve.chart_a, tolerance, sine, curve.conic});
    b.cuts[face_b].push_back({curve.curve, curve.chart_b, tolerance, sine, curve.conic});
    a.sources[face_a].push_back({0, b.solid->faces[face_b], curve.chart_b, false});
    b.sources[face_b].push_back({0, a.solid->faces[face_a], curve.chart_a, false});
    a.curves[face_a].push_back(number);
    b.curves[face_b].push_back(number);
  }
}

void begin(Side& side, std::size_t face, EdgeSplits& splits, double tolerance) {
  side.splitters[face] =
      std::make_unique<FaceSplitter>(side.solid->faces[face], side.cuts[face], splits, tolerance);
}

bool has_split_edge(const TopoDS_Face& face, const EdgeSplits& splits) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (splits.is_split(TopoDS::Edge(it.Current()))) return true;
  return false;
}

void tell_borders(const FaceSplitter& from, int cut, FaceSplitter& to, int as) {
  for (const CutStop& stop : from.stops(cut))
    if (!stop.vertex.IsNull()) to.meet(as, stop);
}

// Every curve is divided at the same places on both sides.
void exchange_stops(Side& a, Side& b, const std::vector<CurveUse>& uses) {
  for (const CurveUse& use : uses) {
    FaceSplitter &on_a = *a.splitters[use.face_a], &on_b = *b.splitters[use.face_b];
    const int cut_a = static_cast<int>(use.cut_a), cut_b = static_cast<int>(use.cut_b);
    tell_borders(on_a, cut_a, on_b, cut_b);
    tell_borders(on_b, cut_b, on_a, cut_a);
  }
  for (Side* side : {&a, &b})
    for (const auto& splitter : side->splitters)
      if (splitter) splitter->tidy();
  for (const CurveUse& use : uses) {
    FaceSplitter &on_a = *a.splitters[use.face_a], &on_b = *b.splitters[use.face_b];
    const int cut_a = static_cast<int>(use.cut_a), cut_b = static_cast<int>(use.cut_b);
    const std::vector<CutStop> of_a = on_a.stops(cut_a), of_b = on_b.stops(cut_b);
    for (const CutStop& stop : of_b) on_a.divide(cut_a, stop);
    for (const CutStop& stop : of_a) on_b.divide(cut_b, stop);
  }
}

void split(Side& side, EdgeSplits& splits, double tolerance) {
  for (std::size_t i = 0; i < side.splits.size(); ++i) {
    const TopoDS_Face& face = side.solid->faces[i];
    if (!side.splitters[i] && has_split_edge(face, splits)) begin(side, i, splits, tolerance);
    if (side.splitters[i])
      side.splits[i] = side.splitters[i]->split();
    else
      side.splits[i] = {{{face, {}, {}}}, {}};
  }
}

void split_both(Side& a, Side& b, const std::vector<CurveUse>& uses, double tolerance) {
  EdgeSplits splits(tolerance);
  for (Side* side : {&a, &b})
    for (std::size_t i = 0; i < side->cuts.size(); ++i)
      if (!side->cuts[i].empty()) begin(*side, i, splits, tolerance);
  for (Side* side : {&a, &b})
    for (const auto& splitter : side->splitters)
      if (splitter) splitter->settle();
  exchange_stops(a, b, uses);
  for (Side* side : {&a, &b}) split(*side, splits, tolerance);
}

// The edges along an intersection curve on one side, and their places on it.
struct CurveEdge {
  Interval at;  // increasing
  TopoDS_Edge edge;
};

std::vector<std::vector<CurveEdge>> curve_edges(const Side& side, std::size_t count,
                                                SolidPieces& result) {
  std::vector<std::vector<CurveEdge>> edges(count);
  for (std::size_t i = 0; i < side.splits.size(); ++i)
    for (const FacePiece& piece : side.splits[i].pieces)
      for (const CutUse& use : piece.cuts) {
        auto& of =
            edges[static_cast<std::size_t>(side.curves[i][static_cast<std::size_t>(use.cut)])];
        const auto is_same = [&](const CurveEdge& known) { return known.edge.IsSame(use.edge); };
        if (use.along)
          result.obstacles.push_back(side.face_name(i) +
                                     ": is cut along one of its edges, which is not supported");
        else if (std::none_of(of.begin(), of.end(), is_same))
          of.push_back(
              {{std::min(use.at.from, use.at.to), std::max(use.at.from, use.at.to)}, use.edge});
      }
  for (auto& of : edges)
    std::sort(of.begin(), of.end(),
              [](const CurveEdge& x, const CurveEdge& y) { return x.at.from < y.at.from; });
  return edges;
}

// Whether each edge of one side has its counterpart on the other.
bool match(const std::vector<CurveEdge>& a, const std::vector<CurveEdge>& b) {
  if (a.size() != b.size()) return false;
  const auto holds_middle = [](const Interval& of, const Interval& other) {
    const double middle = at(other, 0.5);
    return of.from < middle && middle < of.to;
  };
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!holds_middle(a[i].at, b[i].at) || !holds_middle(b[i].at, a[i].at)) return false;
  return true;
}

// The length of a curve between two parameters, by chords.
double length_of(const Spline& curve, const Interval& range) {
  double length = 0;
  for (int i = 0; i < kChords; ++i)
    length += distance(point_at(curve, at(range, static_cast<double>(i) / kChords)),
                       point_at(curve, at(range, (i + 1.0) / kChords)));
  return length;
}

// The longest piece of a curve that became no edge. Ends that stick out over the border of a face
// by its edges' tolerances are left out; more would be an intersection that is lost.
double longest_rest(const Spline& curve, const std::vector<CurveEdge>& edges) {
  double longest = 0, from = curve.knots.front();
  for (const CurveEdge& edge : edges) {
    longest = std::max(longest, length_of(curve, {from, std::max(from, edge.at.from)}));
    from = std::max(from, edge.at.to);
  }
  return std::max(longest, length_of(curve, {from, curve.knots.back()}));
}

double largest_tolerance(const TopoDS_Face& face) {
  double largest = BRep_Tool::Tolerance(face);
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  return largest;
}

void add_notes(const Side& side, std::size_t face, SolidPieces& result) {
  for (const std::string& note : side.splits[face].notes)
    result.obstacles.push_back(side.face_name(face) + ": " + note);
}

void join_edges(const Side& a, const Side& b, const std::vector<CurveUse>& uses, EdgeUnion& joined,
                SolidPieces& result) {
  const auto on_a = curve_edges(a, uses.size(), result);
  const auto on_b = curve_edges(b, uses.size(), result);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const CurveUse& use = uses[i];
    const Spline& curve = a.cuts[use.face_a][use.cut_a].curve;
    const double allowed = kMostRest * std::max(largest_tolerance(a.solid->faces[use.face_a]),
                                                largest_tolerance(b.solid->faces[use.face_b]));
    if (!match(on_a[i], on_b[i]) || longest_rest(curve, on_a[i]) > allowed) {
      result.obstacles.push_back(a.face_name(use.face_a) + " and " + b.face_name(use.face_b) +
                                 " are not divided alike along their intersection");
      add_notes(a, use.face_a, result);
      add_notes(b, use.face_b, result);
      continue;
    }
    for (std::size_t k = 0; k < on_a[i].size(); ++k) joined.join(on_a[i][k].edge, on_b[i][k].edge);
  }
}

std::vector<SolidPiece> sided_pieces(const Side& side, const TrimTool& other) {
  std::vector<SidedPiece> pieces;
  std::vector<SolidPiece> result;
  for (std::size_t i = 0; i < side.splits.size(); ++i)
    for (const FacePiece& piece : side.splits[i].pieces) {
      pieces.push_back({&piece, &side.cuts[i], &side.sources[i]});
      result.push_back({piece.face, static_cast<int>(i), ToolSide::Unknown});
    }
  const std::vector<ToolSide> sides = sides_of(pieces, other, 0);
  for (std::size_t i = 0; i < result.size(); ++i) result[i].side = sides[i];
  return result;
}

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
    if (piece.side == ToolSide::Unknown) piece.side = *inside ? ToolSide::Below : ToolSide::Above;
    if (*inside != (piece.side == ToolSide::Below)) return "its side is not certain";
    if (++agreeing == kAgreeing) return {};
  }
  return "rays cannot tell its side";
}

void check_sides(std::vector<SolidPiece>& pieces, const Side& side, const TrimTool& other,
                 double tolerance, SolidPieces& result) {
  const ShapeRays rays(other.faces, tolerance);
  ShapeRayQuery query(rays);
  for (SolidPiece& piece : pieces)
    if (const std::string cause = objection(piece, query); !cause.empty())
      result.obstacles.push_back(
          "a piece of " + side.face_name(static_cast<std::size_t>(piece.from)) + ": " + cause);
}

void rebuild(std::vector<SolidPiece>& pieces, EdgeUnion& joined) {
  for (SolidPiece& piece : pieces) piece.face = joined.rebuilt(piece.face);
}

}  // namespace

SolidPieces solid_pieces(const TrimTool& a, const TrimTool& b, const IntersectionOptions& options) {
  SolidPieces result;
  Side side_a("part", a), side_b("tool", b);
  std::vector<CurveUse> uses;
  const ShapeIntersection found = intersect(a.faces, b.faces, options);
  result.status = found.status;
  result.certificate = found.certificate;
  for (const FaceIntersection& pair : found.pairs) add_curves(pair, side_a, side_b, uses, result);
  if (result.status == Status::Stopped)
    result.obstacles.emplace_back("the intersection is not complete");
  if (!result.obstacles.empty()) return result;
  const double tolerance = options.tolerances.point;
  guarded("splitting the solids", [&] { split_both(side_a, side_b, uses, tolerance); });
  EdgeUnion joined;
  join_edges(side_a, side_b, uses, joined, result);
  if (!result.obstacles.empty()) return result;
  result.a = sided_pieces(side_a, b);
  result.b = sided_pieces(side_b, a);
  check_sides(result.a, side_a, b, tolerance, result);
  check_sides(result.b, side_b, a, tolerance, result);
  rebuild(result.a, joined);
  rebuild(result.b, joined);
  if (joined.collapsed() > 0)
    result.obstacles.push_back(std::to_string(joined.collapsed()) +
                               " edges are shorter than the tolerance of their ends");
  return result;
}

}  // namespace blossom::occt
