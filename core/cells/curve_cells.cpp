// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/curve_cells.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/bounds/value_arithmetic.h"
#include "core/cells/limits.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

constexpr int kFirstCells = 24;  // room for them at once, besides the spans
constexpr double kNear = 16;  // times the reach: bounds over such cells are near those at a point
constexpr double kSlack = 1e-13;  // covers the few roundings of a bound

// ValueRange of the differences of an order between neighbours, times n! / (n - order)!.
ValueRange difference_range(const double* values, int count, int order) {
  const int n = count - 1;
  if (order > n) return {0, 0};
  ValueRange range{kUnbounded, -kUnbounded};
  for (int i = 0; i + order <= n; ++i) {
    const double d =
        order == 1 ? values[i + 1] - values[i] : values[i + 2] - 2 * values[i + 1] + values[i];
    range.low = std::min(range.low, d);
    range.high = std::max(range.high, d);
  }
  const double factor = order == 1 ? n : n * (n - 1.0);
  return {range.low * factor, range.high * factor};
}

// n (n - 1) times the longest second difference of the control points, rounding included.
double second_differences(const CurveCell& cell, int dimension) {
  const int n = cell.points;
  double longest = 0;
  for (int i = 0; i + 2 < n; ++i) {
    double square = 0;
    for (int k = 0; k < dimension; ++k) {
      const double* p = cell.hull + k * n + i;
      const double d = p[2] - 2 * p[1] + p[0];
      square += d * d;
    }
    longest = std::max(longest, square);
  }
  return (n - 1.0) * (n - 2.0) * (std::sqrt(longest) + 8 * cell.margin);
}

CurveSpans moved(CurveSpans curve, const Vec3& origin) {
  for (CurveSpan& span : curve.spans)
    for (Vec4& p : span.curve.points)
      for (int k = 0; k < 3; ++k) p[k] -= p[3] * origin[k];
  return curve;
}

}  // namespace

ValueRange range_along(const CurveCell& cell, int dimension, const Vec3& direction) {
  const int n = cell.points;
  ValueRange range{kUnbounded, -kUnbounded};
  for (int i = 0; i < n; ++i) {
    double value = direction[0] * cell.hull[i] + direction[1] * cell.hull[n + i];
    if (dimension == 3) value += direction[2] * cell.hull[2 * n + i];
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  // |direction| <= 1 turns the margin of three coordinates into at most sqrt(3) of it.
  return padded(range, 2 * cell.margin);
}

CurveTree::CurveTree(const CurveSpans& curve, const Vec3& origin, int dimension)
    : moved_(origin == Vec3{} ? CurveSpans{} : moved(curve, origin)),
      curve_(origin == Vec3{} ? curve : moved_),
      dimension_(dimension),
      hull_scale_(max_norm(origin)) {
  int degree = 0;
  for (const CurveSpan& span : curve_.spans) {
    degree = std::max(degree, span.curve.degree());
    for (const Vec4& p : span.curve.points)
      hull_scale_ = std::max(hull_scale_, max_norm(Vec3{p[0], p[1], p[2]}) / p[3]);
  }
  evaluation_margin_ = (evaluation_error(degree) + 4 * kUnitRoundoff) * hull_scale_;
  closed_ = end_point({0, 0}) == end_point({spans() - 1, 1});
  cells_.reserve(static_cast<std::size_t>(kFirstCells + spans()));
  for (int i = 0; i < spans(); ++i) add_span(i);
}

void CurveTree::add_span(int span) {
  const RationalBezierCurve& curve = curve_.spans[static_cast<std::size_t>(span)].curve;
  CurveCell cell;
  cell.span = span;
  cell.local = {0, 1};
  cell.points = curve.degree() + 1;
  const int planes = curve_.rational ? dimension_ + 1 : dimension_;
  double* net = allocate(planes * cell.points);
  for (int i = 0; i < cell.points; ++i)
    for (int k = 0; k < planes; ++k)
      net[k * cell.points + i] = curve.points[static_cast<std::size_t>(i)][k == dimension_ ? 3 : k];
  cell.homogeneous = net;
  finish(cell);
  cells_.push_back(cell);
}

int CurveTree::cell_near(const SpanPoint& at, double reach) const {
  const double low = std::max(0.0, at.t - reach), high = std::min(1.0, at.t + reach);
  int index = at.span;
  while ((*this)[index].child >= 0) {
    const int child = (*this)[index].child;
    const double middle = (*this)[child].local.to;
    if (low < middle && high > middle) break;
    index = high <= middle ? child : child + 1;
  }
  return index;
}

double CurveTree::bend_near(const SpanPoint& at, double reach) const {
  const CurveCell& cell = (*this)[cell_near(at, reach)];
  const double square = length(cell.local) * length(cell.local);
  if (!curve_.rational) return second_differences(cell, dimension_) / square;
  double sum = 0;
  for (int k = 0; k < dimension_; ++k) {
    Vec3 direction;
    direction[k] = 1;
    const double bound = magnitude(derivative_ranges(cell, direction)[1]);
    sum += bound * bound;
  }
  return std::sqrt(sum) / square;
}

void CurveTree::split_near(const SpanPoint& at, double reach) {
  for (;;) {
    const int index = cell_near(at, reach);
    if ((*this)[index].child >= 0 || length((*this)[index].local) <= kNear * reach) return;
    split(index);
  }
}

double* CurveTree::allocate(int count) {
  return static_cast<double*>(
      room_.allocate(static_cast<std::size_t>(count) * sizeof(double), alignof(double)));
}

int CurveTree::split(int index) {
  const auto at_index = static_cast<std::size_t>(index);
  if (cells_[at_index].child >= 0) return cells_[at_index].child;
  const CurveCell parent = cells_[at_index];
  const NetShape shape{parent.points, 1, curve_.rational ? dimension_ + 1 : dimension_};
  double* low_net = allocate(shape.size());
  double* high_net = allocate(shape.size());
  halve_bezier_u(shape, parent.homogeneous, kOffMiddle, low_net, high_net);
  const double middle = at(parent.local, kOffMiddle);
  const int child = add_cell(parent, 1, {parent.local.from, middle}, low_net);
  add_cell(parent, 1, {middle, parent.local.to}, high_net);
  cells_[at_index].child = child;
  return child;
}

int CurveTree::part(int index, const Interval& part) {
  if (!(part.from > 0) && !(part.to < 1)) return index;
  const CurveCell parent = cells_[static_cast<std::size_t>(index)];
  const NetShape shape{parent.points, 1, curve_.rational ? dimension_ + 1 : dimension_};
  double* net = allocate(shape.size());
  const Interval local{part.from > 0 ? at(parent.local, part.from) : parent.local.from,
                       part.to < 1 ? at(parent.local, part.to) : parent.local.to};
  double below[4 * (kMaxDegree + 1)], rest[4 * (kMaxDegree + 1)];
  if (!(part.to < 1)) {
    halve_bezier_u(shape, parent.homogeneous, part.from, rest, net);
  } else if (!(part.from > 0)) {
    halve_bezier_u(shape, parent.homogeneous, part.to, net, rest);
  } else {
    halve_bezier_u(shape, parent.homogeneous, part.to, below, rest);
    halve_bezier_u(shape, below, part.from / part.to, rest, net);
  }
  return add_cell(parent, 2, local, net);
}

int CurveTree::add_cell(const CurveCell& parent, int cuts, const Interval& local,
                        const double* net) {
  CurveCell& cell = cells_.emplace_back();
  cell.span = parent.span;
  cell.depth = parent.depth + cuts;
  cell.local = local;
  cell.points = parent.points;
  cell.homogeneous = net;
  finish(cell);
  depth_ = std::max(depth_, cell.depth);
  return static_cast<int>(cells_.size()) - 1;
}

// Halving takes convex combinations, and positive weights bound |X| by w times the largest point,
// so the error of X / w is relative to the points in space, however much the weights vary.
void CurveTree::finish(CurveCell& cell) {
  const int n = cell.points;
  cell.hull = cell.homogeneous;
  if (curve_.rational) {
    double* hull = allocate(dimension_ * n);
    const double* weight = cell.homogeneous + dimension_ * n;
    for (int k = 0; k < dimension_; ++k)
      for (int i = 0; i < n; ++i) hull[k * n + i] = cell.homogeneous[k * n + i] / weight[i];
    cell.hull = hull;
  }
  const double steps = curve_.rational ? 2 : 1;
  cell.margin = (steps * halving_error(n - 1, cell.depth) + 4 * kUnitRoundoff) * hull_scale_;
  largest_margin_ = std::max(largest_margin_, cell.margin);
  cell.extent = 0;
  for (int k = 0; k < dimension_; ++k) {
    const double* values = cell.hull + k * n;
    double low = values[0], high = values[0];
    for (int i = 1; i < n; ++i) {
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
    }
    cell.low[k] = low - cell.margin;
    cell.high[k] = high + cell.margin;
    cell.extent = std::max(cell.extent, cell.high[k] - cell.low[k]);
  }
}

// Directions, of rational curves too, are positive combinations of the legs of the control polygon.
// Source: Floater 1992.
void CurveTree::bound_directions(CurveCell& cell) const {
  cell.directed = true;
  if (dimension_ == 2) return bound_in_plane(cell);
  const int n = cell.points;
  const auto leg = [&](int from, int to) {
    Vec3 d;
    for (int k = 0; k < 3; ++k) d[k] = cell.hull[k * n + to] - cell.hull[k * n + from];
    return d;
  };
  cell.axis = unit(leg(0, n - 1));
  cell.cosine = -1;
  if (cell.axis == Vec3{}) return;
  double cosine = 1;
  for (int i = 0; i + 1 < n; ++i) {
    const Vec3 d = leg(i, i + 1);
    const double length = norm(d);
    // The ends of a leg are known within sqrt(3) margin each.
    if (!(length > 0)) return;
    cosine = std::min(cosine, (dot(cell.axis, d) - 4 * cell.margin) / length);
  }
  cell.cosine = std::max(-1.0, cosine - 8 * kUnitRoundoff);
}

void CurveTree::bound_in_plane(CurveCell& cell) const {
  const int n = cell.points;
  const double *x = cell.hull, *y = cell.hull + n;
  cell.cosine = -1;
  const Vec2 axis = unit(Vec2{x[n - 1] - x[0], y[n - 1] - y[0]});
  cell.axis = {axis[0], axis[1], 0};
  if (axis == Vec2{}) return;
  ValueRange across{kUnbounded, -kUnbounded};
  for (int i = 0; i < n; ++i) {
    const double value = axis[0] * y[i] - axis[1] * x[i];
    across.low = std::min(across.low, value);
    across.high = std::max(across.high, value);
  }
  cell.across = padded(across, 2 * cell.margin);
  Vec2 right{x[1] - x[0], y[1] - y[0]}, left = right;
  double least = kUnbounded;
  for (int i = 0; i + 1 < n; ++i) {
    const Vec2 leg{x[i + 1] - x[i], y[i + 1] - y[i]};
    if (!(dot(axis, leg) > 4 * cell.margin)) return;
    least = std::min(least, dot(leg, leg));
    if (cross(left, leg) > 0) left = leg;
    if (cross(right, leg) < 0) right = leg;
  }
  // The ends of a leg are known within sqrt(2) margin each.
  const double turn = 4 * cell.margin / std::sqrt(least) + kUnitRoundoff;
  if (!(turn < 0.5)) return;
  left = unit(left + turn * Vec2{-left[1], left[0]});
  right = unit(right - turn * Vec2{-right[1], right[0]});
  cell.left = {left[0], left[1], 0};
  cell.right = {right[0], right[1], 0};
  cell.cosine = std::min({dot(axis, left), dot(axis, right), 1.0}) - 8 * kUnitRoundoff;
}

// With the origin c moved into the cell and X' = X - w c:
//   f = X' / w,  f1 = (X'_1 - f w_1) / w,  f2 = (X'_2 - 2 f1 w_1 - f w_2) / w
// so that the products, the loose terms, are of higher order in the cell's size.
std::array<ValueRange, 2> CurveTree::derivative_ranges(const CurveCell& cell,
                                                       const Vec3& direction) const {
  const int n = cell.points;
  double values[kMaxDegree + 1];
  const double m1 = 4.0 * (n - 1) * cell.margin, m2 = 8.0 * (n - 1) * (n - 2) * cell.margin;
  const auto project = [&](const double* net) {
    for (int i = 0; i < n; ++i) {
      values[i] = direction[0] * net[i] + direction[1] * net[n + i];
      if (dimension_ == 3) values[i] += direction[2] * net[2 * n + i];
    }
  };
  if (!curve_.rational) {
    project(cell.hull);
    return {padded(difference_range(values, n, 1), m1), padded(difference_range(values, n, 2), m2)};
  }
  ValueRange f = range_along(cell, dimension_, direction);
  const double centre = 0.5 * (f.low + f.high);
  f = {f.low - centre, f.high - centre};
  const double* weight = cell.homogeneous + dimension_ * n;
  const auto [least, most] = std::minmax_element(weight, weight + n);
  const ValueRange over_w{(1 - kSlack) / *most, (1 + kSlack) / *least};
  const double spread = *most / *least;
  const ValueRange w1 = difference_range(weight, n, 1), w2 = difference_range(weight, n, 2);
  project(cell.homogeneous);
  for (int i = 0; i < n; ++i) values[i] -= weight[i] * centre;
  const auto rest = [&](const ValueRange& x, const ValueRange& y) {
    return ValueRange{x.low - y.high, x.high - y.low};
  };
  ValueRange first = times(rest(difference_range(values, n, 1), times(f, w1)), over_w);
  first = padded(first, 2 * spread * m1 + kSlack * magnitude(first));
  const ValueRange product = times(first, w1), last = times(f, w2);
  ValueRange second =
      times(rest(rest(difference_range(values, n, 2), {2 * product.low, 2 * product.high}), last),
            over_w);
  second = padded(second, 2 * spread * spread * m2 + kSlack * magnitude(second));
  return {first, second};
}

double CurveTree::parameter(const SpanPoint& at) const {
  const CurveSpan& span = curve_.spans[static_cast<std::size_t>(at.span)];
  return parameter_at(span.law, span.place, at.t);
}

SpanPoint CurveTree::place(double parameter) const {
  const auto after =
      std::upper_bound(curve_.spans.begin() + 1, curve_.spans.end(), parameter,
                       [](double value, const CurveSpan& span) { return value < span.place.from; });
  const CurveSpan& span = *(after - 1);
  return {static_cast<int>(after - 1 - curve_.spans.begin()),
          std::clamp(local_parameter(span.law, span.place, parameter), 0.0, 1.0)};
}

Vec3 CurveTree::end_point(const SpanPoint& at) const {
  const RationalBezierCurve& curve = curve_.spans[static_cast<std::size_t>(at.span)].curve;
  const Vec4& p = at.t == 0 ? curve.points.front() : curve.points.back();
  return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

SpanPoint CurveTree::across_join(const SpanPoint& at) const {
  const int last = spans() - 1;
  if (at.t == 1) {
    if (at.span < last) return {at.span + 1, 0};
    return closed_ ? SpanPoint{0, 0} : at;
  }
  if (at.span > 0) return {at.span - 1, 1};
  return closed_ ? SpanPoint{last, 1} : at;
}

bool CurveTree::is_free_end(const SpanPoint& at) const {
  if (at.t != 0 && at.t != 1) return false;
  const SpanPoint other = across_join(at);
  return other.span == at.span && other.t == at.t;
}

bool CurveTree::stays_near(double p, double q, double reach) const {
  const Interval domain = curve_.domain();
  const auto point = [&](double parameter) { return jet(place(parameter)).point; };
  const Vec3 from = point(p), to = point(q);
  if (!(distance(from, to) <= 2 * reach)) return false;
  const bool over_seam = closed_ && std::abs(p - q) > 0.5 * length(domain);
  const Vec3 between = point(over_seam ? domain.from : 0.5 * (p + q));
  return distance(from, between) <= 2 * reach && distance(to, between) <= 2 * reach;
}

double CurveTree::size() const {
  Vec3 low = cells_[0].low, high = cells_[0].high;
  for (int i = 1; i < spans(); ++i)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], (*this)[i].low[k]);
      high[k] = std::max(high[k], (*this)[i].high[k]);
    }
  return max_norm(high - low);
}

}  // namespace blossom
