// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/equal_faces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/base/parallel.h"

namespace blossom::occt {
namespace {

constexpr double kEqual = 1e-3;        // of the tolerance: what differs by less is rounding
constexpr double kSameWeight = 1e-12;  // relative
constexpr std::size_t kGrain = 16;     // pairs that one thread compares in a row

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
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
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
  const auto is_known = [&](const auto& pair) { return pair.first.IsSame(a.edge); };
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

bool is_exact(const FaceMatch& match) {
  return match.gap == 0 && match.same_tolerances && !match.map.exchanged &&
         match.map.slope == Vec2{1, 1} && match.map.offset == Vec2{0, 0};
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

FaceCopies::FaceCopies(const FaceList& a, const FaceList& b,
                       const std::vector<std::pair<int, int>>& pairs, double tolerance)
    : a_(a),
      b_(b),
      originals_(b.size(), -1),
      exact_originals_(b.size(), -1),
      exact_copies_(a.size(), -1) {
  std::vector<std::optional<FaceMatch>> found(pairs.size());
  parallel_for(pairs.size(), kGrain, [&](std::size_t k) {
    found[k] = match(a.data(static_cast<std::size_t>(pairs[k].first)),
                     b.data(static_cast<std::size_t>(pairs[k].second)), kEqual * tolerance);
  });
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!found[k]) continue;
    int& original = originals_[static_cast<std::size_t>(pairs[k].second)];
    if (original < 0) original = pairs[k].first;
    if (is_exact(*found[k])) {
      exact_originals_[static_cast<std::size_t>(pairs[k].second)] = pairs[k].first;
      exact_copies_[static_cast<std::size_t>(pairs[k].first)] = pairs[k].second;
    }
    matches_.emplace(pairs[k], *std::move(found[k]));
  }
}

const FaceMatch* FaceCopies::between(int a, int b) const {
  const auto found = matches_.find({a, b});
  return found == matches_.end() ? nullptr : &found->second;
}

std::pair<int, int> FaceCopies::exchanged(const std::pair<int, int>& pair) const {
  const auto turned = [&](const std::pair<int, int>& of) {
    return std::pair{exact_originals_[static_cast<std::size_t>(of.second)],
                     exact_copies_[static_cast<std::size_t>(of.first)]};
  };
  const std::pair<int, int> other = turned(pair);
  // Where there are several equal faces each has one copy that is taken for its own.
  return other.first >= 0 && other.second >= 0 && turned(other) == pair ? other : pair;
}

std::vector<SharedEdge> FaceCopies::shared(int a, int b) const {
  const TopoDS_Face& face_a = a_.face(static_cast<std::size_t>(a));
  const int original = originals_[static_cast<std::size_t>(b)];
  if (original < 0) return shared_edges(face_a, b_.face(static_cast<std::size_t>(b)));
  const ChartMap& map = matches_.at({original, b}).map;
  std::vector<SharedEdge> edges = shared_edges(face_a, a_.face(static_cast<std::size_t>(original)));
  for (SharedEdge& edge : edges) {
    for (Vec2& point : edge.curve.chart_b.points) point = map(point);
    for (SurfacePoint& sample : edge.curve.samples) sample.uv_b = map(sample.uv_b);
  }
  return edges;
}

}  // namespace blossom::occt
