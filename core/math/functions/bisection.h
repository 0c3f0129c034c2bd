// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a statement that holds at one end of an interval and not at the other ends to hold.

#pragma once

#include "core/math/interval.h"

namespace blossom {

/// The interval halved as often as said, so that the statement still holds at `from` and not at
/// `to`; what it is at the given ends is not asked. from > to runs backwards.
///
/// is_before   bool(double)
template <class IsBefore>
Interval bisected(Interval range, int steps, const IsBefore& is_before) {
  for (int i = 0; i < steps; ++i) {
    const double middle = 0.5 * (range.from + range.to);
    (is_before(middle) ? range.from : range.to) = middle;
  }
  return range;
}

}  // namespace blossom
