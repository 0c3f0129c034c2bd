// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/distance_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/math/vec.h"

namespace blossom {
namespace {

Vec4 homogeneous(const Vec3& p) { return {p[0], p[1], p[2], 1}; }

// The border of a net at its first or last row (along u) or column, and the legs across it, about
// one of its points: with X' = X - w O the derivative across the border is that of X' / w. Weights
// count as the lengths by which they move points as far as `reach` from O.
struct BorderLegs {
  std::vector<Vec4> border;
  std::vector<Vec4> legs;
};

BorderLegs border_legs(const Grid<Vec4>& net, bool along_u, bool at_end, const Vec3& origin,
                       double reach) {
  const int count = along_u ? net.columns() : net.rows();
  const int last = (along_u ? net.rows() : net.columns()) - 1;
  const auto about = [&](Vec4 x) {
    for (int i = 0; i < 3; ++i) x[i] -= x[3] * origin[i];
    x[3] *= reach;
    return x;
  };
  BorderLegs result;
  for (int k = 0; k < count; ++k) {
    const auto point = [&](int across) { return along_u ? net(across, k) : net(k, across); };
    result.border.push_back(about(point(at_end ? last : 0)));
    result.legs.push_back(about(at_end ? point(last) - point(last - 1) : point(1) - point(0)));
  }
  return result;
}

double product(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += dot(a[k], b[k]);
  return sum;
}

// Less the multiple of the border that is nearest to them: adding one to all of X_u leaves the
// derivative of X / w as it is.
std::vector<Vec4> reduced(std::vector<Vec4> legs, const std::vector<Vec4>& border) {
  const double part = product(legs, border) / product(border, border);
  for (std::size_t k = 0; k < legs.size(); ++k) legs[k] -= part * border[k];
  return legs;
}

// Whether two patches that share a border may go on in different directions there. They do not if
// all legs behind it are those before it times one positive number, but for a multiple of the
// border; parts of one polynomial or of one arc are so to rounding. Legs that are parallel by
// different numbers do not sum to parallel derivatives.
bool has_kink(const RationalBezierPatch& low, const RationalBezierPatch& high, bool along_u) {
  constexpr double kSmooth = 1e-10;
  const Vec3 origin = projected(high.points(0, 0));
  double reach = 0;
  for (const Vec4& p : high.points.values())
    reach = std::max(reach, distance(projected(p), origin));
  const BorderLegs there = border_legs(low.points, along_u, true, origin, reach);
  const BorderLegs here = border_legs(high.points, along_u, false, origin, reach);
  if (there.legs.size() != here.legs.size()) return true;
  const std::vector<Vec4> before = reduced(there.legs, here.border);
  const std::vector<Vec4> after = reduced(here.legs, here.border);
  const double squares = product(before, before), products = product(before, after);
  if (!(products > 0)) return true;
  const double ratio = products / squares;
  for (std::size_t k = 0; k < before.size(); ++k)
    if (!(max_norm(after[k] - ratio * before[k]) <= kSmooth * ratio * std::sqrt(squares)))
      return true;
  return false;
}

std::array<std::array<bool, 2>, 2> kinks(const Grid<RationalBezierPatch>& patches, int row,
                                         int column) {
  const RationalBezierPatch& own = patches(row, column);
  return {{{row > 0 && has_kink(patches(row - 1, column), own, true),
            row + 1 < patches.rows() && has_kink(own, patches(row + 1, column), true)},
           {column > 0 && has_kink(patches(row, column - 1), own, false),
            column + 1 < patches.columns() && has_kink(own, patches(row, column + 1), false)}}};
}

RationalBezierPatch as_patch(const std::vector<Vec4>& points) {
  const int count = static_cast<int>(points.size());
  RationalBezierPatch patch{Grid<Vec4>(count, 2)};
  for (int i = 0; i < count; ++i)
    patch.points(i, 0) = patch.points(i, 1) = points[static_cast<std::size_t>(i)];
  return patch;
}

Box checked_box(std::span<const Vec4> points) {
  Box box;
  for (const Vec4& p : points) {
    if (!(p[3] > 0) || !std::isfinite(dot(p, p)))
      throw InvalidInput("least_distance: a number is not finite or a weight not positive");
    const Vec3 point = projected(p);
    box = joined(box, {point, point});
  }
  return box;
}

Box checked_box(const DistanceOperand& set, std::size_t surface) {
  validate(set.surfaces[surface], ("number " + std::to_string(surface)).c_str());
  Box box;
  for (const RationalBezierPatch& patch : set.surfaces[surface].patches.values())
    box = joined(box, checked_box(patch.points.values()));
  return box;
}

DistanceItem item_of(DistanceEnd::Kind kind, std::size_t index, RationalBezierPatch patch) {
  DistanceItem item;
  item.kind = kind;
  item.index = static_cast<int>(index);
  item.u = {0, 1};
  item.box = checked_box(patch.points.values());
  for (const Vec4& p : patch.points.values()) item.rational = item.rational || p[3] != 1;
  item.patch = std::move(patch);
  return item;
}

void add_point(const DistanceOperand& set, std::size_t i, std::vector<DistanceItem>& items) {
  const Vec4 p = homogeneous(set.points[i]);
  items.push_back(item_of(DistanceEnd::Kind::Point, i, as_patch({p, p})));
}

void add_curve(const DistanceOperand& set, std::size_t i, std::vector<DistanceItem>& items) {
  items.push_back(item_of(DistanceEnd::Kind::Curve, i, as_patch(set.curves[i].points)));
}

void add_surface(const DistanceOperand& set, std::size_t number, std::vector<DistanceItem>& items) {
  const BezierSurface& surface = set.surfaces[number];
  for (int row = 0; row < surface.patches.rows(); ++row)
    for (int column = 0; column < surface.patches.columns(); ++column) {
      items.push_back(item_of(DistanceEnd::Kind::Surface, number, surface.patches(row, column)));
      DistanceItem& item = items.back();
      const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
      item.u = {surface.u_knots[i], surface.u_knots[i + 1]};
      item.v = {surface.v_knots[j], surface.v_knots[j + 1]};
      item.u_law = surface.u_law;
      item.v_law = surface.v_law;
      item.kinked = kinks(surface.patches, row, column);
    }
}

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

DistanceOperand measured(const Vec3& point) { return {{point}, {}, {}}; }

DistanceOperand measured(const RationalBezierCurve& curve) {
  if (curve.degree() < 1) throw InvalidInput("measured: a curve needs two points at least");
  return {{projected(curve.points.front()), projected(curve.points.back())}, {curve}, {}};
}

DistanceOperand measured(const BezierSurface& surface) {
  validate(surface, "to measure");
  DistanceOperand set{{}, {}, {surface}};
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

Vec2 DistanceItem::parameters(const Vec2& local) const {
  if (kind != DistanceEnd::Kind::Surface) return {local[0], 0};
  return {parameter_at(u_law, u, local[0]), parameter_at(v_law, v, local[1])};
}

std::array<bool, 2> DistanceItem::across(const Cell& cell) const {
  const auto at_kink = [&](std::size_t k, const Interval& side) {
    return (side.from == 0 && kinked[k][0]) || (side.to == 1 && kinked[k][1]);
  };
  return {dimension() > 0 && !at_kink(0, cell.u), dimension() > 1 && !at_kink(1, cell.v)};
}

DistanceParts::DistanceParts(DistanceOperand set) : set_(std::move(set)) {
  const std::size_t points = set_.points.size(), curves = set_.curves.size();
  parts_ = std::vector<Part>(points + curves + set_.surfaces.size());
  for (std::size_t i = 0; i < curves; ++i)
    parts_[points + i].box = checked_box(set_.curves[i].points);
  for (std::size_t i = 0; i < set_.surfaces.size(); ++i)
    parts_[points + curves + i].box = checked_box(set_, i);
  finish();
}

DistanceParts::DistanceParts(OperandParts parts)
    : hulls_(std::move(parts.hulls)),
      set_{std::move(parts.points), {}, {}, std::move(parts.trims)},
      make_(std::move(parts.make)),
      borders_(std::move(parts.borders)) {
  const std::size_t points = set_.points.size();
  parts_ = std::vector<Part>(points + hulls_.size());
  for (std::size_t i = 0; i < hulls_.size(); ++i) {
    Box box;
    for (const Vec3& p : hulls_[i].points) {
      if (!std::isfinite(dot(p, p))) throw InvalidInput("least_distance: a hull is not finite");
      box = joined(box, {p, p});
    }
    parts_[points + i].box = widened(box, hulls_[i].margin);
  }
  finish();
}

void DistanceParts::finish() {
  if (parts_.empty()) throw InvalidInput("least_distance: a set is empty");
  for (std::size_t i = 0; i < set_.points.size(); ++i)
    parts_[i].box = checked_box(std::array{homogeneous(set_.points[i])});
  for (const Part& part : parts_) bounds_ = joined(bounds_, part.box);
  scale_ = std::max(max_norm(bounds_.low), max_norm(bounds_.high));
}

const BoxTree& DistanceParts::tree() const {
  std::call_once(tree_once_, [&] {
    std::vector<Box> boxes;
    boxes.reserve(parts_.size());
    for (const Part& part : parts_) boxes.push_back(part.box);
    tree_ = BoxTree(boxes);
  });
  return tree_;
}

Interval DistanceParts::heights(int part, const Vec3& direction) const {
  if (hulls_.empty() || is_point(part)) {
    double middle = 0, radius = 0;
    for (int k = 0; k < 3; ++k) {
      middle += 0.5 * direction[k] * (box(part).low[k] + box(part).high[k]);
      radius += 0.5 * std::abs(direction[k]) * (box(part).high[k] - box(part).low[k]);
    }
    return {middle - radius, middle + radius};
  }
  const HullBound& hull = hulls_[static_cast<std::size_t>(part - points())];
  Interval range{dot(direction, hull.points[0]), dot(direction, hull.points[0])};
  for (const Vec3& p : hull.points) {
    const double height = dot(direction, p);
    range = {std::min(range.from, height), std::max(range.to, height)};
  }
  // A margin of three coordinates is at most sqrt(3) of it.
  return {range.from - 2 * hull.margin, range.to + 2 * hull.margin};
}

const DistanceParts::Made& DistanceParts::made(int part) const {
  Part& found = parts_[static_cast<std::size_t>(part)];
  std::call_once(found.once, [&] { found.made = make(part); });
  return *found.made;
}

std::unique_ptr<DistanceParts::Made> DistanceParts::make(int part) const {
  auto made = std::make_unique<Made>();
  const auto number = static_cast<std::size_t>(part);
  const std::size_t points = set_.points.size(), curves = set_.curves.size();
  if (is_point(part)) {
    add_point(set_, number, made->items);
  } else if (!make_) {
    number < points + curves ? add_curve(set_, number - points, made->items)
                             : add_surface(set_, number - points - curves, made->items);
  } else {
    made->own = make_(part - static_cast<int>(points));
    for (std::size_t i = 0; i < made->own.points.size(); ++i) add_point(made->own, i, made->items);
    for (std::size_t i = 0; i < made->own.curves.size(); ++i) add_curve(made->own, i, made->items);
    for (std::size_t i = 0; i < made->own.surfaces.size(); ++i) {
      validate(made->own.surfaces[i], "of a part");
      add_surface(made->own, i, made->items);
    }
  }
  if (made->items.empty())
    throw InvalidInput("distance: part " + std::to_string(part) + " has no points");
  std::vector<Box> boxes;
  for (const DistanceItem& item : made->items) boxes.push_back(item.box);
  made->tree = BoxTree(boxes);
  return made;
}

std::optional<Box> DistanceParts::border_box(int part) const {
  if (hulls_.empty() || is_point(part)) return {};
  const HullBound& hull = hulls_[static_cast<std::size_t>(part - points())];
  if (hull.border_points.empty()) return {};
  const Vec3 gap{hull.border_gap, hull.border_gap, hull.border_gap};
  Box box;
  for (const Vec3& p : hull.border_points) box = joined(box, {p - gap, p + gap});
  return box;
}

const DistanceParts::Border& DistanceParts::border(int part) const {
  Part& found = parts_[static_cast<std::size_t>(part)];
  std::call_once(found.border_once, [&] {
    if (!borders_ || is_point(part)) return;
    const auto known = borders_(part - points());
    if (!known) return;
    const DistanceOperand set{{}, known->curves, {}};
    for (std::size_t i = 0; i < set.curves.size(); ++i) add_curve(set, i, found.border.items);
    found.border.gap = known->gap;
  });
  return found.border;
}

const DistanceOperand& DistanceParts::own_set(int part) const { return made(part + points()).own; }

bool DistanceParts::is_exact(int part) const {
  const std::vector<BezierSurface>& surfaces = make_ ? made(part).own.surfaces : set_.surfaces;
  return std::ranges::all_of(items(part), [&](const DistanceItem& item) {
    return item.dimension() < 2 || surfaces[static_cast<std::size_t>(item.index)].error == 0;
  });
}

TrimSide DistanceParts::side(int part, const DistanceItem& item, const Vec2& low,
                             const Vec2& high) const {
  if (item.kind != DistanceEnd::Kind::Surface || !set_.trims) return TrimSide::Inside;
  const int surface = make_ ? part - points() : item.index;
  return set_.trims(surface, item.parameters(low), item.parameters(high));
}

DistanceEnd DistanceParts::end(int part, const DistanceItem& item, const Vec2& local,
                               const Vec3& point) const {
  const bool in_part = make_ && !is_point(part);
  return {item.kind, item.index, item.parameters(local), point, in_part ? part - points() : -1};
}

}  // namespace blossom
