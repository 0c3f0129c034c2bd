// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/trimming/triangle_lowering.h"

namespace blossom {

ReducedOf<BezierTriangle> TriangleLowering::operator()(const BezierTriangle& triangle, int lowest,
                                                       int highest, double tolerance) {
  ReducedOf<BezierTriangle> result{triangle, 0};
  if (triangle.degree > highest) result = reduction(triangle.degree, highest)(triangle);
  for (int degree = lowest; degree < result.form.degree; ++degree) {
    auto lower = reduction(result.form.degree, degree)(result.form);
    if (lower.error > tolerance) continue;
    lower.error += result.error;
    return lower;
  }
  return result;
}

const TriangleReduction& TriangleLowering::reduction(int from, int to) {
  const auto known = reductions_.find({from, to});
  if (known != reductions_.end()) return known->second;
  return reductions_.emplace(std::pair(from, to), TriangleReduction(from, to)).first->second;
}

}  // namespace blossom
