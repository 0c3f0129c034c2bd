// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/base/work_limit.h"
#include "core/distance/convex_pair.h"
#include "core/distance/curvature_centre.h"
#include "core/distance/distance_parts.h"
#include "core/distance/nearest_pair.h"
#include "core/distance/operand_trees.h"
#include "core/distance/square_form.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

// Distances of points below this, relative to the largest coordinate, are roundings.
constexpr double kRounding = 64 * kUnitRoundoff;
constexpr int kHalvingsPerStart = 12;   // of a pair, for Newton's method even without a promise
constexpr long kPairsPerQuestion = 64;  // looked at before it is asked whether to go on
// Balls, cylinders and tori between the sets are tried at every so many halvings of a pair.
constexpr int kHalvingsPerCentre = 4;

constexpr int kHalvingsPerTurn = 4;
constexpr int kWholeParts = -2;  // depths: their boxes are all that has been looked at
constexpr int kBoxes = -1;       // and those of their items

struct Pair {
  double lower = 0;
  OperandPlace a, b;
  int depth = kWholeParts;  // halvings of cells
  bool left_out = false;    // trims left out the nearest points of these cells, or of larger ones

  // The nearest on top. Pairs that meet are halved a few times each in turn, one after the other,
  // so that a point they have in common is found soon, and no place without one holds up the rest.
  bool operator<(const Pair& other) const {
    if (lower != other.lower) return lower > other.lower;
    const int turn = depth / kHalvingsPerTurn, turn_of_other = other.depth / kHalvingsPerTurn;
    return turn != turn_of_other ? turn > turn_of_other : depth < other.depth;
  }
};

double farthest(const Box& a, const Box& b) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double most = std::max(a.high[k] - b.low[k], b.high[k] - a.low[k]);
    sum += most * most;
  }
  return sum;
}

// Of a square of a length: many times the eight roundings of a sum of three squares and its root.
constexpr double kRoundingOfLength = 1e-14;
constexpr double kRoundingOfSquare = 1e-12;  // of such a square, generously
constexpr double kGapSlack = 1e-6;           // of the gap that is allowed: no wish for more digits

double lower_end(double squared) { return (1 - kRoundingOfLength) * std::sqrt(squared); }

Vec2 inside(const Cell& cell, const Vec2& at) {
  return {std::clamp(at[0], cell.u.from, cell.u.to), std::clamp(at[1], cell.v.from, cell.v.to)};
}

class Search {
 public:
  Search(const DistanceParts& a, const DistanceParts& b, const DistanceOptions& options)
      : options_(options),
        a_(a),
        b_(b),
        rounding_(kRounding * (a.scale() + b.scale())),
        floor_(std::max(options.resolution,
                        (options.enough < 0 ? kDistanceResolution : kDistanceRounding) *
                            (a.scale() + b.scale()))) {
    result_.upper = kInfinity;
  }

  DistanceResult run() {
    add_parts();
    double lowest = kInfinity;
    while (!open_.empty()) {
      const Pair pair = open_.top();
      lowest = pair.lower;
      if (is_settled(pair.lower)) break;
      if (result_.pairs >= options_.budget ||
          (steps_++ % kPairsPerQuestion == 0 && limit_.reached() != nullptr)) {
        result_.status = Status::Stopped;
        break;
      }
      open_.pop();
      lowest = kInfinity;
      if (pair.depth == kBoxes && (pair.a.item < 0 || pair.b.item < 0)) {
        open_boxes(pair);
        continue;
      }
      ++result_.pairs;
      if (pair.depth == kWholeParts)
        look_at_hulls(pair);
      else if (pair.depth == kBoxes)
        consider({pair.lower, pair.a, pair.b, 0});
      else
        examine(pair);
    }
    result_.lower = std::max(0.0, std::min({lowest, dropped_, result_.upper}));
    // Cells at the limit of halving leave a gap, too.
    if (options_.enough < 0 && result_.lower < result_.upper - (1 + kGapSlack) * gap())
      result_.status = Status::Stopped;
    return result_;
  }

 private:
  double gap() const {
    return result_.upper < kInfinity ? std::max(kDistanceAccuracy * result_.upper, floor_) : floor_;
  }

  // No pair at this distance or more matters any longer.
  bool is_settled(double lower) const {
    return lower >= result_.upper - gap() ||
           (options_.enough >= 0 && (lower > options_.enough || result_.upper <= options_.enough));
  }

  // Pairs of parts near enough, by their boxes. Two points give a first upper bound.
  void add_parts() {
    start_with_points();
    double bound = result_.upper * result_.upper;
    const Vec3 along = direction_;
    std::vector<Interval> heights;  // of the parts of b
    double front = -kInfinity;
    for (int j = 0; j < b_.parts.size(); ++j) {
      heights.push_back(b_.parts.heights(j, along));
      front = std::max(front, heights.back().to);
    }
    std::vector<Pair> near;
    for (int i = 0; i < a_.parts.size(); ++i) {
      const double height = a_.parts.heights(i, along).from - rounding_;
      if (height - front > result_.upper) continue;
      const Box& box = a_.parts.box(i);
      b_.parts.tree().for_each_near(box, bound, [&](int j) {
        const double squared = squared_distance(box, b_.parts.box(j));
        const double lower = std::max({0.0, lower_end(squared) - rounding_,
                                       height - heights[static_cast<std::size_t>(j)].to});
        if (a_.parts.is_point(i) && b_.parts.is_point(j)) {
          if (squared < bound) take_points(i, j);
          bound = std::min(bound, squared);
        } else if (lower <= result_.upper) {
          near.push_back({lower, {i}, {j}});
        }
        return bound;
      });
    }
    std::erase_if(near, [&](const Pair& pair) { return pair.lower > result_.upper; });
    open_ = std::priority_queue<Pair>(std::less<Pair>(), std::move(near));
  }

  // The points of each set that lie farthest towards the other one.
  void start_with_points() {
    const auto middle = [](const DistanceParts& parts) {
      return 0.5 * (parts.bounds().low + parts.bounds().high);
    };
    const auto foremost = [](const DistanceParts& parts, const Vec3& direction) {
      int best = -1;
      double highest = -kInfinity;
      for (int i = 0; i < parts.points(); ++i)
        if (const double height = dot(direction, parts.box(i).low); height > highest) {
          best = i;
          highest = height;
        }
      return best;
    };
    const Vec3 towards = middle(b_.parts) - middle(a_.parts);
    const int i = foremost(a_.parts, towards), j = foremost(b_.parts, -towards);
    if (i >= 0 && j >= 0) take_points(i, j);
  }

  void take_points(int i, int j) {
    const Vec3 p = a_.parts.box(i).low, q = b_.parts.box(j).low;
    result_.upper = distance(p, q);
    drop(result_.upper);
    result_.a = {DistanceEnd::Kind::Point, i, {}, p};
    result_.b = {DistanceEnd::Kind::Point, j, {}, q};
    direction_ = unit(p - q);
  }

  // Bounds two parts by their hulls, along the direction of the nearest points so far.
  void look_at_hulls(Pair pair) {
    const Interval a = a_.parts.heights(pair.a.part, direction_);
    const Interval b = b_.parts.heights(pair.b.part, direction_);
    pair.lower = std::max({pair.lower, a.from - b.to - rounding_, b.from - a.to - rounding_});
    push({pair.lower, pair.a, pair.b, kBoxes});
  }

  void drop(double lower) { dropped_ = std::min(dropped_, lower); }

  // The halves of a node with the other one, or with the item that is there.
  void open_boxes(const Pair& pair) {
    const bool opens_a = pair.b.item >= 0 || (pair.a.item < 0 && diagonal(a_.node(pair.a).box) >=
                                                                     diagonal(b_.node(pair.b).box));
    const BoxTree::Node& node = opens_a ? a_.node(pair.a) : b_.node(pair.b);
    for (const int child : {node.left, node.right}) {
      Pair next = pair;
      (opens_a ? next.a : next.b).cell = child;
      const Box box = widened(a_.box(next.a), rounding_);
      next.lower =
          std::max(pair.lower, lower_end(squared_distance(box, b_.box(next.b))) - rounding_);
      push(next);
    }
  }

  // Keeps a pair of boxes if it is near enough.
  void push(Pair pair) {
    a_.resolve(pair.a);
    b_.resolve(pair.b);
    if (is_settled(pair.lower) || pair.lower > reach_) return drop(pair.lower);
    open_.push(pair);
    if (pair.a.item < 0 || pair.b.item < 0) return;
    const DistanceItem &a = a_.item(pair.a), &b = b_.item(pair.b);
    if (a_.parts.is_whole(a) && b_.parts.is_whole(b))
      reach_ = std::min(
          reach_, std::sqrt((1 + kRoundingOfSquare) * farthest(widened(a.box, rounding_), b.box)));
  }

  void examine(Pair pair) {
    // Trims take long to be made, so they are asked last.
    if (is_proven_convex(pair) || a_.is_outside(pair.a, pair.left_out) ||
        b_.is_outside(pair.b, pair.left_out))
      return;
    ItemTree& tree_a = a_.tree(pair.a);
    ItemTree& tree_b = b_.tree(pair.b);
    const Cell &cell_a = tree_a.cells[pair.a.cell], &cell_b = tree_b.cells[pair.b.cell];
    const bool can_a = can_split(a_.item(pair.a), cell_a);
    const bool can_b = can_split(b_.item(pair.b), cell_b);
    if (!can_a && !can_b) {
      drop(pair.lower);  // two points, or the limit of halving
      return;
    }
    const bool split_a = can_a && (cell_a.extent >= cell_b.extent || !can_b);
    const int low = split_a ? tree_a.split(pair.a.cell) : tree_b.split(pair.b.cell);
    for (const int child : {low, low + 1}) {
      Pair next = pair;
      (split_a ? next.a : next.b).cell = child;
      ++next.depth;
      consider(next);
    }
  }

  // Cells that are this small and not excluded by now are on a border of the trims.
  bool can_split(const DistanceItem& item, const Cell& cell) const {
    return item.dimension() > 0 && cell.depth < kDeepest && cell.extent > 0.1 * floor_;
  }

  // Keeps a pair if it may matter.
  void consider(Pair pair) {
    const Cell& cell_a = a_.tree(pair.a).cells[pair.a.cell];
    const Cell& cell_b = b_.tree(pair.b).cells[pair.b.cell];
    pair.lower = std::max(pair.lower, bound_of(pair, cell_a, cell_b));
    if (is_settled(pair.lower)) {
      drop(pair.lower);
      return;
    }
    if (may_be_normal(cell_a, a_.item(pair.a).across(cell_a), cell_b,
                      b_.item(pair.b).across(cell_b)))
      open_.push(pair);
  }

  // Infinite if the least distance is not taken inside of the cells.
  double bound_of(const Pair& pair, const Cell& cell_a, const Cell& cell_b) {
    const DistanceItem &item_a = a_.item(pair.a), &item_b = b_.item(pair.b);
    const NetShape& shape_a = a_.tree(pair.a).cells.shape();
    const NetShape& shape_b = b_.tree(pair.b).cells.shape();
    const int points_a = shape_a.plane_size(), points_b = shape_b.plane_size();
    const double bound = distance_bound({&cell_a, points_a}, {&cell_b, points_b}, direction_);
    if (is_settled(bound) || std::max(points_a, points_b) > kMaxSquarePoints) return bound;
    if (item_a.dimension() == 0) return std::max(bound, bound_of(pair.a, a_, pair.b, b_));
    if (item_b.dimension() == 0) return std::max(bound, bound_of(pair.b, b_, pair.a, a_));
    if (pair.depth % kHalvingsPerCentre != kHalvingsPerCentre - 1) return bound;
    double best = bound;
    for (const Centre& centre : centres_) {
      if (centre.radius > 0) {
        const DistanceRange a = circle_distance(cell_a, shape_a, centre);
        const DistanceRange b = circle_distance(cell_b, shape_b, centre);
        best = std::max({best, a.nearest - b.farthest, b.nearest - a.farthest});
        continue;
      }
      const SquareForm a = square_form(cell_a, shape_a, centre);
      const SquareForm b = square_form(cell_b, shape_b, centre);
      best = std::max({best, a.nearest - b.farthest, b.nearest - a.farthest});
      prefer(pair.a, a_, a);
      prefer(pair.b, b_, b);
    }
    return best;
  }

  // The direction in which halving makes the bounds of a form better, if it still does.
  void prefer(const OperandPlace& place, OperandTrees& side, const SquareForm& form) {
    const double bend = std::max(form.bend_u, form.bend_v);
    if (bend > 2 * result_.upper * gap())
      side.tree(place).cells.prefer(place.cell, form.bend_u == bend);
  }

  // Of a point of one side from a cell of the other one.
  double bound_of(const OperandPlace& at_point, OperandTrees& of_point, const OperandPlace& place,
                  OperandTrees& side) {
    const DistanceItem& item = side.item(place);
    ItemTree& tree = side.tree(place);
    const Cell& cell = tree.cells[place.cell];
    const Vec3 point = projected(of_point.item(at_point).patch.points(0, 0));
    const SquareForm form = square_form(cell, tree.cells.shape(), {point}, item.across(cell));
    if (!form.may_be_stationary) return kInfinity;
    prefer(place, side, form);
    return form.nearest;
  }

  // Whether Newton's method may find something nearer from the middle of the cells.
  bool is_promising(const Pair& pair, const Cell& a, const Cell& b) const {
    const int halvings = options_.enough < 0 ? kHalvingsPerStart : kHalvingsPerTurn;
    return pair.depth % halvings == halvings - 1 ||
           (!pair.left_out &&
            distance(0.5 * (a.low + a.high), 0.5 * (b.low + b.high)) < result_.upper - gap());
  }

  // Whether the least distance of a pair is known and settles it. On the way Newton's method looks
  // for a nearer one.
  bool is_proven_convex(Pair& pair) {
    const Cell& a = a_.tree(pair.a).cells[pair.a.cell];
    const Cell& b = b_.tree(pair.b).cells[pair.b.cell];
    const DistanceItem &item_a = a_.item(pair.a), &item_b = b_.item(pair.b);
    const PatchOf form_a{&item_a.patch, item_a.dimension()};
    const PatchOf form_b{&item_b.patch, item_b.dimension()};
    std::array<Vec2, 2> at_foot = best_at_;
    if (is_promising(pair, a, b)) {
      const NearPair found =
          near_pair(form_a, form_b, {at(a.u, 0.5), at(a.v, 0.5)}, {at(b.u, 0.5), at(b.v, 0.5)});
      at_foot = {found.a, found.b};
      // Where the trims leave the foot out, what they leave of the cells may be nearer, too.
      if (!take(pair, found))
        pair.left_out =
            !take(pair, near_pair({form_a.patch, form_a.dimension, a.u, a.v},
                                  {form_b.patch, form_b.dimension, b.u, b.v},
                                  {at(a.u, 0.5), at(a.v, 0.5)}, {at(b.u, 0.5), at(b.v, 0.5)}));
    } else if (best_a_ != &item_a || best_b_ != &item_b) {
      at_foot = {Vec2{at(a.u, 0.5), at(a.v, 0.5)}, Vec2{at(b.u, 0.5), at(b.v, 0.5)}};
    }
    const double bound = convex_bound(
        {&a, a_.tree(pair.a).cells.shape(), form_a}, {&b, b_.tree(pair.b).cells.shape(), form_b},
        inside(a, at_foot[0]), inside(b, at_foot[1]), result_.upper - gap(), rounding_);
    if (!is_settled(bound)) return false;
    drop(bound);
    return true;
  }

  // Keeps a pair of points if it is the nearest one so far by more than roundings: at the same
  // distance all over there is ever a nearer one. False if the trims leave it out.
  bool take(const Pair& pair, const NearPair& found) {
    const double far = distance(found.point_a, found.point_b);
    if (!(far < result_.upper - rounding_)) {
      if (far < result_.upper + gap() && centres_.empty()) add_centres(pair, found);
      return true;
    }
    if (a_.is_outside(pair.a, found.a) || b_.is_outside(pair.b, found.b)) return false;
    result_.upper = far;
    best_a_ = &a_.item(pair.a);
    best_b_ = &b_.item(pair.b);
    best_at_ = {found.a, found.b};
    direction_ = unit(found.point_a - found.point_b);
    centres_.clear();
    add_centres(pair, found);
    result_.a = a_.end(pair.a, found.a, found.point_a);
    result_.b = b_.end(pair.b, found.b, found.point_b);
    return true;
  }

  // Borders may be as near as the surfaces that have centres.
  void add_centres(const Pair& pair, const NearPair& found) {
    const Vec3 across = unit(found.point_a - found.point_b);
    add_centre(a_.item(pair.a), found.a, across);
    add_centre(b_.item(pair.b), found.b, across);
  }

  void add_centre(const DistanceItem& item, const Vec2& at, const Vec3& across) {
    if (item.dimension() < 2) return;
    auto centre = centre_of_curvature(jet_at(item.patch, at[0], at[1], 2), across);
    if (!centre) centre = centre_circle(item.patch, at);
    if (centre) centres_.push_back(*centre);
  }

  static constexpr int kDeepest = 90;  // halvings of a patch: 45 in each direction

  const DistanceOptions& options_;
  const WorkLimit limit_{options_.time_limit, options_.cancelled};
  OperandTrees a_, b_;
  double rounding_;  // of the distance of two points, model units
  double floor_;     // what differences of distances below this are worth, model units
  DistanceResult result_;
  long steps_ = 0;                        // with those over pairs of boxes, which cost no budget
  const DistanceItem* best_a_ = nullptr;  // those of the nearest points found by Newton's method
  const DistanceItem* best_b_ = nullptr;
  std::array<Vec2, 2> best_at_;
  Vec3 direction_;               // from the nearest point of b to that of a
  std::vector<Centre> centres_;  // that one of the sets may lie round there, the other one within
  double dropped_ = kInfinity;
  double reach_ = kInfinity;  // the distance is no larger, by boxes
  std::priority_queue<Pair> open_;
};

}  // namespace

PreparedSet::PreparedSet(DistanceOperand set)
    : parts_(std::make_unique<DistanceParts>(std::move(set))) {}
PreparedSet::PreparedSet(OperandParts parts)
    : parts_(std::make_unique<DistanceParts>(std::move(parts))) {}
PreparedSet::~PreparedSet() = default;
PreparedSet::PreparedSet(PreparedSet&&) noexcept = default;
PreparedSet& PreparedSet::operator=(PreparedSet&&) noexcept = default;
const DistanceOperand& PreparedSet::set() const { return parts_->set(); }
const DistanceOperand& PreparedSet::part(int number) const { return parts_->own_set(number); }

DistanceResult least_distance(const PreparedSet& a, const PreparedSet& b,
                              const DistanceOptions& options) {
  return Search(*a.parts_, *b.parts_, options).run();
}

DistanceResult least_distance(const DistanceOperand& a, const DistanceOperand& b,
                              const DistanceOptions& options) {
  return least_distance(PreparedSet(a), PreparedSet(b), options);
}

}  // namespace blossom
