// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/gap_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/forms/evaluation.h"
#include "core/math/roundoff.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/surfaces/gap/chart_ownership.h"

namespace blossom {
namespace {

constexpr double kMaxNonlinear = 0.7;  // bound on the nonlinear part of the foot's map
constexpr double kBoxReserve = 1.25;   // of the box round the foot over the linear estimate
constexpr double kMuchWider = 2;       // than the chart: not by the chart's mean Jacobian alone
constexpr int kFootSteps = 12;

using Planes = std::array<double, 4 * (kMaxDegree + 1) * (kMaxDegree + 1)>;

// A surface over a square as three series, with the rounding of their values, but not of the net.
struct SurfaceSeries {
  std::array<TaylorSeries, 3> point;
  double rounding = 0;  // model units
  int degree = 0;       // sum of both
};

// Largest difference of a plane of a net from what its coefficients give back: the true error of
// the coefficients as values, whatever the degree.
double conversion_error(const NetShape& shape, const double* coefficients, const double* net) {
  const NetShape plane{shape.rows, shape.columns, 1};
  Planes back;
  bezier_from_monomial(plane, coefficients, back.data());
  double worst = 0, sum = 0, scale = 0;
  for (int i = 0; i < plane.size(); ++i) {
    worst = std::max(worst, std::abs(back[static_cast<std::size_t>(i)] - net[i]));
    sum += std::abs(coefficients[i]);
    scale = std::max(scale, std::abs(net[i]));
  }
  return worst + bezier_from_monomial_error(shape.rows - 1, shape.columns - 1) * (sum + scale) +
         4 * kUnitRoundoff * scale;
}

// The net relative to a centre, and what rounding does to its numbers.
double move(const NetShape& shape, const double* net, const Vec3& centre, double* moved) {
  const int size = shape.plane_size();
  double heaviest = 1, largest = 0;
  for (int i = 0; i < size; ++i) {
    const double weight = shape.planes == 4 ? net[3 * size + i] : 1;
    heaviest = std::max(heaviest, weight);
    for (int k = 0; k < 3; ++k) {
      largest = std::max(largest, std::abs(net[k * size + i]));
      moved[k * size + i] = net[k * size + i] - weight * centre[k];
    }
    if (shape.planes == 4) moved[3 * size + i] = weight;
  }
  return kUnitRoundoff * (3 * heaviest * max_norm(centre) + largest);
}

// Relative to `centre`: near it the quotient by the weight has small terms, and so small majorants.
std::optional<SurfaceSeries> series_of(const NetShape& shape, const double* net,
                                       const double* coefficients, const Vec3& centre) {
  Planes made, moved;
  SurfaceSeries result;
  if (centre != Vec3{}) {
    result.rounding = move(shape, net, centre, moved.data());
    net = moved.data();
    coefficients = nullptr;
  }
  if (coefficients == nullptr) {
    monomial_from_bezier(shape, net, made.data());
    coefficients = made.data();
  }
  const double of_move = result.rounding;
  result.degree = shape.rows + shape.columns - 2;
  const int size = shape.plane_size();
  for (int k = 0; k < 3; ++k) {
    const double* plane = coefficients + k * size;
    result.rounding =
        std::max(result.rounding, of_move + conversion_error(shape, plane, net + k * size));
    result.point[static_cast<std::size_t>(k)] = taylor_series(plane, shape.rows, shape.columns);
  }
  if (shape.planes == 3) return result;
  const double* plane = coefficients + 3 * size;
  bool exists = false;
  const TaylorSeries inverse = reciprocal(taylor_series(plane, shape.rows, shape.columns), exists);
  if (!exists) return std::nullopt;
  double largest = 0;
  for (TaylorSeries& x : result.point) {
    x = x * inverse;
    largest = std::max(largest, x.total[0]);
  }
  const double weight_error = conversion_error(shape, plane, net + 3 * size);
  result.rounding =
      (result.rounding + largest * weight_error) * inverse.total[0] + 64 * kUnitRoundoff * largest;
  return result;
}

Vec3 absolute(const Vec3& x) { return {std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}; }

TaylorSeries along(const Vec3& direction, const SurfaceSeries& surface) {
  const auto& [x, y, z] = surface.point;
  const auto sum = [](const Vec3& factor, const auto& a, const auto& b, const auto& c, auto& to) {
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] = factor[0] * a[i] + factor[1] * b[i] + factor[2] * c[i];
  };
  TaylorSeries result;
  sum(direction, x.terms, y.terms, z.terms, result.terms);
  sum(absolute(direction), x.low, y.low, z.low, result.low);
  sum(absolute(direction), x.total, y.total, z.total, result.total);
  return result;
}

void planes_of(const RationalBezierPatch& patch, const NetShape& shape, double* planes) {
  const auto points = patch.points.values();
  for (int k = 0; k < shape.planes; ++k)
    for (int i = 0; i < shape.plane_size(); ++i)
      planes[k * shape.plane_size() + i] = points[static_cast<std::size_t>(i)][k];
}

Interval widened(const Interval& x, double part) {
  const double by = part * length(x);
  return {x.from - by, x.to + by};
}

// Largest distance of row . S_u (or S_v) from `middle` over a polynomial patch.
double derivative_spread(const RationalBezierPatch& patch, const Vec3& row, double middle,
                         bool along_u) {
  const auto& p = patch.points;
  double worst = 0;
  for (int i = along_u ? 1 : 0; i < p.rows(); ++i)
    for (int j = along_u ? 0 : 1; j < p.columns(); ++j) {
      const Vec4 d = p(i, j) - (along_u ? p(i - 1, j) : p(i, j - 1));
      const double value = row[0] * d[0] + row[1] * d[1] + row[2] * d[2];
      const int degree = along_u ? patch.degree_u() : patch.degree_v();
      worst = std::max(worst, std::abs(degree * value - middle));
    }
  return worst;
}

struct Matrix2 {
  double a, b, c, d;  // rows (a b), (c d)
  double determinant() const { return a * d - b * c; }
};

// The point of b over a point of the plane, by Newton's method kept within the chart.
struct Foot {
  double s, t;
  PatchJet jet;
  Matrix2 jacobian;
};

Foot foot_of(const CellTree& tree_b, const GraphChart& chart, const Vec3& point) {
  Foot foot{at(chart.s, 0.5), at(chart.t, 0.5), {}, {}};
  for (int step = 0;; ++step) {
    foot.jet = jet_at(tree_b.patch(), foot.s, foot.t, 1);
    foot.jacobian = {dot(chart.e1, foot.jet.u), dot(chart.e1, foot.jet.v),
                     dot(chart.e2, foot.jet.u), dot(chart.e2, foot.jet.v)};
    if (step == kFootSteps) return foot;
    const Vec3 gap = point - foot.jet.point;
    const double x = dot(chart.e1, gap), y = dot(chart.e2, gap);
    const Matrix2& j = foot.jacobian;
    const double ds = (j.d * x - j.b * y) / j.determinant();
    const double dt = (j.a * y - j.c * x) / j.determinant();
    const double s = std::clamp(foot.s + ds, chart.wide_s.from, chart.wide_s.to);
    const double t = std::clamp(foot.t + dt, chart.wide_t.from, chart.wide_t.to);
    if (std::abs(s - foot.s) + std::abs(t - foot.t) < 1e-14) return foot;
    foot.s = s;
    foot.t = t;
  }
}

// Bounds on a series with a polynomial part that ought to vanish.
std::array<double, 3> bounds_of(const TaylorSeries& f) {
  std::array<double, 3> bounds{};
  for (int k = 0; k <= kTaylorDegree; ++k) {
    double sum = 0;
    for (int j = 0; j <= k; ++j) sum += std::abs(f.terms[taylor_index(k - j, j)]);
    bounds[0] += sum;
    bounds[1] += k * sum;
    bounds[2] += k * (k - 1) * sum;
  }
  for (int d = 0; d < 3; ++d) bounds[static_cast<std::size_t>(d)] += f.tail(d);
  return bounds;
}

// Everything in the frame of a foot point: the plane part of a and b in units of the box round
// the foot, in which b's is the identity plus q.
struct Frame {
  std::array<TaylorSeries, 2> a;  // plane part of a
  std::array<TaylorSeries, 2> q;
  TaylorSeries height_a, height_b;
  double plane_scale = 0;  // box units per model unit
  double rounding = 0;     // model units
  int degree = 0;
};

// How far the heights over a tilted plane point move when the point itself is off by T, with
// its derivatives: the chain rule on g = height_b o (id + q)^-1.
std::array<double, 3> height_errors(const Frame& frame, double turn,
                                    const std::array<double, 3>& off) {
  const auto most = [](const std::array<TaylorSeries, 2>& f, std::size_t d) {
    return std::max(f[0].total[d], f[1].total[d]);
  };
  const double p1 = most(frame.a, 1), p2 = most(frame.a, 2);
  const double q2 = most(frame.q, 2), q3 = most(frame.q, 3), r = 1 / (1 - turn);
  const auto& h = frame.height_b.total;
  const double g1 = h[1] * r;
  const double g2 = (h[2] + g1 * q2) * r * r;
  const double g3 = (h[3] + 3 * g2 * q2 * (1 + turn) + g1 * q3) * r * r * r;
  return {
      g1 * off[0], g2 * off[0] * p1 + g1 * off[1],
      g3 * off[0] * p1 * p1 + g2 * (2 * p1 * off[1] + off[1] * off[1] + off[0] * p2) + g1 * off[2]};
}

std::optional<GapModel> model_in(const Frame& frame, const Foot& foot, double hs, double ht) {
  const double turn = std::max(frame.q[0].total[1], frame.q[1].total[1]);
  if (!(turn <= kMaxNonlinear)) return std::nullopt;
  // sigma = (id + q)^-1 (a)
  const TaylorPowers powers(frame.a[0].terms, frame.a[1].terms, frame.q[0].terms, frame.q[1].terms);
  const std::array<const TaylorSeries*, 2> sigma{&powers.x(), &powers.y()};
  if (!(sigma[0]->total[0] <= 1 && sigma[1]->total[0] <= 1)) return std::nullopt;

  std::array<double, 3> off{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto bounds = bounds_of(frame.a[k] - *sigma[k] - powers.compose(frame.q[k]));
    for (std::size_t d = 0; d < 3; ++d) off[d] = std::max(off[d], bounds[d]);
  }
  const double n = frame.degree;
  const double plane_rounding = frame.rounding * frame.plane_scale;
  off[0] += plane_rounding;
  off[1] += n * plane_rounding;
  off[2] += n * n * plane_rounding;

  const TaylorSeries gap = frame.height_a - powers.compose(frame.height_b);
  GapModel model;
  model.gap = gap.terms;
  model.gap_error = height_errors(frame, turn, off);
  const std::array<double, 3> growth{2, n, n * n};
  for (std::size_t d = 0; d < 3; ++d)
    model.gap_error[d] += gap.tail(static_cast<int>(d)) + growth[d] * frame.rounding;
  // With e the error of sigma, e + q(sigma + e) - q(sigma) is what `off` bounds.
  const double error = off[0] / (1 - turn);
  const double bend = std::max(frame.q[0].total[2], frame.q[1].total[2]);
  const std::array<double, 2> middle{foot.s, foot.t}, half{hs, ht};
  const double speed = std::max(sigma[0]->total[1], sigma[1]->total[1]);
  const double slope_error = (off[1] + bend * error * speed) / (1 - turn);
  for (std::size_t k = 0; k < 2; ++k) {
    model.foot[k] = sigma[k]->terms;
    for (double& c : model.foot[k]) c *= half[k];
    model.foot[k][0] += middle[k];
    model.foot_error[k] = half[k] * error;
    model.foot_slope_error[k] = half[k] * slope_error;
  }
  return model;
}

}  // namespace

std::optional<GraphChart> graph_chart(const CellTree& tree, const Interval& s, const Interval& t,
                                      double widening) {
  GraphChart chart{s, t, widened(s, widening), widened(t, widening), {}, {}, {}, {}, {}};
  const CellTree cells = tree.piece(chart.wide_s, chart.wide_t);
  const RationalBezierPatch& wide = cells.patch();
  for (const Vec4& p : wide.points.values())
    if (!(p[3] > 0)) return std::nullopt;
  const VectorBounds &du = cells[0].du, &dv = cells[0].dv;
  chart.normal = unit(cross(du.middle, dv.middle));
  chart.e1 = unit(du.middle);
  chart.e2 = cross(chart.normal, chart.e1);
  if (chart.normal == Vec3{}) return std::nullopt;
  const Matrix2 m{dot(chart.e1, du.middle), dot(chart.e1, dv.middle), dot(chart.e2, du.middle),
                  dot(chart.e2, dv.middle)};
  const double det = m.determinant();
  if (!std::isfinite(1 / det)) return std::nullopt;
  const Vec3 to_s = chart.to_s = (chart.e1 * m.d - chart.e2 * m.b) * (1 / det);
  const Vec3 to_t = chart.to_t = (chart.e2 * m.a - chart.e1 * m.c) * (1 / det);
  const bool rational = tree.shape().planes == 4;
  const auto spread = [&](const Vec3& row, const VectorBounds& d, bool along_u) {
    return rational ? dot(absolute(row), d.radius)
                    : derivative_spread(wide, row, dot(row, d.middle), along_u) +
                          4 * kMaxDegree * cells[0].margin * norm(row);
  };
  const double r11 = spread(to_s, du, true), r12 = spread(to_s, dv, false);
  const double r21 = spread(to_t, du, true), r22 = spread(to_t, dv, false);
  if (!(r11 < 1 && r22 < 1 && (1 - r11) * (1 - r22) > r12 * r21)) return std::nullopt;
  return chart;
}

bool may_have_model(const Cell& a, const GraphChart& chart) {
  const auto width = [&](const Vec3& row) {
    return std::abs(dot(row, a.du.middle)) + std::abs(dot(row, a.dv.middle));
  };
  return kBoxReserve * std::max(width(chart.to_s), width(chart.to_t)) <= kMuchWider;
}

std::optional<GapModel> gap_model(const CellTree& tree_a, const Cell& a, const CellTree& tree_b,
                                  const GraphChart& chart) {
  const bool rational = tree_a.shape().planes == 4 || tree_b.shape().planes == 4;
  const Vec3 centre = rational ? point_at(tree_a.patch(), at(a.u, 0.5), at(a.v, 0.5)) : Vec3{};
  const auto surface_a = series_of(tree_a.shape(), a.homogeneous, a.coefficients, centre);
  if (!surface_a) return std::nullopt;
  const Vec3 middle = centre + Vec3{surface_a->point[0].terms[0], surface_a->point[1].terms[0],
                                    surface_a->point[2].terms[0]};
  const Foot foot = foot_of(tree_b, chart, middle);
  const Vec3 at_foot = foot.jet.point - centre;
  const Matrix2& j = foot.jacobian;
  const double det = j.determinant();
  if (!std::isfinite(1 / det)) return std::nullopt;
  // Rows that take a vector of the plane to parameters of b.
  const Vec3 to_s = (chart.e1 * j.d - chart.e2 * j.b) * (1 / det);
  const Vec3 to_t = (chart.e2 * j.a - chart.e1 * j.c) * (1 / det);

  Frame frame;
  frame.a = {along(to_s, *surface_a), along(to_t, *surface_a)};
  frame.a[0] = frame.a[0] - taylor_series(TaylorPolynomial{dot(to_s, at_foot)});
  frame.a[1] = frame.a[1] - taylor_series(TaylorPolynomial{dot(to_t, at_foot)});
  const auto reach = [](const TaylorSeries& f) {
    double sum = f.tail(0);
    for (const double c : f.terms) sum += std::abs(c);
    return sum;
  };
  double hs = kBoxReserve * reach(frame.a[0]), ht = kBoxReserve * reach(frame.a[1]);
  // A box much thinner than long has no proven model where a is steep over the plane.
  const double ls = norm(foot.jet.u), lt = norm(foot.jet.v);
  hs = std::max(hs, 0.5 * ht * lt / ls);
  ht = std::max(ht, 0.5 * hs * ls / lt);
  const Interval box_s{foot.s - hs, foot.s + hs}, box_t{foot.t - ht, foot.t + ht};
  if (!within(box_s, chart.wide_s) || !within(box_t, chart.wide_t)) return std::nullopt;

  Planes net;
  const RationalBezierPatch round_foot = sub_patch(tree_b.patch(), box_s, box_t);
  planes_of(round_foot, tree_b.shape(), net.data());
  const auto surface_b = series_of(tree_b.shape(), net.data(), nullptr, centre);
  if (!surface_b) return std::nullopt;
  frame.q = {(1 / hs) * along(to_s, *surface_b), (1 / ht) * along(to_t, *surface_b)};
  frame.a = {(1 / hs) * frame.a[0], (1 / ht) * frame.a[1]};
  frame.q[0].terms[0] -= dot(to_s, at_foot) / hs;
  frame.q[1].terms[0] -= dot(to_t, at_foot) / ht;
  frame.q[0].terms[1] -= 1;
  frame.q[1].terms[2] -= 1;
  for (TaylorSeries* f : {&frame.q[0], &frame.q[1], &frame.a[0], &frame.a[1]}) {
    // The terms moved: their majorants anew, keeping the bounds on what was left out.
    std::array<double, 4> tails;
    for (int d = 0; d < 4; ++d) tails[static_cast<std::size_t>(d)] = f->tail(d);
    *f = taylor_series(f->terms);
    for (std::size_t d = 0; d < 4; ++d) f->total[d] += tails[d];
  }
  frame.height_a = along(chart.normal, *surface_a);
  frame.height_b = along(chart.normal, *surface_b);
  frame.plane_scale = std::max(norm(to_s) / hs, norm(to_t) / ht) * 1.5;
  frame.rounding = 2 * (surface_a->rounding + a.margin + surface_b->rounding +
                        tree_b.piece_rounding(round_foot, box_s, box_t));
  frame.degree = surface_a->degree + surface_b->degree;
  return model_in(frame, foot, hs, ht);
}

std::array<Interval, 2> part_over_patch(const GapModel& model) {
  std::array<Interval, 2> part{Interval{-1, 1}, Interval{-1, 1}};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      // slope x + rest lies in [0, 1]
      TaylorPolynomial rest = model.foot[k];
      const double slope =
          std::exchange(rest[axis == 0 ? taylor_index(1, 0) : taylor_index(0, 1)], 0);
      const TaylorRange r = range(rest, 1, 1);
      const double low = (-model.foot_error[k] - r.high) / slope;
      const double high = (1 + model.foot_error[k] - r.low) / slope;
      if (!std::isfinite(low) || !std::isfinite(high)) continue;
      part[axis].from = std::max(part[axis].from, std::min(low, high));
      part[axis].to = std::min(part[axis].to, std::max(low, high));
    }
  for (Interval& range : part) range = {0.5 * (range.from + 1), 0.5 * (range.to + 1)};
  return part;
}

}  // namespace blossom
