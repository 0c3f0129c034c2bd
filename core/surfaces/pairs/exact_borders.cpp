// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/exact_borders.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/base/errors.h"

namespace blossom {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Plane = std::array<Rational, 4>;  // the sum of products with (wx, wy, wz, w) vanishes

// The control points along a border of a patch: where u (0) or v (1) is 0 or 1.
std::vector<Vec4> border_points(const RationalBezierPatch& patch, bool of_v, bool high) {
  const Grid<Vec4>& net = patch.points;
  std::vector<Vec4> points;
  if (of_v)
    for (int i = 0; i < net.rows(); ++i) points.push_back(net(i, high ? net.columns() - 1 : 0));
  else
    for (int j = 0; j < net.columns(); ++j) points.push_back(net(high ? net.rows() - 1 : 0, j));
  return points;
}

using Exact4 = std::array<Rational, 4>;

// Of a higher degree, exactly.
std::vector<Exact4> raised(const std::vector<Vec4>& points, std::size_t degree) {
  std::vector<Exact4> p;
  for (const Vec4& x : points)
    p.push_back({Rational(x[0]), Rational(x[1]), Rational(x[2]), Rational(x[3])});
  while (p.size() <= degree) {
    const std::size_t n = p.size();
    p.push_back(p.back());
    for (std::size_t i = n - 1; i > 0; --i)
      for (std::size_t c = 0; c < 4; ++c)
        p[i][c] = (Rational(i) * p[i - 1][c] + Rational(n - i) * p[i][c]) / Rational(n);
  }
  return p;
}

bool one_curve_either_way(const std::vector<Vec4>& p, std::vector<Vec4> q) {
  if (parameter_ratio(p, q)) return true;
  std::reverse(q.begin(), q.end());
  return parameter_ratio(p, q).has_value();
}

// The plane through three homogeneous points; nothing if they are on a line.
std::optional<Plane> plane_through(const Vec4& p, const Vec4& q, const Vec4& r) {
  const auto minor = [&](int i, int j, int k) {
    const auto x = [](const Vec4& point, int c) { return Rational(point[c]); };
    return Rational(x(p, i) * (x(q, j) * x(r, k) - x(q, k) * x(r, j)) -
                    x(p, j) * (x(q, i) * x(r, k) - x(q, k) * x(r, i)) +
                    x(p, k) * (x(q, i) * x(r, j) - x(q, j) * x(r, i)));
  };
  const Plane plane{minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
  if (plane[0] == 0 && plane[1] == 0 && plane[2] == 0) return {};
  return plane;
}

bool holds(const Plane& plane, const Vec4& p) {
  Rational sum = 0;
  for (int k = 0; k < 4; ++k) sum += plane[static_cast<std::size_t>(k)] * Rational(p[k]);
  return sum == 0;
}

void check(std::span<const Vec4> points) {
  for (const Vec4& p : points)
    if (!std::isfinite(p[0] + p[1] + p[2] + p[3]))
      throw InvalidInput("ExactBorders: a control point is not finite");
}

// True if all of a patch and these points lie in one plane.
bool in_one_plane(const RationalBezierPatch& patch, const std::vector<Vec4>& points) {
  const Grid<Vec4>& net = patch.points;
  check(net.values());
  const int n = net.rows() - 1, m = net.columns() - 1;
  auto plane = plane_through(net(0, 0), net(n, 0), net(0, m));
  if (!plane) plane = plane_through(net(n, m), net(n, 0), net(0, m));
  const auto on_plane = [&](const Vec4& p) { return holds(*plane, p); };
  return plane && std::ranges::all_of(points, on_plane) &&
         std::ranges::all_of(net.values(), on_plane);
}

// True if both ends are on a border of their patch.
bool ends_on(const FoundArc& arc, std::size_t parameter, bool high) {
  const double border = high ? 1 : 0;
  return std::abs(arc.arc.from[parameter] - border) <= kSamePoint &&
         std::abs(arc.arc.to[parameter] - border) <= kSamePoint;
}

const RationalBezierPatch& patch_of(const BezierSurface& surface, int patch) {
  return surface.patches.values()[static_cast<std::size_t>(patch)];
}

}  // namespace

// The change multiplies the control points by k r^i.
std::optional<double> parameter_ratio(const std::vector<Vec4>& p, const std::vector<Vec4>& q) {
  const auto parallel = [](const Vec4& x, const Vec4& y) {
    for (int c = 0; c < 3; ++c)
      if (Rational(x[c]) * Rational(y[3]) != Rational(y[c]) * Rational(x[3])) return false;
    return true;
  };
  if (!parallel(p.front(), q.front()) || !parallel(p.back(), q.back())) return std::nullopt;
  const std::size_t degree = std::max(p.size(), q.size()) - 1;
  if (degree == 0) return 1.0;
  const std::vector<Exact4> x = raised(p, degree), y = raised(q, degree);
  Rational factor = y[0][3] / x[0][3];
  const Rational ratio = y[1][3] / (x[1][3] * factor);
  for (std::size_t i = 0; i <= degree; ++i, factor *= ratio)
    for (std::size_t c = 0; c < 4; ++c)
      if (y[i][c] != factor * x[i][c]) return std::nullopt;
  return ratio > 0 ? std::optional(static_cast<double>(ratio)) : std::nullopt;
}

bool ExactBorders::hold(const FoundArc& arc) {
  for (std::size_t parameter = 0; parameter < 4; ++parameter)
    for (const bool high : {false, true})
      if (ends_on(arc, parameter, high) && holds(arc.patch_a, arc.patch_b, parameter, high, arc))
        return true;
  return false;
}

bool ExactBorders::holds(int patch_a, int patch_b, std::size_t parameter, bool high,
                         const FoundArc& arc) {
  const bool of_a = parameter < 2;
  const RationalBezierPatch& own = of_a ? patch_of(a_, patch_a) : patch_of(b_, patch_b);
  const RationalBezierPatch& other = of_a ? patch_of(b_, patch_b) : patch_of(a_, patch_a);
  const std::vector<Vec4> border = border_points(own, parameter % 2 == 1, high);
  check(border);
  const auto decided = [&](int with, const auto& decide) {
    const auto [known, added] = known_.try_emplace(
        {patch_a, patch_b, 2 * static_cast<int>(parameter) + (high ? 1 : 0), with});
    if (added) known->second = decide();
    return known->second;
  };
  for (int side = 0; side < 4; ++side) {
    const bool of_v = side >= 2, other_high = side % 2 == 1;
    const auto shared = [&] {
      const std::vector<Vec4> points = border_points(other, of_v, other_high);
      check(points);
      return one_curve_either_way(border, points);
    };
    const std::size_t across = (of_a ? 2u : 0u) + (of_v ? 1u : 0u);
    // In the plane of the other patch is not yet on it, along its border.
    if (ends_on(arc, across, other_high)) return decided(side, shared);
  }
  return decided(4, [&] { return in_one_plane(other, border); });
}

}  // namespace blossom
