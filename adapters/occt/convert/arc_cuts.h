// SPDX-License-Identifier: LGPL-2.1-or-later
// Where arcs are cut into the spans that rational curves and surfaces are made of.

#pragma once

namespace blossom::occt {

enum class ArcCuts {
  Even,     ///< into as many equal spans as are at most quarters of a turn
  Shifted,  ///< a little off those places, to which symmetric shapes are often tangent
};

}  // namespace blossom::occt
