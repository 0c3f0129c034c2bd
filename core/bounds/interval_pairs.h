// SPDX-License-Identifier: LGPL-2.1-or-later
// How two intervals lie to each other.

#pragma once

#include "core/math/interval.h"

namespace blossom {

/// Ends that are equal count.
inline bool overlap(const Interval& a, const Interval& b) {
  return a.from <= b.to && b.from <= a.to;
}

inline bool within(const Interval& inner, const Interval& outer) {
  return inner.from >= outer.from && inner.to <= outer.to;
}

}  // namespace blossom
