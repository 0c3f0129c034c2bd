// SPDX-License-Identifier: LGPL-2.1-or-later
// Which span between two neighbours of increasing numbers a parameter is in.

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace blossom {

/// The last span that begins at or before the parameter; the first or last one if it lies before
/// or beyond all. There are two numbers or more.
inline std::size_t span_of(const std::vector<double>& knots, double parameter) {
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
  return static_cast<std::size_t>(above - knots.begin()) - 1;
}

}  // namespace blossom
