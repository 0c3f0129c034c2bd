// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/cleaning/polynomial_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/errors.h"
#include "core/forms/algebra/conversion.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/interpolation.h"
#include "core/forms/algebra/products.h"
#include "core/math/index.h"
#include "core/regions/cleaning/narrow_spans.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

constexpr int kAngleFit = 4;     // degree along an angle
constexpr int kHighestFit = 10;  // as far as kLebesgue holds
constexpr int kMaxParts = 64;    // of a span

// Whether weights differ along u of some patch, or along v.
bool weights_vary(const BezierSurface& surface, bool along_u) {
  return std::ranges::any_of(surface.patches.values(), [&](const RationalBezierPatch& patch) {
    for (int i = 0; i < patch.points.rows(); ++i)
      for (int j = 0; j < patch.points.columns(); ++j)
        if (patch.points(i, j)[3] != patch.points(along_u ? 0 : i, along_u ? j : 0)[3]) return true;
    return false;
  });
}

// Where weights do not vary the surface is a polynomial of its own degree.
int fit_degree(const BezierSurface& surface, bool along_u) {
  if ((along_u ? surface.u_law : surface.v_law) == ParameterLaw::Angle) return kAngleFit;
  const RationalBezierPatch& patch = surface.patches(0, 0);
  const int degree = along_u ? patch.degree_u() : patch.degree_v();
  return weights_vary(surface, along_u) ? std::clamp(degree, kAngleFit, kHighestFit) : degree;
}

RationalBezierPatch transposed(const RationalBezierPatch& patch) {
  RationalBezierPatch result{Grid<Vec4>(patch.points.columns(), patch.points.rows())};
  for (int i = 0; i < patch.points.rows(); ++i)
    for (int j = 0; j < patch.points.columns(); ++j) result.points(j, i) = patch.points(i, j);
  return result;
}

// |A| + |B| of the arcs c + A cos + B sin along u, for all v: the rows are those of a quadratic.
double amplitude(const RationalBezierPatch& patch, double angle) {
  const double alpha = 0.5 * angle;
  double most = 0;
  for (int j = 0; j < patch.points.columns(); ++j) {
    const Vec3 a = projected(patch.points(0, j)), p = projected(patch.points(1, j));
    const Vec3 b = projected(patch.points(2, j));
    most = std::max(
        most, distance(p, 0.5 * (a + b)) * std::cos(alpha) / (std::sin(alpha) * std::sin(alpha)) +
                  distance(a, b) / (2 * std::sin(alpha)));
  }
  return most;
}

// max |P - X / w| by the coefficients of w P - X.
double distance_bound(const BezierPatch& fit, const RationalBezierPatch& patch) {
  BezierFunction2 weight{Grid<double>(patch.points.rows(), patch.points.columns())};
  BezierPatch x{Grid<Vec3>(patch.points.rows(), patch.points.columns())};
  double least = patch.points(0, 0)[3];
  for (std::size_t k = 0; k < patch.points.values().size(); ++k) {
    const Vec4& p = patch.points.values()[k];
    weight.points.values()[k] = p[3];
    x.points.values()[k] = {p[0], p[1], p[2]};
    least = std::min(least, p[3]);
  }
  const BezierPatch image = product(weight, fit);
  x = elevated(x, image.degree_u(), image.degree_v());
  double most = 0;
  for (std::size_t k = 0; k < x.points.values().size(); ++k)
    most = std::max(most, distance(image.points.values()[k], x.points.values()[k]));
  return most / least;
}

// One patch of the result, over parts of a span, and the bound on its error.
class Fitter {
 public:
  Fitter(const BezierSurface& surface, int i, int j)
      : surface_(surface),
        patch_(surface.patches(i, j)),
        u_{surface.u_knots[index(i)], surface.u_knots[index(i) + 1]},
        v_{surface.v_knots[index(j)], surface.v_knots[index(j) + 1]},
        degree_u_(fit_degree(surface, true)),
        degree_v_(fit_degree(surface, false)) {}

  BezierPatch fit(const Interval& u, const Interval& v) const {
    const std::vector<double> in_u = extreme_points(degree_u_), in_v = extreme_points(degree_v_);
    Grid<Vec3> values(static_cast<int>(in_u.size()), static_cast<int>(in_v.size()));
    for (int a = 0; a < values.rows(); ++a)
      for (int b = 0; b < values.columns(); ++b)
        values(a, b) = point_at(surface_, {at(u, in_u[index(a)]), at(v, in_v[index(b)])});
    return {bezier_through(values)};
  }

  // Along an angle the remainder; across it, at each of its nodes, the same or the coefficients.
  double error(const BezierPatch& made, const Interval& u, const Interval& v) const {
    const bool angle_u = surface_.u_law == ParameterLaw::Angle;
    const bool angle_v = surface_.v_law == ParameterLaw::Angle;
    if (!angle_u && !angle_v)
      return distance_bound(
          made, sub_patch(patch_, local(surface_.u_law, u_, u), local(surface_.v_law, v_, v)));
    if (angle_u && angle_v)
      return remainder(patch_, u_, u) + kLebesgue * remainder(transposed(patch_), v_, v);
    // The whole span along the angle, in which alone the law holds.
    const RationalBezierPatch along =
        angle_u ? sub_patch(patch_, {0, 1}, local(surface_.v_law, v_, v))
                : transposed(sub_patch(patch_, local(surface_.u_law, u_, u), {0, 1}));
    const double first = angle_u ? remainder(patch_, u_, u) : remainder(transposed(patch_), v_, v);
    return first + kLebesgue * across(along, angle_u ? u : v, angle_u ? v : u, angle_u);
  }

 private:
  static Interval local(ParameterLaw law, const Interval& span, const Interval& part) {
    return {part.from == span.from ? 0 : local_parameter(law, span, part.from),
            part.to == span.to ? 1 : local_parameter(law, span, part.to)};
  }

  static double remainder(const RationalBezierPatch& patch, const Interval& span,
                          const Interval& part) {
    return interpolation_error(amplitude(patch, length(span)), length(part), kAngleFit);
  }

  // The error across the angle on the lines at its nodes; `along` has the angle as u.
  double across(const RationalBezierPatch& along, const Interval& angle, const Interval& other,
                bool angle_is_u) const {
    const int degree = angle_is_u ? degree_v_ : degree_u_;
    double most = 0;
    for (const double s : extreme_points(kAngleFit)) {
      const double here = at(angle, s);
      const double t = local_parameter(ParameterLaw::Angle, angle_is_u ? u_ : v_, here);
      const RationalBezierPatch line = sub_patch(along, {t, t}, {0, 1});
      BezierPatch fit{Grid<Vec3>(1, degree + 1)};
      std::vector<Vec3> values;
      for (const double x : extreme_points(degree)) {
        const double there = at(other, x);
        values.push_back(point_at(surface_, angle_is_u ? Vec2{here, there} : Vec2{there, here}));
      }
      values = bezier_through(values).points;
      std::ranges::copy(values, fit.points.values().begin());
      RationalBezierPatch row{Grid<Vec4>(1, line.points.columns())};
      for (int k = 0; k < line.points.columns(); ++k) row.points(0, k) = line.points(0, k);
      most = std::max(most, distance_bound(fit, row));
    }
    return most;
  }

  const BezierSurface& surface_;
  const RationalBezierPatch& patch_;
  Interval u_, v_;
  int degree_u_, degree_v_;
};

// Parts of each span, along u and along v.
struct Parts {
  std::vector<int> u;
  std::vector<int> v;
};

std::vector<double> divided(const Interval& span, int parts) {
  std::vector<double> ends;
  for (int part = 0; part < parts; ++part)
    ends.push_back(at(span, static_cast<double>(part) / parts));
  ends.push_back(span.to);
  return ends;
}

std::vector<double> divided(const std::vector<double>& knots, const std::vector<int>& parts) {
  std::vector<double> result{knots.front()};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::vector<double> ends = divided(Interval{knots[k], knots[k + 1]}, parts[k]);
    result.insert(result.end(), ends.begin() + 1, ends.end());
  }
  return result;
}

// The error of one patch in so many parts.
double error_in_parts(const BezierSurface& surface, int i, int j, int parts_u, int parts_v) {
  const Fitter fitter(surface, i, j);
  const auto in_u = divided({surface.u_knots[index(i)], surface.u_knots[index(i) + 1]}, parts_u);
  const auto in_v = divided({surface.v_knots[index(j)], surface.v_knots[index(j) + 1]}, parts_v);
  double most = 0;
  for (std::size_t a = 0; a + 1 < in_u.size(); ++a)
    for (std::size_t b = 0; b + 1 < in_v.size(); ++b) {
      const Interval u{in_u[a], in_u[a + 1]}, v{in_v[b], in_v[b + 1]};
      most = std::max(most, fitter.error(fitter.fit(u, v), u, v));
    }
  return most;
}

// As many parts of each span as it takes, in the direction that gains more; narrow spans, as they
// come with nearly equal knots, stay whole.
Parts parts_within(const BezierSurface& surface, double tolerance) {
  Parts parts{std::vector<int>(index(surface.patches.rows()), 1),
              std::vector<int>(index(surface.patches.columns()), 1)};
  while (true) {
    Parts more = parts;
    for (int i = 0; i < surface.patches.rows(); ++i)
      for (int j = 0; j < surface.patches.columns(); ++j) {
        const int u = parts.u[index(i)], v = parts.v[index(j)];
        if (std::max(u, v) >= kMaxParts) continue;
        if (error_in_parts(surface, i, j, u, v) <= tolerance) continue;
        if (error_in_parts(surface, i, j, 2 * u, v) <= error_in_parts(surface, i, j, u, 2 * v))
          more.u[index(i)] = 2 * u;
        else
          more.v[index(j)] = 2 * v;
      }
    if (more.u == parts.u && more.v == parts.v) return parts;
    parts = std::move(more);
  }
}

// The span of each part.
std::vector<int> spans_of(const std::vector<int>& parts) {
  std::vector<int> spans;
  for (std::size_t k = 0; k < parts.size(); ++k)
    spans.insert(spans.end(), index(parts[k]), static_cast<int>(k));
  return spans;
}

BezierSurface in_parts(const BezierSurface& surface, const Parts& parts) {
  BezierSurface result;
  result.u_knots = divided(surface.u_knots, parts.u);
  result.v_knots = divided(surface.v_knots, parts.v);
  result.closed_u = surface.closed_u;
  result.closed_v = surface.closed_v;
  result.patches = Grid<RationalBezierPatch>(static_cast<int>(result.u_knots.size()) - 1,
                                             static_cast<int>(result.v_knots.size()) - 1);
  const std::vector<int> span_u = spans_of(parts.u), span_v = spans_of(parts.v);
  for (int i = 0; i < result.patches.rows(); ++i)
    for (int j = 0; j < result.patches.columns(); ++j) {
      const Interval u{result.u_knots[index(i)], result.u_knots[index(i) + 1]};
      const Interval v{result.v_knots[index(j)], result.v_knots[index(j) + 1]};
      const Fitter fitter(surface, span_u[index(i)], span_v[index(j)]);
      const BezierPatch made = fitter.fit(u, v);
      result.error = std::max(result.error, fitter.error(made, u, v));
      result.patches(i, j) = homogeneous(made);
    }
  return result;
}

}  // namespace

BezierSurface polynomial_surface(const BezierSurface& surface, double tolerance) {
  validate(surface, "polynomial_surface");
  if (!(tolerance > 0)) throw InvalidInput("polynomial_surface: the tolerance must be positive");
  if (!surface.rational) return without_narrow_spans(surface);
  BezierSurface result = in_parts(surface, parts_within(surface, tolerance));
  result.error += surface.error;
  return without_narrow_spans(std::move(result));
}

}  // namespace blossom
