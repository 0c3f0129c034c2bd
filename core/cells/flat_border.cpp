// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/flat_border.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

constexpr double kStraightBorder = 1e-3;  // of its length: what is off a line by less has no plane

// Differences along u, or else along v.
RationalBezierPatch steps_of(const RationalBezierPatch& patch, bool by_u) {
  const Grid<Vec4>& p = patch.points;
  const int rows = p.rows() - (by_u ? 1 : 0), columns = p.columns() - (by_u ? 0 : 1);
  if (rows == 0 || columns == 0) return {Grid<Vec4>(1, 1)};
  Grid<Vec4> steps(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) steps(i, j) = (by_u ? p(i + 1, j) : p(i, j + 1)) - p(i, j);
  return {steps};
}

// Of the first coordinate over a rectangle.
Interval range_over(const RationalBezierPatch& patch, const Interval& u, const Interval& v,
                    double rounding) {
  const RationalBezierPatch piece = sub_patch(patch, u, v);
  Interval range{kUnbounded, -kUnbounded};
  for (const Vec4& p : piece.points.values()) {
    range.from = std::min(range.from, p[0]);
    range.to = std::max(range.to, p[0]);
  }
  return {range.from - rounding, range.to + rounding};
}

// r d / (2 root): d of either sign, r and root not negative.
Interval change_of_root(const Interval& r, const Interval& d, const Interval& root) {
  return {d.from < 0 ? r.to * d.from / (2 * root.from) : r.from * d.from / (2 * root.to),
          d.to > 0 ? r.to * d.to / (2 * root.from) : r.from * d.to / (2 * root.to)};
}

Vec3 farthest(const std::vector<Vec3>& points, const Vec3& from, const Vec3& axis) {
  Vec3 found = from;
  double most = 0;
  for (const Vec3& p : points) {
    const Vec3 step = p - from;
    const double far = norm(step - axis * dot(axis, step));
    if (far > most) {
      most = far;
      found = p;
    }
  }
  return found;
}

}  // namespace

int FlatBorder::degree_across(const RationalBezierPatch& patch) const {
  return across_u() ? patch.degree_u() : patch.degree_v();
}

Vec3 FlatBorder::point(const RationalBezierPatch& patch, int inwards, int along) const {
  const int i = is_low() ? inwards : degree_across(patch) - inwards;
  const Vec4& p = across_u() ? patch.points(i, along) : patch.points(along, i);
  return {p[0], p[1], p[2]};
}

std::vector<Vec3> FlatBorder::points_in_rows(SurfaceCells& cells, int first, int last) const {
  std::vector<Vec3> points;
  for (int patch = 0; patch < cells.patches(); ++patch) {
    if (!place_of(cells.span_u(patch), cells.span_v(patch))) continue;
    const RationalBezierPatch& net = cells.tree(patch).patch();
    const int along = across_u() ? net.degree_v() : net.degree_u();
    for (int i = 0; i <= along; ++i)
      for (int row = first; row <= last; ++row) points.push_back(point(net, row, i));
  }
  return points;
}

// The plane through three points of the border that are far from each other.
bool FlatBorder::find_plane(const std::vector<Vec3>& points, double tolerance) {
  in_plane_ = points.front();
  const Vec3 end = farthest(points, in_plane_, {}), line = unit(end - in_plane_);
  const Vec3 third = farthest(points, in_plane_, line) - in_plane_;
  const Vec3 aside = third - line * dot(line, third);
  if (!(norm(aside) > kStraightBorder * distance(in_plane_, end))) return false;
  axes_ = {line, unit(aside), cross(line, unit(aside))};
  for (const Vec3& p : points) within_ = std::max(within_, std::abs(dot(axes_[2], p - in_plane_)));
  return within_ <= tolerance;
}

std::optional<FlatBorder> FlatBorder::of(SurfaceCells& cells, PoleSide side, double tolerance) {
  const auto& patches = cells.surface().patches;
  FlatBorder border(side, patches.rows(), patches.columns());
  if (cells.surface().rational || border.degree_across(cells.tree(0).patch()) < 2) return {};
  if (!border.find_plane(border.points_in_rows(cells, 0, 1), tolerance)) return {};
  double height = 0;
  for (const Vec3& p : border.points_in_rows(cells, 2, 2))
    height += dot(border.axes_[2], p - border.in_plane_);
  if (height < 0) border.axes_ = {border.axes_[1], border.axes_[0], -border.axes_[2]};
  for (int patch = 0; patch < cells.patches(); ++patch)
    if (border.place_of(cells.span_u(patch), cells.span_v(patch)))
      border.heights_.push_back(border.heights_of(cells.tree(patch).patch()));
  return border;
}

std::optional<int> FlatBorder::place_of(int span_u, int span_v) const {
  const int across = across_u() ? span_u : span_v, last = (across_u() ? rows_ : columns_) - 1;
  if (across != (is_low() ? 0 : last)) return {};
  return across_u() ? span_v : span_u;
}

// B^q_row = r^2 q (q - 1) / (row (row - 1)) B^(q - 2)_(row - 2), rows counted from the border.
FlatBorder::Heights FlatBorder::heights_of(const RationalBezierPatch& patch) const {
  const int q = degree_across(patch);
  Heights heights{{Grid<Vec4>(patch.points.rows() - (across_u() ? 2 : 0),
                              patch.points.columns() - (across_u() ? 0 : 2))}};
  const int along = across_u() ? patch.degree_v() : patch.degree_u();
  double largest = 0;
  for (int row = 2; row <= q; ++row)
    for (int i = 0; i <= along; ++i) {
      const double height = dot(axes_[2], point(patch, row, i) - in_plane_);
      const int k = is_low() ? row - 2 : q - row;
      Vec4& h = across_u() ? heights.whole.points(k, i) : heights.whole.points(i, k);
      h = {height * q * (q - 1) / (row * (row - 1)), 0, 0, 0};
      largest = std::max(largest, std::abs(h[0]));
    }
  heights.by_u = steps_of(heights.whole, true);
  heights.by_v = steps_of(heights.whole, false);
  heights.rounding = 8 * subdivision_error(std::max(q, along)) * largest;
  return heights;
}

// Along the axes of the plane the derivative itself, without its degree.
VectorBounds FlatBorder::bounds(const RationalBezierPatch& slope, const SlopeNets& nets,
                                const Interval& third) const {
  const int degree = std::max(slope.degree_u(), slope.degree_v()) + 1;
  const double slack =
      8 * subdivision_error(degree) * nets.scale * (1 + nets.scale) + 8 * nets.given_rounding;
  VectorBounds bounds;
  for (int k = 0; k < 3; ++k) {
    Interval range = third;
    if (k < 2) {
      range = {kUnbounded, -kUnbounded};
      for (const Vec4& p : slope.points.values()) {
        const double x = dot(axes_[static_cast<std::size_t>(k)], Vec3{p[0], p[1], p[2]});
        range = {std::min(range.from, x), std::max(range.to, x)};
      }
    }
    bounds.middle[k] = 0.5 * (range.from + range.to);
    bounds.radius[k] = 0.5 * (range.to - range.from) + slack;
  }
  // A positive factor is free: no rectangle shall outweigh its neighbours.
  const double largest = max_norm(bounds.middle);
  if (!(largest > 0) || !std::isfinite(1 / largest)) return bounds;
  return {bounds.middle * (1 / largest), bounds.radius * ((1 + 0x1p-50) / largest)};
}

std::optional<DirectionCones> FlatBorder::cones_in(const SlopeNets& nets, int place,
                                                   const Interval& u, const Interval& v) const {
  const Heights& heights = heights_[static_cast<std::size_t>(place)];
  const Interval h = range_over(heights.whole, u, v, heights.rounding);
  if (!(h.from > 0)) return {};
  const Interval root{std::sqrt(h.from), std::sqrt(h.to)};
  const Interval& across = across_u() ? u : v;
  const Interval r = is_low() ? across : Interval{1 - across.to, 1 - across.from};
  const auto change = [&](const RationalBezierPatch& steps) {
    return change_of_root(r, range_over(steps, u, v, heights.rounding), root);
  };
  const Interval along = change(across_u() ? heights.by_v : heights.by_u);
  const Interval bent = change(across_u() ? heights.by_u : heights.by_v);
  const double q = degree_across(nets.points);
  const Interval straight = is_low() ? root : Interval{-root.to, -root.from};
  const Interval away{(straight.from + (q - 2) * bent.from) / q,
                      (straight.to + (q - 2) * bent.to) / q};
  return DirectionCones{bounds(sub_patch(nets.u, u, v), nets, across_u() ? away : along),
                        bounds(sub_patch(nets.v, u, v), nets, across_u() ? along : away)};
}

std::optional<DirectionCones> FlatBorder::cones(const std::vector<SlopeNets>& nets,
                                                const Interval& u, const Interval& v) const {
  constexpr int kMaxSpans = 2;  // either way: as many as cells that touch may lie in
  const auto first = [](const Interval& x) { return static_cast<int>(std::floor(x.from)); };
  const auto end = [](const Interval& x) { return static_cast<int>(std::ceil(x.to)); };
  const auto part = [](const Interval& x, int span) {
    return Interval{std::max(x.from - span, 0.0), std::min(x.to - span, 1.0)};
  };
  if (end(u) - first(u) > kMaxSpans || end(v) - first(v) > kMaxSpans) return {};
  std::optional<DirectionCones> all;
  for (int i = first(u); i < end(u); ++i)
    for (int j = first(v); j < end(v); ++j) {
      const std::optional<int> place = place_of(i, j);
      if (!place) return {};
      const SlopeNets& own = nets[static_cast<std::size_t>(i * columns_ + j)];
      const std::optional<DirectionCones> cones = cones_in(own, *place, part(u, i), part(v, j));
      if (!cones) return {};
      all = all ? joined(*all, *cones) : *cones;
    }
  return all;
}

}  // namespace blossom
