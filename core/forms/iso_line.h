// SPDX-License-Identifier: LGPL-2.1-or-later
// Patches along lines on which one parameter is constant, for many points of each.

#pragma once

#include <array>

#include "core/forms/evaluation.h"

namespace blossom {

/// Which parameter varies.
enum class Along { U, V };

/// A patch along a line on which one parameter is constant: a point there costs what one of a curve
/// does.
class IsoLine {
 public:
  /// constant   the other parameter, any real. Cost: O((n + 1)(m + 1))
  IsoLine(const RationalBezierPatch& patch, Along along, double constant);

  /// As jet_at(patch, u, v, 1), to rounding. t: the parameter that varies, any real. Cost: O(n + 1)
  PatchJet jet(double t) const;

 private:
  Along along_;
  int degree_;
  std::array<Vec4, kMaxDegree + 1> points_, rates_;  // on the line, and by the constant parameter
};

}  // namespace blossom
