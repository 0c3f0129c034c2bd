// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/cell_jets.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/unbounded.h"
#include "core/math/binomial.h"

namespace blossom {
namespace {

struct NumberRange {
  double centre = 0;
  double radius = 0;
};

NumberRange range_of(double low, double high) { return {0.5 * (low + high), 0.5 * (high - low)}; }

NumberRange operator*(const NumberRange& a, const NumberRange& b) {
  return {a.centre * b.centre,
          std::abs(a.centre) * b.radius + a.radius * (std::abs(b.centre) + b.radius)};
}

VectorRange operator*(const NumberRange& m, const VectorRange& v) {
  return {m.centre * v.centre,
          std::abs(m.centre) * v.radius + m.radius * (absolute(v.centre) + v.radius)};
}

VectorRange operator+(const VectorRange& a, const VectorRange& b) {
  return {a.centre + b.centre, a.radius + b.radius};
}

VectorRange operator-(const VectorRange& a, const VectorRange& b) {
  return {a.centre - b.centre, a.radius + b.radius};
}

// Of all control points of one homogeneous derivative.
struct NetRange {
  VectorRange space;
  NumberRange weight;
};

// Of the differences of a net, some times along each direction, times what makes them derivatives.
template <int order_u, int order_v>
NetRange derivative_range(const Grid<Vec4>& net) {
  const int rows = net.rows() - order_u, columns = net.columns() - order_v;
  if (rows < 1 || columns < 1) return {};
  double factor = 1;
  for (int k = 0; k < order_u; ++k) factor *= net.rows() - 1 - k;
  for (int k = 0; k < order_v; ++k) factor *= net.columns() - 1 - k;
  const auto width = static_cast<std::size_t>(net.columns());
  // To the next point in the direction of a derivative.
  const std::size_t step = order_u > 0 ? width : 1;
  Vec4 low{kInfinity, kInfinity, kInfinity, kInfinity}, high = -1.0 * low;
  for (int i = 0; i < rows; ++i) {
    const Vec4* at = net.values().data() + static_cast<std::size_t>(i) * width;
    for (int j = 0; j < columns; ++j, ++at)
      for (int k = 0; k < 4; ++k) {
        double d = (*at)[k];
        if constexpr (order_u + order_v >= 1) d = at[step][k] - d;
        if constexpr (order_u == 1 && order_v == 1) d = (at[step + 1][k] - at[1][k]) - d;
        if constexpr (order_u == 2 || order_v == 2) d = (at[2 * step][k] - at[step][k]) - d;
        low[k] = std::min(low[k], d);
        high[k] = std::max(high[k], d);
      }
  }
  low *= factor, high *= factor;
  NetRange range;
  for (int k = 0; k < 3; ++k) {
    range.space.centre[k] = 0.5 * (low[k] + high[k]);
    range.space.radius[k] = 0.5 * (high[k] - low[k]);
  }
  range.weight = range_of(low[3], high[3]);
  return range;
}

// First and second derivative of the net's parameter by the surface's own.
struct ParameterRange {
  NumberRange first, second;
};

// With x = 2 t - 1 in [-1, 1] and k = tan(alpha / 2) an angle p = 2 atan(k x) has
//   dt/dp = (1 + k^2 x^2) / (4 k),   d2t/dp2 = k x dt/dp
ParameterRange parameter_range(const CellSide& side) {
  const double part = length(side.part);
  if (side.law == ParameterLaw::Linear) return {{1 / (length(side.span) * part), 0}, {}};
  const double k = std::tan(0.25 * length(side.span));
  const double x0 = 2 * side.part.from - 1, x1 = 2 * side.part.to - 1;
  const double largest = std::max(x0 * x0, x1 * x1);
  const double least = x0 * x1 <= 0 ? 0 : std::min(x0 * x0, x1 * x1);
  const NumberRange first =
      range_of((1 + k * k * least) / (4 * k * part), (1 + k * k * largest) / (4 * k * part));
  return {first, NumberRange{k, 0} * range_of(x0, x1) * first};
}

// Homogeneous derivative by the surface's own parameter, across the border, at each of its points.
std::vector<Vec4> across(const RationalBezierPatch& patch, const CellSide& side, bool by_u,
                         bool at_end) {
  const Grid<Vec4>& net = patch.points;
  const int degree = (by_u ? net.rows() : net.columns()) - 1;
  const int count = by_u ? net.columns() : net.rows();
  const double speed = parameter_derivative(side.law, side.span, at_end ? 1.0 : 0.0);
  std::vector<Vec4> result;
  for (int k = 0; k < count; ++k) {
    const auto point = [&](int i) { return by_u ? net(i, k) : net(k, i); };
    const Vec4 d = at_end ? point(degree) - point(degree - 1) : point(1) - point(0);
    result.push_back(d * (degree / speed));
  }
  return result;
}

Vec3 largest_jump(const RationalBezierPatch& before, const CellSide& at_before,
                  const RationalBezierPatch& after, const CellSide& at_after, bool by_u) {
  const std::vector<Vec4> left = across(before, at_before, by_u, true);
  const std::vector<Vec4> right = across(after, at_after, by_u, false);
  if (left.size() != right.size()) return {kUnbounded, kUnbounded, kUnbounded};
  const int n = static_cast<int>(left.size()) - 1;
  // Coefficients of the numerator and of w^2.
  std::vector<Vec4> product(static_cast<std::size_t>(2 * n + 1));
  for (int i = 0; i <= n; ++i) {
    const Vec4 x = by_u ? after.points(0, i) : after.points(i, 0);
    for (int j = 0; j <= n; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const Vec4 d = right[at] - left[at];
      const double w = by_u ? after.points(0, j)[3] : after.points(j, 0)[3];
      const double share = binomial(n, i) * binomial(n, j) / binomial(2 * n, i + j);
      Vec4& sum = product[static_cast<std::size_t>(i + j)];
      for (int k = 0; k < 3; ++k) sum[k] += share * (d[k] * x[3] - d[3] * x[k]);
      sum[3] += share * w * x[3];
    }
  }
  Vec3 largest;
  for (const Vec4& p : product)
    for (int k = 0; k < 3; ++k) largest[k] = std::max(largest[k], std::abs(p[k]) / p[3]);
  return largest;
}

}  // namespace

CellJet cell_jet(RationalBezierPatch patch, const CellSide& u, const CellSide& v) {
  Grid<Vec4>& net = patch.points;  // moved to the origin in place
  const Vec4 middle = net(net.rows() / 2, net.columns() / 2);
  const Vec3 origin = projected(middle);
  for (Vec4& p : net.values())
    for (int k = 0; k < 3; ++k) p[k] -= p[3] * origin[k];
  const NetRange at = derivative_range<0, 0>(net);
  const NetRange s = derivative_range<1, 0>(net), t = derivative_range<0, 1>(net);
  const NetRange ss = derivative_range<2, 0>(net), st = derivative_range<1, 1>(net);
  const NetRange tt = derivative_range<0, 2>(net);
  const double low = at.weight.centre - at.weight.radius,
               high = at.weight.centre + at.weight.radius;
  const NumberRange over_w = range_of(1 / high, 1 / low), two{2, 0};
  const VectorRange S = over_w * at.space;
  const VectorRange S_s = over_w * (s.space - s.weight * S);
  const VectorRange S_t = over_w * (t.space - t.weight * S);
  const VectorRange S_ss = over_w * (ss.space - two * (s.weight * S_s) - ss.weight * S);
  const VectorRange S_st = over_w * (st.space - s.weight * S_t - t.weight * S_s - st.weight * S);
  const VectorRange S_tt = over_w * (tt.space - two * (t.weight * S_t) - tt.weight * S);
  const ParameterRange pu = parameter_range(u), pv = parameter_range(v);
  CellJet made;
  made.first_u = pu.first * S_s;
  made.first_v = pv.first * S_t;
  made.jet.uu = (pu.first * pu.first) * S_ss + pu.second * S_s;
  made.jet.uv = (pu.first * pv.first) * S_st;
  made.jet.vv = (pv.first * pv.first) * S_tt + pv.second * S_t;
  made.jet.length_u = made.first_u.size();
  made.jet.length_v = made.first_v.size();
  made.jet.jacobian = least_area(made.first_u, made.first_v);
  return made;
}

Vec3 largest_jump_u(const RationalBezierPatch& before, const CellSide& at_before,
                    const RationalBezierPatch& after, const CellSide& at_after) {
  return largest_jump(before, at_before, after, at_after, true);
}

Vec3 largest_jump_v(const RationalBezierPatch& before, const CellSide& at_before,
                    const RationalBezierPatch& after, const CellSide& at_after) {
  return largest_jump(before, at_before, after, at_after, false);
}

}  // namespace blossom
