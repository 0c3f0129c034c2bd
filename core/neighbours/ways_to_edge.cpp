// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/neighbours/ways_to_edge.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/base/unbounded.h"
#include "core/cells/limits.h"
#include "core/neighbours/coedge_stretch.h"
#include "core/neighbours/limits.h"
#include "core/neighbours/sliver_spans.h"
#include "core/topology/face_trims.h"

namespace blossom {
namespace {

constexpr double kEdgeEndRounding = 0x1p-44;  // of a span, by which an edge on its end may miss it
constexpr Axes kAxes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

}  // namespace

FaceCells::FaceCells(const FaceData& data, const Vec3& origin)
    : data_(data),
      cells_(data.surface, origin, CellForm::Auto, kSurfaceOffMiddle, part_test(data.trims)),
      slopes_(static_cast<std::size_t>(cells_.patches())),
      widths_(static_cast<std::size_t>(cells_.patches())) {
  if (data.trims.largest_gap == 0) return;
  for (const auto& loop : data.trims.loops)
    for (const Coedge& coedge : loop)
      for (const auto& [from, to] : closing_chords(data.trims, coedge))
        gaps_.push_back(united({from, from}, {to, to}));
}

bool FaceCells::is_outside(int patch, int cell) {
  std::optional<bool>& outside = facts(patch, cell).outside;
  if (!outside) outside = finds_outside(patch, cells_.tree(patch)[cell]);
  return *outside;
}

const std::optional<WaysToEdge>& FaceCells::ways(const Coedge& edge, int patch, int cell) {
  auto& known = facts(patch, cell).ways;
  for (const auto& [of, ways] : known)
    if (of == &edge) return ways;
  return known.emplace_back(&edge, found_ways(edge, patch, cells_.tree(patch)[cell])).second;
}

bool FaceCells::finds_outside(int patch, const Cell& cell) const {
  if (cell.part != PartSide::Mixed) return cell.part == PartSide::Outside;
  return is_empty(chart_box(patch, cell));
}

bool FaceCells::is_empty(const PlanarBox& box) const {
  return !meets_gap(box) &&
         coedge_near(data_.trims, box, 0, kMaxHalvings, Wires::AsTheyAre) == nullptr &&
         !is_inside(data_.trims, 0.5 * (box.low + box.high));
}

double FaceCells::nearest_on(const Coedge& edge, int patch, const Cell& cell) const {
  const PlanarBox box = chart_box(patch, cell);
  return foot_on(edge, 0.5 * (box.low + box.high));
}

std::optional<WaysToEdge> FaceCells::found_ways(const Coedge& edge, int patch, const Cell& cell) {
  const PlanarBox box = chart_box(patch, cell);
  const std::optional<CoedgeStretch> stretch = stretch_past(edge, box);
  if (!stretch || !lies_beside(data_.trims, edge, *stretch, box)) return {};
  const int across = 1 - stretch->along;
  PlanarBox swept = box;
  swept.low[across] = std::min(box.low[across], stretch->box.low[across]);
  swept.high[across] = std::max(box.high[across], stretch->box.high[across]);
  WaysToEdge ways{stretch->range, {}, stretch->shortfall};
  add_directions(swept, across, -stretch->inner, edge.tolerance, ways);
  return ways;
}

double FaceCells::depth_behind(const Elementary& surface, const Coedge& edge, double tolerance,
                               int patch, int cell) {
  for (const auto& [of, depth] : facts(patch, cell).depths)
    if (of == &edge) return depth;
  const double depth = found_depth(surface, edge, tolerance, patch, cell);
  facts(patch, cell).depths.emplace_back(&edge, depth);
  return depth;
}

double FaceCells::found_depth(const Elementary& surface, const Coedge& edge, double tolerance,
                              int patch, int cell) {
  const PlanarBox box = chart_box(patch, cells_.tree(patch)[cell]);
  const std::optional<CoedgeStretch> stretch = stretch_past(edge, box);
  if (!stretch) return kInfinity;
  // The line on which they touch may not go on in the face beyond the ends of the edge; a part of
  // the cell as wide as the tolerance is the end. What lies beside it there is behind nothing.
  const int along = stretch->along;
  const double extent = cells_.tree(patch)[cell].extent;
  const double end = (box.high[along] - box.low[along]) * std::min(1.0, tolerance / extent);
  PlanarBox before = stretch->box, after = stretch->box;
  before.low[along] = box.low[along];
  after.high[along] = box.high[along];
  before.high[along] = stretch->box.low[along] - end;
  after.low[along] = stretch->box.high[along] + end;
  for (const PlanarBox& beyond : {before, after})
    if (beyond.low[along] < beyond.high[along] && !is_empty(beyond)) return kInfinity;
  return depth_beside(surface, stretch->box, 1 - along, patch, cell);
}

double FaceCells::depth_beside(const Elementary& surface, const Vec2& through, int across,
                               int patch, int cell) {
  return depth_beside(surface, PlanarBox{through, through}, across, patch, cell);
}

// The line has to be on the cell's own patch: what is farther from it is apart otherwise.
double FaceCells::depth_beside(const Elementary& surface, const PlanarBox& line, int across,
                               int patch, int cell) {
  const BezierSurface& s = data_.surface;
  const std::array<ParameterLaw, 2> laws{s.u_law, s.v_law};
  const std::array<Interval, 2> spans{cells_.knots_u(patch), cells_.knots_v(patch)};
  const PlanarBox box = chart_box(patch, cells_.tree(patch)[cell]), swept = united(box, line);
  const auto k = static_cast<std::size_t>(across);
  const double scale = data_.trims.scale[across], slack = kEdgeEndRounding * length(spans[k]);
  if (swept.low[across] < (spans[k].from - slack) * scale ||
      swept.high[across] > (spans[k].to + slack) * scale)
    return kInfinity;
  const auto lengthwise = local(laws[1 - k], spans[1 - k], box, 1 - across);
  const auto on_line = local(laws[k], spans[k], line, across);
  const auto whole = local(laws[k], spans[k], swept, across);
  if (!lengthwise || !on_line || !whole || !side(surface, patch)) return kInfinity;
  return side(surface, patch)->depth(across, *lengthwise, *on_line, *whole) + s.error;
}

const std::optional<ElementarySide>& FaceCells::side(const Elementary& surface, int patch) {
  const auto [known, is_new] = sides_.try_emplace(patch);
  if (is_new) {
    Elementary seen = surface;
    seen.centre = surface.centre - cells_.origin();
    known->second = ElementarySide::of(seen, cells_.tree(patch).patch());
  }
  return known->second;
}

// Whether a box meets what closes a gap between the ends of coedges.
bool FaceCells::meets_gap(const PlanarBox& box) const {
  return std::ranges::any_of(gaps_, [&](const PlanarBox& gap) { return !are_disjoint(box, gap); });
}

PlanarBox FaceCells::chart_box(int patch, const Cell& cell) const {
  const BezierSurface& s = data_.surface;
  const Interval u = cells_.knots_u(patch), v = cells_.knots_v(patch);
  const Vec2& scale = data_.trims.scale;
  return {{parameter_at(s.u_law, u, cell.u.from) * scale[0],
           parameter_at(s.v_law, v, cell.v.from) * scale[1]},
          {parameter_at(s.u_law, u, cell.u.to) * scale[0],
           parameter_at(s.v_law, v, cell.v.to) * scale[1]}};
}

// Of the derivatives across, over all patches that a rectangle of the chart meets. Patches that are
// narrower than the edge is exact may go to and fro; what leads through them is short instead.
void FaceCells::add_directions(const PlanarBox& box, int across, double sign, double strip,
                               WaysToEdge& ways) {
  const BezierSurface& s = data_.surface;
  for (int patch = 0; patch < cells_.patches(); ++patch) {
    const auto u = local(s.u_law, cells_.knots_u(patch), box, 0);
    const auto v = local(s.v_law, cells_.knots_v(patch), box, 1);
    if (!u || !v) continue;
    if (width(patch, across) <= strip) {
      ways.shortfall += width(patch, across);
      continue;
    }
    const DirectionCones cones = cones_of(slopes(patch), *u, *v, kAxes);
    const VectorBounds& bounds = across == 0 ? cones.u : cones.v;
    ways.directions.push_back({sign * bounds.middle, bounds.radius});
  }
}

double FaceCells::width(int patch, int across) {
  auto& known = widths_[static_cast<std::size_t>(patch)][static_cast<std::size_t>(across)];
  if (!known) known = width_across(cells_.tree(patch).patch(), across);
  return *known;
}

std::optional<Interval> FaceCells::local(ParameterLaw law, const Interval& span,
                                         const PlanarBox& box, int k) const {
  const double from = box.low[k] / data_.trims.scale[k], to = box.high[k] / data_.trims.scale[k];
  if (from > span.to || to < span.from) return {};
  const auto at = [&](double t) {
    return std::clamp(local_parameter(law, span, std::clamp(t, span.from, span.to)), 0.0, 1.0);
  };
  return Interval{at(from), at(to)};
}

const SlopeNets& FaceCells::slopes(int patch) {
  auto& nets = slopes_[static_cast<std::size_t>(patch)];
  if (!nets) {
    const CellTree& tree = cells_.tree(patch);
    nets = slope_nets(tree.patch(), tree.shape().planes == 4, tree.given_rounding());
  }
  return *nets;
}

}  // namespace blossom
