// SPDX-License-Identifier: LGPL-2.1-or-later
// A number beyond all lengths, parameters and gaps.

#pragma once

namespace blossom {

/// Where no bound is known: the least of nothing is kUnbounded, the largest -kUnbounded. Finite, so
/// that differences and means of such bounds are numbers; squares and products of two are not.
inline constexpr double kUnbounded = 1e300;

}  // namespace blossom
