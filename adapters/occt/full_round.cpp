// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/full_round.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

constexpr double kRoundError = 1e-13;  // of radii, relative: some hundred roundings
constexpr double kSameRound = 1e-12;   // radii of both ends that differ by less, of them, are one
// Pairs of edges that would do: so many are told, of so many that are rounded to see it, of so many
// that are looked at, which takes some tenths of a second for each and microseconds.
constexpr std::size_t kTold = 3, kTried = 8, kLookedAt = 10000;

std::string round_edge_name(int edge) { return "edge " + std::to_string(edge); }

[[noreturn]] void refuse_round(const std::string& why) {
  throw InvalidInput(
      "a full round is made of two straight edges of one plane face, beside planes: " + why);
}

bool round_face_is_plane(const BodyEdges& body, int face) {
  return !Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(body.face(face))).IsNull();
}

void check_round_edge(const BodyEdges& body, int edge) {
  if (edge < 1 || edge > body.edge_count())
    throw InvalidInput("there is no edge " + std::to_string(edge) + ", only 1 to " +
                       std::to_string(body.edge_count()));
  try {
    if (smooth_chain(body, edge).size() > 1)
      refuse_round(round_edge_name(edge) + " goes on smoothly in others");
  } catch (const FilletRefused& refusal) {
    refuse_round(refusal.why().text());
  }
  if (BRepAdaptor_Curve(body.edge(edge)).GetType() != GeomAbs_Line)
    refuse_round(round_edge_name(edge) + " is not straight");
  for (const bool forward : {true, false})
    if (!round_face_is_plane(body, body.use(edge, forward).face))
      refuse_round("face " + std::to_string(body.use(edge, forward).face) + " beside " +
                   round_edge_name(edge) + " is no plane");
}

int round_face(const BodyEdges& body, int a, int b) {
  for (const bool of_a : {true, false})
    for (const bool of_b : {true, false})
      if (body.use(a, of_a).face == body.use(b, of_b).face) return body.use(a, of_a).face;
  refuse_round(round_edge_name(a) + " and " + round_edge_name(b) + " have no face in common");
}

/// A face at the start of an edge, and at its end.
struct RoundSide {
  std::array<BodyEdges::Corner, 2> ends;
  double tangent = 0;  // of half the turn of the normals
};

RoundSide round_side_of(const BodyEdges& body, int edge, int face) {
  const EdgeUseInFace& use = body.use_in(edge, face);
  double first = 0, last = 0;
  BRep_Tool::Range(body.edge(edge), first, last);
  RoundSide side{{body.corner(use, first), body.corner(use, last)}};
  const Vec3 own = side.ends[0].normal, other = body.corner(body.behind(use), first).normal;
  side.tangent = std::tan(0.5 * std::atan2(norm(cross(own, other)), dot(own, other)));
  return side;
}

// Of the numbers that are the same but for rounding that with the fewest digits.
double shortest_same(double radius) {
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, radius);
    const double told = std::strtod(text.data(), nullptr);
    if (std::abs(told - radius) <= kRoundError * radius) return told;
  }
  return radius;
}

EdgeRadius round_radius(const RoundSide& of, const RoundSide& other, int edge) {
  std::array<double, 2> radii{};
  for (const std::size_t end : {0U, 1U}) {
    const Vec3 &across = other.ends[0].inwards, &own = of.ends[end].inwards;
    const double apart = dot(of.ends[end].point - other.ends[0].point, across);
    radii[end] = apart / (other.tangent - of.tangent * dot(own, across));
    if (!(radii[end] > 0) || !std::isfinite(radii[end]))
      refuse_round("no ball touches all three planes along " + round_edge_name(edge));
    radii[end] = shortest_same(radii[end]);
  }
  if (std::abs(radii[0] - radii[1]) <= kSameRound * radii[0]) return {radii[0], std::nullopt};
  return {1, RadiusLaw::linear({0, 1}, radii[0], radii[1])};
}

std::map<int, EdgeRadius> round_radii(const BodyEdges& body, int edge_a, int edge_b) {
  if (edge_a == edge_b) refuse_round("one edge is named twice");
  for (const int edge : {edge_a, edge_b}) check_round_edge(body, edge);
  const int face = round_face(body, edge_a, edge_b);
  const RoundSide a = round_side_of(body, edge_a, face), b = round_side_of(body, edge_b, face);
  return {{edge_a, round_radius(a, b, edge_a)}, {edge_b, round_radius(b, a, edge_b)}};
}

using EdgePair = std::pair<int, int>;

std::optional<std::map<int, EdgeRadius>> radii_if_any(const BodyEdges& body, const EdgePair& pair) {
  try {
    return round_radii(body, pair.first, pair.second);
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

// Whether a full round can be made.
bool rounds_fully(const TopoDS_Shape& shape, std::map<int, EdgeRadius> radii) try {
  FilletOptions options;
  options.own = std::move(radii);
  options.volumes = options.largest = false;
  std::vector<int> edges;
  for (const auto& [edge, of] : options.own) edges.push_back(edge);
  return fillet(shape, edges, options).refused.empty();
} catch (const InvalidInput&) {
  return false;
} catch (const BadModel&) {
  return false;
}

// Pairs of edges that have one of these, or of all edges where it is 0, in plane faces.
std::set<EdgePair> round_pairs(const BodyEdges& body, const std::array<int, 2>& named) {
  std::set<EdgePair> pairs;
  for (int face = 1; face <= body.face_count(); ++face) {
    if (!round_face_is_plane(body, face)) continue;
    for (const EdgeUseInFace& a : body.uses(face))
      for (const EdgeUseInFace& b : body.uses(face)) {
        if (pairs.size() == kLookedAt) return pairs;
        const bool wanted = named[0] == 0 || std::ranges::count(named, a.edge) > 0 ||
                            std::ranges::count(named, b.edge) > 0;
        if (wanted && a.edge < b.edge) pairs.emplace(a.edge, b.edge);
      }
  }
  return pairs;
}

// "; edges 1 and 3 would do": with one of the edges that were named, else any.
std::string pairs_that_do(const TopoDS_Shape& shape, const BodyEdges& body,
                          const std::array<int, 2>& named) {
  std::string text;
  std::size_t told = 0, tried = 0;
  for (const std::array<int, 2>& of : {named, std::array{0, 0}}) {
    for (const EdgePair& pair : round_pairs(body, of)) {
      if (told == kTold || tried == kTried) break;
      auto radii = radii_if_any(body, pair);
      if (!radii) continue;
      ++tried;
      if (!rounds_fully(shape, *std::move(radii))) continue;
      text += (told++ == 0 ? "; edges " : ", or ") + std::to_string(pair.first) + " and " +
              std::to_string(pair.second);
    }
    if (told > 0) return text + " would do";
  }
  return text;
}

}  // namespace

std::map<int, EdgeRadius> full_round_radii(const TopoDS_Shape& shape, int edge_a, int edge_b) {
  const BodyEdges body(shape);
  try {
    return round_radii(body, edge_a, edge_b);
  } catch (const InvalidInput& refused) {
    throw InvalidInput(refused.what() + pairs_that_do(shape, body, {edge_a, edge_b}));
  }
}

double told_radius(double radius) { return told_below(radius); }

}  // namespace blossom::occt
