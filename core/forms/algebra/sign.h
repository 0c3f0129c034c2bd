// SPDX-License-Identifier: LGPL-2.1-or-later
// Signs of Bernstein forms, decided exactly.
//
// The coefficients and parameters are taken as the exact values of the doubles. A value in double
// with its error bound decides nearly always; where it cannot, rational arithmetic does.

#pragma once

#include <optional>

#include "core/forms/function.h"

namespace blossom {

/// A parameter as a quotient of two doubles, such as 1/3.
struct Ratio {
  double numerator = 0;
  double denominator = 1;
};

/// The sign of f at a parameter: -1, 0 or 1, exactly.
///
/// t            any real
/// throws       InvalidInput if f is empty, its degree is above kMaxProductDegree, or a
///              coefficient or parameter is not finite or a denominator is 0
/// cost         O(n^2), O(n^2 m); rational numbers of about 53 n bits where doubles cannot tell
int sign_at(const BezierFunction& f, double t);
int sign_at(const BezierFunction& f, const Ratio& t);
int sign_at(const BezierFunction2& f, double u, double v);
int sign_at(const BezierFunction2& f, const Ratio& u, const Ratio& v);

/// The sign of f on all of [0, 1] or the unit square, if the coefficients show it: 1 if none is
/// below 0 and those at the ends or corners are above, -1 likewise, 0 if all are 0, otherwise
/// nothing.
///
/// margin       bound on the error of the coefficients: they count as 0 within it, and then the
///              answer is never 0 (unless the margin is 0)
/// throws       InvalidInput as above, or if the margin is negative or not a number
std::optional<int> sign_on_domain(const BezierFunction& f, double margin = 0);
std::optional<int> sign_on_domain(const BezierFunction2& f, double margin = 0);

}  // namespace blossom
