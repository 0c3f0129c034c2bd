// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/offset_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/blending/balls/chart_cell.h"
#include "core/blending/balls/detail/ball_equations.h"
#include "core/blending/balls/limits.h"
#include "core/forms/algebra/conversion.h"
#include "core/forms/algebra/interpolation.h"
#include "core/forms/evaluation.h"
#include "core/math/matrix.h"

namespace blossom {
namespace {

constexpr int kOffsetDegree = 7;
constexpr double kErrorMargin = 2;  // on errors measured at twice as many nodes a direction
constexpr int kMaxCuts = 64;        // of one span in one direction
constexpr double kPole =
    1e-9;  // |S_u x S_v| relative to its factors' sizes: a border that is a point
constexpr double kTorn = 100;  // tolerances: what two patches may differ by at a knot line

constexpr int kFine =
    2 * kOffsetDegree + 1;  // nodes a direction for measuring; every other one is a node

// What a fit needs of the nodes: Bezier points from values, and values and derivatives of Bezier
// points at the finer nodes.
struct FitTables {
  Grid<double> solve{kOffsetDegree + 1, kOffsetDegree + 1};
  Grid<double> value{kFine, kOffsetDegree + 1}, slope{kFine, kOffsetDegree + 1};

  FitTables() {
    const std::vector<double> fine = extreme_points(2 * kOffsetDegree);
    for (int k = 0; k <= kOffsetDegree; ++k) {
      std::vector<Vec2> one(kOffsetDegree + 1);
      one[static_cast<std::size_t>(k)] = {1, 0};
      const std::vector<Vec2> column = bezier_through(one).points;
      for (int i = 0; i <= kOffsetDegree; ++i) solve(i, k) = column[static_cast<std::size_t>(i)][0];
      RationalBezierCurve basis{std::vector<Vec4>(kOffsetDegree + 1, Vec4{0, 0, 0, 1})};
      basis.points[static_cast<std::size_t>(k)][0] = 1;
      for (int i = 0; i < kFine; ++i) {
        const CurveJet jet = jet_at(basis, fine[static_cast<std::size_t>(i)]);
        value(i, k) = jet.point[0];
        slope(i, k) = jet.first[0];
      }
    }
  }
};

const FitTables& fit_tables() {
  static const FitTables tables;
  return tables;
}

struct OffsetPoint {
  Vec3 point, by_u, by_v;  // by own parameters
  bool has_slopes = true;
};

// The normal where a border is a point: S_u = 0 there, so that S_u x S_v grows from 0 like
// +-S_uv x S_v, or S_u x S_uv if S_v = 0. `inwards` is the sign of the steps from the border.
std::optional<Vec3> pole_normal(const PatchJet& s, const Vec2& inwards) {
  const double u = norm(s.u), v = norm(s.v);
  const Vec3 n = u < v ? cross(s.uv, s.v) * inwards[1] : cross(s.u, s.uv) * inwards[0];
  if (!(norm(n) > kPole * norm(s.uv) * std::max(u, v))) return std::nullopt;
  return unit(n);
}

class OffsetFit {
 public:
  OffsetFit(const BezierSurface& surface, double distance, double tolerance)
      : surface_(surface), distance_(distance), tolerance_(tolerance) {}

  OffsetSurface fitted(std::vector<double> u, std::vector<double> v);

 private:
  struct Errors {
    double u = 0, v = 0;  // where one direction's nodes are those of the fit
    double both = 0, slope = 0;
  };
  struct Piece {
    RationalBezierPatch patch;
    Errors errors;
  };
  using Pieces = std::map<std::array<double, 4>, Piece>;  // by the ranges in u and v

  OffsetPoint at_node(const ChartCell& cell, const Vec2& uv, const Vec2& inwards) const;
  Piece piece(const Interval& u, const Interval& v) const;
  void check_borders(const Grid<RationalBezierPatch>& patches, const std::vector<double>& u,
                     const std::vector<double>& v) const;

  const BezierSurface& surface_;
  double distance_;
  double tolerance_;
};

OffsetPoint OffsetFit::at_node(const ChartCell& cell, const Vec2& uv, const Vec2& inwards) const {
  const PatchJet s = chart_jet(surface_, cell, uv, 2);
  const double across = norm(cross(s.u, s.v));
  const Vec2 span{length(range_of(surface_, cell, 0)), length(range_of(surface_, cell, 1))};
  const double size = (norm(s.u) + norm(s.uv) * span[1]) * (norm(s.v) + norm(s.uv) * span[0]);
  if (across > kPole * size) {
    const auto o = offset_jet(surface_, cell, uv, 1, distance_);
    if (o) return {o->offset, o->by_u, o->by_v};
  }
  const auto n = pole_normal(s, inwards);
  if (!n)
    throw InvalidInput("offset_surface: the normal vanishes at (" + std::to_string(uv[0]) + ", " +
                       std::to_string(uv[1]) + ")");
  return {s.point + distance_ * *n, {}, {}, false};
}

OffsetFit::Piece OffsetFit::piece(const Interval& u, const Interval& v) const {
  const ChartCell cell = cell_at(surface_, {at(u, 0.5), at(v, 0.5)});
  static const std::vector<double> fine = extreme_points(2 * kOffsetDegree);
  std::array<double, kFine> own_u, own_v, rate_u, rate_v;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    own_u[i] = parameter_at(surface_.u_law, u, fine[i]);
    own_v[i] = parameter_at(surface_.v_law, v, fine[i]);
    rate_u[i] = parameter_derivative(surface_.u_law, u, fine[i]);
    rate_v[i] = parameter_derivative(surface_.v_law, v, fine[i]);
  }
  Grid<OffsetPoint> points(kFine, kFine);
  Grid<Vec3> nodes(kOffsetDegree + 1, kOffsetDegree + 1);
  for (int i = 0; i < kFine; ++i)
    for (int j = 0; j < kFine; ++j) {
      const auto iu = static_cast<std::size_t>(i), jv = static_cast<std::size_t>(j);
      points(i, j) = at_node(cell, {own_u[iu], own_v[jv]},
                             {i < kOffsetDegree ? 1.0 : -1.0, j < kOffsetDegree ? 1.0 : -1.0});
      if (i % 2 == 0 && j % 2 == 0) nodes(i / 2, j / 2) = points(i, j).point;
    }
  const FitTables& tables = fit_tables();
  const Grid<Vec3> net = product_transposed(product(tables.solve, nodes), tables.solve);
  const Grid<Vec3> by_rows = product(tables.value, net);
  const Grid<Vec3> value = product_transposed(by_rows, tables.value),
                   slope_u = product_transposed(product(tables.slope, net), tables.value),
                   slope_v = product_transposed(by_rows, tables.slope);
  Piece piece{homogeneous({net}), {}};
  Errors& errors = piece.errors;
  for (int i = 0; i < kFine; ++i)
    for (int j = 0; j < kFine; ++j) {
      if (i % 2 == 0 && j % 2 == 0) continue;
      const OffsetPoint& exact = points(i, j);
      const double off = distance(value(i, j), exact.point);
      errors.both = std::max(errors.both, off);
      if (j % 2 == 0) errors.u = std::max(errors.u, off);
      if (i % 2 == 0) errors.v = std::max(errors.v, off);
      if (!exact.has_slopes) continue;
      const Vec3 u_off = slope_u(i, j) - exact.by_u * rate_u[static_cast<std::size_t>(i)],
                 v_off = slope_v(i, j) - exact.by_v * rate_v[static_cast<std::size_t>(j)];
      errors.slope = std::max({errors.slope, norm(u_off), norm(v_off)});
    }
  return piece;
}

// Neighbours have the same nodes on their common border, so they only differ if S has a crease.
void OffsetFit::check_borders(const Grid<RationalBezierPatch>& patches,
                              const std::vector<double>& u, const std::vector<double>& v) const {
  const auto torn = [&](const Vec4& a, const Vec4& b) {
    return distance(projected(a), projected(b)) > kTorn * tolerance_;
  };
  for (int i = 0; i < patches.rows(); ++i)
    for (int j = 0; j < patches.columns(); ++j)
      for (int k = 0; k <= kOffsetDegree; ++k) {
        const Grid<Vec4>& p = patches(i, j).points;
        if (i + 1 < patches.rows() && torn(p(kOffsetDegree, k), patches(i + 1, j).points(0, k)))
          throw InvalidInput("offset_surface: the normal jumps at u = " +
                             std::to_string(u[static_cast<std::size_t>(i) + 1]));
        if (j + 1 < patches.columns() && torn(p(k, kOffsetDegree), patches(i, j + 1).points(k, 0)))
          throw InvalidInput("offset_surface: the normal jumps at v = " +
                             std::to_string(v[static_cast<std::size_t>(j) + 1]));
      }
}

// Every span is cut into equal parts, as many as its worst piece asks for.
std::vector<double> with_cuts(const std::vector<double>& knots, const std::vector<int>& parts) {
  std::vector<double> cuts{knots.front()};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (int k = 1; k < parts[i]; ++k)
      cuts.push_back(at({knots[i], knots[i + 1]}, static_cast<double>(k) / parts[i]));
    cuts.push_back(knots[i + 1]);
  }
  return cuts;
}

OffsetSurface OffsetFit::fitted(std::vector<double> u, std::vector<double> v) {
  Pieces known;
  for (int round = 0; round < kMaxCuts; ++round) {
    const int rows = static_cast<int>(u.size()) - 1, columns = static_cast<int>(v.size()) - 1;
    Grid<RationalBezierPatch> patches(rows, columns);
    std::vector<int> u_parts(static_cast<std::size_t>(rows), 1),
        v_parts(static_cast<std::size_t>(columns), 1);
    OffsetSurface result;
    bool good = true;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        const auto iu = static_cast<std::size_t>(i), jv = static_cast<std::size_t>(j);
        const auto [fit, is_new] = known.try_emplace({u[iu], u[iu + 1], v[jv], v[jv + 1]});
        if (is_new) fit->second = piece({u[iu], u[iu + 1]}, {v[jv], v[jv + 1]});
        patches(i, j) = fit->second.patch;
        const Errors& errors = fit->second.errors;
        result.error = std::max(result.error, kErrorMargin * errors.both);
        result.slope_error = std::max(result.slope_error, kErrorMargin * errors.slope);
        if (kErrorMargin * errors.both <= tolerance_) continue;
        good = false;
        // The direction that has most of the error, or both.
        if (errors.u >= 0.5 * errors.v) u_parts[iu] = 2;
        if (errors.v >= 0.5 * errors.u) v_parts[jv] = 2;
      }
    if (!good) {
      u = with_cuts(u, u_parts);
      v = with_cuts(v, v_parts);
      if (u.size() * v.size() > static_cast<std::size_t>(kMaxCuts) * kMaxCuts) break;
      continue;
    }
    check_borders(patches, u, v);
    result.surface = {u, v, surface_.u_law, surface_.v_law, std::move(patches)};
    result.surface.error = result.error;
    return result;
  }
  throw InvalidInput("offset_surface: no fit within the tolerance, by " + std::to_string(kMaxCuts) +
                     " cuts a direction");
}

// The ends of a range and the knots inside of it; of a closed direction the part may begin before
// its knots or end behind them.
std::vector<double> knots_in(const std::vector<double>& knots, const Interval& range, bool closed) {
  const double slack = kRangeSlack * length(range), period = knots.back() - knots.front();
  std::vector<double> result{range.from, range.to};
  const double first = closed ? std::floor((range.from - knots.front()) / period) : 0;
  for (const double turns : {first, first + (closed ? 1 : 0)})
    for (const double knot : knots) {
      const double x = knot + turns * period;
      if (x > range.from + slack && x < range.to - slack) result.push_back(x);
    }
  std::sort(result.begin(), result.end());
  result.erase(
      std::unique(result.begin(), result.end(), [&](double a, double b) { return b - a <= slack; }),
      result.end());
  return result;
}

bool is_whole(const std::vector<double>& knots, const Interval& range) {
  return range.from == knots.front() && range.to == knots.back();
}

}  // namespace

OffsetSurface offset_surface(const BezierSurface& surface, const ChartRectangle& part,
                             double distance, double tolerance) {
  validate(BallSupport{&surface, part, 1}, "to offset");
  if (!std::isfinite(distance) || !(tolerance > 0))
    throw InvalidInput("offset_surface: the distance is not finite, or the tolerance not positive");
  OffsetSurface result = OffsetFit(surface, distance, tolerance)
                             .fitted(knots_in(surface.u_knots, part.u, surface.closed_u),
                                     knots_in(surface.v_knots, part.v, surface.closed_v));
  result.surface.closed_u = surface.closed_u && is_whole(surface.u_knots, part.u);
  result.surface.closed_v = surface.closed_v && is_whole(surface.v_knots, part.v);
  return result;
}

}  // namespace blossom
