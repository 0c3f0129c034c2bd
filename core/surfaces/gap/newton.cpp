// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/newton.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/cells/cell_pair.h"
#include "core/math/linear_solve.h"

namespace blossom {
namespace {

constexpr int kNewtonSteps = 12;
constexpr double kNewtonSettled =
    1e-14;  // a Newton step below this is rounding; fraction of a patch
constexpr double kNewtonStalled =
    1e-10;  // so is one below this that no longer shrinks: ill conditioned

}  // namespace

std::optional<Point4> newton(const RationalBezierPatch& a, const RationalBezierPatch& b,
                             const Point4& start, int fixed, const Box4& box) {
  const auto kept = kept_columns(fixed);
  Point4 x = start;
  double last_step = 0;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const PatchJet ja = jet_at(a, x[0], x[1], 1), jb = jet_at(b, x[2], x[3], 1);
    const JacobianColumns j = jacobian_columns(ja, jb);
    const auto column = [&](int i) {
      return j[static_cast<std::size_t>(kept[static_cast<std::size_t>(i)])];
    };
    const auto delta = solved(column(0), column(1), column(2), ja.point - jb.point);
    if (!delta) return std::nullopt;
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(kept[static_cast<std::size_t>(i)]);
      const double width = length(box[k]);
      x[k] -= (*delta)[i];
      if (!(x[k] > box[k].from - 0.5 * width && x[k] < box[k].to + 0.5 * width))
        return std::nullopt;
      largest = std::max(largest, std::abs((*delta)[i]));
    }
    // Steps shrink quadratically: the next one would be this times the square of the ratio.
    const double ratio = step == 0 ? 1 : largest / last_step;
    if (largest * ratio * ratio < kNewtonSettled || (largest < kNewtonStalled && ratio > 0.25))
      return x;
    last_step = largest;
  }
  return std::nullopt;
}

}  // namespace blossom
