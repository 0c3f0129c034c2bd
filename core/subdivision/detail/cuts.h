// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists of cuts and the matrices that belong to them.

#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/detail/checks.h"
#include "core/math/detail/bernstein.h"
#include "core/subdivision/subdivision_matrix.h"

namespace blossom::detail {

/// Throws InvalidInput unless there are at least 2 finite cuts and they increase.
inline void check_cuts(const char* function, const char* name, std::span<const double> cuts) {
  const std::string place = std::string(function) + ": " + name;
  if (cuts.size() < 2)
    throw InvalidInput(place + " must be at least 2, got " + std::to_string(cuts.size()));
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    if (!std::isfinite(cuts[k]))
      throw InvalidInput(place + " must be finite, number " + std::to_string(k + 1) + " is not");
    if (k > 0 && !(cuts[k - 1] < cuts[k]))
      throw InvalidInput(place + " must increase, got " + text(cuts[k - 1]) + " before " +
                         text(cuts[k]));
  }
}

/// The subdivision matrix of each piece between neighbouring cuts.
inline std::vector<Grid<double>> matrices(int degree, std::span<const double> cuts) {
  std::vector<Grid<double>> result;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
    result.push_back(subdivision_matrix(degree, Interval{cuts[k], cuts[k + 1]}));
  return result;
}

}  // namespace blossom::detail
