// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/chart_region.h"

#include <algorithm>
#include <cstddef>

namespace blossom {
namespace {

// Squares in each direction. A wire then runs through some 5 % of them; 4 kB a face.
constexpr int kCells = 64;
// Pieces of a wire are halved down to a square; no piece needs more.
constexpr int kDeepest = 40;

// Whether the curve comes into the rectangle, or too close to it to tell.
bool meets(const PlanarBezier& curve, const PlanarBox& rectangle, int depth) {
  const PlanarBox box = box_of(curve.points);
  bool within = true;
  for (int k = 0; k < 2; ++k) {
    if (box.low[k] > rectangle.high[k] || box.high[k] < rectangle.low[k]) return false;
    within = within && box.low[k] >= rectangle.low[k] && box.high[k] <= rectangle.high[k];
  }
  return within || depth >= kDeepest ||
         meets(bezier_piece(curve, {0, 0.5}), rectangle, depth + 1) ||
         meets(bezier_piece(curve, {0.5, 1}), rectangle, depth + 1);
}

PlanarBezier line(const Vec2& from, const Vec2& to) {
  return {{{from[0], from[1], 1}, {to[0], to[1], 1}}};
}

bool meets(const FaceTrims& trims, const PlanarBox& rectangle) {
  const auto corner = [&](int i) { return trims.corners[static_cast<std::size_t>(i)]; };
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      for (const PlanarSpan& span : coedge.curve.spans)
        if (meets(span.curve, rectangle, 0)) return true;
      if (meets(line(corner(coedge.from), end_point(coedge, false)), rectangle, 0) ||
          meets(line(end_point(coedge, true), corner(coedge.to)), rectangle, 0))
        return true;
    }
  return false;
}

}  // namespace

ChartRegion::ChartRegion(const FaceTrims& trims) : box_(trims.box), natural_(trims.natural) {
  if (natural_) return;
  for (int k = 0; k < 2; ++k) per_cell_[k] = kCells / (box_.high[k] - box_.low[k]);
  cells_.assign(static_cast<std::size_t>(kCells * kCells), Place::Outside);
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      for (const PlanarSpan& span : coedge.curve.spans) mark(span.curve, 0);
      const auto corner = [&](int i) { return trims.corners[static_cast<std::size_t>(i)]; };
      mark(line(corner(coedge.from), end_point(coedge, false)), 0);
      mark(line(end_point(coedge, true), corner(coedge.to)), 0);
    }
  fill(trims);
}

ChartRegion::Place ChartRegion::place(const Vec2& point) const {
  if (natural_) return Place::Inside;
  const double x = (point[0] - box_.low[0]) * per_cell_[0];
  const double y = (point[1] - box_.low[1]) * per_cell_[1];
  // A hair outside may still be on a wire that runs along the box.
  if (!(x >= -1 && y >= -1 && x <= kCells + 1 && y <= kCells + 1)) return Place::Outside;
  return cells_[static_cast<std::size_t>(row(point[1]) * kCells + column(point[0]))];
}

ChartRegion::Place ChartRegion::place(const FaceTrims& trims, const PlanarBox& rectangle) const {
  if (natural_) return Place::Inside;
  const int i1 = column(rectangle.high[0]), j1 = row(rectangle.high[1]);
  bool seen[3] = {};  // by place
  for (int j = row(rectangle.low[1]); j <= j1; ++j)
    for (int i = column(rectangle.low[0]); i <= i1; ++i)
      seen[static_cast<std::size_t>(cells_[static_cast<std::size_t>(j * kCells + i)])] = true;
  const auto was = [&](Place place) { return seen[static_cast<std::size_t>(place)]; };
  if (was(Place::Inside) && was(Place::Outside)) return Place::Near;
  if (!was(Place::Near)) return was(Place::Inside) ? Place::Inside : Place::Outside;
  if (meets(trims, rectangle)) return Place::Near;
  return is_inside(trims, 0.5 * (rectangle.low + rectangle.high)) ? Place::Inside : Place::Outside;
}

int ChartRegion::column(double x) const {
  return static_cast<int>(std::clamp((x - box_.low[0]) * per_cell_[0], 0.0, kCells - 1.0));
}
int ChartRegion::row(double y) const {
  return static_cast<int>(std::clamp((y - box_.low[1]) * per_cell_[1], 0.0, kCells - 1.0));
}

ChartRegion::Place& ChartRegion::at_cell(int i, int j) {
  return cells_[static_cast<std::size_t>(j * kCells + i)];
}

// The squares that the box meets, and those beside them.
void ChartRegion::mark_box(const PlanarBox& box) {
  const int i1 = std::min(column(box.high[0]) + 1, kCells - 1);
  const int j1 = std::min(row(box.high[1]) + 1, kCells - 1);
  for (int j = std::max(row(box.low[1]) - 1, 0); j <= j1; ++j)
    for (int i = std::max(column(box.low[0]) - 1, 0); i <= i1; ++i) at_cell(i, j) = Place::Near;
}

void ChartRegion::mark(const PlanarBezier& curve, int depth) {
  const PlanarBox box = box_of(curve.points);
  const bool small = (box.high[0] - box.low[0]) * per_cell_[0] <= 1 ||
                     (box.high[1] - box.low[1]) * per_cell_[1] <= 1;
  if (small || depth >= kDeepest) {
    mark_box(box);
    return;
  }
  mark(bezier_piece(curve, {0, 0.5}), depth + 1);
  mark(bezier_piece(curve, {0.5, 1}), depth + 1);
}

// Squares side by side that no wire comes near are of one kind.
void ChartRegion::fill(const FaceTrims& trims) {
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      if (at_cell(i, j) == Place::Near) continue;
      if (i > 0 && at_cell(i - 1, j) != Place::Near) {
        at_cell(i, j) = at_cell(i - 1, j);
      } else if (j > 0 && at_cell(i, j - 1) != Place::Near) {
        at_cell(i, j) = at_cell(i, j - 1);
      } else {
        const Vec2 centre{box_.low[0] + (i + 0.5) / per_cell_[0],
                          box_.low[1] + (j + 0.5) / per_cell_[1]};
        at_cell(i, j) = is_inside(trims, centre) ? Place::Inside : Place::Outside;
      }
    }
}

}  // namespace blossom
