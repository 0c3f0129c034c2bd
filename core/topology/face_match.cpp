// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/face_match.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/unbounded.h"

namespace blossom {
namespace {

constexpr double kSameWeight = 1e-12;  // relative

bool nearly_equal(const Box& a, const Box& b, double within) {
  return distance(a.low, b.low) <= within && distance(a.high, b.high) <= within;
}

// The map of two faces' parameters in the coordinates of their charts.
struct ScaledMap {
  const ChartMap& map;
  const Vec2& scale_a;
  const Vec2& scale_b;

  Vec2 operator()(const Vec3& homogeneous) const {
    const Vec2 uv = map({homogeneous[0] / homogeneous[2] / scale_a[0],
                         homogeneous[1] / homogeneous[2] / scale_a[1]});
    return {uv[0] * scale_b[0], uv[1] * scale_b[1]};
  }
};

// The largest distance of the control points of two spans, q perhaps from its end; infinite where
// their degrees or weights differ.
double difference(const PlanarBezier& p, const PlanarBezier& q, bool reversed,
                  const ScaledMap& map) {
  if (p.degree() != q.degree()) return kInfinity;
  const auto of_q = [&](std::size_t i) { return q.points[reversed ? q.points.size() - 1 - i : i]; };
  const double factor = of_q(0)[2] / p.points[0][2];
  double largest = 0;
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const Vec3 &from = p.points[i], to = of_q(i);
    if (std::abs(to[2] - factor * from[2]) > kSameWeight * to[2]) return kInfinity;
    largest = std::max(largest, distance(map(from), Vec2{to[0] / to[2], to[1] / to[2]}));
  }
  return largest;
}

std::optional<double> difference(const PlanarCurve& a, const PlanarCurve& b, bool reversed,
                                 const ScaledMap& map, double within) {
  if (a.spans.size() != b.spans.size()) return {};
  double largest = 0;
  for (std::size_t i = 0; i < a.spans.size() && largest <= within; ++i) {
    const std::size_t k = reversed ? b.spans.size() - 1 - i : i;
    largest = std::max(largest, difference(a.spans[i].curve, b.spans[k].curve, reversed, map));
  }
  if (!(largest <= within)) return {};
  return largest;
}

std::vector<const Coedge*> coedges_of(const FaceTrims& trims) {
  std::vector<const Coedge*> all;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) all.push_back(&coedge);
  return all;
}

// Seams are used twice; poles are no edges in space.
void add_edges(const Coedge& a, const Coedge& b, FaceMatch& match) {
  const auto is_known = [&](const auto& pair) { return pair.first == a.edge; };
  if (!a.degenerated && std::ranges::none_of(match.edges, is_known))
    match.edges.emplace_back(a.edge, b.edge);
}

// Adds the pairs of edges to the match; false if some coedge has no counterpart.
bool match_wires(const FaceTrims& a, const FaceTrims& b, double within, FaceMatch& match) {
  const std::vector<const Coedge*> of_a = coedges_of(a);
  std::vector<const Coedge*> of_b = coedges_of(b);
  if (of_a.size() != of_b.size()) return false;
  const ScaledMap map{match.map, a.scale, b.scale};
  double largest = 0;
  for (const Coedge* coedge : of_a) {
    std::optional<double> off;
    const auto other = std::find_if(of_b.begin(), of_b.end(), [&](const Coedge* each) {
      for (const bool reversed : {false, true})
        if (!off) off = difference(coedge->curve, each->curve, reversed, map, within);
      return off.has_value();
    });
    if (other == of_b.end()) return false;
    largest = std::max(largest, *off);
    if (coedge->tolerance != (*other)->tolerance) match.same_tolerances = false;
    add_edges(*coedge, **other, match);
    of_b.erase(other);
  }
  match.gap += largest;
  return true;
}

}  // namespace

std::optional<FaceMatch> match(const FaceData& a, const FaceData& b, double within) {
  if (!nearly_equal(a.box, b.box, within)) return {};
  const std::optional<SurfaceMatch> surfaces = match(a.surface, b.surface, within);
  if (!surfaces) return {};
  FaceMatch found{surfaces->map, surfaces->gap, true, {}};
  if (!match_wires(a.trims, b.trims, within, found)) return {};
  return found;
}

}  // namespace blossom
