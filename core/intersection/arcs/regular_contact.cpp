// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/arcs/regular_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/intersection/cells/cell_pair.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

constexpr double kAround = 0.1;       // of its width: by so much a rectangle is widened,
constexpr double kLeastWidth = 1e-6;  // and by this: derivatives over less are rounding
constexpr int kMostSpans = 3;         // that a rectangle meets, in one direction

// Over a whole surface: index of the span plus the local parameter.
using Rectangle = std::array<Interval, 2>;

std::optional<Rectangle> widened_inside(Rectangle r, const BezierSurface& surface) {
  const std::array spans{surface.patches.rows(), surface.patches.columns()};
  for (std::size_t k = 0; k < 2; ++k) {
    const double by = kAround * length(r[k]) + kLeastWidth;
    r[k] = {r[k].from - by, r[k].to + by};
    const bool inside = r[k].from > 0 && r[k].to < spans[k];
    if (!inside || std::ceil(r[k].to) - std::floor(r[k].from) > kMostSpans) return {};
  }
  return r;
}

VectorBounds hull(const VectorBounds& p, const VectorBounds& q) {
  VectorBounds result;
  for (int k = 0; k < 3; ++k) {
    const double low = std::min(p.middle[k] - p.radius[k], q.middle[k] - q.radius[k]);
    const double high = std::max(p.middle[k] + p.radius[k], q.middle[k] + q.radius[k]);
    result.middle[k] = 0.5 * (low + high);
    result.radius[k] = 0.5 * (high - low) * (1 + 0x1p-50) + 0x1p-52 * std::abs(result.middle[k]);
  }
  return result;
}

// Derivatives over a part of a patch by the parameters of the surface in which the patch has the
// widths of its knot spans: they are continuous from patch to patch.
std::array<VectorBounds, 2> derivatives(SurfaceCells& cells, int patch, const Interval& u,
                                        const Interval& v) {
  const CellTree& tree = cells.tree(patch);
  const CellTree part(sub_patch(tree.patch(), u, v), tree.shape().planes == 4, {}, CellForm::Bezier,
                      0.5);
  const int degree = std::max(tree.shape().rows, tree.shape().columns) - 1;
  const double spread = tree.weight_spread();
  const double rounding =
      2 * degree * subdivision_error(degree) * tree.scale() * spread * spread * spread;
  const auto scaled = [&](const VectorBounds& bounds, double width) {
    const Vec3 more{rounding, rounding, rounding};
    return VectorBounds{bounds.middle * (1 / width), (bounds.radius + more) * (1 / width)};
  };
  return {scaled(part[0].du, length(u) * length(cells.knots_u(patch))),
          scaled(part[0].dv, length(v) * length(cells.knots_v(patch)))};
}

// Over a whole rectangle; nothing if it reaches what does not count of the surface.
std::optional<std::array<VectorBounds, 2>> derivatives(SurfaceCells& cells, const Rectangle& r) {
  std::optional<std::array<VectorBounds, 2>> all;
  const auto local = [](const Interval& x, int span) {
    return Interval{std::max(x.from - span, 0.0), std::min(x.to - span, 1.0)};
  };
  for (int i = static_cast<int>(r[0].from); i < r[0].to; ++i)
    for (int j = static_cast<int>(r[1].from); j < r[1].to; ++j) {
      const int patch = i * cells.surface().patches.columns() + j;
      const Interval u = local(r[0], i), v = local(r[1], j);
      if (!cells.inside(patch, u, v)) return {};
      const auto here = derivatives(cells, patch, u, v);
      all = all ? std::array{hull((*all)[0], here[0]), hull((*all)[1], here[1])} : here;
    }
  return all;
}

}  // namespace

bool crosses_regularly(const PairSearchResult& found, std::span<const int> pairs, SurfaceCells& a,
                       SurfaceCells& b) {
  if (&a == &b || found.beside_known || found.stopped) return false;
  constexpr Interval kNone{1e300, -1e300};
  Rectangle over_a{kNone, kNone}, over_b{kNone, kNone};
  const auto add = [](Interval& all, const Interval& x, int span) {
    all = {std::min(all.from, x.from + span), std::max(all.to, x.to + span)};
  };
  for (const int i : pairs) {
    const CriticalPair& pair = found.critical[static_cast<std::size_t>(i)];
    add(over_a[0], pair.box[0], a.span_u(pair.patch_a));
    add(over_a[1], pair.box[1], a.span_v(pair.patch_a));
    add(over_b[0], pair.box[2], b.span_u(pair.patch_b));
    add(over_b[1], pair.box[3], b.span_v(pair.patch_b));
  }
  const auto inside_a = widened_inside(over_a, a.surface());
  const auto inside_b = widened_inside(over_b, b.surface());
  if (!inside_a || !inside_b) return false;
  const auto of_a = derivatives(a, *inside_a), of_b = derivatives(b, *inside_b);
  if (!of_a || !of_b) return false;
  const auto opposite = [](const VectorBounds& x) { return VectorBounds{-x.middle, x.radius}; };
  const JacobianBounds bounds(
      std::array{(*of_a)[0], (*of_a)[1], opposite((*of_b)[0]), opposite((*of_b)[1])});
  return bounds.certified_column() >= 0;
}

}  // namespace blossom
