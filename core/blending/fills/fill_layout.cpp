// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill_layout.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/base/errors.h"

namespace blossom {
namespace {

Vec2 turned(const Vec2& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
}

Vec2 polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

void make_star(PolygonLayout& layout, double h) {
  enum { P, M, C };
  layout.places = {{1, 0}, polar(std::cos(h), h), {0, 0}};
  layout.quads = {{{{{P, 0}, {M, 0}, {C, 0}, {M, -1}}}}};
  layout.borders = {QuadEdge{0, 0, 0}, QuadEdge{0, 3, 1}};
}

/// R is the mean of P, m, m' and lies at the distance r; m is the mean of M, R, R', c at the
/// distance q on the bisector:  3 r = 1 + 2 q cos h,  4 q = cos h + 2 r cos h.
void make_ring(PolygonLayout& layout, double h) {
  enum { P, M, R, m, C };
  const double cosine = std::cos(h);
  const double r = (1 + cosine * cosine / 2) / (3 - cosine * cosine);
  const double q = (cosine + 2 * r * cosine) / 4;
  layout.places = {{1, 0}, polar(cosine, h), {r, 0}, polar(q, h), {0, 0}};
  layout.quads = {{{{{P, 0}, {M, 0}, {m, 0}, {R, 0}}}},
                  {{{{M, 0}, {P, 1}, {R, 1}, {m, 0}}}},
                  {{{{R, 0}, {m, 0}, {C, 0}, {m, -1}}}}};
  layout.borders = {QuadEdge{0, 0, 0}, QuadEdge{1, 0, 0}};
}

/// b is the mean of P, r, m and a its mirror image; r the mean of a, b, c; m the mean of M, b, the
/// next a, and c, at the distance q on the bisector:
///   b_x = (1 + r + q cos h) / 3,  b_y = q sin h / 3,  r = 2 b_x / 3,
///   4 q = cos h + 2 (b_x cos h + b_y sin h).
void make_deep_ring(PolygonLayout& layout, double h) {
  enum { P, M, A, B, R, m, C };
  const double cosine = std::cos(h), sine = std::sin(h);
  const double q = cosine * 13 / 7 / (4 - cosine * cosine * 6 / 7 - sine * sine * 2 / 3);
  const double r = (1 + q * cosine) * 2 / 7;
  const Vec2 b{1.5 * r, q * sine / 3};
  layout.places = {{1, 0}, polar(cosine, h), {b[0], -b[1]}, b, {r, 0}, polar(q, h), {0, 0}};
  layout.quads = {{{{{P, 0}, {M, 0}, {m, 0}, {B, 0}}}},
                  {{{{M, 0}, {P, 1}, {A, 1}, {m, 0}}}},
                  {{{{P, 0}, {B, 0}, {R, 0}, {A, 0}}}},
                  {{{{C, 0}, {R, 0}, {B, 0}, {m, 0}}}},
                  {{{{C, 0}, {m, -1}, {A, 0}, {R, 0}}}}};
  layout.borders = {QuadEdge{0, 0, 0}, QuadEdge{1, 0, 0}};
}

LayoutVertex corner(const PolygonLayout& layout, const QuadEdge& at, int i) {
  const auto quad = static_cast<std::size_t>(at.quad);
  LayoutVertex vertex = layout.quads[quad].corners[static_cast<std::size_t>((at.edge + i) % 4)];
  if (vertex.role != layout.centre) vertex.sector += at.sector;
  return vertex;
}

/// Whether an edge of sector 0 and another one, both as they are, run along the same vertices in
/// opposite directions, up to a turn by `sectors`.
bool opposite(const PolygonLayout& layout, const QuadEdge& a, const QuadEdge& b) {
  const auto same = [&](LayoutVertex v, LayoutVertex w) {
    if (v.role != w.role) return false;
    return v.role == layout.centre || (v.sector - w.sector) % layout.sides == 0;
  };
  return same(corner(layout, a, 0), corner(layout, b, 1)) &&
         same(corner(layout, a, 1), corner(layout, b, 0));
}

/// Finds the other quad at each inner edge of sector 0; each class of turned copies once.
void find_shared(PolygonLayout& layout) {
  const int quads = static_cast<int>(layout.quads.size());
  for (int i = 0; i < 4 * quads; ++i)
    for (int j = i + 1; j < 4 * quads; ++j)
      for (int sector = -1; sector <= 1; ++sector) {
        const QuadEdge a{i / 4, i % 4, 0}, b{j / 4, j % 4, sector};
        if (opposite(layout, a, b)) layout.shared.push_back({a, b});
      }
}

}  // namespace

const char* to_string(FillLayout layout) {
  switch (layout) {
    case FillLayout::Star: return "star";
    case FillLayout::Ring: return "ring";
    case FillLayout::DeepRing: break;
  }
  return "deep ring";
}

double sector_angle(int sides) { return 2 * std::numbers::pi / sides; }

PolygonLayout polygon_layout(FillLayout kind, int sides) {
  if (sides < kMinFillSides || sides > kMaxFillSides)
    throw InvalidInput("polygon_layout: " + std::to_string(kMinFillSides) + " to " +
                       std::to_string(kMaxFillSides) + " sides are wanted, got " +
                       std::to_string(sides));
  PolygonLayout layout;
  layout.kind = kind;
  layout.sides = sides;
  const double h = sector_angle(sides) / 2;
  switch (kind) {
    case FillLayout::Star: make_star(layout, h); break;
    case FillLayout::Ring: make_ring(layout, h); break;
    case FillLayout::DeepRing: make_deep_ring(layout, h); break;
  }
  layout.centre = static_cast<int>(layout.places.size()) - 1;
  find_shared(layout);
  return layout;
}

Vec2 place_of(const PolygonLayout& layout, const LayoutVertex& vertex) {
  return turned(layout.places[static_cast<std::size_t>(vertex.role)],
                vertex.sector * sector_angle(layout.sides));
}

std::array<Vec2, 4> corners_from(const PolygonLayout& layout, const QuadEdge& edge) {
  std::array<Vec2, 4> places;
  for (int i = 0; i < 4; ++i)
    places[static_cast<std::size_t>(i)] = place_of(layout, corner(layout, edge, i));
  return places;
}

}  // namespace blossom
