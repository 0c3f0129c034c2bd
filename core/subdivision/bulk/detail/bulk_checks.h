// SPDX-License-Identifier: LGPL-2.1-or-later
// Preconditions of bulk subdivision, with one wording.

#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include "core/base/errors.h"
#include "core/forms/curve.h"
#include "core/subdivision/cell_nets.h"

namespace blossom::detail {

/// Throws InvalidInput unless the degrees are 0..kMaxDegree and there are 1 to 4 planes.
inline void check_shape(const char* function, const NetShape& shape) {
  const bool fits = 1 <= shape.rows && shape.rows <= kMaxDegree + 1 && 1 <= shape.columns &&
                    shape.columns <= kMaxDegree + 1 && 1 <= shape.planes && shape.planes <= 4;
  if (fits) return;
  throw InvalidInput(std::string(function) + ": a net must have 1.." +
                     std::to_string(kMaxDegree + 1) + " rows and columns and 1..4 planes, got " +
                     std::to_string(shape.rows) + " x " + std::to_string(shape.columns) + ", " +
                     std::to_string(shape.planes));
}

inline void check_count(const char* function, const char* name, std::size_t count,
                        std::size_t wanted) {
  if (count == wanted) return;
  throw InvalidInput(std::string(function) + ": " + name + " must have " + std::to_string(wanted) +
                     " values, got " + std::to_string(count));
}

/// Throws InvalidInput naming the first value that is not finite. The sum of 0 x is 0 unless there
/// is one, and cheap to have beside a kernel.
inline void check_finite(const char* function, const char* name, std::span<const double> values) {
  double sum[4] = {};
  std::size_t k = 0;
  for (; k + 4 <= values.size(); k += 4)
    for (std::size_t j = 0; j < 4; ++j) sum[j] += 0 * values[k + j];
  for (; k < values.size(); ++k) sum[0] += 0 * values[k];
  if (sum[0] + sum[1] + sum[2] + sum[3] == 0) return;
  for (k = 0; std::isfinite(values[k]);) ++k;
  throw InvalidInput(std::string(function) + ": " + name + " must be finite, number " +
                     std::to_string(k + 1) + " is not");
}

}  // namespace blossom::detail
