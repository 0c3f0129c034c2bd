// SPDX-License-Identifier: LGPL-2.1-or-later
// The points at a cut of a (q1,q2)-Bezier curve over any scalar, without preconditions.

#pragma once

#include <vector>

#include "core/papers/detail/q_blossom.h"
#include "core/papers/q_curve.h"

namespace blossom::detail {

/// first[i][0] and last[n - i][i]: the left points from the levels of the identity, the right ones
/// from those of the reversed permutation. Source: Disibuyuk 2022, after Theorem 5.1.
template <class Value>
std::vector<Value> left_edge(const QLevels<Value>& levels) {
  std::vector<Value> edge;
  for (const std::vector<Value>& level : levels) edge.push_back(level.front());
  return edge;
}

template <class Value>
std::vector<Value> right_edge(const QLevels<Value>& levels) {
  std::vector<Value> edge;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) edge.push_back(level->back());
  return edge;
}

template <class Point, class Scalar = typename Point::scalar_type>
QCutPoints<Point> cut_points(const std::vector<Point>& points, const IntervalOf<Scalar>& interval,
                             const QParametersOf<Scalar>& q, const Scalar& t) {
  const int n = static_cast<int>(points.size()) - 1;
  return {left_edge(evaluation_levels(points, interval, q, t, identity_permutation(n))),
          right_edge(evaluation_levels(points, interval, q, t, reversed_permutation(n)))};
}

}  // namespace blossom::detail
