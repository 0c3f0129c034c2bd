// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/triangle_composition.h"

#include <array>
#include <vector>

#include "core/base/errors.h"
#include "core/blossom/detail/scaled_forms.h"
#include "core/forms/detail/checks.h"
#include "core/math/binomial.h"

namespace blossom {
namespace {

using Form = detail::ScaledForm;
using detail::add_form_product;
using detail::add_multiple;
using detail::form_product;
using detail::zero_form;

// A linear function of the map's points, scaled.
template <class Function>
Form scaled_form(const BezierTriangle& map, Function&& function) {
  Form form = zero_form(map.degree);
  for (int nu = 0; nu <= map.degree; ++nu)
    for (int mu = 0; nu + mu <= map.degree; ++mu)
      form(nu, mu) = trinomial(map.degree, nu, mu) * function(map(nu, mu));
  return form;
}

// binom(n, i) (w - x)^(n - i) x^i for i = 0..n, x the coordinate k of the map.
std::vector<Form> bernstein_forms(const BezierTriangle& map, int k, int n) {
  const Form on = scaled_form(map, [&](const Vec3& p) { return p[k]; });
  const Form back = scaled_form(map, [&](const Vec3& p) { return p[2] - p[k]; });
  std::vector<Form> forms{Form{0, {1.0}}};
  for (int power = 1; power <= n; ++power) {
    forms.push_back(form_product(forms.back(), on));
    for (std::size_t i = 0; i + 1 < forms.size(); ++i) forms[i] = form_product(forms[i], back);
  }
  for (int i = 0; i <= n; ++i)
    for (double& x : forms[static_cast<std::size_t>(i)].points) x *= binomial(n, i);
  return forms;
}

void check(const RationalBezierPatch& patch, const BezierTriangle& map) {
  detail::check_degree("composition", patch.degree_u());
  detail::check_degree("composition", patch.degree_v());
  detail::check_triangle("composition", map, 2 * kMaxDegree);
  detail::check_degree("composition", map.degree * (patch.degree_u() + patch.degree_v()),
                       2 * kMaxDegree);
}

// The derivative by a barycentric coordinate as if the three were independent, over the degree.
BezierTriangle partial(const BezierTriangle& map, int coordinate) {
  BezierTriangle result{map.degree - 1, {}};
  for (int nu = 0; nu < map.degree; ++nu)
    for (int mu = 0; nu + mu < map.degree; ++mu)
      result.points.push_back(map(nu + (coordinate == 0), mu + (coordinate == 1)));
  return result;
}

}  // namespace

RationalBezierTriangle composition(const RationalBezierPatch& patch, const BezierTriangle& map) {
  check(patch, map);
  const int n = patch.degree_u(), m = patch.degree_v(), degree = map.degree * (n + m);
  const std::vector<Form> in_u = bernstein_forms(map, 0, n), in_v = bernstein_forms(map, 1, m);
  RationalBezierTriangle result{degree, std::vector<Vec4>(RationalBezierTriangle::count(degree))};
  for (int k = 0; k < 4; ++k) {
    Form sum = zero_form(degree);
    for (int i = 0; i <= n; ++i) {
      Form row = zero_form(map.degree * m);
      for (int j = 0; j <= m; ++j)
        add_multiple(in_v[static_cast<std::size_t>(j)], patch.points(i, j)[k], row);
      add_form_product(in_u[static_cast<std::size_t>(i)], row, sum);
    }
    for (int nu = 0; nu <= degree; ++nu)
      for (int mu = 0; nu + mu <= degree; ++mu)
        result(nu, mu)[k] = sum(nu, mu) / trinomial(degree, nu, mu);
  }
  return result;
}

BezierTriangleOf<double> turning_form(const BezierTriangle& map) {
  detail::check_triangle("turning_form", map, 2 * kMaxDegree / 3);
  if (map.degree == 0) throw InvalidInput("turning_form: the degree is 0");
  std::array<std::array<Form, 3>, 3> by;  // by[derivative][coordinate]
  for (std::size_t c = 0; c < 3; ++c) {
    const BezierTriangle derivative = partial(map, static_cast<int>(c));
    for (std::size_t k = 0; k < 3; ++k)
      by[c][k] = scaled_form(derivative, [&](const Vec3& p) { return p[static_cast<int>(k)]; });
  }
  Form sum = zero_form(3 * (map.degree - 1));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    Form minor = form_product(by[1][i], by[2][j]);
    add_multiple(form_product(by[1][j], by[2][i]), -1, minor);
    add_form_product(by[0][k], minor, sum);
  }
  for (int nu = 0; nu <= sum.degree; ++nu)
    for (int mu = 0; nu + mu <= sum.degree; ++mu) sum(nu, mu) /= trinomial(sum.degree, nu, mu);
  return sum;
}

}  // namespace blossom
