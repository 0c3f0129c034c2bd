// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/cells/odd_contact.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/surfaces/gap/cells/valley_shape.h"
#include "core/surfaces/gap/limits.h"
#include "core/surfaces/gap/model_points.h"

namespace blossom {
namespace {

constexpr double kMinTwist = 0.1;    // of the largest third derivative across the line
constexpr double kGapShare = 0.25;   // and most gap along the line
constexpr double kSlopeShare = 0.5;  // of the mean slope where the gap reaches the tolerance
constexpr double kBeyond = 1.5;      // how far from the cell's range the line is followed
constexpr int kDirections = 24;
constexpr int kEdgeSamples = 16;

// The direction in which the third derivative in the middle is largest, and positive.
Vec2 direction_of(const TaylorPolynomial& gap) {
  Vec2 best{};
  double most = 0;
  for (int k = 0; k < 2 * kDirections; ++k) {
    const double angle = M_PI * k / kDirections, x = std::cos(angle), y = std::sin(angle);
    const double third = ((gap[taylor_index(3, 0)] * x + gap[taylor_index(2, 1)] * y) * x +
                          gap[taylor_index(1, 2)] * y * y) *
                             x +
                         gap[taylor_index(0, 3)] * y * y * y;
    if (third <= most) continue;
    most = third;
    best = {x, y};
  }
  return best;
}

// The slope of the gap across the line, as a function with a valley. Only the polynomial counts:
// its distance to the gap enters with the gap itself.
std::optional<ValleyShape> slope_shape(const TaylorPolynomial& gap) {
  const Vec2 across = direction_of(gap);
  if (!(norm(across) > 0)) return std::nullopt;
  ValleyShape shape{TurnedAxes(across)};
  shape.gap = derivative_y(shape.turned(gap));
  shape.gap_w = derivative_x(shape.gap);
  shape.gap_z = derivative_y(shape.gap);
  shape.gap_zz = derivative_y(shape.gap_z);
  const double high = kBeyond * shape.reach;
  const TaylorRange bend = range(shape.gap_zz, shape.reach, high);
  const TaylorRange twist = range(derivative_x(shape.gap_z), shape.reach, high);
  shape.bend_low = bend.low;
  shape.bend_high = bend.high;
  shape.twist = std::max(std::abs(twist.low), std::abs(twist.high));
  if (!(shape.bend_low > kMinTwist * shape.bend_high)) return std::nullopt;
  return shape;
}

double largest(const PolynomialRange& r) { return std::max(std::abs(r.low), std::abs(r.high)); }

// True if along the whole line, on both sides of the cell too, gap and slope are so small that
// everything the gap does against its growth is within the tolerance.
bool is_flat(const ValleyShape& shape, const TaylorPolynomial& gap, double tolerance) {
  TaylorPolynomial z{};
  z[taylor_index(0, 1)] = 1;
  const auto place = shape.along(z, -shape.reach, shape.reach);
  if (!place || largest(place->range) + place->off > kBeyond * shape.reach) return false;
  const auto stretch = shape.stretch(-shape.reach, shape.reach);
  const auto value = shape.along(gap, -shape.reach, shape.reach);
  if (!stretch || !value) return false;
  const ValleyBounds slope = shape.bounds_on(*stretch);
  const double steepest = std::max(std::abs(slope.low), std::abs(slope.high));
  // The cubic gap c z^3 / 6 reaches the tolerance at this z.
  const double c = shape.bend_low, band = std::cbrt(6 * tolerance / c);
  const double beside = (steepest + 0.5 * shape.bend_high * value->off * value->off) * value->off;
  return largest(value->range) + beside <= kGapShare * tolerance &&
         steepest * band <= kSlopeShare * tolerance;
}

struct Crossing {
  double w, z;
  int edge;
};

// Where the line meets the border of the cell, by w; nothing if that stays undecided.
std::optional<std::vector<Crossing>> crossings_of(const ValleyShape& shape) {
  std::vector<Crossing> crossings;
  for (int edge = 0; edge < 4; ++edge) {
    const auto roots = isolated_roots(shape.along_edge(shape.gap_z, edge), 0, 0, -1, 1);
    if (!roots) return std::nullopt;
    for (const IsolatedRoot& root : *roots) {
      const Vec2 wz = shape.on_edge(edge, root.t);
      crossings.push_back({wz[0], wz[1], edge});
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.w < b.w; });
  return crossings;
}

std::optional<CellContact> piece_between(const ValleyShape& shape, const ModelPoints& points,
                                         const Crossing& from, const Crossing& to) {
  CellContact contact;
  contact.leaves = {true, true};
  contact.crosses = true;
  for (int k = 0; k <= kContactSteps; ++k) {
    const double w = from.w + (to.w - from.w) * k / kContactSteps;
    const auto z = shape.valley_at(w);
    if (!z) return std::nullopt;
    const auto x = k == 0               ? points.on_touch_at(from.edge, from.w, from.z, true)
                   : k == kContactSteps ? points.on_touch_at(to.edge, to.w, to.z, true)
                                        : points.on_touch(w, *z, true);
    if (!x) return std::nullopt;
    contact.path.push_back(*x);
    contact.gaps.push_back(points.gap(*x));
  }
  return contact;
}

// The point of least gap on the border: with the line beside the cell the gap has no slope inside.
Point4 closest_on_border(const ValleyShape& shape, const TaylorPolynomial& gap,
                         const ModelPoints& points) {
  Vec2 best{};
  double least = kUnbounded;
  for (int edge = 0; edge < 4; ++edge)
    for (int k = 0; k <= kEdgeSamples; ++k) {
      const Vec2 wz = shape.on_edge(edge, 2.0 * k / kEdgeSamples - 1);
      const double here = std::abs(value(gap, wz[0], wz[1]));
      if (here >= least) continue;
      least = here;
      best = wz;
    }
  return points.at(best[0], best[1]);
}

}  // namespace

std::optional<OddContact> crossing_contact(const RationalBezierPatch& patch_a, const Cell& a,
                                           const RationalBezierPatch& patch_b,
                                           const GapModel& model, double tolerance) {
  if (model.gap_error[0] > kErrorShare * tolerance) return std::nullopt;
  const auto shape = slope_shape(model.gap);
  if (!shape) return std::nullopt;
  const TaylorPolynomial gap = shape->turned(model.gap);
  if (!is_flat(*shape, gap, tolerance)) return std::nullopt;
  const auto crossings = crossings_of(*shape);
  if (!crossings) return std::nullopt;
  const ModelPoints points(patch_a, a, patch_b, model, *shape);
  if (crossings->empty()) return OddContact{{}, closest_on_border(*shape, gap, points)};
  if (crossings->size() != 2) return std::nullopt;
  auto contact = piece_between(*shape, points, crossings->front(), crossings->back());
  if (!contact) return std::nullopt;
  return OddContact{std::move(contact), {}};
}

}  // namespace blossom
