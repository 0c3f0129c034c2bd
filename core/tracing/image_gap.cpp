// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/image_gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/blossom/composition.h"
#include "core/forms/degree.h"
#include "core/forms/products.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/tracing/local_form.h"
#include "core/tracing/sites.h"

namespace blossom {
namespace {

constexpr double kUnit = 0x1p-53;
constexpr double kWeightSpread = 0.05;   // of a piece's weights round their middle
constexpr double kStray = 1e-3;          // a piece's way out of its patch, in local parameters
constexpr double kFormError = 2e-11;     // model units, of a polynomial for another function
constexpr double kFormRounding = 1e-10;  // model units; beyond it slopes are bounded closely
constexpr double kLeastHull = 1e-3;      // of a chart curve, in local parameters
constexpr int kBits = 48;                // of a parameter where the chart curve is cut
constexpr int kInverseDegree = 3;        // of the weight, as its inverse is made
// Making the points of a span, or of its half, rounds 30 times.
constexpr double kConvexSums = 32 * kUnit;

// The same polynomial in a degree that is at least the given one.
template <class Point>
void raise_to(BezierCurveOf<Point>& form, int degree) {
  if (form.degree() < degree) form = elevated(form, degree);
}

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

void subtract(BezierCurve& form, const BezierCurve& other) {
  for (std::size_t k = 0; k < form.points.size(); ++k) form.points[k] -= other.points[k];
}

Interval hull(const BezierCurve2& chart, int k) {
  Interval range{1e300, -1e300};
  for (const Vec2& p : chart.points) range = {std::min(range.from, p[k]), std::max(range.to, p[k])};
  const double wider = std::max(0.0, 0.5 * (kLeastHull - length(range)));
  return {range.from - wider, range.to + wider};
}

Interval knots(const std::vector<double>& all, int span) {
  return {all[static_cast<std::size_t>(span)], all[static_cast<std::size_t>(span) + 1]};
}

// The span whose patch holds the middle of the piece.
int span_at(const std::vector<double>& knots, double parameter) {
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
  return static_cast<int>(above - knots.begin()) - 1;
}

// `rounding`: of the piece's points, relative to the largest parameter.
LocalForm local(const QuinticPoints& piece, int coordinate, ParameterLaw law, const Interval& span,
                int degree, double rounding) {
  std::array<double, 6> c;
  double largest = std::abs(span.from);
  for (std::size_t i = 0; i <= 5; ++i) {
    c[i] = piece[i][coordinate];
    largest = std::max(largest, std::abs(c[i]));
  }
  LocalForm result = local_form(c, law, span, degree);
  // A local parameter of an angle grows at most twice as fast as that of a line.
  result.rounding += 2 * (rounding + 4 * kUnit) * largest / length(span);
  return result;
}

double stray(const BezierFunction& form) {
  const auto [low, high] = std::minmax_element(form.points.begin(), form.points.end());
  return std::max({0.0, -*low, *high - 1});
}

// The cubic that has a form's values and slopes at both ends; a form of lower degree itself.
BezierFunction cubic_near(const BezierFunction& form) {
  if (form.degree() <= kInverseDegree) return form;
  const std::vector<double>& p = form.points;
  const double third = form.degree() / 3.0;
  const std::size_t last = p.size() - 1;
  return {{p[0], p[0] + third * (p[1] - p[0]), p[last] - third * (p[last] - p[last - 1]), p[last]}};
}

// Divides a form by a weight, nearly: with m the middle of the weight's values, d = w / m - 1 and c
// a cubic near d, 1 - c + c^2 takes the place of m / w. With c = d the quotient's relative error
// is d^3. Returns false if the weights differ too much.
bool divide(ImageGap& gap, const BezierFunction& weight) {
  const auto [low, high] = std::minmax_element(weight.points.begin(), weight.points.end());
  const double middle = 0.5 * (*low + *high), d = 0.5 * (*high - *low) / middle;
  if (!(*low > 0) || d > kWeightSpread) return false;
  for (Vec3& p : gap.form.points) p *= 1 / middle;
  gap.relative = d;
  if (gap.form.degree() + 2 * kInverseDegree > kMaxProductDegree) return true;
  BezierFunction c = cubic_near(weight);
  double off = 64 * kUnit;
  if (weight.degree() > c.degree()) {
    const BezierFunction raised = elevated(c, weight.degree());
    for (std::size_t k = 0; k < weight.points.size(); ++k)
      off = std::max(off, std::abs(raised.points[k] - weight.points[k]) / middle + 64 * kUnit);
  }
  for (double& p : c.points) p = p / middle - 1;
  BezierFunction inverse = product(c, c);
  raise_to(c, inverse.degree());
  for (std::size_t k = 0; k < inverse.points.size(); ++k) inverse.points[k] += 1 - c.points[k];
  gap.form = product(inverse, gap.form);
  gap.relative = d * d * d + (1 + d) * (1 + 2 * (d + off)) * off;
  return true;
}

// A patch relative to a point, and what was lost on the way.
struct LocalPatch {
  RationalBezierPatch patch;
  double largest = 0;  // coordinate before the point was taken away
  double error = 0;    // of a point, where the degrees were reduced
};

LocalPatch relative_to(const Vec3& origin, const RationalBezierPatch& patch) {
  LocalPatch result{patch, max_norm(origin), 0};
  for (Vec4& p : result.patch.points.values()) {
    result.largest = std::max(result.largest, max_norm(p));
    for (int k = 0; k < 3; ++k) p[k] -= p[3] * origin[k];
  }
  return result;
}

// The part of the patch round the chart curve, in degrees of at most `highest` together.
void reduce(LocalPatch& local, BezierCurve2& chart, int highest) {
  const Interval u = hull(chart, 0), v = hull(chart, 1);
  const RationalBezierPatch part = sub_patch(local.patch, u, v);
  const int n = part.degree_u(), m = part.degree_v();
  const int low_n = std::min(n, std::max(highest / 2, highest - m));
  const ReducedOf<RationalBezierPatch> low = reduced(part, low_n, std::min(m, highest - low_n));
  double least = 1e300, radius = 0, largest = 0;
  for (const Vec4& p : local.patch.points.values()) largest = std::max(largest, max_norm(p));
  for (const Vec4& p : part.points.values()) {
    least = std::min(least, p[3]);
    radius = std::max(radius, norm(Vec3{p[0], p[1], p[2]}) / std::abs(p[3]));
  }
  // X / w - X' / w' = (X - X' - (X / w) (w - w')) / w'.
  // The part may reach beyond the unit square by kStray.
  const double error = low.error + 1.2 * subdivision_error(std::max(n, m)) * largest;
  local.error = least > 100 * error ? 1.02 * error * (1 + radius) / least : 1e300;
  local.patch = low.form;
  for (Vec2& p : chart.points) p = {(p[0] - u.from) / length(u), (p[1] - v.from) / length(v)};
}

BezierPatch in_space(const RationalBezierPatch& patch) {
  BezierPatch result{Grid<Vec3>(patch.points.rows(), patch.points.columns())};
  for (std::size_t k = 0; k < result.points.values().size(); ++k) {
    const Vec4& p = patch.points.values()[k];
    result.points.values()[k] = {p[0], p[1], p[2]};
  }
  return result;
}

// X - w C over w.
std::optional<ImageGap> rational_gap(const RationalBezierCurve& image, const BezierCurve& curve) {
  ImageGap result;
  BezierFunction weights;
  for (const Vec4& p : image.points) {
    result.form.points.push_back({p[0], p[1], p[2]});
    weights.points.push_back(p[3]);
  }
  const BezierCurve weighted = product(weights, curve);
  raise_to(result.form, weighted.degree());
  subtract(result.form, weighted);
  if (!divide(result, weights)) return {};
  return result;
}

// Of all that is multiplied and added for a gap, over the weight: the largest coordinate.
double largest_product(const RationalBezierPatch& patch, const QuinticPoints& piece) {
  double size = 0, least = 1e300, most = 0;
  for (const Vec4& p : patch.points.values()) {
    size = std::max(size, max_norm(Vec3{p[0], p[1], p[2]}));
    least = std::min(least, p[3]);
    most = std::max(most, p[3]);
  }
  for (const Vec7& p : piece) size = std::max(size, most * max_norm(space(p) - space(piece[0])));
  return least > 0 ? size / least : 1e300;
}

}  // namespace

ImageGaps::ImageGaps(const BezierSurface& surface, int chart)
    : surface_(surface),
      first_(chart),
      slopes_(surface.patches.rows(), surface.patches.columns()) {}

void ImageGaps::add_cuts(const QuinticPoints& points, std::vector<double>& cuts) const {
  for (const auto& [coordinate, all] :
       {std::pair{first_, std::span(surface_.u_knots)}, {first_ + 1, std::span(surface_.v_knots)}})
    add_crossings(points, coordinate, all.subspan(1, all.size() - 2), cuts);
}

std::optional<ImageGap> ImageGaps::on(const QuinticPoints& piece, int halvings) {
  const Vec7 middle = value_at(piece, 0.5);
  const int i = span_at(surface_.u_knots, middle[first_]);
  const int j = span_at(surface_.v_knots, middle[first_ + 1]);
  const RationalBezierPatch& patch = surface_.patches(i, j);
  const bool angles =
      surface_.u_law == ParameterLaw::Angle || surface_.v_law == ParameterLaw::Angle;
  const int total = patch.degree_u() + patch.degree_v();
  const int wanted = angles ? kAngleDegree : kFitDegree;
  const int highest = std::min(wanted, highest_product() / total);
  const int degree = highest < kFitDegree ? wanted : highest;
  const double rounding = kConvexSums * (2 + halvings);
  LocalForm u = local(piece, first_, surface_.u_law, knots(surface_.u_knots, i), degree, rounding);
  LocalForm v =
      local(piece, first_ + 1, surface_.v_law, knots(surface_.v_knots, j), degree, rounding);
  const double stray_u = stray(u.form), stray_v = stray(v.form);
  if (!(std::max(stray_u, stray_v) <= kStray)) return {};
  raise_to(u.form, degree);
  raise_to(v.form, degree);
  BezierCurve2 chart;
  for (std::size_t k = 0; k < u.form.points.size(); ++k)
    chart.points.push_back({u.form.points[k], v.form.points[k]});
  Slopes slope = slopes(i, j);
  const auto lost = [&] {
    return Vec2{u.error * slope.u + v.error * slope.v, u.rounding * slope.u + v.rounding * slope.v};
  };
  if (lost()[0] > kFormError || lost()[1] > kFormRounding) slope = slopes_round(patch, chart);
  if (!(lost()[0] <= kFormError)) return {};
  std::optional<ImageGap> result = composed(patch, chart, piece, rounding);
  if (!result) return {};
  result->margin += 1.1 * (lost()[0] + lost()[1]);
  if (stray_u + stray_v > 0) {
    // Beyond its border the patch is continued where the surface goes on in the next one, or
    // ends: both leave the border no faster than by their slopes.
    const Slopes around = slopes_beside(i, j);
    result->margin += 3.3 * (stray_u * around.u + stray_v * around.v);
  }
  return result;
}

std::optional<ImageGap> ImageGaps::composed(const RationalBezierPatch& patch, BezierCurve2 chart,
                                            const QuinticPoints& piece, double rounding) const {
  // Relative to a point of the curve, so that little is rounded.
  const Vec3 origin = space(piece[0]);
  BezierCurve curve;
  for (const Vec7& p : piece) curve.points.push_back(space(p) - origin);
  LocalPatch local = relative_to(origin, patch);
  for (const Vec7& p : piece) local.largest = std::max(local.largest, max_norm(space(p)));
  const int highest = highest_product() / chart.degree();
  if (patch.degree_u() + patch.degree_v() > highest) reduce(local, chart, highest);
  if (local.error > kFormError + 1e3 * kUnit * local.largest) return {};
  ImageGap result;
  if (surface_.rational) {
    const auto gap = rational_gap(composition(local.patch, chart), curve);
    if (!gap) return {};
    result = *gap;
  } else {
    result.form = composition(in_space(local.patch), chart);
    raise_to(curve, result.form.degree());
    subtract(result.form, curve);
  }
  const int n = local.patch.degree_u(), m = local.patch.degree_v();
  const double products = composition_error(n, m, chart.degree()) + 160 * kUnit;
  result.margin =
      2 * (products * composition_growth(n, m, chart) * largest_product(local.patch, piece) +
           (rounding + 4 * kUnit) * local.largest) +
      local.error;
  return result;
}

ImageGaps::Slopes ImageGaps::slopes_of(const RationalBezierPatch& patch) {
  const Vec4& corner = patch.points(0, 0);
  const Vec3 centre = Vec3{corner[0], corner[1], corner[2]} * (1 / corner[3]);
  double radius = 0, least = 1e300;
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
  if (!(least > 0)) return {1e300, 1e300};
  slopes.u *= patch.degree_u() / least;
  slopes.v *= patch.degree_v() / least;
  return slopes;
}

// Of the part of the patch round a chart curve, by the patch's parameters.
ImageGaps::Slopes ImageGaps::slopes_round(const RationalBezierPatch& patch,
                                          const BezierCurve2& chart) {
  const Interval u = hull(chart, 0), v = hull(chart, 1);
  const Slopes slopes = slopes_of(sub_patch(patch, u, v));
  return {slopes.u / length(u), slopes.v / length(v)};
}

const ImageGaps::Slopes& ImageGaps::slopes(int i, int j) {
  Slopes& found = slopes_(i, j);
  if (found.u < 0) found = slopes_of(surface_.patches(i, j));
  return found;
}

// The largest of the patch and its neighbours, that a piece strays into if by little; by the
// local parameters of the patch.
ImageGaps::Slopes ImageGaps::slopes_beside(int i, int j) {
  const auto width = [](const std::vector<double>& all, int k) { return length(knots(all, k)); };
  Slopes largest;
  for (int k = std::max(i - 1, 0); k <= std::min(i + 1, slopes_.rows() - 1); ++k)
    for (int l = std::max(j - 1, 0); l <= std::min(j + 1, slopes_.columns() - 1); ++l) {
      const double u = width(surface_.u_knots, i) / width(surface_.u_knots, k);
      const double v = width(surface_.v_knots, j) / width(surface_.v_knots, l);
      largest.u = std::max(largest.u, u * slopes(k, l).u);
      largest.v = std::max(largest.v, v * slopes(k, l).v);
    }
  return largest;
}

// Of the products of patch and chart curve; with weights, that is multiplied by the curve.
int ImageGaps::highest_product() const {
  return kMaxProductDegree - (surface_.rational ? kFitDegree : 0);
}

}  // namespace blossom
