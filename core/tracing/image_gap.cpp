// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/image_gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "core/base/unbounded.h"
#include "core/math/roundoff.h"
#include "core/math/spans.h"
#include "core/tracing/image_series.h"
#include "core/tracing/local_form.h"
#include "core/tracing/sites.h"

namespace blossom {
namespace {

constexpr double kWeightError = 1e-3;    // of the inverse of a piece's weight, relative
constexpr double kRestShare = 1.0 / 64;  // of a gap, that its series may leave out
constexpr double kStray = 1e-3;          // a piece's way out of its patch, in local parameters
constexpr double kFormError = 2e-11;     // model units, of a polynomial for another function
constexpr double kFalseStray = 2;        // of a form's values: farther out only its points are
constexpr int kStrayHalvings = 6;        // then a stray is taken for a true one
constexpr int kBits = 48;                // of a parameter where the chart curve is cut
// Making the points of a span, or of its half, rounds 30 times.
constexpr double kConvexSums = 32 * kUnitRoundoff;

// Parameters in (0, 1) where a form passes zero, by halving wherever its coefficients change sign:
// no more often than they do in all, so this ends soon. Rounding may miss a root at an end.
void add_roots(const std::array<double, 6>& c, double from, double to, int depth,
               std::vector<double>& roots) {
  int changes = 0;
  for (std::size_t i = 0; i < 5; ++i) changes += (c[i] < 0) != (c[i + 1] < 0);
  if (changes == 0) return;
  if (depth == kBits) return roots.push_back(0.5 * (from + to));
  std::array<double, 6> left, right = c;
  for (std::size_t k = 0; k <= 5; ++k) {
    left[k] = right[0];
    for (std::size_t i = 0; i + k < 5; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
  }
  const double middle = 0.5 * (from + to);
  add_roots(left, from, middle, depth + 1, roots);
  add_roots(right, middle, to, depth + 1, roots);
}

void add_crossings(const QuinticPoints& points, int coordinate, std::span<const double> knots,
                   std::vector<double>& cuts) {
  std::array<double, 6> c;
  for (std::size_t i = 0; i <= 5; ++i) c[i] = points[i][coordinate];
  const auto [low, high] = std::minmax_element(c.begin(), c.end());
  const auto first = std::upper_bound(knots.begin(), knots.end(), *low);
  const auto last = std::lower_bound(knots.begin(), knots.end(), *high);
  for (auto knot = first; knot < last; ++knot) {
    std::array<double, 6> d = c;
    for (double& x : d) x -= *knot;
    add_roots(d, 0, 1, 0, cuts);
  }
}

double largest_norm(std::span<const Vec3> points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max(largest, dot(p, p));
  return std::sqrt(largest);
}

Interval knots(const std::vector<double>& all, int span) {
  return {all[static_cast<std::size_t>(span)], all[static_cast<std::size_t>(span) + 1]};
}

// `rounding`: of the piece's points, relative to the largest parameter.
LocalForm local(const QuinticPoints& piece, int coordinate, ParameterLaw law, const Interval& span,
                double rounding) {
  std::array<double, 6> c;
  double largest = std::abs(span.from);
  for (std::size_t i = 0; i <= 5; ++i) {
    c[i] = piece[i][coordinate];
    largest = std::max(largest, std::abs(c[i]));
  }
  LocalForm result = local_form(c, law, span, kSeriesChartDegree);
  // A local parameter of an angle grows at most twice as fast as that of a line.
  result.rounding += 2 * (rounding + 4 * kUnitRoundoff) * largest / length(span);
  const auto [low, high] = std::ranges::minmax(result.points());
  result.rounding += power_rounding(result.degree) * (high - low) + 2 * kUnitRoundoff;
  return result;
}

// How far numbers leave [0, 1].
double stray(std::span<const double> numbers) {
  const auto [low, high] = std::ranges::minmax(numbers);
  return std::max({0.0, -low, high - 1});
}

// Ends and middle of a form.
std::array<double, 3> values_of(const LocalForm& form) {
  auto p = form.coefficients;
  for (int level = form.degree; level > 0; --level)
    for (std::size_t i = 0; i < static_cast<std::size_t>(level); ++i)
      p[i] = 0.5 * (p[i] + p[i + 1]);
  return {form.points().front(), p.front(), form.points().back()};
}

PowerSeries<double> weight_of(const PowerSeries<Vec4>& image) {
  PowerSeries<double> weight;
  for (std::size_t k = 0; k <= kSeriesDegree; ++k) weight.terms[k] = image.terms[k][3];
  weight.rest = image.rest[3];
  return weight;
}

// X - w C.
PowerSeries<Vec3> difference(const PowerSeries<Vec4>& image, const PowerSeries<Vec3>& weighted) {
  PowerSeries<Vec3> result;
  for (std::size_t k = 0; k <= kSeriesDegree; ++k)
    result.terms[k] = head(image.terms[k]) - weighted.terms[k];
  result.rest = head(image.rest) + weighted.rest;
  return result;
}

// With r near 1 / w and w r = 1 + e the gap (X - w C) / w is (X - w C) r, but for |e| of itself.
// Returns how large r is, and |e|: 1 or more where there is no such r. `rounded`: the weight.
std::pair<double, double> divide(PowerSeries<Vec3>& gap, const PowerSeries<double>& weight,
                                 double rounded) {
  const PowerSeries<double> inverse = reciprocal(weight);
  PowerSeries<double> one = product(weight, inverse);
  one.terms[0] -= 1;
  const double size = absolute_sum(inverse);
  const double rounding =
      ((2 * kSeriesDegree + 8) * kUnitRoundoff * absolute_sum(weight) + rounded) * size;
  const double off = absolute_sum(one) + one.rest + rounding;
  if (off < kWeightError) gap = product(inverse, gap);
  return {size, off};
}

}  // namespace

// The inverse of a weight falls off slowly.
ImageGaps::ImageGaps(const BezierSurface& surface, int chart)
    : surface_(surface), first_(chart), short_series_(!surface.rational) {}

void ImageGaps::add_cuts(const QuinticPoints& points, std::vector<double>& cuts) const {
  for (const auto& [coordinate, all] :
       {std::pair{first_, std::span(surface_.u_knots)}, {first_ + 1, std::span(surface_.v_knots)}})
    add_crossings(points, coordinate, all.subspan(1, all.size() - 2), cuts);
}

std::optional<ImageGap> ImageGaps::on(const QuinticPoints& piece, int halvings) {
  const Vec7 middle = value_at(piece, 0.5);
  const int i = static_cast<int>(span_of(surface_.u_knots, middle[first_]));
  const int j = static_cast<int>(span_of(surface_.v_knots, middle[first_ + 1]));
  const RationalBezierPatch& patch = surface_.patches(i, j);
  const double rounding = kConvexSums * (2 + halvings);
  const LocalForm u = local(piece, first_, surface_.u_law, knots(surface_.u_knots, i), rounding);
  const LocalForm v =
      local(piece, first_ + 1, surface_.v_law, knots(surface_.v_knots, j), rounding);
  const double stray_u = stray(u.points()), stray_v = stray(v.points());
  if (!(std::max(stray_u, stray_v) <= kStray)) return {};
  std::optional<ImageGap> result;
  if (short_series_) result = composed(patch, u, v, piece, rounding, kShortSeriesDegree);
  short_series_ = result.has_value();
  if (!result) result = composed(patch, u, v, piece, rounding, kSeriesDegree);
  if (!result) return {};
  if (stray_u + stray_v > 0) {
    // Beyond its border the patch is continued where the surface goes on in the next one, or
    // ends: both leave the border no faster than by their slopes.
    const Slopes around = slopes_beside(i, j);
    const double margin = 3.3 * (stray_u * around.u + stray_v * around.v);
    // Beside a line that the curve touches the control points alone stray: halving ends that.
    if (halvings < kStrayHalvings &&
        margin > std::max(kFormError, kRestShare * largest_norm(result->form.points())) &&
        stray_u + stray_v > kFalseStray * (stray(values_of(u)) + stray(values_of(v))))
      return {};
    result->margin += margin;
  }
  return result;
}

std::optional<ImageGap> ImageGaps::composed(const RationalBezierPatch& patch, const LocalForm& u,
                                            const LocalForm& v, const QuinticPoints& piece,
                                            double rounding, std::size_t degree) const {
  // Relative to a point of the curve, so that little is rounded.
  const Vec3 origin = space(piece[0]);
  std::array<Vec3, 6> points;
  for (std::size_t k = 0; k < points.size(); ++k) points[k] = space(piece[k]) - origin;
  const PowerSeries<Vec3> curve = power_series(points);
  const ImageSeries series = image_series(patch, origin, power_series(u.points()),
                                          power_series(v.points()), kFormError, degree);
  ImageGap result;
  double inverse = 1;
  PowerSeries<Vec3> gap;
  if (surface_.rational) {
    const PowerSeries<double> weight = weight_of(series.image);
    gap = difference(series.image, product(weight, curve, kFitDegree));
    std::tie(inverse, result.relative) = divide(gap, weight, series.rounding[3]);
    if (!(result.relative < kWeightError)) return {};
  } else {
    gap = difference(series.image, curve);
  }
  result.form = bezier_form(gap, degree);
  const double seen = largest_norm(result.form.points());
  const double reach = norm(absolute_sum(curve));
  // (X / w)' = (X' - (X / w) w') / w.
  const auto slope = [&](const Vec4& by) {
    return 1.1 * inverse * (norm(head(by)) + (reach + seen) * by[3]);
  };
  const double slope_u = slope(series.slope_u), slope_v = slope(series.slope_v);
  const double rest = norm(gap.rest) + u.error * slope_u + v.error * slope_v;
  if (!(rest <= std::max(kFormError, kRestShare * seen))) return {};
  const double weight = surface_.rational ? series.size[3] : 1;
  const double rounded =
      max_norm(head(series.rounding)) + (surface_.rational ? series.rounding[3] * reach : 0) +
      (rounding + 4 * kUnitRoundoff) *
          (max_norm(head(series.size)) + weight * (max_norm(origin) + reach)) +
      weight * (power_rounding(kFitDegree) * largest_norm(points) + 64 * kUnitRoundoff * reach);
  result.margin = 2 * rounded * inverse + rest + u.rounding * slope_u + v.rounding * slope_v;
  return result;
}

ImageGaps::Slopes ImageGaps::slopes_of(const RationalBezierPatch& patch) {
  const Vec4& corner = patch.points(0, 0);
  const Vec3 centre = projected(corner);
  double radius = 0, least = kUnbounded;
  Grid<Vec3> net(patch.points.rows(), patch.points.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) {
      const Vec4& p = patch.points(i, j);
      net(i, j) = Vec3{p[0], p[1], p[2]} - p[3] * centre;
      radius = std::max(radius, norm(net(i, j)) / p[3]);
      least = std::min(least, p[3]);
    }
  // w S_u = X_u - S w_u.
  const auto step = [&](int i, int j, int k, int l) {
    return norm(net(k, l) - net(i, j)) +
           radius * std::abs(patch.points(k, l)[3] - patch.points(i, j)[3]);
  };
  Slopes slopes{0, 0};
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) {
      if (i + 1 < net.rows()) slopes.u = std::max(slopes.u, step(i, j, i + 1, j));
      if (j + 1 < net.columns()) slopes.v = std::max(slopes.v, step(i, j, i, j + 1));
    }
  if (!(least > 0)) return {kUnbounded, kUnbounded};
  slopes.u *= patch.degree_u() / least;
  slopes.v *= patch.degree_v() / least;
  return slopes;
}

const ImageGaps::Slopes& ImageGaps::slopes(int i, int j) {
  const auto [known, added] = slopes_.try_emplace({i, j});
  if (added) known->second = slopes_of(surface_.patches(i, j));
  return known->second;
}

// The largest of the patch and its neighbours, that a piece strays into if by little; by the
// local parameters of the patch.
ImageGaps::Slopes ImageGaps::slopes_beside(int i, int j) {
  const auto width = [](const std::vector<double>& all, int k) { return length(knots(all, k)); };
  Slopes largest;
  for (int k = std::max(i - 1, 0); k <= std::min(i + 1, surface_.patches.rows() - 1); ++k)
    for (int l = std::max(j - 1, 0); l <= std::min(j + 1, surface_.patches.columns() - 1); ++l) {
      const double u = width(surface_.u_knots, i) / width(surface_.u_knots, k);
      const double v = width(surface_.v_knots, j) / width(surface_.v_knots, l);
      largest.u = std::max(largest.u, u * slopes(k, l).u);
      largest.v = std::max(largest.v, v * slopes(k, l).v);
    }
  return largest;
}

}  // namespace blossom
