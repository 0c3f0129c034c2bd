// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/with_surfaces/curve_surface_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/cells/limits.h"
#include "core/curves/contact_length.h"
#include "core/curves/limits.h"
#include "core/math/linear_solve.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

constexpr int kSurfaceNewtonSteps = 20;
constexpr double kSurfaceSettled = 1e-15;
constexpr int kKrawczykSteps = 6;
constexpr double kRoundingOfSpread = 1e-12;  // part of it, generously
constexpr double kRoundingOfPlace = 1e-14;   // part of a patch: many roundings of a parameter

bool are_disjoint(const ValueRange& a, double low, double high, double tolerance) {
  return a.low > high + tolerance || low > a.high + tolerance;
}

bool within(double t, const Interval& range, double slack) {
  return t >= range.from - slack && t <= range.to + slack;
}

}  // namespace

SurfaceTrees::SurfaceTrees(const BezierSurface& surface, const Vec3& origin, CellForm form)
    : surface_(surface) {
  double scale = max_norm(origin);
  int degree = 0;
  for (const RationalBezierPatch& patch : surface.patches.values()) {
    trees_.push_back(std::make_unique<CellTree>(patch, surface.rational, origin, form, kOffMiddle));
    degree = std::max(degree, patch.degree_u() + patch.degree_v());
    const RationalBezierPatch& moved = trees_.back()->patch();
    for (const Vec4& p : moved.points.values())
      for (int k = 0; k < 3; ++k) scale = std::max(scale, std::abs(p[k] / p[3]));
  }
  // Weights of each direction carry 3 roundings a degree, sums one a term, the quotient as much.
  evaluation_margin_ = (8.0 * degree + 16) * kUnitRoundoff * scale;
}

Vec2 SurfaceTrees::parameters(int patch, const Vec2& uv) const {
  const auto i = static_cast<std::size_t>(patch / surface_.patches.columns());
  const auto j = static_cast<std::size_t>(patch % surface_.patches.columns());
  return {parameter_at(surface_.u_law, {surface_.u_knots[i], surface_.u_knots[i + 1]}, uv[0]),
          parameter_at(surface_.v_law, {surface_.v_knots[j], surface_.v_knots[j + 1]}, uv[1])};
}

std::optional<CurveSurfaceParameters> curve_surface_point(const CurveTree& curve, int span,
                                                          const Interval& t,
                                                          const RationalBezierPatch& patch,
                                                          const Interval& u, const Interval& v) {
  CurveSurfaceParameters x{at(t, 0.5), {at(u, 0.5), at(v, 0.5)}};
  const auto inside = [](double value, const Interval& range) {
    return within(value, range, kNewtonReach * length(range));
  };
  double last = 1;
  for (int k = 0; k < kSurfaceNewtonSteps; ++k) {
    const CurveJet c = curve.jet({span, x.t});
    const PatchJet s = jet_at(patch, x.uv[0], x.uv[1], 1);
    const auto step = solved(c.first, -s.u, -s.v, s.point - c.point);
    if (!step) return std::nullopt;
    x = {x.t + (*step)[0], {x.uv[0] + (*step)[1], x.uv[1] + (*step)[2]}};
    if (!inside(x.t, t) || !inside(x.uv[0], u) || !inside(x.uv[1], v)) return std::nullopt;
    const double size = max_norm(*step);
    if (size < kSurfaceSettled || (size < kNewtonStalled && size > 0.25 * last)) return x;
    last = size;
  }
  return std::nullopt;
}

CurveSurfaceSearch::CurveSurfaceSearch(CurveTree& curve, SurfaceTrees& surface, SharedWork& work,
                                       double tolerance)
    : curve_(curve),
      surface_(surface),
      work_(work),
      tolerance_(tolerance),
      valley_{tolerance, curve_touch_length(tolerance, curve.size()),
              4 * (curve.evaluation_margin() + surface.evaluation_margin())} {}

CurveSurfaceFindings CurveSurfaceSearch::run(const std::vector<CurveSurfaceContact>& inside) {
  inside_ = &inside;
  for (int i = 0; i < curve_.spans(); ++i)
    for (int p = 0; p < surface_.count(); ++p) {
      if (separated(curve_[i], surface_[p][0]))
        ++found_.excluded;
      else
        pairs_.push_back({i, p, 0});
    }
  work_off();
  return std::move(found_);
}

CurveSurfaceFindings CurveSurfaceSearch::run_within(
    const std::vector<CurveSurfaceContact>& contacts,
    const std::vector<CurveSurfaceContact>& inside) {
  inside_ = &inside;
  for (const CurveSurfaceContact& c : contacts) pairs_.push_back({c.cell, c.patch, c.surface_cell});
  work_off();
  return std::move(found_);
}

void CurveSurfaceSearch::work_off() {
  while (!pairs_.empty()) {
    found_.stopped = work_.step();
    if (found_.stopped) break;
    const Pair pair = pairs_.back();
    pairs_.pop_back();
    examine(pair);
  }
  for (const Pair& pair : pairs_) found_.open.push_back(contact(pair));
}

void CurveSurfaceSearch::examine(const Pair& pair) {
  const CurveCell& c = curve_[pair.cell];
  const Cell& s = surface_[pair.patch][pair.surface_cell];
  if (separated(c, s)) {
    ++found_.excluded;
    return;
  }
  if (is_inside(c, pair, s)) return;
  if (settle(c, pair, s) || settle_valley(c, pair, s)) {
    ++found_.certified;
    return;
  }
  const double least = tolerance_ + 8 * (c.margin + s.margin);
  const bool is_place = std::max(c.extent, s.extent) <= least, in_slab = within_slab(c, s);
  const Over over_cell =
      is_place || !in_slab ? Over::All : over(c, s, surface_[pair.patch].patch());
  if (over_cell == Over::None)
    ++found_.excluded;
  else if (is_place || (in_slab && over_cell == Over::All))
    found_.contacts.push_back(contact(pair));
  else
    halve(pair, in_slab ? over_cell == Over::Part : c.extent >= s.extent);
}

void CurveSurfaceSearch::halve(const Pair& pair, bool curve) {
  const int child = curve ? curve_.split(pair.cell) : surface_[pair.patch].split(pair.surface_cell);
  for (const int half : {child, child + 1})
    pairs_.push_back({curve ? half : pair.cell, pair.patch, curve ? pair.surface_cell : half});
}

bool CurveSurfaceSearch::separated(const CurveCell& c, const Cell& s) const {
  for (int k = 0; k < 3; ++k)
    if (are_disjoint({c.low[k], c.high[k]}, s.low[k], s.high[k], tolerance_)) return true;
  if (s.plane.normal == Vec3{}) return false;
  return are_disjoint(range_along(c, 3, s.plane.normal), s.plane.low, s.plane.high, tolerance_);
}

bool CurveSurfaceSearch::within_slab(const CurveCell& c, const Cell& s) const {
  if (s.plane.normal == Vec3{}) return false;
  const ValueRange range = range_along(c, 3, s.plane.normal);
  const double thickness = std::max(range.high, s.plane.high) - std::min(range.low, s.plane.low);
  return thickness <= tolerance_ + 8 * (c.margin + s.margin);
}

// Which part of a curve in the slab of a cell is over it, by its heights along the rows a and b
// that invert the middle derivatives: for a place (u, v) of the cell, from its middle on,
//   a . (S - S_middle) = u +- turn / 2,   turn = sum |a_k| (rad S_u + rad S_v)_k
// So nothing of the cell is beyond (1 + turn) / 2, and all up to (1 - turn) / 2 is covered: a
// smaller cell tells of what is between, unless that is within the tolerance. A curve as short as
// the tolerance is over the cell where a part of it is.
CurveSurfaceSearch::Over CurveSurfaceSearch::over(const CurveCell& c, const Cell& s,
                                                  const RationalBezierPatch& patch) const {
  const Vec3 &u = s.du.middle, &v = s.dv.middle, across = cross(u, v);
  const double area = dot(across, across);
  if (!(area > 0) || !std::isfinite(1 / area)) return Over::All;
  const Vec3 middle = jet_at(patch, at(s.u, 0.5), at(s.v, 0.5), 1).point;
  const double least = tolerance_ + 8 * (c.margin + s.margin);
  bool is_part = false, is_known = true, is_sharp = true;
  for (const Vec3& row : {cross(v, across) * (1 / area), cross(across, u) * (1 / area)}) {
    const double size = norm(row), slack = size * least;
    double turn = 0;
    for (int k = 0; k < 3; ++k) turn += std::abs(row[k]) * (s.du.radius[k] + s.dv.radius[k]);
    const double reach = 0.5 * (1 + turn) + slack, covered = turn <= slack ? reach : reach - turn;
    const ValueRange heights = range_along(c, 3, row * (1 / size));
    const double from = size * heights.low - dot(row, middle),
                 to = size * heights.high - dot(row, middle);
    if (from > reach || to < -reach) return Over::None;
    is_part = is_part || from < -reach || to > reach;
    is_sharp = is_sharp && turn <= slack;
    is_known = is_known && from >= -covered && to <= covered;
  }
  if (is_part && c.extent > least) return Over::Part;
  return is_known || is_sharp || s.extent <= least ? Over::All : Over::Unknown;
}

VectorBounds CurveSurfaceSearch::derivative(const CurveCell& c) const {
  VectorBounds bounds;
  for (int k = 0; k < 3; ++k) {
    Vec3 direction;
    direction[k] = 1;
    const ValueRange range = curve_.derivative_ranges(c, direction)[0];
    bounds.middle[k] = 0.5 * (range.low + range.high);
    bounds.radius[k] = 0.5 * (range.high - range.low);
  }
  return bounds;
}

// The cell is a graph over some plane, in which the curve lies: elsewhere in the cell there is no
// common point.
bool CurveSurfaceSearch::is_inside(const CurveCell& c, const Pair& pair, const Cell& s) const {
  const auto meets = [](const Interval& a, const Interval& b) {
    return a.from <= b.to && b.from <= a.to;
  };
  for (const CurveSurfaceContact& piece : *inside_) {
    if (piece.span != c.span || piece.patch != pair.patch) continue;
    if (!(piece.t.from <= c.local.from && c.local.to <= piece.t.to)) continue;
    if (!meets(piece.u, s.u) || !meets(piece.v, s.v)) continue;
    const VectorBounds normal{cross(s.du.middle, s.dv.middle), Vec3{}};
    if (JacobianBounds(normal, s).minor(1).regular) return true;
  }
  return false;
}

// The one common point that a pair with regular Jacobian can have. False if it is not decided.
bool CurveSurfaceSearch::settle(const CurveCell& c, const Pair& pair, const Cell& s) {
  const Minor minor = JacobianBounds(derivative(c), s).minor(1);
  if (!minor.regular) return false;
  const RationalBezierPatch& patch = surface_[pair.patch].patch();
  const auto found = curve_surface_point(curve_, c.span, c.local, patch, s.u, s.v);
  if (!found) return krawczyk_empties(c, pair.patch, s, minor);
  // How far an error of the distance moves the solution, as parts of the cells.
  const auto reach = [&](std::size_t row, double error) {
    double sum = 0;
    for (const double x : minor.inverse[row]) sum += std::abs(x);
    return 2 * sum * error;
  };
  const double rounding = valley_.rounding;
  const auto inside = [&](double error) {
    return within(found->t, c.local, reach(0, error) * length(c.local) + kSurfaceParameterSlack) &&
           within(found->uv[0], s.u, reach(1, error) * length(s.u) + kSurfaceParameterSlack) &&
           within(found->uv[1], s.v, reach(2, error) * length(s.v) + kSurfaceParameterSlack);
  };
  if (!inside(tolerance_)) return krawczyk_empties(c, pair.patch, s, minor);
  const SpanPoint t{c.span, std::clamp(found->t, 0.0, 1.0)};
  const Vec2 uv{std::clamp(found->uv[0], 0.0, 1.0), std::clamp(found->uv[1], 0.0, 1.0)};
  const double gap = distance(curve_.jet(t).point, jet_at(patch, uv[0], uv[1], 1).point);
  const bool exact = gap <= rounding;
  if (exact || gap <= tolerance_) {
    found_.points.push_back(
        {t, pair.patch, uv, exact,
         Vec3{reach(0, rounding) * length(c.local), reach(1, rounding) * length(s.u),
              reach(2, rounding) * length(s.v)}});
    return true;
  }
  return krawczyk_empties(c, pair.patch, s, minor);
}

// False if the gap is not proven to be a valley.
bool CurveSurfaceSearch::settle_valley(const CurveCell& c, const Pair& pair, const Cell& s) {
  const auto valley = pierce_valley(curve_, c, pair.patch, surface_[pair.patch], s, valley_);
  if (!valley) return false;
  for (int i = 0; i < valley->count; ++i)
    found_.points.push_back(valley->points[static_cast<std::size_t>(i)]);
  if (valley->touch) found_.touches.push_back(*valley->touch);
  return true;
}

// Any root in the box with middle y and radius r lies in y - C F(y) +- E r; intersecting again and
// again empties the box if there is none. In the cells' own parameters.
// Source: Krawczyk 1969.
bool CurveSurfaceSearch::krawczyk_empties(const CurveCell& c, int patch, const Cell& s,
                                          const Minor& minor) const {
  std::array<double, 3> y{0.5, 0.5, 0.5}, radius{0.5, 0.5, 0.5};
  const double rounding = valley_.rounding;
  for (int step = 0; step < kKrawczykSteps; ++step) {
    const Vec3 f = curve_.jet({c.span, at(c.local, y[0])}).point -
                   jet_at(surface_[patch].patch(), at(s.u, y[1]), at(s.v, y[2]), 1).point;
    std::array<double, 3> next{};
    for (std::size_t i = 0; i < 3; ++i) {
      double shift = 0, spread = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        shift += minor.inverse[i][j] * f[static_cast<int>(j)];
        spread += minor.spread[i][j] * radius[j] + std::abs(minor.inverse[i][j]) * rounding;
      }
      spread = spread * (1 + kRoundingOfSpread) + kRoundingOfPlace;
      const double low = std::max(y[i] - shift - spread, y[i] - radius[i]);
      const double high = std::min(y[i] - shift + spread, y[i] + radius[i]);
      if (low > high) return true;
      y[i] = 0.5 * (low + high);
      next[i] = 0.5 * (high - low);
    }
    radius = next;
  }
  return false;
}

CurveSurfaceContact CurveSurfaceSearch::contact(const Pair& pair) const {
  const CurveCell& c = curve_[pair.cell];
  const Cell& s = surface_[pair.patch][pair.surface_cell];
  return {c.span, c.local, pair.patch, s.u, s.v, pair.cell, pair.surface_cell};
}

}  // namespace blossom
