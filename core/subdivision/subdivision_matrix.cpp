// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/subdivision_matrix.h"

#include "core/forms/detail/checks.h"
#include "core/math/detail/bernstein.h"

namespace blossom {

Grid<double> subdivision_matrix(int degree, const Interval& piece) {
  detail::check_degree("subdivision_matrix", degree);
  detail::check_interval("subdivision_matrix", "of the piece", piece);
  return detail::subdivision_matrix(degree, piece);
}

Grid<double> monomial_matrix(int degree, const Interval& piece) {
  detail::check_degree("monomial_matrix", degree);
  detail::check_interval("monomial_matrix", "of the piece", piece);
  return detail::monomial_matrix(degree, piece);
}

}  // namespace blossom
