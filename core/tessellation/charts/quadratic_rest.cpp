// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/quadratic_rest.h"

#include <algorithm>

#include "core/math/index.h"

namespace blossom {
namespace {

int degree_u(const PlacedNet& part) { return part.net.points.rows() - 1; }
int degree_v(const PlacedNet& part) { return part.net.points.columns() - 1; }

// Sums over the rectangle, of which means follow.
struct Means {
  Interval u, v;
  int degree_u = 1, degree_v = 1;  // the least
  Vec3 first_u, first_v, uu, uv, vv;
};

Means means_of(const std::vector<PlacedNet>& parts) {
  Means m{parts.front().u,
          parts.front().v,
          degree_u(parts.front()),
          degree_v(parts.front()),
          {},
          {},
          {},
          {},
          {}};
  for (const PlacedNet& part : parts) {
    m.u = {std::min(m.u.from, part.u.from), std::max(m.u.to, part.u.to)};
    m.v = {std::min(m.v.from, part.v.from), std::max(m.v.to, part.v.to)};
    m.degree_u = std::min(m.degree_u, degree_u(part));
    m.degree_v = std::min(m.degree_v, degree_v(part));
  }
  const double width_u = length(m.u), width_v = length(m.v);
  for (const PlacedNet& part : parts) {
    const int n = degree_u(part), k = degree_v(part);
    const bool first_row = part.u.from == m.u.from, last_row = part.u.to == m.u.to;
    const bool first_column = part.v.from == m.v.from, last_column = part.v.to == m.v.to;
    const auto p = [&](int i, int j) -> const Vec3& { return part.net.points(i, j); };
    // The mean of a Bezier form is that of its control points.
    const double share_v = length(part.v) / width_v / (k + 1), rate_u = n / length(part.u);
    for (int j = 0; j <= k; ++j) {
      if (first_row) m.first_u -= share_v / width_u * p(0, j);
      if (last_row) m.first_u += share_v / width_u * p(n, j);
      if (first_row) m.uu -= share_v / width_u * rate_u * (p(1, j) - p(0, j));
      if (last_row) m.uu += share_v / width_u * rate_u * (p(n, j) - p(n - 1, j));
    }
    const double share_u = length(part.u) / width_u / (n + 1), rate_v = k / length(part.v);
    for (int i = 0; i <= n; ++i) {
      if (first_column) m.first_v -= share_u / width_v * p(i, 0);
      if (last_column) m.first_v += share_u / width_v * p(i, k);
      if (first_column) m.vv -= share_u / width_v * rate_v * (p(i, 1) - p(i, 0));
      if (last_column) m.vv += share_u / width_v * rate_v * (p(i, k) - p(i, k - 1));
    }
    const double area = width_u * width_v;
    if (first_row && first_column) m.uv += (1 / area) * p(0, 0);
    if (first_row && last_column) m.uv -= (1 / area) * p(0, k);
    if (last_row && first_column) m.uv -= (1 / area) * p(n, 0);
    if (last_row && last_column) m.uv += (1 / area) * p(n, k);
  }
  // No linear form has the coefficients of a square.
  if (m.degree_u < 2) m.uu = {};
  if (m.degree_v < 2) m.vv = {};
  return m;
}

// The coefficient of x^2, where x runs over an interval.
double square_coefficient(const Interval& x, int i, int degree) {
  if (degree < 2) return 0;
  const double n = degree, k = i;
  return ((n - k) * (n - k - 1) * x.from * x.from + 2 * k * (n - k) * x.from * x.to +
          k * (k - 1) * x.to * x.to) /
         (n * (n - 1));
}

struct Bounds {
  Vec3 low, high;
  bool any = false;

  void add(const Vec3& p) {
    for (int k = 0; k < 3; ++k) {
      low[k] = any ? std::min(low[k], p[k]) : p[k];
      high[k] = any ? std::max(high[k], p[k]) : p[k];
    }
    any = true;
  }
  VectorRange range() const { return {0.5 * (low + high), 0.5 * (high - low)}; }
};

}  // namespace

QuadraticRest quadratic_rest(const std::vector<PlacedNet>& parts) {
  const Means m = means_of(parts);
  const double middle_u = at(m.u, 0.5), middle_v = at(m.v, 0.5);
  const Vec3 origin = parts.front().net.points(0, 0);
  Bounds rest, first_u, first_v;
  for (const PlacedNet& part : parts) {
    const int n = degree_u(part), k = degree_v(part);
    const Interval u{part.u.from - middle_u, part.u.to - middle_u};
    const Interval v{part.v.from - middle_v, part.v.to - middle_v};
    const double rate_u = n / length(u), rate_v = k / length(v);
    for (int i = 0; i <= n; ++i) {
      const double x = at(u, static_cast<double>(i) / n);
      const Vec3 of_row = origin + x * m.first_u + 0.5 * square_coefficient(u, i, n) * m.uu;
      const Vec3 slope = m.first_v + x * m.uv;
      for (int j = 0; j <= k; ++j) {
        const double y = at(v, static_cast<double>(j) / k);
        const Vec3& p = part.net.points(i, j);
        rest.add((p - of_row) - y * slope - 0.5 * square_coefficient(v, j, k) * m.vv);
        if (i < n) first_u.add(rate_u * (part.net.points(i + 1, j) - p));
        if (j < k) first_v.add(rate_v * (part.net.points(i, j + 1) - p));
      }
    }
  }
  return {m.uu, m.uv, m.vv, rest.range().radius, first_u.range(), first_v.range()};
}

}  // namespace blossom
