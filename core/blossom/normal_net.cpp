// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/normal_net.h"

#include <string>

#include "core/base/errors.h"
#include "core/blossom/detail/normal_net.h"

namespace blossom {
namespace {

template <class Point>
void check(const BezierPatchOf<Point>& patch, int highest) {
  for (const int degree : {patch.degree_u(), patch.degree_v()})
    if (degree < 1 || degree > highest)
      throw InvalidInput("normal_net: a degree must be 1.." + std::to_string(highest) + ", got " +
                         std::to_string(degree));
}

}  // namespace

BezierPatch normal_net(const BezierPatch& patch) {
  check(patch, kMaxDegree);
  return {detail::normal_net(patch.points)};
}

BezierPatch normal_net(const RationalBezierPatch& patch) {
  check(patch, (kMaxProductDegree + 1) / 3);
  return {detail::normal_net(patch.points)};
}

}  // namespace blossom
