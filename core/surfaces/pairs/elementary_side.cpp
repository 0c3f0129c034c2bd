// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/elementary_side.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/forms/algebra/derivatives.h"
#include "core/forms/algebra/products.h"
#include "core/math/roundoff.h"
#include "core/math/vec.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

// Each point of f goes through some ten steps beside the product, whose size is bounded by the
// squares of the largest coordinate and radius; signed distances of up to twice it are told well.
constexpr double kSteps = 16 * kUnitRoundoff;

double largest(const BezierFunction2& f) {
  double result = 0;
  for (const double x : f.points.values()) result = std::max(result, std::abs(x));
  return result;
}

// The patch about the surface's centre; of a cylinder what is across the axis.
BezierPatchOf<Vec4> seen_from(const Elementary& surface, const RationalBezierPatch& patch) {
  BezierPatchOf<Vec4> moved{patch.points};
  for (Vec4& p : moved.points.values()) {
    Vec3 x = Vec3{p[0], p[1], p[2]} - p[3] * surface.centre;
    if (surface.kind == ElementaryKind::Cylinder) x = x - dot(x, surface.axis) * surface.axis;
    p = {x[0], x[1], x[2], p[3]};
  }
  return moved;
}

double largest_coordinate(const BezierPatchOf<Vec4>& patch) {
  double result = 0;
  for (const Vec4& p : patch.points.values())
    result = std::max(result, std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}));
  return result;
}

BezierFunction2 plane_equation(const Vec3& normal, const BezierPatchOf<Vec4>& patch) {
  BezierFunction2 f{Grid<double>(patch.points.rows(), patch.points.columns())};
  for (std::size_t k = 0; k < f.points.values().size(); ++k) {
    const Vec4& p = patch.points.values()[k];
    f.points.values()[k] = dot(normal, Vec3{p[0], p[1], p[2]});
  }
  return f;
}

// (X . X - r^2 w^2) / 2r, as the product of X and X / 2r with -r^2 w in the place of w.
BezierFunction2 round_equation(double radius, const BezierPatchOf<Vec4>& patch) {
  BezierPatchOf<Vec4> scaled{patch.points};
  for (Vec4& p : scaled.points.values()) {
    p = (0.5 / radius) * p;
    p[3] = -radius * radius * p[3];
  }
  return dot_product(patch, scaled);
}

}  // namespace

std::optional<ElementarySide> ElementarySide::of(const Elementary& surface,
                                                 const RationalBezierPatch& patch) {
  const bool flat = surface.kind == ElementaryKind::Plane;
  const bool round =
      surface.kind == ElementaryKind::Cylinder || surface.kind == ElementaryKind::Sphere;
  if (!flat && !round) return std::nullopt;
  const int degree = std::max(patch.degree_u(), patch.degree_v());
  if ((flat ? 1 : 2) * degree > kMaxDegree) return std::nullopt;
  double least = kInfinity, heaviest = 0;
  for (const Vec4& p : patch.points.values()) {
    least = std::min(least, p[3]);
    heaviest = std::max(heaviest, p[3]);
  }
  if (!(least > 0)) return std::nullopt;

  const BezierPatchOf<Vec4> seen = seen_from(surface, patch);
  ElementarySide side;
  side.value_ = flat ? plane_equation(surface.axis, seen) : round_equation(surface.radius, seen);
  side.least_scale_ = flat ? least : least * least;
  const double coordinate =
      largest_coordinate(seen) + heaviest * (max_norm(surface.centre) + surface.radius);
  const double given = flat ? kSteps * coordinate
                            : (kSteps + product_error(patch.degree_u(), patch.degree_v())) *
                                  coordinate * std::max(coordinate / surface.radius, heaviest);
  side.rounding_[0] = given;
  for (int k = 0; k < 2; ++k) {
    const auto along = static_cast<std::size_t>(k);
    side.first_[along] = derivative(side.value_, k == 0 ? 1 : 0, k == 0 ? 0 : 1);
    side.second_[along] = derivative(side.value_, k == 0 ? 2 : 0, k == 0 ? 0 : 2);
  }
  const int height = std::max(side.value_.degree_u(), side.value_.degree_v());
  const double with_cuts =
      given + subdivision_error(std::min(height, kMaxDegree)) * largest(side.value_);
  side.rounding_[0] = with_cuts;
  for (int order = 1; order <= 2; ++order)
    side.rounding_[static_cast<std::size_t>(order)] =
        derivative_growth(height, order) * with_cuts +
        derivative_error(height, order) * largest(side.value_);
  return side;
}

double ElementarySide::depth(int across, const Interval& along, const Interval& line,
                             const Interval& whole) const {
  const auto on = [&](const BezierFunction2& f, const Interval& part) {
    return across == 0 ? sub_patch(f, part, along) : sub_patch(f, along, part);
  };
  const auto k = static_cast<std::size_t>(across);
  const BezierFunction2 bend = on(second_[k], whole);
  const auto [low, high] = std::ranges::minmax(bend.points.values());
  const double least = std::max(low, -high) - rounding_[2];
  if (!(least > 0)) return kInfinity;
  const double value = largest(on(value_, line)) + rounding_[0];
  const double slope = largest(on(first_[k], line)) + rounding_[1];
  // Twice: a signed distance of -d has the value -d + d^2 / 2r, no less than half of it.
  return 2 * (value + 0.5 * slope * slope / least) / least_scale_;
}

}  // namespace blossom
