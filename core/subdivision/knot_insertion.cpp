// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/knot_insertion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/errors.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

// A direction of a surface, cut at local parameter t of one of its spans.
struct Cut {
  Direction direction;
  double t;
  // The weight of an arc with weights (1, cosine, 1) at t, or 1 if there is no law of angles.
  double weight;
};

Cut cut_of(Direction direction, ParameterLaw law, const Interval& span, double knot) {
  const double t = local_parameter(law, span, knot), s = 1 - t;
  if (law == ParameterLaw::Linear) return {direction, t, 1};
  return {direction, t, s * s + 2 * s * t * std::cos(length(span) / 2) + t * t};
}

// The part of an arc from its start has weights (1, m, w). Multiplied by c^i with c^2 = 1 / w they
// are those of its angle, and the points stay; likewise from the end.
void scale(RationalBezierPatch& half, const Cut& cut, bool from_start) {
  Grid<Vec4>& net = half.points;
  const bool along_u = cut.direction == Direction::U;
  const int degree = along_u ? half.degree_u() : half.degree_v();
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) {
      const int k = along_u ? i : j;
      net(i, j) = std::pow(cut.weight, -0.5 * (from_start ? k : degree - k)) * net(i, j);
    }
}

std::array<RationalBezierPatch, 2> halves_of(const RationalBezierPatch& patch, const Cut& cut,
                                             bool rational) {
  const std::array<double, 2> whole{0, 1};
  const std::array<double, 3> cuts{0, cut.t, 1};
  const bool along_u = cut.direction == Direction::U;
  const auto cells =
      along_u ? subdivide<Vec4>(patch, cuts, whole) : subdivide<Vec4>(patch, whole, cuts);
  std::array halves{cells(0, 0), along_u ? cells(1, 0) : cells(0, 1)};
  for (std::size_t k = 0; k < 2; ++k) {
    if (cut.weight != 1) scale(halves[k], cut, k == 0);
    if (rational) continue;
    for (Vec4& point : halves[k].points.values()) point[3] = 1;
  }
  return halves;
}

}  // namespace

BezierSurface with_knot(const BezierSurface& surface, Direction direction, double knot) {
  const bool along_u = direction == Direction::U;
  BezierSurface result = surface;
  std::vector<double>& knots = along_u ? result.u_knots : result.v_knots;
  const auto above = std::ranges::upper_bound(knots, knot);
  if (above == knots.begin() || above == knots.end())
    throw InvalidInput("with_knot: the knot is outside of the surface");
  const Cut cut =
      cut_of(direction, along_u ? surface.u_law : surface.v_law, {*(above - 1), *above}, knot);
  if (!(cut.t > 0 && cut.t < 1)) throw InvalidInput("with_knot: the knot is there already");
  const int span = static_cast<int>(above - knots.begin()) - 1;
  knots.insert(above, knot);
  const Grid<RationalBezierPatch>& old = surface.patches;
  result.patches =
      Grid<RationalBezierPatch>(old.rows() + (along_u ? 1 : 0), old.columns() + (along_u ? 0 : 1));
  for (int i = 0; i < old.rows(); ++i)
    for (int j = 0; j < old.columns(); ++j) {
      const int place = along_u ? i : j;
      const auto put = [&](int at, RationalBezierPatch patch) {
        (along_u ? result.patches(at, j) : result.patches(i, at)) = std::move(patch);
      };
      if (place != span) {
        put(place < span ? place : place + 1, old(i, j));
        continue;
      }
      auto [low, high] = halves_of(old(i, j), cut, surface.rational);
      put(span, std::move(low));
      put(span + 1, std::move(high));
    }
  return result;
}

}  // namespace blossom
