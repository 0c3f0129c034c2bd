// SPDX-License-Identifier: LGPL-2.1-or-later
// Scalar forms over a triangle by their coefficients times the trinomials: products of forms are
// products of polynomials, row by row.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/forms/triangle.h"
#include "core/math/convolution.h"

namespace blossom::detail {

using ScaledForm = BezierTriangleOf<double>;

inline std::span<double> row_of(ScaledForm& form, int nu) {
  return std::span(form.points)
      .subspan(ScaledForm::index(form.degree, nu, 0),
               static_cast<std::size_t>(form.degree - nu + 1));
}
inline std::span<const double> row_of(const ScaledForm& form, int nu) {
  return std::span(form.points)
      .subspan(ScaledForm::index(form.degree, nu, 0),
               static_cast<std::size_t>(form.degree - nu + 1));
}

inline ScaledForm zero_form(int degree) {
  return {degree, std::vector<double>(ScaledForm::count(degree), 0.0)};
}

inline void add_form_product(const ScaledForm& f, const ScaledForm& g, ScaledForm& sum) {
  for (int i = 0; i <= f.degree; ++i)
    for (int j = 0; j <= g.degree; ++j) add_product(row_of(f, i), row_of(g, j), row_of(sum, i + j));
}

inline ScaledForm form_product(const ScaledForm& f, const ScaledForm& g) {
  ScaledForm result = zero_form(f.degree + g.degree);
  add_form_product(f, g, result);
  return result;
}

inline void add_multiple(const ScaledForm& f, double factor, ScaledForm& sum) {
  for (std::size_t k = 0; k < f.points.size(); ++k) sum.points[k] += factor * f.points[k];
}

}  // namespace blossom::detail
