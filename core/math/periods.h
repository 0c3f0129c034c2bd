// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters that mean the same a period on.

#pragma once

#include <cmath>

#include "core/math/vec.h"

namespace blossom {

/// The value nearest to `near` that is whole periods from x; x without a period, which is 0 then.
inline double unwrapped(double x, double near, double period) {
  return period > 0 ? x + period * std::round((near - x) / period) : x;
}

inline Vec2 unwrapped(const Vec2& x, const Vec2& near, const Vec2& period) {
  return {unwrapped(x[0], near[0], period[0]), unwrapped(x[1], near[1], period[1])};
}

}  // namespace blossom
