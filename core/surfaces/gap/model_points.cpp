// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/model_points.h"

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

constexpr double kReach = 0.05;  // of the cell: how far Newton may move a point of the model

}  // namespace

Point4 ModelPoints::at(double w, double z) const {
  const double x = axes_.w_axis[0] * w + axes_.z_axis[0] * z,
               y = axes_.w_axis[1] * w + axes_.z_axis[1] * z;
  return {blossom::at(a_.u, 0.5 * (x + 1)), blossom::at(a_.v, 0.5 * (y + 1)),
          value(model_.foot[0], x, y), value(model_.foot[1], x, y)};
}

double ModelPoints::w_of(const Point4& x) const {
  return axes_.w_axis[0] * (2 * (x[0] - a_.u.from) / length(a_.u) - 1) +
         axes_.w_axis[1] * (2 * (x[1] - a_.v.from) / length(a_.v) - 1);
}

double ModelPoints::gap(const Point4& x) const {
  return std::abs(signed_gap(patch_a_, patch_b_, x));
}

double ModelPoints::reach() const {
  const TaylorPolynomial &s = model_.foot[0], &t = model_.foot[1];
  return kReach * std::max({length(a_.u), length(a_.v), std::abs(s[1]) + std::abs(s[2]),
                            std::abs(t[1]) + std::abs(t[2])});
}

Point4 ModelPoints::line() const {
  return {axes_.w_axis[0] * 2 / length(a_.u), axes_.w_axis[1] * 2 / length(a_.v), 0, 0};
}

Vec2 ModelPoints::across() const {
  return {axes_.z_axis[0] * 0.5 * length(a_.u), axes_.z_axis[1] * 0.5 * length(a_.v)};
}

Point4 ModelPoints::fix_edge(int edge, Point4& x) const {
  const std::size_t fixed = edge < 2 ? 0 : 1;
  const Interval& side = fixed == 0 ? a_.u : a_.v;
  x[fixed] = edge % 2 == 0 ? side.from : side.to;
  Point4 plane{};
  plane[fixed] = 1;
  return plane;
}

std::optional<Point4> ModelPoints::on_touch(double w, double z, bool cross) const {
  return touch_point(patch_a_, patch_b_, at(w, z), {across(), cross}, line(), reach());
}

std::optional<Point4> ModelPoints::on_touch_at(int edge, double w, double z, bool cross) const {
  Point4 start = at(w, z);
  const Point4 plane = fix_edge(edge, start);
  auto x = touch_point(patch_a_, patch_b_, start, {across(), cross}, plane, reach());
  if (x) fix_edge(edge, *x);
  return x;
}

}  // namespace blossom
