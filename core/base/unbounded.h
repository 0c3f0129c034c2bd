// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers beyond all lengths, parameters and gaps.

#pragma once

#include <limits>

namespace blossom {

/// Where nothing bounds a number, or no number is known: the least of nothing.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where no bound is known: the least of nothing is kUnbounded, the largest -kUnbounded. Finite, so
/// that differences and means of such bounds are numbers; squares and products of two are not.
inline constexpr double kUnbounded = 1e300;

}  // namespace blossom
