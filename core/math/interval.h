// SPDX-License-Identifier: LGPL-2.1-or-later
// A directed parameter interval.

#pragma once

#include <algorithm>

namespace blossom {

/// Parameters from `from` to `to`. from > to runs backwards, from == to is one point.
template <class Scalar>
struct IntervalOf {
  Scalar from{0};
  Scalar to{1};

  friend bool operator==(const IntervalOf&, const IntervalOf&) = default;
};

using Interval = IntervalOf<double>;

inline double length(const Interval& interval) { return interval.to - interval.from; }

/// The parameter at fraction `t` of the interval.
inline double at(const Interval& interval, double t) {
  return (1 - t) * interval.from + t * interval.to;
}

/// The same parameters from the least one on.
inline Interval increasing(const Interval& x) {
  return {std::min(x.from, x.to), std::max(x.from, x.to)};
}

/// Of increasing intervals: whether they have something in common. Ends that are equal count.
inline bool overlap(const Interval& a, const Interval& b) {
  return a.from <= b.to && b.from <= a.to;
}

/// Of increasing intervals.
inline bool within(const Interval& inner, const Interval& outer) {
  return inner.from >= outer.from && inner.to <= outer.to;
}

/// The least interval that holds both, of increasing ones.
inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.from, b.from), std::max(a.to, b.to)};
}

}  // namespace blossom
