// SPDX-License-Identifier: LGPL-2.1-or-later
// A directed parameter interval.

#pragma once

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

}  // namespace blossom
