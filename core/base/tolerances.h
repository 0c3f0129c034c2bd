// SPDX-License-Identifier: LGPL-2.1-or-later
// The user's wishes: what counts as equal.

#pragma once

namespace blossom {

/// What counts as equal. Pass one of these, never a bare double. The defaults
/// are those of Open CASCADE's `Precision`, so a model means the same on both sides.
struct Tolerances {
  /// Two points closer than this are one point. Model units.
  double point = 1e-7;

  /// Two parameters of a curve or patch closer than this are one parameter.
  /// Dimensionless: a fraction of the unit interval.
  double parameter = 1e-9;

  /// Two directions closer than this are parallel. Radians.
  double angle = 1e-12;
};

}  // namespace blossom
