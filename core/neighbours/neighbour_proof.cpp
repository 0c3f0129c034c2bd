// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/neighbours/neighbour_proof.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/bounds/patch_boxes.h"
#include "core/cells/cell_pair.h"
#include "core/cells/known_curves.h"
#include "core/cells/net_ranges.h"
#include "core/neighbours/limits.h"
#include "core/neighbours/neighbour_edge.h"
#include "core/neighbours/ways_to_edge.h"
#include "core/surfaces/adjacency/cell_descent.h"
#include "core/surfaces/adjacency/corner_separation.h"
#include "core/surfaces/adjacency/path_reach.h"

namespace blossom {
namespace {

constexpr int kDeepest = 100;          // halvings of a patch: 2^-50 in each direction
constexpr long kMaxPairs = 30'000;     // of cells, for each pair of patches
constexpr double kReach = 4;           // tolerances: what is so near an edge or a vertex is it
constexpr double kRounding = 0x1p-44;  // of the coordinates, by which ends of paths may be off

const Coedge* only_use(const FaceTrims& trims, int edge) {
  const Coedge* use = nullptr;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      if (coedge.edge != edge) continue;
      if (use != nullptr) return nullptr;
      use = &coedge;
    }
  return use;
}

// A vertex of both faces.
struct CommonVertex {
  KnownCurve ball;               // what is so near that it is the vertex
  std::vector<Vec2> on_a, on_b;  // in the charts; on a seam twice
};

std::vector<Vec2> images_of(int vertex, const FaceTrims& trims) {
  std::vector<Vec2> images;
  if (vertex < 0) return images;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      if ((coedge.reversed ? coedge.end : coedge.start) == vertex) images.push_back(coedge.ends[0]);
      if ((coedge.reversed ? coedge.start : coedge.end) == vertex) images.push_back(coedge.ends[1]);
    }
  return images;
}

std::vector<CommonVertex> common_vertices(const FaceData& a, const FaceData& b,
                                          const std::vector<SharedVertex>& shared,
                                          double tolerance) {
  std::vector<CommonVertex> common;
  for (const SharedVertex& vertex : shared) {
    CommonVertex& added = common.emplace_back();
    added.ball.points.assign(2, vertex.point);
    added.ball.radius = kReach * std::max(tolerance, vertex.tolerance);
    added.on_a = images_of(vertex.in_a, a.trims);
    added.on_b = images_of(vertex.in_b, b.trims);
  }
  return common;
}

std::vector<KnownCurve> balls_of(const std::vector<CommonVertex>& vertices) {
  std::vector<KnownCurve> balls;
  for (const CommonVertex& vertex : vertices) balls.push_back(vertex.ball);
  return balls;
}

// Along the line of the chart on which a coordinate is constant.
Vec3 line_direction(const FaceTrims& trims, const Vec2& at, int across) {
  const SurfaceJet jet = trims.jet({at[0] / trims.scale[0], at[1] / trims.scale[1]});
  return unit(across == 0 ? jet.dv : jet.du);
}

class Proof {
 public:
  Proof(const FaceData& a, const FaceData& b, const std::vector<SharedVertex>& vertices,
        double tolerance, const WorkLimit& limit)
      : a_data_(a),
        b_data_(b),
        tolerance_(tolerance),
        limit_(limit),
        origin_(0.5 * (a.box.low + a.box.high)),
        rounding_(kRounding * (max_norm(origin_) + diagonal(a.box))),
        gap_(a.surface.error + b.surface.error),
        strip_(kEdgeStrip * std::min(diagonal(a.box), diagonal(b.box))),
        vertices_(common_vertices(a, b, vertices, tolerance)),
        balls_(balls_of(vertices_), origin_),
        a_(a, origin_),
        b_(b, origin_) {}

  bool add_edges(const std::vector<SharedEdge>& edges) {
    if (edges.empty() && vertices_.empty()) gap_ += tolerance_;
    for (const SharedEdge& edge : edges) {
      const Coedge* on_a = only_use(a_data_.trims, edge.in_a);
      const Coedge* on_b = only_use(b_data_.trims, edge.in_b);
      if (on_a == nullptr || on_b == nullptr) return false;
      edges_.emplace_back(a_data_.trims, b_data_.trims, edge, *on_a, *on_b);
    }
    return true;
  }

  bool holds() {
    const PatchBoxes boxes_a(a_data_.surface), boxes_b(b_data_.surface);
    for (const auto& [i, j] : meeting_patches(boxes_a, boxes_b, gap_)) {
      pairs_ = 0;
      if (!holds(i, 0, j, 0)) return false;
    }
    return true;
  }

  const Certificate& certificate() const { return certificate_; }

 private:
  bool holds(int patch_a, int cell_a, int patch_b, int cell_b) {
    if (++pairs_ > kMaxPairs || (pairs_ % 64 == 0 && limit_.reached() != nullptr)) return false;
    CellTree &tree_a = a_.cells().tree(patch_a), &tree_b = b_.cells().tree(patch_b);
    const Cell a = tree_a[cell_a], b = tree_b[cell_b];
    const int points_a = tree_a.shape().plane_size(), points_b = tree_b.shape().plane_size();
    if (separated(a, b, points_a, points_b, gap_) ||
        separated_across(a, b, points_a, points_b, gap_) ||
        meet_at_vertex(a, b, points_a, points_b) ||
        touch_at_vertex(patch_a, cell_a, patch_b, cell_b) || a_.is_outside(patch_a, cell_a) ||
        b_.is_outside(patch_b, cell_b) ||
        std::ranges::any_of(edges_, [&](const NeighbourEdge& edge) {
          return meet_beside(edge, patch_a, cell_a, patch_b, cell_b) ||
                 touch_from_one_side(b_data_, a_, edge.on_a, patch_a, cell_a) ||
                 touch_from_one_side(a_data_, b_, edge.on_b, patch_b, cell_b);
        })) {
      count_excluded(a, b, certificate_);
      return true;
    }
    if (std::max(a.extent, b.extent) <= tolerance_ || (a.depth >= kDeepest && b.depth >= kDeepest))
      return false;
    const bool of_a = halves_first(a, b, kDeepest);
    const int child = of_a ? tree_a.split(cell_a) : tree_b.split(cell_b);
    return of_a ? holds(patch_a, child, patch_b, cell_b) &&
                      holds(patch_a, child + 1, patch_b, cell_b)
                : holds(patch_a, cell_a, patch_b, child) &&
                      holds(patch_a, cell_a, patch_b, child + 1);
  }

  // Within the ball round a common vertex, or on either side of a plane through it.
  bool meet_at_vertex(const Cell& a, const Cell& b, int points_a, int points_b) const {
    return balls_.hold_common({a.low, a.high}, {b.low, b.high}) ||
           std::ranges::any_of(vertices_, [&](const CommonVertex& vertex) {
             return separated_at(vertex.ball.points.front() - origin_, a, b, points_a, points_b,
                                 vertex.ball.radius);
           });
  }

  // Whether one of them touches all of the other one's surface along a parameter line through a
  // common vertex, from one side, and the vertex is where they end.
  bool touch_at_vertex(int patch_a, int cell_a, int patch_b, int cell_b) {
    return std::ranges::any_of(vertices_, [&](const CommonVertex& vertex) {
      return (b_data_.elementary &&
              touch_beyond(vertex, vertex.on_a, *b_data_.elementary, a_data_, a_, patch_a, cell_a,
                           b_.cells().tree(patch_b), cell_b, b_data_.surface.error)) ||
             (a_data_.elementary &&
              touch_beyond(vertex, vertex.on_b, *a_data_.elementary, b_data_, b_, patch_b, cell_b,
                           a_.cells().tree(patch_a), cell_a, a_data_.surface.error));
    });
  }

  bool touch_beyond(const CommonVertex& vertex, const std::vector<Vec2>& images,
                    const Elementary& surface, const FaceData& data, FaceCells& cells, int patch,
                    int cell, const CellTree& others, int other, double error) const {
    const CellTree& tree = cells.cells().tree(patch);
    const Cell &own = tree[cell], &opposite = others[other];
    const Vec3 point = vertex.ball.points.front() - origin_;
    if (!holds(own, point) || !holds(opposite, point)) return false;
    for (const Vec2& image : images)
      for (int across = 0; across < 2; ++across) {
        const Vec3 along = line_direction(data.trims, image, across);
        if (!goes_on(across == 0 ? own.dv : own.du, along)) continue;
        const Range here = heights(own, tree.shape().plane_size(), along, point),
                    there = heights(opposite, others.shape().plane_size(), along, point);
        if (std::max(here.low, there.low) < -vertex.ball.radius ||
            std::min(here.high, there.high) > vertex.ball.radius)
          continue;
        if (cells.depth_beside(surface, image, across, patch, cell) + error <= tolerance_)
          return true;
      }
    return false;
  }

  static bool holds(const Cell& cell, const Vec3& point) {
    for (int k = 0; k < 3; ++k)
      if (point[k] < cell.low[k] || point[k] > cell.high[k]) return false;
    return true;
  }

  // Whether derivatives lead on along a direction or against it, all over the cell.
  static bool goes_on(const VectorBounds& derivative, const Vec3& along) {
    return std::abs(dot(derivative.middle, along)) > norm(derivative.radius);
  }

  // Over a point along a direction.
  static Range heights(const Cell& cell, int points, const Vec3& along, const Vec3& point) {
    const Range range = height_range(cell.hull, points, along);
    const double from = dot(along, point);
    return {range.low - from - 2 * cell.margin, range.high - from + 2 * cell.margin};
  }

  // In the tube round the edge, or such that paths lead from one to the other.
  bool meet_beside(const NeighbourEdge& edge, int patch_a, int cell_a, int patch_b, int cell_b) {
    const Cell &a = a_.cells().tree(patch_a)[cell_a], &b = b_.cells().tree(patch_b)[cell_b];
    const double reach = kReach * std::max(tolerance_, edge.tolerance());
    if (std::min(a.extent, b.extent) < reach && is_in_tube(edge, reach, patch_a, a, b)) return true;
    if (is_along(edge, edge.on_a, reach, a_, patch_a, cell_a) ||
        is_along(edge, edge.on_b, reach, b_, patch_b, cell_b))
      return true;
    const std::optional<WaysToEdge>& to = a_.ways(edge.on_a, patch_a, cell_a);
    if (!to) return false;
    const std::optional<WaysToEdge>& from = b_.ways(edge.on_b, patch_b, cell_b);
    if (!from) return false;
    std::vector<VectorBounds> across = to->directions;
    for (const VectorBounds& way : from->directions) across.push_back({-way.middle, way.radius});
    const Interval range{std::min(to->on_edge.from, from->on_edge.from),
                         std::max(to->on_edge.to, from->on_edge.to)};
    const double jumps = edge.gap(range) + to->shortfall + from->shortfall + a_data_.surface.error +
                         b_data_.surface.error + rounding_;
    const double most = path_reach(across, edge.directions(range)) * jumps;
    // Each face may be off the edge by its tolerance.
    return most <= reach || (jumps <= 2 * std::max(tolerance_, edge.tolerance()) && most <= strip_);
  }

  // Whether a cell stays on one side of all of the other face's surface, which it touches at the
  // edge.
  bool touch_from_one_side(const FaceData& other, FaceCells& cells, const Coedge& edge, int patch,
                           int cell) const {
    return other.elementary &&
           cells.depth_behind(*other.elementary, edge, tolerance_, patch, cell) +
                   other.surface.error <=
               tolerance_;
  }

  bool is_in_tube(const NeighbourEdge& edge, double reach, int patch_a, const Cell& a,
                  const Cell& b) const {
    Box common;
    for (int k = 0; k < 3; ++k) {
      common.low[k] = std::max(a.low[k], b.low[k]);
      common.high[k] = std::min(a.high[k], b.high[k]);
    }
    const Vec3 centre = 0.5 * (common.low + common.high) + origin_;
    const Vec3 foot = edge.point(a_.nearest_on(edge.on_a, patch_a, a));
    return distance(centre, foot) + 0.5 * diagonal(common) <= reach;
  }

  // Whether all of a cell that is narrower than the tube, and may be long, lies in it.
  static bool is_along(const NeighbourEdge& edge, const Coedge& use, double reach, FaceCells& cells,
                       int patch, int cell) {
    const CellTree& tree = cells.cells().tree(patch);
    const Cell& own = tree[cell];
    const auto size = [](const VectorBounds& step) {
      return norm(step.middle) + norm(step.radius);
    };
    if (std::min(size(own.du), size(own.dv)) > 2 * reach) return false;
    return edge.is_near(cells.nearest_on(use, patch, own), own.hull, tree.shape().plane_size(),
                        cells.cells().origin(), reach - own.margin);
  }

  const FaceData& a_data_;
  const FaceData& b_data_;
  const double tolerance_;
  const WorkLimit& limit_;
  const Vec3 origin_;
  const double rounding_;
  double gap_;          // by more than it cells are apart
  const double strip_;  // so far beside an edge faces may meet that are nearly tangent there
  const std::vector<CommonVertex> vertices_;
  const KnownCurves balls_;  // round them
  FaceCells a_, b_;
  std::vector<NeighbourEdge> edges_;
  long pairs_ = 0;  // of the patches at hand
  Certificate certificate_;
};

}  // namespace

NeighbourProof meet_in_shared_only(const FaceData& a, const FaceData& b,
                                   const std::vector<SharedEdge>& edges,
                                   const std::vector<SharedVertex>& vertices, double tolerance,
                                   const WorkLimit& limit) {
  Proof proof(a, b, vertices, tolerance, limit);
  if (!proof.add_edges(edges) || !proof.holds()) return {};
  return {true, proof.certificate()};
}

}  // namespace blossom
