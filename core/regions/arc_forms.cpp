// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/arc_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/interpolation.h"
#include "core/forms/algebra/products.h"
#include "core/math/index.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/tracing/local_form.h"

namespace blossom {
namespace {

constexpr double kMinBox = 1e-6;  // of a side of a box: below, differences of points are rounding
constexpr int kFitDegree = 5;     // of polynomials that take a curve's place, as local_form wants

bool is_polynomial(const PlanarBezier& curve) {
  return std::ranges::all_of(curve.points,
                             [&](const Vec3& p) { return p[2] == curve.points[0][2]; });
}

bool is_constant(const PlanarBezier& curve, int k) {
  const double first = curve.points[0][k] / curve.points[0][2];
  return std::ranges::all_of(curve.points, [&](const Vec3& p) { return p[k] == first * p[2]; });
}

const PlanarSpan& span_under(const PlanarCurve& curve, double parameter) {
  for (const PlanarSpan& span : curve.spans)
    if (parameter <= span.place.to) return span;
  return curve.spans.back();
}

// The same curve with weight 1 at both ends: a change of parameter.
PlanarBezier with_unit_ends(PlanarBezier curve) {
  const double first = curve.points.front()[2], last = curve.points.back()[2];
  if (first == 1 && last == 1) return curve;
  const double ratio = std::pow(first / last, 1.0 / std::max(curve.degree(), 1));
  double factor = 1 / first;
  for (Vec3& p : curve.points) {
    p *= factor;
    factor *= ratio;
  }
  curve.points.front()[2] = curve.points.back()[2] = 1;
  return curve;
}

// Maps a coordinate by a law that is linear, or at one value only.
void map_coordinate(PlanarBezier& curve, int k, const Interval& span, ParameterLaw law) {
  if (law == ParameterLaw::Angle) {
    const double local = local_parameter(law, span, curve.points[0][k] / curve.points[0][2]);
    for (Vec3& p : curve.points) p[k] = local * p[2];
    return;
  }
  for (Vec3& p : curve.points) p[k] = (p[k] - span.from * p[2]) / length(span);
}

// max |p w - x| / w for polynomials p and a rational curve (x, w), by coefficients.
double distance_bound(const std::vector<double>& p, const PlanarBezier& curve, int k) {
  BezierFunction weight, x;
  double least = curve.points[0][2];
  for (const Vec3& point : curve.points) {
    x.points.push_back(point[k]);
    weight.points.push_back(point[2]);
    least = std::min(least, point[2]);
  }
  const BezierFunction image = product(BezierFunction{p}, weight);
  x = elevated(x, image.degree());
  double most = 0;
  for (std::size_t i = 0; i < x.points.size(); ++i)
    most = std::max(most, std::abs(image.points[i] - x.points[i]));
  return most / least;
}

// An arc c + A cos(angle) + B sin(angle) as a rational quadratic span: |A| + |B| per coordinate.
Vec2 amplitude(const PlanarSpan& span) {
  const double alpha = 0.5 * length(span.place);
  const PlanarBezier curve = with_unit_ends(span.curve);
  const Vec2 a = projected(curve.points.front()), b = projected(curve.points.back());
  const Vec2 m = 0.5 * (a + b), p = projected(curve.points[curve.points.size() / 2]);
  Vec2 sum;
  for (int k = 0; k < 2; ++k)
    sum[k] = std::abs(p[k] - m[k]) * std::cos(alpha) / (std::sin(alpha) * std::sin(alpha)) +
             std::abs(b[k] - a[k]) / (2 * std::sin(alpha));
  return sum;
}

struct Fit {
  PlanarBezier curve;  // polynomial, the surface's parameters
  Vec2 error;
};

Fit fitted(const PlanarCurve& curve, const PlanarBezier& piece, const Interval& place,
           const ArcFormOptions& options) {
  const PlanarSpan& span = span_under(curve, at(place, 0.5));
  const bool by_angle = options.keep_parameter && span.law == ParameterLaw::Angle;
  const int degree = std::min({options.highest_degree, kFitDegree, std::max(piece.degree(), 1)});
  const int wanted =
      by_angle || !is_polynomial(piece) ? std::min(options.highest_degree, kFitDegree) : degree;
  const std::vector<double> nodes = extreme_points(wanted);
  Fit fit;
  fit.curve.points.resize(nodes.size(), {0, 0, 1});
  std::vector<Vec2> points;
  for (const double t : nodes)
    points.push_back(by_angle ? point_at(curve, at(place, t)) : jet_at(piece, t).point);
  const BezierCurve2 through = bezier_through(points);
  for (int k = 0; k < 2; ++k) {
    std::vector<double> form;
    for (const Vec2& p : through.points) form.push_back(p[k]);
    for (std::size_t i = 0; i < form.size(); ++i) fit.curve.points[i][k] = form[i];
    fit.error[k] = by_angle
                       ? interpolation_error(amplitude(span)[k], std::abs(length(place)), wanted)
                       : distance_bound(form, piece, k);
  }
  return fit;
}

// A coordinate of a polynomial in the patch's parameter, and the bound on its error.
struct Coordinate {
  std::vector<double> points;
  double error = 0;
};

Coordinate local_coordinate(const Fit& fit, int k, const Interval& span, ParameterLaw law) {
  Coordinate result;
  BezierFunction own;
  for (const Vec3& p : fit.curve.points) own.points.push_back(p[k]);
  if (law == ParameterLaw::Linear) {
    for (const double p : own.points) result.points.push_back((p - span.from) / length(span));
    result.error = fit.error[k] / length(span);
    return result;
  }
  const double range = std::tan(0.25 * length(span));
  const double steepest = (1 + range * range) / (4 * range);
  result.error = fit.error[k] * steepest;
  if (std::ranges::all_of(own.points, [&](double p) { return p == own.points[0]; })) {
    result.points.assign(own.points.size(), local_parameter(law, span, own.points[0]));
    return result;
  }
  own = elevated(own, kFitDegree);
  std::array<double, 6> parameters;
  std::ranges::copy(own.points, parameters.begin());
  const LocalForm form = local_form(parameters, law, span, kFitDegree);
  const auto points = form.points();
  result.points.assign(points.begin(), points.end());
  result.error += form.error + form.rounding;
  return result;
}

ArcForm fitted_form(const Fit& fit, const PatchChart& chart, int highest_degree) {
  const Coordinate u = local_coordinate(fit, 0, chart.u, chart.u_law);
  const Coordinate v = local_coordinate(fit, 1, chart.v, chart.v_law);
  const int degree = static_cast<int>(std::max(u.points.size(), v.points.size())) - 1;
  const BezierFunction in_u = elevated(BezierFunction{u.points}, degree);
  const BezierFunction in_v = elevated(BezierFunction{v.points}, degree);
  BezierCurve2 curve;
  for (std::size_t i = 0; i < in_u.points.size(); ++i)
    curve.points.push_back({in_u.points[i], in_v.points[i]});
  ArcForm form{{}, {u.error, v.error}, false};
  if (degree > highest_degree) {
    auto lower = reduced(curve, highest_degree);
    form.error += Vec2{lower.error, lower.error};
    curve = std::move(lower.form);
  }
  for (const Vec2& p : curve.points) form.curve.points.push_back({p[0], p[1], 1});
  return form;
}

ArcForm full_form(const PlanarCurve& curve, const Interval& place, const PatchChart& chart,
                  const ArcFormOptions& options) {
  std::vector<PlanarBezier> pieces = bezier_pieces(curve, place);
  if (pieces.empty()) {  // no longer than rounding
    const Vec2 from = point_at(curve, place.from), to = point_at(curve, place.to);
    pieces.push_back({{{from[0], from[1], 1}, {to[0], to[1], 1}}});
  }
  PlanarBezier& piece = pieces.front();
  const bool constant[] = {is_constant(piece, 0), is_constant(piece, 1)};
  const bool even = span_under(curve, at(place, 0.5)).law == ParameterLaw::Linear;
  if ((constant[0] || constant[1]) && !options.keep_parameter)
    piece = {{with_unit_ends(piece).points.front(), with_unit_ends(piece).points.back()}};
  const bool straight = piece.degree() == 1 && (constant[0] || constant[1]);
  const bool in_u = chart.u_law == ParameterLaw::Linear || constant[0];
  const bool in_v = chart.v_law == ParameterLaw::Linear || constant[1];
  const bool in_step = (!options.keep_parameter || even) &&
                       (is_polynomial(piece) || !(options.keep_parameter || options.polynomial));
  if (straight && !options.keep_parameter && !(in_u && in_v)) {
    ArcForm form{{}, {}, true};
    for (const Vec3& p : piece.points)
      form.curve.points.push_back({local_parameter(chart.u_law, chart.u, p[0]),
                                   local_parameter(chart.v_law, chart.v, p[1]), 1});
    return form;
  }
  if (!in_u || !in_v || !in_step || piece.degree() > options.highest_degree)
    return fitted_form(fitted(curve, piece, place, options), chart, options.highest_degree);
  map_coordinate(piece, 0, chart.u, chart.u_law);
  map_coordinate(piece, 1, chart.v, chart.v_law);
  return {with_unit_ends(std::move(piece)), {}, true};
}

// The lowest degree that stays near enough.
ArcForm lowered(ArcForm form, double within) {
  const bool polynomial =
      std::ranges::all_of(form.curve.points, [](const Vec3& p) { return p[2] == 1; });
  if (!polynomial) return form;
  BezierCurve2 curve;
  for (const Vec3& p : form.curve.points) curve.points.push_back({p[0], p[1]});
  for (int degree = 1; degree < curve.degree(); ++degree) {
    const auto lower = reduced(curve, degree);
    if (lower.error > within) continue;
    form.exact = form.exact && lower.error <= kArcRounding;
    if (!form.exact) form.error += Vec2{lower.error, lower.error};
    form.curve.points.clear();
    for (const Vec2& p : lower.form.points) form.curve.points.push_back({p[0], p[1], 1});
    break;
  }
  return form;
}

}  // namespace

PatchChart chart_of(const BezierSurface& surface, int patch_u, int patch_v) {
  const std::size_t i = index(patch_u), j = index(patch_v);
  return {{surface.u_knots[i], surface.u_knots[i + 1]},
          {surface.v_knots[j], surface.v_knots[j + 1]},
          surface.u_law,
          surface.v_law};
}

ArcForm arc_form(const PlanarCurve& curve, const Interval& place, const PatchChart& chart,
                 const ArcFormOptions& options) {
  if (options.highest_degree < 1) throw InvalidInput("arc_form: the highest degree is below 1");
  return lowered(full_form(curve, place, chart, options), options.lower_within);
}

Vec2 derivative_bounds(const RationalBezierPatch& patch) {
  const Grid<Vec4>& net = patch.points;
  const Vec3 middle = projected(net(net.rows() / 2, net.columns() / 2));
  double radius = 0, least = net(0, 0)[3];
  for (const Vec4& p : net.values()) {
    radius = std::max(radius, distance(projected(p), middle));
    least = std::min(least, p[3]);
  }
  const auto length_of = [&](const Vec4& a, const Vec4& b) {
    const Vec4 d = b - a;
    return norm(Vec3{d[0], d[1], d[2]} - middle * d[3]) + radius * std::abs(d[3]);
  };
  if (!(least > 0)) return {kInfinity, kInfinity};
  Vec2 most;
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) {
      if (i + 1 < net.rows()) most[0] = std::max(most[0], length_of(net(i, j), net(i + 1, j)));
      if (j + 1 < net.columns()) most[1] = std::max(most[1], length_of(net(i, j), net(i, j + 1)));
    }
  return {most[0] * patch.degree_u() / least, most[1] * patch.degree_v() / least};
}

Vec2 derivative_bounds(const RationalBezierPatch& patch, PlanarBox box) {
  for (int k = 0; k < 2; ++k) {
    const double wider = std::max(0.5 * (kMinBox - (box.high[k] - box.low[k])), 0.0);
    box.low[k] -= wider;
    box.high[k] += wider;
  }
  const Interval u{box.low[0], box.high[0]}, v{box.low[1], box.high[1]};
  const Vec2 steep = derivative_bounds(sub_patch(patch, u, v));
  return {steep[0] / length(u), steep[1] / length(v)};
}

}  // namespace blossom
