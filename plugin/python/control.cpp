// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/control.h"

#include <algorithm>
#include <limits>

namespace blossom::python {

double Watch::seconds_left() const {
  if (engine_.time_limit == 0) return 0;
  // A limit of 0 would be none.
  return std::max(engine_.time_limit - seconds(), std::numeric_limits<double>::min());
}

IntersectionOptions Watch::engine() const {
  IntersectionOptions options = engine_;
  options.time_limit = seconds_left();
  options.cancelled = [this] { return ended(); };
  return options;
}

DistanceOptions Watch::distance() const {
  DistanceOptions options{.time_limit = seconds_left(), .cancelled = [this] { return ended(); }};
  if (engine_.budget != IntersectionOptions{}.budget) options.budget = engine_.budget;
  return options;
}

}  // namespace blossom::python
