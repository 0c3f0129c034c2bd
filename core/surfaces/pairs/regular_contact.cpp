// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/regular_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"
#include "core/cells/cell_pair.h"

namespace blossom {
namespace {

constexpr double kAround = 0.1;          // of its width: by so much a rectangle is widened,
constexpr double kMinWidth = 1e-6;       // and by this: derivatives over less are rounding
constexpr int kMaxSpans = 3;             // that a rectangle meets, in one direction
constexpr int kMaxLooks = 48;            // at parts of a pair of cells
constexpr double kSeamRounding = 1e-14;  // of the coordinates: between the two sides of a seam

// Over a whole surface: index of the span plus the local parameter.
using Rectangle = std::array<Interval, 2>;

std::optional<Rectangle> widened_inside(Rectangle r, const BezierSurface& surface) {
  const std::array spans{surface.patches.rows(), surface.patches.columns()};
  for (std::size_t k = 0; k < 2; ++k) {
    const double by = kAround * length(r[k]) + kMinWidth;
    r[k] = {r[k].from - by, r[k].to + by};
    const bool inside = r[k].from > 0 && r[k].to < spans[k];
    if (!inside || std::ceil(r[k].to) - std::floor(r[k].from) > kMaxSpans) return {};
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

// What a surface does over a rectangle. Derivatives are by the parameters in which patches have the
// widths of their knot spans: they are continuous from patch to patch.
struct Bounds {
  VectorBounds du, dv;
  Box box;
};

Bounds hull(const Bounds& p, const Bounds& q) {
  return {hull(p.du, q.du), hull(p.dv, q.dv), joined(p.box, q.box)};
}

// Over a part of a patch.
Bounds bounds_over(SurfaceCells& cells, int patch, const Interval& u, const Interval& v) {
  const CellTree part = cells.tree(patch).piece(u, v);
  const auto scaled = [](const VectorBounds& bounds, double width) {
    return VectorBounds{bounds.middle * (1 / width), bounds.radius * (1 / width)};
  };
  return {scaled(part[0].du, length(u) * length(cells.knots_u(patch))),
          scaled(part[0].dv, length(v) * length(cells.knots_v(patch))),
          {part[0].low, part[0].high}};
}

// Over a whole rectangle, which may reach over the seam of a closed surface; nothing if it reaches
// what does not count of the surface.
std::optional<Bounds> bounds_over(SurfaceCells& cells, const Rectangle& r) {
  std::optional<Bounds> all;
  const int rows = cells.surface().patches.rows(), columns = cells.surface().patches.columns();
  const auto local = [](const Interval& x, int span) {
    return Interval{std::max(x.from - span, 0.0), std::min(x.to - span, 1.0)};
  };
  const auto first = [](const Interval& x) { return static_cast<int>(std::floor(x.from)); };
  for (int i = first(r[0]); i < r[0].to; ++i)
    for (int j = first(r[1]); j < r[1].to; ++j) {
      const int patch = (i + rows) % rows * columns + (j + columns) % columns;
      const Interval u = local(r[0], i), v = local(r[1], j);
      if (!cells.inside(patch, u, v)) return {};
      const Bounds here = bounds_over(cells, patch, u, v);
      all = all ? hull(*all, here) : here;
    }
  return all;
}

bool is_regular(const Bounds& a, const Bounds& b) {
  const auto opposite = [](const VectorBounds& x) { return VectorBounds{-x.middle, x.radius}; };
  const JacobianBounds bounds(std::array{a.du, a.dv, opposite(b.du), opposite(b.dv)});
  return bounds.certified_column() >= 0;
}

// One direction of the extent of a pair of cells, over the whole surface.
struct Side {
  Interval range;
  bool on_line = false;  // the arc runs along a knot line: both sides of it
  bool closed = false;
  int spans = 0;

  // With what is around it in the surface.
  Interval widened() const {
    const double by = kAround * length(range) + kMinWidth;
    const Interval wide{range.from - by, range.to + by};
    if (closed) return wide;
    return {std::max(wide.from, 0.0), std::min(wide.to, static_cast<double>(spans))};
  }
};

using Sides = std::array<Side, 4>;

// Nothing if the arc may run along an outer border.
std::optional<Side> side_of(const Interval& cell, double from, double to, int spans, bool closed) {
  const double by = kAround * length(cell);
  const auto is_along = [&](double line, double within) {
    return std::max(std::abs(from - line), std::abs(to - line)) <= within;
  };
  if (!closed && (is_along(0, by + kMinWidth) || is_along(spans, by + kMinWidth))) return {};
  const double line = std::round(from);
  if (!is_along(line, kMinWidth)) return Side{cell, false, closed, spans};
  return Side{{line - by, line + by}, true, closed, spans};
}

bool agree(const Vec4& p, const Vec4& q) {
  double scale = 0, gap = 0;
  for (int k = 0; k < 4; ++k) {
    scale = std::max(scale, std::abs(p[k]));
    gap = std::max(gap, std::abs(p[k] - q[k]));
  }
  return gap <= kSeamRounding * scale;
}

// True if the surface is one continuous one across its seam, not only within some tolerance.
bool closes_in_u(const BezierSurface& surface) {
  const Grid<RationalBezierPatch>& patches = surface.patches;
  for (int j = 0; surface.closed_u && j < patches.columns(); ++j) {
    const Grid<Vec4>&low = patches(0, j).points, &high = patches(patches.rows() - 1, j).points;
    if (low.columns() != high.columns()) return false;
    for (int k = 0; k < low.columns(); ++k)
      if (!agree(low(0, k), high(high.rows() - 1, k))) return false;
  }
  return surface.closed_u;
}

bool closes_in_v(const BezierSurface& surface) {
  const Grid<RationalBezierPatch>& patches = surface.patches;
  for (int i = 0; surface.closed_v && i < patches.rows(); ++i) {
    const Grid<Vec4>&low = patches(i, 0).points, &high = patches(i, patches.columns() - 1).points;
    if (low.rows() != high.rows()) return false;
    for (int k = 0; k < low.rows(); ++k)
      if (!agree(low(k, 0), high(k, high.columns() - 1))) return false;
  }
  return surface.closed_v;
}

std::optional<Sides> sides_of(const FoundArc& arc, const SurfaceCells& a, const SurfaceCells& b) {
  const BezierSurface &sa = a.surface(), &sb = b.surface();
  const std::array first{a.span_u(arc.patch_a), a.span_v(arc.patch_a), b.span_u(arc.patch_b),
                         b.span_v(arc.patch_b)};
  const std::array spans{sa.patches.rows(), sa.patches.columns(), sb.patches.rows(),
                         sb.patches.columns()};
  const std::array closed{closes_in_u(sa), closes_in_v(sa), closes_in_u(sb), closes_in_v(sb)};
  Sides sides;
  for (std::size_t k = 0; k < 4; ++k) {
    const Interval cell{first[k] + arc.box[k].from, first[k] + arc.box[k].to};
    const auto side =
        side_of(cell, first[k] + arc.arc.from[k], first[k] + arc.arc.to[k], spans[k], closed[k]);
    if (!side) return {};
    sides[k] = *side;
  }
  return sides;
}

// Halves what is widest in space; what lies about a knot line shrinks with it.
std::array<Sides, 2> halves(const Sides& sides, const Bounds& a, const Bounds& b) {
  const std::array derivative{&a.du, &a.dv, &b.du, &b.dv};
  const auto width = [&](std::size_t k) {
    return sides[k].on_line ? 0 : length(sides[k].range) * norm(derivative[k]->middle);
  };
  std::size_t widest = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (width(k) > width(widest)) widest = k;
  std::array<Sides, 2> parts{sides, sides};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const Interval range = sides[k].range;
      if (sides[k].on_line)
        parts[i][k].range = {at(range, 0.25), at(range, 0.75)};
      else if (k == widest)
        parts[i][k].range =
            i == 0 ? Interval{range.from, at(range, 0.5)} : Interval{at(range, 0.5), range.to};
    }
  return parts;
}

}  // namespace

bool crosses_regularly(const PairSearchResult& found, std::span<const int> pairs, SurfaceCells& a,
                       SurfaceCells& b) {
  if (&a == &b || found.beside_known || found.stopped) return false;
  constexpr Interval kNone{kUnbounded, -kUnbounded};
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
  const auto of_a = bounds_over(a, *inside_a), of_b = bounds_over(b, *inside_b);
  return of_a && of_b && is_regular(*of_a, *of_b);
}

bool runs_regularly(const FoundArc& arc, SurfaceCells& a, SurfaceCells& b) {
  const auto sides = sides_of(arc, a, b);
  if (!sides) return false;
  std::vector<Sides> parts{*sides};
  for (int looks = 0; !parts.empty(); ++looks) {
    if (looks == kMaxLooks) return false;
    const Sides part = parts.back();
    parts.pop_back();
    const auto of_a = bounds_over(a, {part[0].widened(), part[1].widened()});
    const auto of_b = bounds_over(b, {part[2].widened(), part[3].widened()});
    if (!of_a || !of_b) return false;
    if (!meet(of_a->box, of_b->box) || is_regular(*of_a, *of_b)) continue;
    for (const Sides& half : halves(part, *of_a, *of_b)) parts.push_back(half);
  }
  return true;
}

}  // namespace blossom
