// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/bounds/box_tree.h"
#include "core/forms/evaluation.h"
#include "core/intersection/cell_tree.h"
#include "core/queries/nearest_pair.h"

namespace blossom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Distances below this, relative to the largest coordinate, are roundings.
constexpr double kRounding = 64 * 0x1p-53;
// Off the middle, so that cells of symmetric shapes have no stationary points on their borders.
constexpr double kCut = 0.5 - 1.0 / 64;
// The bound from squares costs the square of the number of control points.
constexpr int kMostPoints = 64;
// Newton's method starts at every so many halvings of a pair.
constexpr int kHalvingsPerStart = 3;

// A point, a curve or a patch of a surface, all as patches: a curve has no width.
struct Item {
  DistanceEnd::Kind kind = DistanceEnd::Kind::Point;
  int index = 0;
  int row = 0, column = 0;  // of a surface's patch
  RationalBezierPatch patch;
  bool rational = false;
  Box box;
  /// By direction, at the low and the high border: the surface goes on there, but with a kink.
  std::array<std::array<bool, 2>, 2> kinked{};

  int dimension() const { return static_cast<int>(kind); }

  // Whether a line that is nearest within a cell must be across its derivatives.
  std::array<bool, 2> across(const Cell& cell) const {
    const auto at_kink = [&](std::size_t k, const Interval& side) {
      return (side.from == 0 && kinked[k][0]) || (side.to == 1 && kinked[k][1]);
    };
    return {dimension() > 0 && !at_kink(0, cell.u), dimension() > 1 && !at_kink(1, cell.v)};
  }
};

Vec3 projected(const Vec4& p) { return Vec3{p[0], p[1], p[2]} * (1 / p[3]); }

// Whether two patches that share a border go on in different directions there. Parts of one
// polynomial agree to rounding.
bool has_kink(const RationalBezierPatch& low, const RationalBezierPatch& high, bool along_u) {
  constexpr double kSmooth = 1e-10;
  const Grid<Vec4>&p = low.points, &q = high.points;
  const int count = along_u ? p.columns() : p.rows();
  const auto point = [&](const Grid<Vec4>& net, int across, int along) {
    return projected(along_u ? net(across, along) : net(along, across));
  };
  const int last = (along_u ? p.rows() : p.columns()) - 1;
  for (int k = 0; k < count; ++k) {
    const Vec3 before = point(p, last, k) - point(p, last - 1, k);
    const Vec3 after = point(q, 1, k) - point(q, 0, k);
    const double lengths = norm(before) * norm(after);
    if (!(lengths > 0) || norm(cross(before, after)) > kSmooth * lengths || dot(before, after) < 0)
      return true;
  }
  return false;
}

Vec4 homogeneous(const Vec3& p) { return {p[0], p[1], p[2], 1}; }

RationalBezierPatch as_patch(const std::vector<Vec4>& points) {
  const int count = static_cast<int>(points.size());
  RationalBezierPatch patch{Grid<Vec4>(count, 2)};
  for (int i = 0; i < count; ++i)
    patch.points(i, 0) = patch.points(i, 1) = points[static_cast<std::size_t>(i)];
  return patch;
}

}  // namespace

struct PreparedSet::Items {
  explicit Items(MeasuredSet measured_set) : set(std::move(measured_set)) {
    for (std::size_t i = 0; i < set.points.size(); ++i)
      add(DistanceEnd::Kind::Point, i,
          as_patch({homogeneous(set.points[i]), homogeneous(set.points[i])}));
    for (std::size_t i = 0; i < set.curves.size(); ++i)
      add(DistanceEnd::Kind::Curve, i, as_patch(set.curves[i].points));
    for (std::size_t i = 0; i < set.surfaces.size(); ++i) {
      validate(set.surfaces[i], ("number " + std::to_string(i)).c_str());
      for (int row = 0; row < set.surfaces[i].patches.rows(); ++row)
        for (int column = 0; column < set.surfaces[i].patches.columns(); ++column) {
          add(DistanceEnd::Kind::Surface, i, set.surfaces[i].patches(row, column));
          all.back().row = row;
          all.back().column = column;
          all.back().kinked = kinks(set.surfaces[i].patches, row, column);
        }
    }
    if (all.empty()) throw InvalidInput("least_distance: a set is empty");
    std::vector<Box> boxes;
    for (const Item& item : all) boxes.push_back(item.box);
    tree = BoxTree(boxes);
  }

  const Item& operator[](int item) const { return all[static_cast<std::size_t>(item)]; }

  // Of trimmed surfaces it is not known where they have points.
  bool is_whole(int item) const { return !set.trims || (*this)[item].dimension() < 2; }

  Vec2 parameters(const Item& item, const Vec2& local) const {
    if (item.kind != DistanceEnd::Kind::Surface) return {local[0], 0};
    const BezierSurface& s = set.surfaces[static_cast<std::size_t>(item.index)];
    const auto i = static_cast<std::size_t>(item.row), j = static_cast<std::size_t>(item.column);
    return {parameter_at(s.u_law, {s.u_knots[i], s.u_knots[i + 1]}, local[0]),
            parameter_at(s.v_law, {s.v_knots[j], s.v_knots[j + 1]}, local[1])};
  }

  TrimSide side(const Item& item, const Vec2& low, const Vec2& high) const {
    if (item.kind != DistanceEnd::Kind::Surface || !set.trims) return TrimSide::Inside;
    return set.trims(item.index, parameters(item, low), parameters(item, high));
  }

  static std::array<std::array<bool, 2>, 2> kinks(const Grid<RationalBezierPatch>& patches, int row,
                                                  int column) {
    const RationalBezierPatch& own = patches(row, column);
    return {{{row > 0 && has_kink(patches(row - 1, column), own, true),
              row + 1 < patches.rows() && has_kink(own, patches(row + 1, column), true)},
             {column > 0 && has_kink(patches(row, column - 1), own, false),
              column + 1 < patches.columns() && has_kink(own, patches(row, column + 1), false)}}};
  }

  void add(DistanceEnd::Kind kind, std::size_t index, RationalBezierPatch patch) {
    Item item;
    item.kind = kind;
    item.index = static_cast<int>(index);
    for (const Vec4& p : patch.points.values()) {
      const Vec3 point = Vec3{p[0], p[1], p[2]} * (1 / p[3]);
      if (!(p[3] > 0) || !std::isfinite(dot(p, p)))
        throw InvalidInput("least_distance: a number is not finite or a weight not positive");
      item.box = joined(item.box, {point, point});
      item.rational = item.rational || p[3] != 1;
      scale = std::max(scale, max_norm(point));
    }
    item.patch = std::move(patch);
    all.push_back(std::move(item));
  }

  MeasuredSet set;
  std::vector<Item> all;
  BoxTree tree{{}};
  double scale = 0;  // largest absolute coordinate
};

namespace {

struct Pair {
  double lower = 0;
  int item_a = 0, cell_a = 0;
  int item_b = 0, cell_b = 0;
  int depth = 0;
  bool operator<(const Pair& other) const { return lower > other.lower; }  // the nearest on top
};

template <class Items>
class Search {
 public:
  Search(const Items& a, const Items& b, const DistanceOptions& options)
      : options_(options),
        a_(a),
        b_(b),
        trees_a_(a.all.size()),
        trees_b_(b.all.size()),
        rounding_(kRounding * (a.scale + b.scale)) {
    result_.upper = kInfinity;
  }

  DistanceResult run() {
    add_items();
    double lowest = kInfinity;
    while (!open_.empty()) {
      const Pair pair = open_.top();
      lowest = pair.lower;
      if (is_settled(pair.lower)) break;
      if (result_.pairs >= options_.budget) {
        result_.status = Status::Stopped;
        break;
      }
      open_.pop();
      lowest = kInfinity;
      ++result_.pairs;
      examine(pair);
    }
    result_.lower = std::max(0.0, std::min({lowest, dropped_, result_.upper}));
    // Cells at the limit of halving leave a gap, too.
    if (options_.enough < 0 && result_.lower < result_.upper - (1 + 1e-6) * gap())
      result_.status = Status::Stopped;
    return result_;
  }

 private:
  double gap() const { return std::max(kDistanceAccuracy * result_.upper, rounding_); }

  // No pair at this distance or more matters any longer.
  bool is_settled(double lower) const {
    return lower >= result_.upper - gap() ||
           (options_.enough >= 0 && (lower > options_.enough || result_.upper <= options_.enough));
  }

  // Pairs of items near enough, by their boxes.
  void add_items() {
    double bound = kInfinity;  // square of a distance that is not exceeded
    for (int i = 0; i < static_cast<int>(a_.all.size()); ++i)
      if (a_.is_whole(i)) bound = std::min(bound, farthest(a_[i].box, b_.tree.box()));
    for (int i = 0; i < static_cast<int>(a_.all.size()); ++i) {
      const Box box = widened(a_[i].box, rounding_);
      b_.tree.for_each_near(box, bound, [&](int j) {
        const Box& other = b_[j].box;
        if (a_.is_whole(i) && b_.is_whole(j)) bound = std::min(bound, farthest(box, other));
        open_.push({(1 - 1e-14) * std::sqrt(squared_distance(box, other)), i, 0, j, 0, 0});
        return bound;
      });
    }
  }

  static double farthest(const Box& a, const Box& b) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double most = std::max(a.high[k] - b.low[k], b.high[k] - a.low[k]);
      sum += most * most;
    }
    return sum;
  }

  void examine(const Pair& pair) {
    Tree& tree_a = tree(a_, trees_a_, pair.item_a);
    Tree& tree_b = tree(b_, trees_b_, pair.item_b);
    const double before = pair.lower;
    if (pair.depth % kHalvingsPerStart == 0) start_from(pair);
    const Cell cell_a = tree_a.cells[pair.cell_a], cell_b = tree_b.cells[pair.cell_b];
    const bool split_a = can_split(pair.item_a, a_, cell_a) &&
                         (cell_a.extent >= cell_b.extent || !can_split(pair.item_b, b_, cell_b));
    if (!split_a && !can_split(pair.item_b, b_, cell_b)) {
      dropped_ = std::min(dropped_, before);  // two points, or cells at the limit of halving
      return;
    }
    const int low = (split_a ? tree_a : tree_b).split(split_a ? pair.cell_a : pair.cell_b);
    for (const int child : {low, low + 1}) {
      Pair next = pair;
      (split_a ? next.cell_a : next.cell_b) = child;
      ++next.depth;
      consider(next, tree_a, tree_b, split_a);
    }
  }

  // The cells of an item, and how those that were asked about lie to the trims.
  struct Tree {
    CellTree cells;
    std::vector<std::optional<TrimSide>> sides{std::nullopt};

    int split(int cell) {
      const int low = cells.split(cell);
      const auto size = static_cast<std::size_t>(cells.size());
      if (sides.size() < size) {
        // Halves of a cell inside are inside.
        const auto known = sides[static_cast<std::size_t>(cell)];
        sides.resize(size, known == TrimSide::Inside ? known : std::nullopt);
      }
      return low;
    }
  };

  static Tree& tree(const Items& items, std::vector<std::unique_ptr<Tree>>& trees, int item) {
    auto& made = trees[static_cast<std::size_t>(item)];
    const Item& it = items[item];
    if (!made)
      made = std::make_unique<Tree>(
          Tree{CellTree(it.patch, it.rational, Vec3{}, CellForm::Bezier, kCut)});
    return *made;
  }

  static bool is_outside(const Items& items, const Item& item, Tree& tree, int index) {
    auto& side = tree.sides[static_cast<std::size_t>(index)];
    const Cell& cell = tree.cells[index];
    if (!side) side = items.side(item, {cell.u.from, cell.v.from}, {cell.u.to, cell.v.to});
    return side == TrimSide::Outside;
  }

  static bool can_split(int item, const Items& items, const Cell& cell) {
    return items[item].dimension() > 0 && cell.depth < kDeepest;
  }

  void consider(Pair& pair, Tree& tree_a, Tree& tree_b, bool new_a) {
    const Cell& cell_a = tree_a.cells[pair.cell_a];
    const Cell& cell_b = tree_b.cells[pair.cell_b];
    const Item& item_a = a_[pair.item_a];
    const Item& item_b = b_[pair.item_b];
    const NetShape &shape_a = tree_a.cells.shape(), &shape_b = tree_b.cells.shape();
    const int points_a = shape_a.plane_size(), points_b = shape_b.plane_size();
    pair.lower =
        std::max(pair.lower, distance_bound({&cell_a, points_a}, {&cell_b, points_b}, direction_));
    if (!is_settled(pair.lower) && std::min(item_a.dimension(), item_b.dimension()) == 0 &&
        std::max(points_a, points_b) <= kMostPoints) {
      const bool point_a = item_a.dimension() == 0;
      const Vec3 point = projected((point_a ? item_a : item_b).patch.points(0, 0));
      pair.lower = std::max(pair.lower, point_a ? distance_bound(cell_b, shape_b, point)
                                                : distance_bound(cell_a, shape_a, point));
    }
    if (is_settled(pair.lower)) {
      dropped_ = std::min(dropped_, pair.lower);
      return;
    }
    if (!may_be_normal(cell_a, item_a.across(cell_a), cell_b, item_b.across(cell_b))) return;
    if (new_a ? is_outside(a_, item_a, tree_a, pair.cell_a)
              : is_outside(b_, item_b, tree_b, pair.cell_b))
      return;
    open_.push(pair);
  }

  // A pair of near points, by Newton's method from the middle of the cells.
  void start_from(const Pair& pair) {
    const Item& item_a = a_[pair.item_a];
    const Item& item_b = b_[pair.item_b];
    const Cell& a = tree(a_, trees_a_, pair.item_a).cells[pair.cell_a];
    const Cell& b = tree(b_, trees_b_, pair.item_b).cells[pair.cell_b];
    const NearPair found =
        near_pair({&item_a.patch, item_a.dimension()}, {&item_b.patch, item_b.dimension()},
                  {at(a.u, 0.5), at(a.v, 0.5)}, {at(b.u, 0.5), at(b.v, 0.5)});
    const double far = distance(found.point_a, found.point_b);
    if (!(far < result_.upper)) return;
    if (a_.side(item_a, found.a, found.a) == TrimSide::Outside ||
        b_.side(item_b, found.b, found.b) == TrimSide::Outside)
      return;
    result_.upper = far;
    direction_ = unit(found.point_a - found.point_b);
    result_.a = {item_a.kind, item_a.index, a_.parameters(item_a, found.a), found.point_a};
    result_.b = {item_b.kind, item_b.index, b_.parameters(item_b, found.b), found.point_b};
  }

  static constexpr int kDeepest = 90;  // halvings of a patch: 45 in each direction

  DistanceOptions options_;
  const Items& a_;
  const Items& b_;
  std::vector<std::unique_ptr<Tree>> trees_a_, trees_b_;  // made when a pair needs them
  double rounding_;
  DistanceResult result_;
  Vec3 direction_;
  double dropped_ = kInfinity;
  std::priority_queue<Pair> open_;
};

// One border of a patch.
RationalBezierCurve border(const RationalBezierPatch& patch, bool along_u, bool last) {
  const Grid<Vec4>& net = patch.points;
  RationalBezierCurve curve;
  for (int k = 0; k < (along_u ? net.rows() : net.columns()); ++k)
    curve.points.push_back(along_u ? net(k, last ? net.columns() - 1 : 0)
                                   : net(last ? net.rows() - 1 : 0, k));
  return curve;
}

}  // namespace

MeasuredSet measured(const Vec3& point) { return {{point}, {}, {}}; }

MeasuredSet measured(const RationalBezierCurve& curve) {
  if (curve.degree() < 1) throw InvalidInput("measured: a curve needs two points at least");
  return {{projected(curve.points.front()), projected(curve.points.back())}, {curve}, {}};
}

MeasuredSet measured(const BezierSurface& surface) {
  validate(surface, "to measure");
  MeasuredSet set{{}, {}, {surface}};
  const auto& patches = surface.patches;
  const auto add = [&](const RationalBezierPatch& patch, bool along_u, bool last) {
    set.curves.push_back(border(patch, along_u, last));
    set.points.push_back(projected(set.curves.back().points.front()));
    set.points.push_back(projected(set.curves.back().points.back()));
  };
  for (const bool last : {false, true}) {
    for (int i = 0; i < patches.rows(); ++i)
      add(patches(i, last ? patches.columns() - 1 : 0), true, last);
    for (int j = 0; j < patches.columns(); ++j)
      add(patches(last ? patches.rows() - 1 : 0, j), false, last);
  }
  return set;
}

PreparedSet::PreparedSet(MeasuredSet set) : items_(std::make_unique<Items>(std::move(set))) {}
PreparedSet::~PreparedSet() = default;
PreparedSet::PreparedSet(PreparedSet&&) noexcept = default;
PreparedSet& PreparedSet::operator=(PreparedSet&&) noexcept = default;
const MeasuredSet& PreparedSet::set() const { return items_->set; }

DistanceResult least_distance(const PreparedSet& a, const PreparedSet& b,
                              const DistanceOptions& options) {
  return Search<PreparedSet::Items>(*a.items_, *b.items_, options).run();
}

DistanceResult least_distance(const MeasuredSet& a, const MeasuredSet& b,
                              const DistanceOptions& options) {
  return least_distance(PreparedSet(a), PreparedSet(b), options);
}

}  // namespace blossom
