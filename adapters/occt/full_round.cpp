// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/full_round.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

constexpr double kSameRound = 1e-12;  // radii of both ends that differ by less, of them, are one

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

EdgeRadius round_radius(const RoundSide& of, const RoundSide& other, int edge) {
  std::array<double, 2> radii{};
  for (const std::size_t end : {0U, 1U}) {
    const Vec3 &across = other.ends[0].inwards, &own = of.ends[end].inwards;
    const double apart = dot(of.ends[end].point - other.ends[0].point, across);
    radii[end] = apart / (other.tangent - of.tangent * dot(own, across));
    if (!(radii[end] > 0) || !std::isfinite(radii[end]))
      refuse_round("no ball touches all three planes along " + round_edge_name(edge));
  }
  if (std::abs(radii[0] - radii[1]) <= kSameRound * radii[0]) return {radii[0], std::nullopt};
  return {1, RadiusLaw::linear({0, 1}, radii[0], radii[1])};
}

}  // namespace

std::map<int, EdgeRadius> full_round_radii(const TopoDS_Shape& shape, int edge_a, int edge_b) {
  const BodyEdges body(shape);
  if (edge_a == edge_b) refuse_round("one edge is named twice");
  for (const int edge : {edge_a, edge_b}) check_round_edge(body, edge);
  const int face = round_face(body, edge_a, edge_b);
  const RoundSide a = round_side_of(body, edge_a, face), b = round_side_of(body, edge_b, face);
  return {{edge_a, round_radius(a, b, edge_a)}, {edge_b, round_radius(b, a, edge_b)}};
}

}  // namespace blossom::occt
