// SPDX-License-Identifier: LGPL-2.1-or-later
// First use from C++: evaluation, conversion and subdivision of a curve are one formula, its
// blossom. Prints some values and checks them against those computed by hand.

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>

#include "core/blossom/curve_blossom.h"
#include "core/forms/curve.h"

namespace {

using blossom::Vec3;

void show(const std::string& what, const Vec3& found, const Vec3& by_hand) {
  std::cout << what << " = (" << found[0] << ", " << found[1] << ", " << found[2] << ")\n";
  if (blossom::distance(found, by_hand) < 1e-15) return;
  std::cerr << "that should be (" << by_hand[0] << ", " << by_hand[1] << ", " << by_hand[2]
            << ")\n";
  std::exit(1);
}

}  // namespace

int main() {
  // C(t) = (t, t^2, t^3), whose blossom is
  // c(r, s, t) = ((r + s + t) / 3, (r s + r t + s t) / 3, r s t).
  const blossom::MonomialCurve curve{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  show("c(1, 2, 3)", blossom_at(curve, std::array{1.0, 2.0, 3.0}), {2, 11.0 / 3, 6});
  show("C(1/2) = c(1/2, 1/2, 1/2)", blossom_at(curve, std::array{0.5, 0.5, 0.5}),
       {0.5, 0.25, 0.125});

  // The Bezier points of a piece are the blossom at its two ends.
  const blossom::BezierCurve piece = bezier_points(curve, {0.25, 0.75});
  const std::array<Vec3, 4> by_hand = {{{1.0 / 4, 1.0 / 16, 1.0 / 64},
                                        {5.0 / 12, 7.0 / 48, 3.0 / 64},
                                        {7.0 / 12, 5.0 / 16, 9.0 / 64},
                                        {3.0 / 4, 9.0 / 16, 27.0 / 64}}};
  for (std::size_t k = 0; k < 4; ++k)
    show("point " + std::to_string(k) + " of the piece [1/4, 3/4]", piece.points[k], by_hand[k]);
  return 0;
}
