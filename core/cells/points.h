// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and boxes in the four parameters of a pair of patches.

#pragma once

#include <array>

#include "core/cells/cell_tree.h"
#include "core/math/interval.h"

namespace blossom {

/// A point in the four parameters (u, v, s, t), each in its patch's own [0, 1].
using Point4 = std::array<double, 4>;

/// The place of a cell pair in the four parameters.
using Box4 = std::array<Interval, 4>;

inline Box4 box_of(const Cell& a, const Cell& b) { return {a.u, a.v, b.u, b.v}; }

}  // namespace blossom
