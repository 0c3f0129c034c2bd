// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/jet_enclosure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace blossom {
namespace {

constexpr double kSteepest = 0.8;  // sine of the angle between n and normals, for the second bound

double extent(const std::array<Vec2, 3>& corners, int k) {
  const auto [low, high] = std::minmax({corners[0][k], corners[1][k], corners[2][k]});
  return high - low;
}

// The largest value of a quadratic form with these second derivatives over a facet less its linear
// interpolation: along n, and by length.
struct FormDistance {
  double along = 0, whole = 0;
};

FormDistance form_distance(const Vec3& uu, const Vec3& uv, const Vec3& vv, const Vec3& n,
                           const std::array<Vec2, 3>& corners) {
  std::array<Vec3, 3> bends;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 e = corners[(i + 1) % 3] - corners[(i + 2) % 3];
    bends[i] = e[0] * e[0] * uu + 2 * e[0] * e[1] * uv + e[1] * e[1] * vv;
  }
  const auto along = [&](double sign) {
    return largest_mean(sign * dot(n, bends[0]), sign * dot(n, bends[1]), sign * dot(n, bends[2]));
  };
  return {0.5 * std::max(along(1), along(-1)),
          0.5 * largest_mean(norm(bends[0]), norm(bends[1]), norm(bends[2]))};
}

struct Extent {
  double u, v;

  double rest(double uu, double uv, double vv) const {
    return (u * u * uu + 2 * u * v * std::abs(uv) + v * v * vv) / 8;
  }
};

}  // namespace

VectorRange united(const VectorRange& a, const VectorRange& b) {
  VectorRange both;
  for (int k = 0; k < 3; ++k) {
    const double low = std::min(a.centre[k] - a.radius[k], b.centre[k] - b.radius[k]);
    const double high = std::max(a.centre[k] + a.radius[k], b.centre[k] + b.radius[k]);
    both.centre[k] = 0.5 * (low + high);
    both.radius[k] = 0.5 * (high - low);
  }
  return both;
}

double least_area(const VectorRange& a, const VectorRange& b) {
  const double r_a = norm(a.radius), r_b = norm(b.radius);
  return std::max(0.0, norm(cross(a.centre, b.centre)) - norm(a.centre) * r_b -
                           norm(b.centre) * r_a - r_a * r_b);
}

JetEnclosure united(const JetEnclosure& a, const JetEnclosure& b) {
  return {united(a.uu, b.uu),
          united(a.uv, b.uv),
          united(a.vv, b.vv),
          std::max(a.length_u, b.length_u),
          std::max(a.length_v, b.length_v),
          std::min(a.jacobian, b.jacobian),
          a.jump_u + b.jump_u,
          a.jump_v + b.jump_v};
}

double largest_mean(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (a < c) std::swap(a, c);
  if (!(a > 0)) return 0;
  b = std::max(b / a, 0.0), c = std::max(c / a, 0.0);
  const double excess = b + c - 1;
  if (!(excess > 0)) return a / 4;
  // It is taken inside of the triangle. As the excess is at most b and at most c, what is divided
  // by is at least 3 b c, and rounded little.
  return a * std::clamp(b * c / (4 * b * c - excess * excess), 0.25, 1.0 / 3);
}

double facet_distance(const JetEnclosure& jet, const Vec3& n, const std::array<Vec2, 3>& corners,
                      const std::optional<QuadraticRest>& form) {
  const Extent extents{extent(corners, 0), extent(corners, 1)};
  const Vec3 size_n = absolute(n);
  const FormDistance middle =
      form_distance(jet.uu.centre, jet.uv.centre, jet.vv.centre, n, corners);
  double height =
      middle.along +
      extents.rest(jet.uu.spread_along(n), jet.uv.spread_along(n), jet.vv.spread_along(n)) +
      (extents.u * dot(size_n, jet.jump_u) + extents.v * dot(size_n, jet.jump_v)) / 4;
  double whole = middle.whole +
                 extents.rest(norm(jet.uu.radius), norm(jet.uv.radius), norm(jet.vv.radius)) +
                 (extents.u * norm(jet.jump_u) + extents.v * norm(jet.jump_v)) / 4;
  // n is normal somewhere on the facet, so that |n S_u| is what S_u changes by.
  double slope_u =
      extents.u * jet.uu.size_along(n) + extents.v * jet.uv.size_along(n) + dot(size_n, jet.jump_u);
  double slope_v =
      extents.u * jet.uv.size_along(n) + extents.v * jet.vv.size_along(n) + dot(size_n, jet.jump_v);
  double length_u = jet.length_u, length_v = jet.length_v, jacobian = jet.jacobian;
  if (form) {
    const FormDistance mean = form_distance(form->uu, form->uv, form->vv, n, corners);
    height = std::min(height, mean.along + 2 * dot(size_n, form->rest));
    whole = std::min(whole, mean.whole + 2 * norm(form->rest));
    slope_u = std::min(slope_u, form->u.size_along(n));
    slope_v = std::min(slope_v, form->v.size_along(n));
    length_u = std::min(length_u, form->u.size());
    length_v = std::min(length_v, form->v.size());
    jacobian = std::max(jacobian, least_area(form->u, form->v));
  }
  if (!(jacobian > 0)) return whole;
  const double sine = (slope_u * length_v + slope_v * length_u) / jacobian;
  if (!(sine < kSteepest)) return whole;
  const double m = jacobian * std::sqrt(1 - sine * sine);
  const double d_u = whole * length_v / m, d_v = whole * length_u / m;
  const double moved =
      0.5 * (d_u * d_u * jet.uu.size() + 2 * d_u * d_v * jet.uv.size() + d_v * d_v * jet.vv.size());
  return std::min(whole, height + 2 * (slope_u * d_u + slope_v * d_v) + 4 * moved);
}

}  // namespace blossom
