// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/with_surfaces/curve_surface_valley.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/bounds/value_arithmetic.h"
#include "core/cells/cell_bend.h"
#include "core/curves/limits.h"
#include "core/math/functions/convex_gap.h"
#include "core/math/interval.h"

namespace blossom {
namespace {

constexpr double kFlat = 0.5;          // how far the cell's derivatives may turn
constexpr double kBeyond = 0.1;        // of a patch; as far as its formula is used outside
constexpr double kWider = 0.05;        // of the feet's range, by which the region exceeds it
constexpr double kFootSettled = 1e-9;  // of the region: the rest is taken off to first order
constexpr double kNoise = 1e-3;        // a gap this part of the bound on its error is 0
constexpr double kBesideEnd = 0.05;    // of a run: a least value so near beyond an end counts, too
constexpr double kSlack = 1e-12;       // covers the few roundings of sums and products of bounds
constexpr double kOnBorder = 1e-13;    // of a patch

ValueRange along(const VectorBounds& bounds, const Vec3& d) {
  const double middle = dot(bounds.middle, d);
  double radius = kSlack * std::abs(middle);
  for (int k = 0; k < 3; ++k) radius += std::abs(d[k]) * bounds.radius[k];
  return {middle - radius, middle + radius};
}

ValueRange square(const ValueRange& a) {
  const double low = a.low > 0 ? a.low : a.high < 0 ? a.high : 0, most = magnitude(a);
  return {low * low, most * most};
}

class CurveSurfaceValley {
 public:
  CurveSurfaceValley(const CurveTree& curve, const CurveCell& piece, int patch,
                     const CellTree& tree, const Cell& cell,
                     const CurveSurfaceValleyOptions& options)
      : curve_(curve), piece_(piece), patch_(patch), tree_(tree), cell_(cell), options_(options) {}

  std::optional<CurveSurfaceValleyPoints> points() {
    region_ = {cell_.u, cell_.v};
    if (!make_frame(cell_) || !runs_along()) return std::nullopt;
    const auto middle = first_foot();
    if (!middle) return std::nullopt;
    const auto feet = feet_round(*middle);
    if (within(feet[0], {0, 1}) && within(feet[1], {0, 1}))
      return prove_convex(cell_) && decide() ? std::optional(result_) : std::nullopt;
    return points_beyond(feet);
  }

 private:
  struct Side {
    double x = 0, gap = 0, slope = 0, bend = 1;
    Vec2 foot;  // in the region
  };

  // The same over a region that holds the cell and the feet of the piece.
  std::optional<CurveSurfaceValleyPoints> points_beyond(const std::array<Interval, 2>& feet) {
    for (std::size_t k = 0; k < 2; ++k) {
      const double wider = kWider * length(feet[k]);
      const Interval hull{std::min(0.0, feet[k].from - wider), std::max(1.0, feet[k].to + wider)};
      region_[k] = {at(region_[k], hull.from), at(region_[k], hull.to)};
      if (!within(region_[k], {-kBeyond, 1 + kBeyond})) return std::nullopt;
    }
    const CellTree extended = tree_.piece(region_[0], region_[1]);
    const Cell whole = extended[0];
    if (!make_frame(whole) || !runs_along()) return std::nullopt;
    const auto middle = first_foot();
    if (!middle) return std::nullopt;
    for (const Interval& range : feet_round(*middle))
      if (!within(range, {0, 1})) return std::nullopt;
    return prove_convex(whole) && decide() ? std::optional(result_) : std::nullopt;
  }

  // The normal, the rows that invert the middle derivatives in the tangent plane, and how far those
  // turn. False where the feet are not proven to be unique.
  bool make_frame(const Cell& region) {
    const Vec3 &u = region.du.middle, &v = region.dv.middle;
    const Vec3 across = cross(u, v);
    const double area = dot(across, across);
    if (!(area > 0) || !std::isfinite(1 / area)) return false;
    n_ = unit(across);
    a_ = cross(v, across) * (1 / area);
    b_ = cross(across, u) * (1 / area);
    turn_ = 0;
    for (const Vec3& row : {a_, b_}) {
      double sum = kSlack;
      for (int k = 0; k < 3; ++k)
        sum += std::abs(row[k]) * (region.du.radius[k] + region.dv.radius[k]);
      turn_ = std::max(turn_, sum);
    }
    if (!(turn_ < kFlat)) return false;
    growth_ = 1 / (1 - turn_);
    stretch_ = std::max(norm(a_), norm(b_)) * growth_;
    tilt_ = magnitude(along(region.du, n_)) + magnitude(along(region.dv, n_));
    error_ = options_.rounding * (1 + tilt_ * stretch_);
    return true;
  }

  // Bounds of the foot's speed, as far as the frame holds: x' = J^-1 (a . C', b . C') with
  // |I - J| <= turn. False if the gap grows in one sense: then no valley is needed.
  bool runs_along() {
    std::size_t k = 0;
    for (const Vec3& row : {a_, b_}) {
      const double size = norm(row);
      const auto ranges = curve_.derivative_ranges(piece_, row * (1 / size));
      speed_[k] = {size * ranges[0].low, size * ranges[0].high};
      second_[k] = size * magnitude(ranges[1]);
      ++k;
    }
    fastest_ = growth_ * std::max(magnitude(speed_[0]), magnitude(speed_[1]));
    for (ValueRange& speed : speed_)
      speed = {speed.low - turn_ * fastest_, speed.high + turn_ * fastest_};
    const auto ranges = curve_.derivative_ranges(piece_, n_);
    across_ = ranges[1];
    return ranges[0].low <= tilt_ * fastest_ && ranges[0].high >= -tilt_ * fastest_;
  }

  // Newton's method for the foot at a place of the piece, from the latest one; the gap, its slope
  // and bend there. What is left of the equations is taken off to first order.
  Side side_at(double x) {
    const double width = length(piece_.local);
    const CurveJet c = curve_.jet({piece_.span, at(piece_.local, x)});
    const double du = length(region_[0]), dv = length(region_[1]);
    Side side{x, 0, 0, 1, guess_.foot + guess_rate_ * (x - guess_.x)};
    for (int k = 0; k < kFootSteps; ++k) {
      const PatchJet s =
          jet_at(tree_.patch(), at(region_[0], side.foot[0]), at(region_[1], side.foot[1]), 2);
      const Vec3 su = s.u * du, sv = s.v * dv, rest = c.point - s.point;
      const double j00 = dot(a_, su), j01 = dot(a_, sv), j10 = dot(b_, su), j11 = dot(b_, sv);
      const double d = 1 / (j00 * j11 - j01 * j10);
      const auto solve = [&](const Vec3& r) {
        const double p = dot(a_, r), q = dot(b_, r);
        return Vec2{(j11 * p - j01 * q) * d, (j00 * q - j10 * p) * d};
      };
      const double nu = dot(n_, su), nv = dot(n_, sv);
      const auto off = [&](const Vec3& r, const Vec2& y) {
        return sign_ * (dot(n_, r) - nu * y[0] - nv * y[1]);
      };
      const Vec2 step = solve(rest);
      side.foot += step;
      if (!(max_norm(step) <= kFootSettled) && k + 1 < kFootSteps) continue;
      const Vec3 first = c.first * width;
      guess_rate_ = solve(first);
      const Vec3 bent = c.second * (width * width) -
                        s.uu * (du * du * guess_rate_[0] * guess_rate_[0]) -
                        s.uv * (2 * du * dv * guess_rate_[0] * guess_rate_[1]) -
                        s.vv * (dv * dv * guess_rate_[1] * guess_rate_[1]);
      side.gap = off(rest, step);
      side.slope = off(first, guess_rate_);
      side.bend = std::clamp(off(bent, solve(bent)), least_bend_, most_bend_);
      settled_ = settled_ && max_norm(step) <= kFootSettled;
      break;
    }
    guess_ = side;
    return side;
  }

  // The foot of the middle of the piece.
  std::optional<Vec2> first_foot() {
    guess_ = {0.5, 0, 0, 1, {0.5, 0.5}};
    guess_rate_ = {};
    settled_ = true;
    const Side side = side_at(0.5);
    return settled_ ? std::optional(side.foot) : std::nullopt;
  }

  // Where the feet of the whole piece lie, from that of its middle.
  std::array<Interval, 2> feet_round(const Vec2& middle) const {
    std::array<Interval, 2> feet;
    for (std::size_t k = 0; k < 2; ++k) {
      const double reach = 0.5 * magnitude(speed_[k]), at_middle = middle[static_cast<int>(k)];
      feet[k] = {at_middle - reach, at_middle + reach};
    }
    return feet;
  }

  // h'' = n . C'' - n . S''[x', x'] - (n . S_u, n . S_v) x''
  bool prove_convex(const Cell& region) {
    const SecondDerivatives second = second_derivatives(region, tree_.shape());
    const auto bent = [&](const Vec3& d) {
      const ValueRange uu = times(along(second.uu, d), square(speed_[0]));
      const ValueRange uv = times(along(second.uv, d), times(speed_[0], speed_[1]));
      const ValueRange vv = times(along(second.vv, d), square(speed_[1]));
      return ValueRange{uu.low + 2 * uv.low + vv.low, uu.high + 2 * uv.high + vv.high};
    };
    const double rate =
        growth_ * std::max(second_[0] + magnitude(bent(a_)), second_[1] + magnitude(bent(b_)));
    const ValueRange sheet = bent(n_);
    const double loose =
        tilt_ * rate + kSlack * (magnitude(across_) + magnitude(sheet) + tilt_ * rate);
    ValueRange bend{across_.low - sheet.high - loose, across_.high - sheet.low + loose};
    sign_ = bend.low > 0 ? 1 : -1;
    if (sign_ < 0) bend = {-bend.high, -bend.low};
    least_bend_ = bend.low;
    most_bend_ = bend.high;
    if (!(least_bend_ > 0)) return false;
    half_run_ = std::sqrt(2 * (options_.tolerance + error_) / least_bend_);
    length_ = norm(curve_.jet({piece_.span, at(piece_.local, 0.5)}).first) * length(piece_.local);
    return true;
  }

  bool decide() {
    const Side low = side_at(0), high = side_at(1);
    const double slack = most_bend_ * kBesideEnd * half_run_;
    if (low.slope < slack && high.slope > -slack) {
      const auto at_place = [&](double x) { return side_at(x); };
      const Side bottom = low.slope >= 0    ? low
                          : high.slope <= 0 ? high
                                            : least_between(low, high, at_place);
      if (bottom.gap > options_.tolerance + error_) return settled_;
      const double depth = std::max(0.0, -bottom.gap - error_);
      const bool one_point = 2 * std::sqrt(2 * depth / least_bend_) * length_ <= options_.tolerance;
      if (bottom.gap >= -error_ || one_point) return add_touch(bottom) && settled_;
      return add_zero(low, bottom) && add_zero(high, bottom) && settled_;
    }
    const bool rises = low.slope >= slack;
    return decide_monotone(rises ? low : high, rises ? high : low) && settled_;
  }

  // The gap grows from `lower` to `upper`. Near an end within tolerance the next piece tells.
  bool decide_monotone(const Side& lower, const Side& upper) {
    const double most = options_.tolerance + error_;
    if (lower.gap > error_) return lower.gap > most || !ends_span(lower);
    if (upper.gap < -error_) return upper.gap < -most || !ends_span(upper);
    if (lower.gap >= -error_) return add_point(lower);
    if (upper.gap <= error_) return add_point(upper);
    return add_point(zero(upper, lower));
  }

  // A zero between an end of the piece and the least value, if there is one.
  bool add_zero(const Side& side, const Side& least) {
    if (side.gap < -error_) return side.gap < -options_.tolerance - error_ || !ends_span(side);
    return add_point(side.gap <= error_ ? side : zero(side, least));
  }

  Side zero(const Side& above, const Side& below) {
    return zero_between(
        above, below, [&](double x) { return side_at(x); }, kNoise * error_);
  }

  bool ends_span(const Side& side) const {
    const double t = at(piece_.local, side.x);
    return t <= 0 || t >= 1;
  }

  enum class Where { InPatch, Elsewhere, AtBorder };

  // How the foot of a place lies to the cell, if that may be off by `slack` of the region.
  Where where(const Side& side, const Vec2& slack) const {
    bool in_patch = true;
    for (int k = 0; k < 2; ++k) {
      const Interval& region = region_[static_cast<std::size_t>(k)];
      const Interval& cell = k == 0 ? cell_.u : cell_.v;
      const double x = at(region, side.foot[k]), more = slack[k] * length(region) + kOnBorder;
      if (x < cell.from - more || x > cell.to + more) return Where::Elsewhere;
      in_patch = in_patch && x >= -kOnBorder && x <= 1 + kOnBorder;
    }
    return in_patch ? Where::InPatch : Where::AtBorder;
  }

  Vec2 slack_for(double reach) const {
    const double off = stretch_ * options_.tolerance + fastest_ * reach;
    return {off, off};
  }

  Vec2 on_patch(const Side& side) const {
    return {std::clamp(at(region_[0], side.foot[0]), 0.0, 1.0),
            std::clamp(at(region_[1], side.foot[1]), 0.0, 1.0)};
  }

  // True if the foot, moved into the patch, is within tolerance.
  bool is_near(const Side& side) const {
    const Vec2 uv = on_patch(side);
    const CurveJet c = curve_.jet({piece_.span, at(piece_.local, side.x)});
    return distance(c.point, jet_at(tree_.patch(), uv[0], uv[1], 1).point) <= options_.tolerance;
  }

  bool add_point(const Side& side) {
    const double slope = std::abs(side.slope);
    const double within = std::min(half_run_, 2 * options_.tolerance / slope);
    const Where place = where(side, slack_for(within));
    if (place == Where::Elsewhere) return true;
    if (place == Where::AtBorder && !is_near(side)) return false;
    const double off = 4 * error_ / slope;
    const double moved = fastest_ * off + stretch_ * error_;
    FoundCurveSurfacePoint& point = result_.points[static_cast<std::size_t>(result_.count++)];
    point = {{piece_.span, std::clamp(at(piece_.local, side.x), 0.0, 1.0)},
             patch_,
             on_patch(side),
             place == Where::InPatch && off * most_bend_ <= slope,
             {off * length(piece_.local), moved * length(region_[0]), moved * length(region_[1])}};
    return true;
  }

  // Over the plane across n the surface is no steeper than tilt * stretch, so points at a height h
  // above it are no nearer than h / sqrt(1 + steep^2).
  bool add_touch(const Side& side) {
    if (2 * half_run_ * length_ > options_.longest) return false;
    const Where place = where(side, slack_for(half_run_));
    if (place == Where::Elsewhere) return true;
    if (place == Where::AtBorder && !is_near(side)) return false;
    const double t = std::clamp(at(piece_.local, side.x), 0.0, 1.0);
    const double half = half_run_ * length(piece_.local), steep = tilt_ * stretch_;
    result_.touch = {{piece_.span, t},
                     patch_,
                     on_patch(side),
                     std::max(0.0, side.gap - error_) / std::sqrt(1 + steep * steep),
                     {std::max(0.0, t - half), std::min(1.0, t + half)},
                     half_run_ * length_,
                     side.x <= 0 || side.x >= 1};
    return true;
  }

  const CurveTree& curve_;
  const CurveCell& piece_;
  const int patch_;
  const CellTree& tree_;
  const Cell& cell_;
  const CurveSurfaceValleyOptions& options_;
  std::array<Interval, 2> region_;  // of the patch
  Vec3 n_, a_, b_;                  // the frame: the normal, and the rows of the inverse
  double turn_ = 0, growth_ = 1, stretch_ = 0, tilt_ = 0, error_ = 0;
  ValueRange across_;                // second derivative of the piece along n
  std::array<ValueRange, 2> speed_;  // of the foot, by the piece's own [0, 1]
  std::array<double, 2> second_{};
  double fastest_ = 0;
  double sign_ = 1, least_bend_ = -kUnbounded, most_bend_ = kUnbounded;
  double half_run_ = 0, length_ = 0;
  Side guess_;
  Vec2 guess_rate_;
  bool settled_ = true;
  CurveSurfaceValleyPoints result_;
};

}  // namespace

std::optional<CurveSurfaceValleyPoints> pierce_valley(const CurveTree& curve,
                                                      const CurveCell& piece, int patch,
                                                      const CellTree& tree, const Cell& cell,
                                                      const CurveSurfaceValleyOptions& options) {
  return CurveSurfaceValley(curve, piece, patch, tree, cell, options).points();
}

}  // namespace blossom
