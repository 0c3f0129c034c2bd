// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/search/self_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/work_limit.h"
#include "core/bounds/box_tree.h"
#include "core/cells/cell_pair.h"
#include "core/cells/direction_cones.h"
#include "core/cells/flat_border.h"
#include "core/math/interval.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

constexpr int kMaxSelfHalvings = 56;  // halvings of a patch: 2^-28 in each direction
// Pairs of one generation, and how many more for a patch; singular curves have more.
constexpr std::size_t kMaxOpen = 32768;
constexpr std::size_t kMaxOpenPerPatch = 64;
constexpr double kLikeOpen = 4;   // times the size of open boxes at a singular curve
constexpr long kLookEvery = 64;   // pairs between looks at the clock
constexpr double kGlued = 1e-12;  // of the surface's size: borders this near are one

// A block of spans or, in a block of one span, a cell.
struct Part {
  int block = 0;
  int cell = 0;
  friend bool operator==(const Part&, const Part&) = default;
};

// Spans [u0, u1) x [v0, v1).
struct Block {
  int u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  int left = -1, right = -1;  // -1: one span
  int patch = -1;
  Box box{};
  DirectionCones cones{};
};

struct PartPair {
  Part a, b;
};

// Place over the whole surface: number of the span plus local parameter.
struct Place {
  Interval u, v;
};

bool touch(const Interval& a, const Interval& b, bool seam, double period) {
  if (overlap(a, b)) return true;
  return seam && (overlap({a.from + period, a.to + period}, b) ||
                  overlap({a.from - period, a.to - period}, b));
}

Vec3 point_of(const Vec4& p) { return {p[0] / p[3], p[1] / p[3], p[2] / p[3]}; }

// Of boxes that meet.
Box common(const Box& a, const Box& b) {
  Box both;
  for (int k = 0; k < 3; ++k) {
    both.low[k] = std::max(a.low[k], b.low[k]);
    both.high[k] = std::min(a.high[k], b.high[k]);
  }
  return both;
}

// Boxes along curves on which the surface is singular: places that stay open. There may be
// thousands of them at one place.
class OpenBoxes {
 public:
  explicit OpenBoxes(const std::vector<CriticalPair>& pairs)
      : boxes_(boxes_of(pairs)),
        tree_(boxes_),
        largest_(boxes_.empty() ? 0 : 2 * boxes_.size() - 1) {
    for (std::size_t i = largest_.size(); i-- > 0;) {  // what is below a node comes behind it
      const BoxTree::Node& node = tree_.node(static_cast<int>(i));
      largest_[i] = node.item >= 0 ? diagonal(node.box)
                                   : std::max(largest_[static_cast<std::size_t>(node.left)],
                                              largest_[static_cast<std::size_t>(node.right)]);
    }
  }

  // Whether a box meets one whose diagonal is that long at least.
  bool meets(const Box& box, double length) const {
    return !largest_.empty() && meets_below(0, box, length);
  }

 private:
  bool meets_below(int index, const Box& box, double length) const {
    const BoxTree::Node& node = tree_.node(index);
    if (largest_[static_cast<std::size_t>(index)] < length || !meet(node.box, box)) return false;
    return node.item >= 0 || meets_below(node.left, box, length) ||
           meets_below(node.right, box, length);
  }

  static std::vector<Box> boxes_of(const std::vector<CriticalPair>& pairs) {
    std::vector<Box> boxes;
    for (const CriticalPair& pair : pairs)
      if (!pair.within_tolerance) boxes.push_back({pair.low, pair.high});
    return boxes;
  }

  std::vector<Box> boxes_;
  BoxTree tree_;
  std::vector<double> largest_;  // diagonals at or below a node, by its index
};

class SelfPairSearch {
 public:
  SelfPairSearch(SurfaceCells& cells, const GluedBorders& glued, const Vec3& origin,
                 const IntersectionOptions& options)
      : cells_(cells),
        glued_(glued),
        origin_(origin),
        options_(options),
        limit_(options),
        axes_(axes_of(cells.surface())) {
    const auto& patches = cells.surface().patches;
    for (int i = 0; i < cells.patches(); ++i)
      slopes_.push_back(slope_nets(cells.tree(i).patch(), cells.surface().rational,
                                   cells.tree(i).given_rounding()));
    for (int side = 0; side < 4; ++side)
      if (auto border =
              FlatBorder::of(cells, static_cast<PoleSide>(side), options.tolerances.point))
        flat_borders_.push_back(*std::move(border));
    build({.u0 = 0, .u1 = patches.rows(), .v0 = 0, .v1 = patches.columns()});
  }

  SelfPairs run() {
    std::vector<PartPair> open{{Part{}, Part{}}}, next;
    const auto patches = static_cast<std::size_t>(cells_.patches());
    while (!open.empty()) {
      const bool too_many = open.size() > kMaxOpen + kMaxOpenPerPatch * patches;
      if (too_many) result_.reasons.emplace_back("the surface is singular, or nearly, on a curve");
      next.clear();
      for (const PartPair& pair : open) {
        if (too_many || out_of_budget())
          keep(pair, false);
        else
          examine(pair, next);
      }
      open.swap(next);
    }
    const OpenBoxes open_boxes(result_.singular);
    while (!apart_.empty()) {
      const PartPair pair = apart_.back();
      apart_.pop_back();
      separate(pair, open_boxes);
    }
    return std::move(result_);
  }

 private:
  bool out_of_budget() {
    if (result_.stopped) return true;
    if (++examined_ > options_.budget) return stop("the budget of cell pairs is spent");
    if (examined_ % kLookEvery != 0) return false;
    if (const char* reason = limit_.reached()) return stop(reason);
    return false;
  }

  bool stop(const char* reason) {
    result_.stopped = true;
    result_.cancelled = WorkLimit::is_cancelled(reason);
    result_.reasons.emplace_back(reason);
    return true;
  }

  // --- parts

  int build(Block block) {
    const int index = static_cast<int>(blocks_.size());
    blocks_.push_back(block);
    const int across = block.u1 - block.u0, along = block.v1 - block.v0;
    if (across * along == 1) {
      block.patch = block.u0 * cells_.surface().patches.columns() + block.v0;
      const Cell& root = cells_.tree(block.patch)[0];
      block.box = {root.low, root.high};
      block.cones = cell_cones(block.patch, root);
    } else {
      Block low = block, high = block;
      if (across >= along)
        low.u1 = high.u0 = block.u0 + across / 2;
      else
        low.v1 = high.v0 = block.v0 + along / 2;
      block.left = build(low);
      block.right = build(high);
      const Block &l = blocks_[static_cast<std::size_t>(block.left)],
                  &r = blocks_[static_cast<std::size_t>(block.right)];
      block.box = joined(l.box, r.box);
      block.cones = joined(l.cones, r.cones);
    }
    blocks_[static_cast<std::size_t>(index)] = block;
    return index;
  }

  const Block& block(const Part& part) const {
    return blocks_[static_cast<std::size_t>(part.block)];
  }
  bool is_cell(const Part& part) const { return block(part).patch >= 0; }
  CellTree& tree(const Part& part) const { return cells_.tree(block(part).patch); }
  const Cell& cell(const Part& part) const { return tree(part)[part.cell]; }

  Box box(const Part& part) const {
    if (!is_cell(part)) return block(part).box;
    return {cell(part).low, cell(part).high};
  }

  Place place(const Part& part) const {
    const Block& b = block(part);
    if (!is_cell(part))
      return {{static_cast<double>(b.u0), static_cast<double>(b.u1)},
              {static_cast<double>(b.v0), static_cast<double>(b.v1)}};
    const Cell& c = cell(part);
    return {{b.u0 + c.u.from, b.u0 + c.u.to}, {b.v0 + c.v.from, b.v0 + c.v.to}};
  }

  std::array<Part, 2> halves(const Part& part) {
    if (!is_cell(part)) return {Part{block(part).left, 0}, Part{block(part).right, 0}};
    const int child = tree(part).split(part.cell);
    result_.depth = std::max(result_.depth, cell(Part{part.block, child}).depth);
    return {Part{part.block, child}, Part{part.block, child + 1}};
  }

  bool may_halve(const Part& part) const {
    return !is_cell(part) || cell(part).depth < kMaxSelfHalvings;
  }

  // Whether it is halved rather than the other one of a pair.
  bool first(const Part& a, const Part& b) const {
    if (!may_halve(a) || !may_halve(b)) return may_halve(a);
    if (is_cell(a) != is_cell(b)) return is_cell(b);
    return diagonal(box(a)) >= diagonal(box(b));
  }

  // --- cones and poles

  // The only side of a cell that is a pole; nothing if there is none, or more than one.
  std::optional<PoleSide> pole_side(int patch, const Cell& c) const {
    const auto& patches = cells_.surface().patches;
    const int i = cells_.span_u(patch), j = cells_.span_v(patch);
    const std::array at{i == 0 && c.u.from == 0, i == patches.rows() - 1 && c.u.to == 1,
                        j == 0 && c.v.from == 0, j == patches.columns() - 1 && c.v.to == 1};
    std::optional<PoleSide> side;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!at[k] || !glued_.poles[k]) continue;
      if (side) return std::nullopt;
      side = static_cast<PoleSide>(k);
    }
    return side;
  }

  Vec3 pole(PoleSide side) const { return *glued_.poles[static_cast<std::size_t>(side)] - origin_; }

  DirectionCones cell_cones(int patch, const Cell& c) const {
    const auto side = pole_side(patch, c);
    const SlopeNets& nets = slopes_[static_cast<std::size_t>(patch)];
    return side ? cones_at_pole(nets, c.u, c.v, *side, pole(*side), axes_)
                : cones_of(nets, c.u, c.v, axes_);
  }

  DirectionCones cones(const Part& part) const {
    return is_cell(part) ? cell_cones(block(part).patch, cell(part)) : block(part).cones;
  }

  // --- pairs

  bool touches(const Part& a, const Part& b) const {
    const Place p = place(a), q = place(b);
    const auto& patches = cells_.surface().patches;
    return touch(p.u, q.u, glued_.seam_u, patches.rows()) &&
           touch(p.v, q.v, glued_.seam_v, patches.columns());
  }

  // Across a seam there is a second way from part to part; each alone proves all.
  void examine(const PartPair& pair, std::vector<PartPair>& next) {
    const auto& [a, b] = pair;
    if (!(a == b) && !touches(a, b)) {
      apart_.push_back(pair);
      return;
    }
    if (is_injective(a == b ? cones(a) : joined(cones(a), cones(b)))) {
      ++result_.excluded;
      return;
    }
    if (is_injective_at_flat_border(a, b)) return;
    const double tolerance = options_.tolerances.point;
    const bool tiny = diagonal(box(a)) <= tolerance && diagonal(box(b)) <= tolerance;
    if (tiny || !(may_halve(a) || may_halve(b))) return keep(pair, tiny);
    if (a == b) {
      const auto [low, high] = halves(a);
      next.push_back({low, low});
      next.push_back({high, high});
      next.push_back({low, high});
    } else if (first(a, b)) {
      for (const Part& half : halves(a)) next.push_back({half, b});
    } else {
      for (const Part& half : halves(b)) next.push_back({a, half});
    }
  }

  // Parts that do not touch: down to pairs of cells that some search has to settle. Beside a
  // singular curve there is no end to such pairs: those no larger than what is open of it are open,
  // too.
  void separate(const PartPair& pair, const OpenBoxes& open_boxes) {
    const auto& [a, b] = pair;
    if (!meet(box(a), box(b))) {
      ++result_.excluded;
      return;
    }
    if (is_cell(a) && is_cell(b)) {
      if (!out_of_budget() &&
          (pole_between(a, b) || in_one_piece(a, b) || is_injective_at_flat_border(a, b)))
        return;
      const bool forward =
          place(a).u.from < place(b).u.from ||
          (place(a).u.from == place(b).u.from && place(a).v.from < place(b).v.from);
      const Part &low = forward ? a : b, &high = forward ? b : a;
      const Box both = common(box(a), box(b));
      if (!open_boxes.meets(both, 0)) {
        result_.apart.push_back({block(low).patch, low.cell, block(high).patch, high.cell});
        return;
      }
      const double size = std::max(diagonal(box(a)), diagonal(box(b)));
      if (result_.stopped || !(may_halve(a) || may_halve(b)) ||
          open_boxes.meets(both, size / kLikeOpen))
        return keep({low, high}, false);
    }
    const bool of_a = first(a, b);
    for (const Part& half : halves(of_a ? a : b))
      apart_.push_back(of_a ? PartPair{half, b} : PartPair{a, half});
  }

  // True if both cells lie in a rectangle of their patch that does not meet itself.
  bool in_one_piece(const Part& a, const Part& b) {
    if (a.block != b.block) return false;
    const Interval u = hull(cell(a).u, cell(b).u), v = hull(cell(a).v, cell(b).v);
    const SlopeNets& nets = slopes_[static_cast<std::size_t>(block(a).patch)];
    if (!is_injective(cones_of(nets, u, v, axes_))) return false;
    ++result_.excluded;
    return true;
  }

  // Whether both cells lie in a rectangle that does not meet itself, of one patch or across the
  // lines between a few.
  bool is_injective_at_flat_border(const Part& a, const Part& b) {
    if (!is_cell(a) || !is_cell(b)) return false;
    const Place p = place(a), q = place(b);
    const Interval u = hull(p.u, q.u), v = hull(p.v, q.v);
    return std::ranges::any_of(flat_borders_, [&](const FlatBorder& border) {
      const std::optional<DirectionCones> cones = border.cones(slopes_, u, v);
      if (!cones || !is_injective(*cones)) return false;
      result_.moved_into_plane = std::max(result_.moved_into_plane.value_or(0), border.within());
      ++result_.excluded;
      return true;
    });
  }

  // Cells at the same pole; true if nothing is left to be done for them.
  bool pole_between(const Part& a, const Part& b) {
    const auto side_a = pole_side(block(a).patch, cell(a));
    const auto side_b = pole_side(block(b).patch, cell(b));
    if (!side_a || !side_b || norm(pole(*side_a) - pole(*side_b)) > 0) return false;
    const auto at_pole = [&](const Part& part, PoleSide side) {
      const SlopeNets& nets = slopes_[static_cast<std::size_t>(block(part).patch)];
      return PolePart{nets, cell(part).u, cell(part).v, side};
    };
    if (meet_in_pole_only(at_pole(a, *side_a), at_pole(b, *side_b), pole(*side_a))) {
      ++result_.excluded;
      return true;
    }
    const double tolerance = options_.tolerances.point;
    const bool tiny = diagonal(box(a)) <= tolerance && diagonal(box(b)) <= tolerance;
    if (tiny || !(may_halve(a) || may_halve(b)) || out_of_budget()) {
      keep({a, b}, tiny);
      return true;
    }
    const bool of_a = first(a, b);
    for (const Part& half : halves(of_a ? a : b))
      apart_.push_back(of_a ? PartPair{half, b} : PartPair{a, half});
    return true;
  }

  // No proof: listed both ways round, cell by cell.
  void keep(const PartPair& pair, bool within_tolerance) {
    const auto& [a, b] = pair;
    if (!is_cell(a) || !is_cell(b)) {
      if (!(a == b) && !touches(a, b)) return apart_.push_back(pair);
      const bool of_a = !is_cell(a);
      for (const Part& half : halves(of_a ? a : b))
        keep(of_a ? PartPair{half, a == b ? half : b} : PartPair{a, half}, within_tolerance);
      if (a == b) keep({halves(a)[0], halves(a)[1]}, within_tolerance);
      return;
    }
    const Cell &x = cell(a), &y = cell(b);
    const Box both = common({x.low, x.high}, {y.low, y.high});
    CriticalPair critical{block(a).patch, block(b).patch, box_of(x, y),
                          both.low,       both.high,      within_tolerance};
    critical.singular = true;
    result_.singular.push_back(critical);
    if (a == b) return;
    std::swap(critical.patch_a, critical.patch_b);
    std::swap(critical.box[0], critical.box[2]);
    std::swap(critical.box[1], critical.box[3]);
    result_.singular.push_back(critical);
  }

  SurfaceCells& cells_;
  const GluedBorders& glued_;
  const Vec3 origin_;
  const IntersectionOptions& options_;
  const WorkLimit limit_;
  const Axes axes_;
  std::vector<SlopeNets> slopes_;  // of the patches
  std::vector<FlatBorder> flat_borders_;
  long examined_ = 0;
  std::vector<Block> blocks_;
  std::vector<PartPair> apart_;
  SelfPairs result_;
};

// --- glued borders

// The control points of a border, span after span, in space and with their weights.
std::vector<Vec4> border_points(const BezierSurface& surface, PoleSide side) {
  const auto& patches = surface.patches;
  const bool across_u = side == PoleSide::LowU || side == PoleSide::HighU;
  const bool low = side == PoleSide::LowU || side == PoleSide::LowV;
  std::vector<Vec4> points;
  for (int k = 0; k < (across_u ? patches.columns() : patches.rows()); ++k) {
    const int last_u = patches.rows() - 1, last_v = patches.columns() - 1;
    const Grid<Vec4>& net =
        (across_u ? patches(low ? 0 : last_u, k) : patches(k, low ? 0 : last_v)).points;
    for (int i = 0; i < (across_u ? net.columns() : net.rows()); ++i) {
      const Vec4& p =
          across_u ? net(low ? 0 : net.rows() - 1, i) : net(i, low ? 0 : net.columns() - 1);
      const Vec3 x = point_of(p);
      points.push_back({x[0], x[1], x[2], p[3]});
    }
  }
  return points;
}

std::optional<Vec3> as_pole(const std::vector<Vec4>& border, double slack) {
  Box box;
  for (const Vec4& p : border) box = joined(box, {{p[0], p[1], p[2]}, {p[0], p[1], p[2]}});
  if (diagonal(box) > slack) return std::nullopt;
  return Vec3{border[0][0], border[0][1], border[0][2]};
}

// The same curve span by span: equal points, and weights equal up to one factor a surface.
bool same_border(const std::vector<Vec4>& p, const std::vector<Vec4>& q, double slack) {
  if (p.size() != q.size()) return false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec4 d = p[i] * (1 / p[0][3]) - q[i] * (1 / q[0][3]);
    if (std::abs(d[3]) > kGlued) return false;
    if (norm(Vec3{p[i][0] - q[i][0], p[i][1] - q[i][1], p[i][2] - q[i][2]}) > slack) return false;
  }
  return true;
}

}  // namespace

GluedBorders glued_borders(const BezierSurface& surface) {
  GluedBorders glued{surface.closed_u, surface.closed_v};
  Box box;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values()) box = joined(box, {point_of(p), point_of(p)});
  const double slack = kGlued * diagonal(box);
  std::array<std::vector<Vec4>, 4> borders;
  for (std::size_t k = 0; k < 4; ++k) {
    borders[k] = border_points(surface, static_cast<PoleSide>(k));
    glued.poles[k] = as_pole(borders[k], slack);
  }
  glued.seam_u = glued.seam_u || (!glued.poles[0] && same_border(borders[0], borders[1], slack));
  glued.seam_v = glued.seam_v || (!glued.poles[2] && same_border(borders[2], borders[3], slack));
  return glued;
}

SelfPairs self_pairs(SurfaceCells& cells, const GluedBorders& glued, const Vec3& origin,
                     const IntersectionOptions& options) {
  return SelfPairSearch(cells, glued, origin, options).run();
}

}  // namespace blossom
