// SPDX-License-Identifier: LGPL-2.1-or-later
// (q1,q2)-Bezier curves: the cubic of Disibuyuk 2022, Figure 1, evaluated, turned into a classical
// Bezier curve and subdivided. Prints some values and checks them.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/papers/q_curve.h"

namespace {

using blossom::QBezierCurveOf;
using blossom::Vec2;

void show(const std::string& what, double found, double wanted, double tolerance) {
  std::cout << what << " = " << found << '\n';
  if (std::abs(found - wanted) <= tolerance) return;
  std::cerr << "that should be " << wanted << " within " << tolerance << '\n';
  std::exit(1);
}

// The largest distance between the curve and the control points' polygons, piece by piece.
double polygon_distance(const QBezierCurveOf<Vec2>& curve, int levels) {
  double largest = 0;
  for (const auto& piece : midpoint_pieces(curve, levels))
    for (int k = 0; k <= piece.degree(); ++k) {
      const double x = at(piece.interval, static_cast<double>(k) / piece.degree());
      largest = std::max(largest,
                         distance(piece.points[static_cast<std::size_t>(k)], point_at(curve, x)));
    }
  return largest;
}

}  // namespace

int main() {
  // Over [0, 1] with q1 = 1/2, q2 = 3/5, so that rho = q1 / q2 = 5/6. By hand at x = 1/2:
  //   B_0 = (1 - x)(1 - rho x)(1 - rho^2 x) = 329/1728       B_1 = [3] x (1 - x)(1 - rho x) =
  //   637/1728 B_2 = [3] x^2 (1 - x) = 546/1728                       B_3 = x^3 = 216/1728
  // with [3] = 1 + rho + rho^2 = 91/36.
  const QBezierCurveOf<Vec2> curve{{{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {0, 1}, {0.5, 0.6}};
  const Vec2 middle = point_at(curve, 0.5);
  show("x of P(1/2)", middle[0], (637 + 3 * 546 + 4 * 216) / 1728.0, 1e-15);
  show("y of P(1/2)", middle[1], (2 * 637 + 2 * 546) / 1728.0, 1e-15);

  // Each of the 3! permutations is an algorithm for the same point.
  for (const std::vector<int>& sigma : {std::vector<int>{2, 3, 1}, {3, 1, 2}, {3, 2, 1}}) {
    const auto levels = q_evaluation_levels(curve.points, curve.interval, curve.q, 0.5, sigma);
    show("distance of another algorithm's point", distance(levels.back()[0], middle), 0, 1e-14);
  }

  // The same curve with classical points, for Open CASCADE and everything else.
  const blossom::BezierCurve2 classical = bezier_form(curve);
  show("distance of the classical form at 1/2", distance(point_at(classical, 0.5), middle), 0,
       1e-14);

  // Control polygons of midpoint subdivision come closer by 2 a level; those of the classical
  // points by 4.
  const QBezierCurveOf<Vec2> equal{classical.points, {0, 1}, {1, 1}};
  show("convergence from level 5 to 6", polygon_distance(curve, 5) / polygon_distance(curve, 6), 2,
       0.2);
  show("the same for q1 = q2", polygon_distance(equal, 5) / polygon_distance(equal, 6), 4, 0.2);

  // With q1 / q2 = 2 the half [1/2, 1] has no basis.
  try {
    subdivide(QBezierCurveOf<Vec2>{curve.points, {0, 1}, {2, 1}}, 0.5);
  } catch (const blossom::InvalidInput& error) {
    std::cout << error.what() << '\n';
    return 0;
  }
  std::cerr << "a piece without a basis was accepted\n";
  return 1;
}
