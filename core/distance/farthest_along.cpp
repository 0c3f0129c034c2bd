// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a set goes along an axis.
//
// Cells of one coordinate alone are halved, those with the largest coefficient first. A set goes
// farthest in a point, at the end or where the derivative of a curve vanishes, or in a surface
// where both do; so a cell is left out if one of its derivatives has a sign wherever it is farther
// than what is known. Borders belong to the set as curves, and along a kink the derivative across
// it is not asked.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/base/work_limit.h"
#include "core/distance.h"
#include "core/distance/distance_parts.h"
#include "core/distance/height_cells.h"

namespace blossom {
namespace {

constexpr int kHalvingsPerSide = 6;     // of a cell: asking for trims takes as long as these
constexpr int kDeepestHeight = 90;      // halvings
constexpr long kCellsPerQuestion = 64;  // looked at before it is asked whether to go on

// A part, one of its items, or a cell of that.
struct HeightPlace {
  double upper = 0;  // it goes no farther
  int part = 0;
  int item = -1;
  bool on_border = false;  // the item is a curve of the part's border
  bool left = false;       // to the part's border
  int depth = -1;          // halvings; while there is no net, -1
  bool inside = false;     // of the trims
  bool split_u = true;
  HeightNet net{};
  Interval u{0, 1}, v{0, 1};

  bool operator<(const HeightPlace& other) const {
    return upper != other.upper ? upper < other.upper : depth < other.depth;
  }
};

class HeightSearch {
 public:
  HeightSearch(const DistanceParts& parts, int axis, bool backwards, double known,
               const DistanceOptions& options)
      : parts_(parts),
        options_(options),
        axis_(axis),
        sign_(backwards ? -1 : 1),
        floor_(std::max(options.resolution, kDistanceRounding * parts.scale())) {
    result_.lower = known;
  }

  FarthestResult run() {
    Vec3 direction;
    direction[axis_] = sign_;
    for (int part = 0; part < parts_.size(); ++part) {
      const double height = parts_.heights(part, direction).to;
      if (parts_.is_point(part))
        reach(height);
      else
        push({.upper = height + kDistanceRounding * parts_.scale(), .part = part});
    }
    for (long steps = 0; !open_.empty(); ++steps) {
      const bool stopped = result_.cells >= options_.budget ||
                           (steps % kCellsPerQuestion == 0 && limit_.reached() != nullptr);
      if (stopped || is_settled(open_.front().upper)) {
        left_ = std::max(left_, open_.front().upper);
        if (!is_settled(left_)) result_.status = Status::Stopped;
        break;
      }
      std::pop_heap(open_.begin(), open_.end());
      const HeightPlace place = open_.back();
      open_.pop_back();
      open(place);
    }
    const double border = std::min(result_.lower + border_gap_, border_upper_);
    result_.upper = std::max({result_.lower, left_, border});
    return result_;
  }

 private:
  const DistanceItem& item(const HeightPlace& place) const {
    const auto& items =
        place.on_border ? parts_.border(place.part).items : parts_.items(place.part);
    return items[static_cast<std::size_t>(place.item)];
  }
  bool is_settled(double upper) const { return upper <= result_.lower + floor_; }
  void reach(double height) { result_.lower = std::max(result_.lower, height); }

  void push(const HeightPlace& place) {
    if (is_settled(place.upper)) return leave(place);
    open_.push_back(place);
    std::push_heap(open_.begin(), open_.end());
  }
  void leave(const HeightPlace& place) {
    left_ = std::max(left_, place.upper);
    drop(place);
  }
  void drop(const HeightPlace& place) {
    if (place.depth >= 0) cells_.release(place.net);
  }

  void open(const HeightPlace& place) {
    if (place.left) return open_left(place);
    if (place.item < 0) return open_part(place);
    if (place.depth < 0) return open_item(place);
    open_cell(place);
  }

  void open_part(const HeightPlace& part) { push_items(part.part, parts_.items(part.part), false); }

  void push_items(int part, const std::vector<DistanceItem>& items, bool on_border) {
    for (int i = 0; i < static_cast<int>(items.size()); ++i) {
      const double height = height_of(items[static_cast<std::size_t>(i)].box);
      push({.upper = height + kDistanceRounding * parts_.scale(),
            .part = part,
            .item = i,
            .on_border = on_border});
    }
  }

  void open_item(const HeightPlace& place) {
    const DistanceItem& of = item(place);
    if (of.kind == DistanceEnd::Kind::Point)
      return reach(sign_ * projected(of.patch.points(0, 0))[axis_]);
    HeightPlace whole = place;
    whole.depth = 0;
    whole.inside = parts_.is_whole(of);
    whole.net = cells_.load(of.patch, of.rational, of.dimension() == 1, axis_, sign_);
    consider(whole);
  }

  // Keeps a cell if it may matter.
  void consider(HeightPlace& cell) {
    ++result_.cells;
    const HeightBounds bounds =
        cells_.bounds(cell.net, result_.lower, across(cell), kDistanceRounding);
    if (!bounds.may_be_highest) return leave_to_border(cell, bounds.upper);
    cell.upper = std::min(cell.upper, bounds.upper);
    cell.split_u = bounds.varies_along_u;
    push(cell);
  }

  // It goes farthest on a border, which may be farther than the curves that stand for it. Borders
  // take long to be made: where that matters, what may be farther is looked at first. A curve of
  // the border itself goes farthest at an end.
  void leave_to_border(HeightPlace& cell, double upper) {
    if (cell.on_border) return drop(cell);
    const double gap = parts_.border_gap(cell.part);
    if (gap > floor_ && !is_settled(upper)) {
      cell.upper = std::min({cell.upper, upper, border_height(cell.part)});
      cell.left = true;
      return push(cell);
    }
    end_at_border(cell, upper, gap);
  }

  // The border of a part goes no farther.
  double border_height(int part) const {
    const std::optional<Box> box = parts_.border_box(part);
    if (!box) return kInfinity;
    return height_of(*box) + kDistanceRounding * parts_.scale();
  }
  double height_of(const Box& box) const { return sign_ > 0 ? box.high[axis_] : -box.low[axis_]; }

  void open_left(const HeightPlace& cell) {
    double gap = parts_.border_gap(cell.part);
    if (open_border(cell.part))
      gap = parts_.border(cell.part).gap;
    else
      reach_corner(cell);
    end_at_border(cell, cell.upper, gap);
  }

  void end_at_border(const HeightPlace& cell, double upper, double gap) {
    border_upper_ = std::max(border_upper_, upper);
    border_gap_ = std::max(border_gap_, gap);
    drop(cell);
  }

  // False if the border is not known any better than the curves of the set.
  bool open_border(int part) {
    const std::vector<DistanceItem>& items = parts_.border(part).items;
    if (items.empty()) return false;
    opened_.resize(static_cast<std::size_t>(parts_.size()));
    if (std::exchange(opened_[static_cast<std::size_t>(part)], char{1})) return true;
    for (const DistanceItem& item : items)
      for (const int row : {0, item.patch.points.rows() - 1})
        reach(sign_ * projected(item.patch.points(row, 0))[axis_]);
    push_items(part, items, true);
    return true;
  }

  std::array<bool, 2> across(const HeightPlace& place) const {
    Cell cell;
    cell.u = place.u;
    cell.v = place.v;
    return item(place).across(cell);
  }

  void open_cell(HeightPlace cell) {
    // Trims take long to be made, so they are asked last.
    const bool asks = !cell.inside && cell.depth > 0 && cell.depth % kHalvingsPerSide == 0;
    if (asks) {
      const TrimSide side =
          parts_.side(cell.part, item(cell), {cell.u.from, cell.v.from}, {cell.u.to, cell.v.to});
      if (side == TrimSide::Outside) return drop(cell);
      cell.inside = side == TrimSide::Inside;
    }
    if (asks || cell.inside) reach_corner(cell);
    if (is_settled(cell.upper) || cell.depth == kDeepestHeight) return leave(cell);
    ++cell.depth;
    HeightPlace high = cell;
    high.net = cells_.split(cell.net, cell.split_u);
    Interval& low_side = cell.split_u ? cell.u : cell.v;
    Interval& high_side = cell.split_u ? high.u : high.v;
    low_side.to = high_side.from = 0.5 * (low_side.from + low_side.to);
    consider(cell);
    consider(high);
  }

  // Of a cell that a trim cuts the trim is asked about the corner alone that goes farthest.
  void reach_corner(const HeightPlace& cell) {
    double height = -kInfinity;
    Vec2 at;
    for (const bool last_row : {false, true})
      for (const bool last_column : {false, true}) {
        const double there = cells_.corner(cell.net, last_row, last_column);
        if (there <= height) continue;
        height = there;
        at = {last_row ? cell.u.to : cell.u.from, last_column ? cell.v.to : cell.v.from};
      }
    if (height <= result_.lower) return;
    if (cell.inside || parts_.side(cell.part, item(cell), at, at) != TrimSide::Outside)
      reach(height);
  }

  const DistanceParts& parts_;
  const DistanceOptions& options_;
  const WorkLimit limit_{options_.time_limit, options_.cancelled};
  int axis_;
  double sign_;
  double floor_;  // what differences below this are worth, model units
  FarthestResult result_;
  double left_ = -kInfinity;  // what was settled goes no farther
  // What was left to curves goes no farther, nor farther than they do by more than the gap.
  double border_upper_ = -kInfinity;
  double border_gap_ = 0;
  std::vector<char> opened_;       // by part: its border is looked at
  std::vector<HeightPlace> open_;  // a heap
  HeightCells cells_;
};

}  // namespace

FarthestResult farthest_along(const PreparedSet& set, int axis, bool backwards, double known,
                              const DistanceOptions& options) {
  if (axis < 0 || axis > 2) throw InvalidInput("farthest_along: there are three axes");
  return HeightSearch(*set.parts_, axis, backwards, known, options).run();
}

}  // namespace blossom
