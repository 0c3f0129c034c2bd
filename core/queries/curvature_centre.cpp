// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/queries/curvature_centre.h"

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

// Curvatures that differ by this part of the larger one are alike.
constexpr double kAlike = 1e-6;

}  // namespace

// The principal curvatures k are the roots of det(II - k I) = 0,
//   I = (S_u.S_u, S_u.S_v, S_v.S_v),  II = (S_uu.n, S_uv.n, S_vv.n)
std::optional<Centre> centre_of_curvature(const PatchJet& jet, const Vec3& normal) {
  const double e = dot(jet.u, jet.u), f = dot(jet.u, jet.v), g = dot(jet.v, jet.v);
  const double l = dot(jet.uu, normal), m = dot(jet.uv, normal), n = dot(jet.vv, normal);
  const double area = e * g - f * f;
  if (!(area > 0)) return {};
  const double mean = 0.5 * (e * n - 2 * f * m + g * l) / area;
  const double gauss = (l * n - m * m) / area;
  const double root = std::sqrt(std::max(0.0, mean * mean - gauss));
  const double most = std::abs(mean) + root;
  if (!(most > 0) || !std::isfinite(1 / most)) return {};
  if (2 * root <= kAlike * most) return Centre{jet.point + (1 / mean) * normal, {}};
  if (std::abs(std::abs(mean) - root) > kAlike * most) return {};
  const Vec3 by_row = m * jet.u - l * jet.v, by_column = n * jet.u - m * jet.v;  // along k = 0
  const Vec3 axis = unit(norm(by_row) > norm(by_column) ? by_row : by_column);
  return Centre{jet.point + (0.5 / mean) * normal, axis};
}

}  // namespace blossom
