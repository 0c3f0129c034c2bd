// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/curvature_centre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace blossom {
namespace {

// Curvatures that differ by this part of the larger one are alike.
constexpr double kAlike = 1e-6;

// Where a patch is looked at besides a given point: far from each other in both parameters.
constexpr std::array<Vec2, 3> kElsewhere{{{0.1, 0.2}, {0.5, 0.9}, {0.9, 0.4}}};

struct Bending {
  Vec3 point, normal;
  double mean = 0, root = 0;  // the principal curvatures are mean +- root
};

// The roots of det(II - k I) = 0, with
//   I = (S_u.S_u, S_u.S_v, S_v.S_v),  II = (S_uu.n, S_uv.n, S_vv.n)
std::optional<Bending> bending_of(const PatchJet& jet, const Vec3& normal) {
  const double e = dot(jet.u, jet.u), f = dot(jet.u, jet.v), g = dot(jet.v, jet.v);
  const double l = dot(jet.uu, normal), m = dot(jet.uv, normal), n = dot(jet.vv, normal);
  const double area = e * g - f * f;
  if (!(area > 0)) return {};
  Bending result{jet.point, normal, 0.5 * (e * n - 2 * f * m + g * l) / area};
  const double gauss = (l * n - m * m) / area;
  result.root = std::sqrt(std::max(0.0, result.mean * result.mean - gauss));
  const double most = std::abs(result.mean) + result.root;
  if (!(most > 0) || !std::isfinite(1 / most)) return {};
  return result;
}

std::optional<Bending> bending_at(const RationalBezierPatch& patch, const Vec2& at) {
  const PatchJet jet = jet_at(patch, at[0], at[1], 2);
  return bending_of(jet, unit(cross(jet.u, jet.v)));
}

// The centre of a principal curvature, if it is like `curvature`.
std::optional<Vec3> centre_like(const Bending& of, double curvature) {
  for (const double k : {of.mean - of.root, of.mean + of.root})
    if (std::abs(k - curvature) <= kAlike * std::abs(curvature))
      return of.point + (1 / k) * of.normal;
  return {};
}

//   c = p + (|a|^2 b x n + |b|^2 n x a) / (2 n.n),  n = a x b,  a = q - p,  b = r - p
std::optional<Centre> circle_through(const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 a = q - p, b = r - p, n = cross(a, b);
  if (!(norm(n) > kAlike * norm(a) * norm(b))) return {};
  const Vec3 to_centre = (dot(a, a) * cross(b, n) + dot(b, b) * cross(n, a)) * (0.5 / dot(n, n));
  return Centre{p + to_centre, unit(n), norm(to_centre)};
}

}  // namespace

std::optional<Centre> centre_of_curvature(const PatchJet& jet, const Vec3& normal) {
  const auto bending = bending_of(jet, normal);
  if (!bending) return {};
  const double mean = bending->mean, root = bending->root, most = std::abs(mean) + root;
  if (2 * root <= kAlike * most) return Centre{jet.point + (1 / mean) * normal, {}};
  if (std::abs(std::abs(mean) - root) > kAlike * most) return {};
  const double l = dot(jet.uu, normal), m = dot(jet.uv, normal), n = dot(jet.vv, normal);
  const Vec3 by_row = m * jet.u - l * jet.v, by_column = n * jet.u - m * jet.v;  // along k = 0
  const Vec3 axis = unit(norm(by_row) > norm(by_column) ? by_row : by_column);
  return Centre{jet.point + (0.5 / mean) * normal, axis};
}

std::optional<Centre> centre_circle(const RationalBezierPatch& patch, const Vec2& at) {
  const auto here = bending_at(patch, at);
  if (!here) return {};
  std::array<Bending, kElsewhere.size()> others;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const auto other = bending_at(patch, kElsewhere[i]);
    if (!other) return {};
    others[i] = *other;
  }
  for (const double curvature : {here->mean - here->root, here->mean + here->root}) {
    std::array<Vec3, kElsewhere.size()> centres;
    bool alike = curvature != 0;
    for (std::size_t i = 0; i < others.size() && alike; ++i) {
      const auto centre = centre_like(others[i], curvature);
      alike = centre.has_value();
      centres[i] = centre.value_or(Vec3{});
    }
    const auto circle = alike ? circle_through(centres[0], centres[1], centres[2]) : std::nullopt;
    if (!circle) continue;
    const Vec3 spoke = here->point + (1 / curvature) * here->normal - circle->point;
    const double off = std::hypot(norm(spoke) - circle->radius, dot(spoke, circle->axis));
    if (off <= 10 * kAlike * circle->radius) return circle;
  }
  return {};
}

}  // namespace blossom
