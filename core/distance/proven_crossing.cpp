// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/proven_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/cells/cell_tree.h"
#include "core/cells/pair_model.h"
#include "core/forms/evaluation.h"
#include "core/surfaces/gap/newton.h"

namespace blossom {
namespace {

constexpr double kMiddle = 0.5;
constexpr Box4 kPatches{Interval{0, 1}, Interval{0, 1}, Interval{0, 1}, Interval{0, 1}};
// How far along the curve a place inside of the trims is looked for, as part of a patch.
constexpr std::array<double, 8> kSteps{1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.25, 0.5};
// Half sides of the boxes, likewise: where derivatives change fast only small ones are proven.
constexpr std::array<double, 3> kRadii{1e-4, 1e-6, 1e-8};

bool is_rational(const RationalBezierPatch& patch) {
  return std::ranges::any_of(patch.points.values(), [](const Vec4& p) { return p[3] != 1; });
}

class CrossingProof {
 public:
  CrossingProof(const RationalBezierPatch& a, const RationalBezierPatch& b, const Vec3& origin)
      : tree_a_(a, is_rational(a), origin, CellForm::Bezier, kMiddle),
        tree_b_(b, is_rational(b), origin, CellForm::Bezier, kMiddle),
        model_(tree_a_, tree_a_[0], tree_b_, tree_b_[0]) {}

  // The direction of the curve, its largest entry 1; zeros where the surfaces touch.
  Point4 direction(const Point4& x) const {
    const std::array<Vec3, 4> columns = model_.jet(place_of(x)).columns;
    Point4 along{};
    double largest = 0;
    for (int k = 0; k < 4; ++k) {
      const auto kept = kept_columns(k);
      const auto column = [&](std::size_t i) { return columns[static_cast<std::size_t>(kept[i])]; };
      const double minor = dot(column(0), cross(column(1), column(2)));
      along[static_cast<std::size_t>(k)] = k % 2 == 0 ? minor : -minor;
      largest = std::max(largest, std::abs(minor));
    }
    for (double& entry : along) entry = largest > 0 ? entry / largest : 0;
    return along;
  }

  // The point of the curve with the given value of the parameter that changes most along it.
  std::optional<Point4> root_near(const Point4& x, const Point4& along) const {
    const auto most = std::ranges::max_element(
        along, [](double p, double q) { return std::abs(p) < std::abs(q); });
    return newton(tree_a_.patch(), tree_b_.patch(), x, static_cast<int>(most - along.begin()),
                  kPatches);
  }

  std::optional<Box4> proven_round(const Point4& x) const {
    double margin = 1;
    for (const double t : x) margin = std::min({margin, t, 1 - t});
    for (const double radius : kRadii)
      if (radius < margin && is_proven(x, radius)) {
        Box4 box;
        for (std::size_t i = 0; i < 4; ++i) box[i] = {x[i] - radius, x[i] + radius};
        return box;
      }
    return {};
  }

 private:
  static Point4 place_of(Point4 x) {
    for (double& t : x) t -= 0.5;
    return x;
  }

  bool is_proven(const Point4& x, double radius) const {
    PairPart part{place_of(x), {radius, radius, radius, radius}};
    const JacobianBounds bounds = model_.jacobian(model_.jet(part.middle), part);
    const int fixed = bounds.certified_column();
    if (fixed < 0) return false;
    part.radius[static_cast<std::size_t>(fixed)] = 0;
    PairPart image = part;
    if (!narrow(image, bounds.minor(fixed), fixed, bounds.column(fixed), part.middle,
                model_.gap(part.middle)))
      return false;
    // What the operator leaves is cut to the part: only if it is smaller on every side, all of
    // its image lies within.
    return std::ranges::all_of(kept_columns(fixed), [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      return std::abs(image.middle[i] - part.middle[i]) + image.radius[i] < kInner * radius;
    });
  }

  static constexpr double kInner = 1 - 1e-9;

  CellTree tree_a_, tree_b_;
  PairModel model_;
};

}  // namespace

bool proven_crossing(const RationalBezierPatch& a, const RationalBezierPatch& b,
                     const Point4& start, const std::function<bool(const Box4&)>& counts) {
  const CrossingProof proof(a, b, point_at(a, start[0], start[1]));
  const auto is_crossing = [&](const std::optional<Point4>& x) {
    const std::optional<Box4> box = x ? proof.proven_round(*x) : std::nullopt;
    return box && counts(*box);
  };
  const auto root = proof.root_near(start, proof.direction(start));
  if (!root) return false;
  if (is_crossing(root)) return true;
  const Point4 along = proof.direction(*root);
  for (const double step : kSteps)
    for (const double side : {step, -step}) {
      Point4 next = *root;
      for (std::size_t i = 0; i < 4; ++i) next[i] += side * along[i];
      if (is_crossing(proof.root_near(next, along))) return true;
    }
  return false;
}

}  // namespace blossom
