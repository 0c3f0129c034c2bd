// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/border_arcs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/forms/evaluation.h"
#include "core/math/index.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

// Relative to the surface's range of a parameter: ends that moved less than this moved by rounding.
constexpr double kRounding = 1e-13;
constexpr double kLoweringPart = 0.25;  // of the tolerance, for a lower degree
constexpr double kMinCosine = 0.5;      // of the angle that an arc's control polygon may turn
constexpr double kLongest = 1.5;        // of an arc, in cells
constexpr double kCrossing = 1e-4;      // of a border: as near to a line at so far from where it
                                        // crosses it, it runs along it but for rounding
constexpr double kCornerReach = 8;      // tolerances: as near to a corner on a line is that corner

bool is_whole(double x) { return x == std::floor(x); }

const std::vector<double>& knots_of(const BezierSurface& surface, int direction) {
  return direction == 0 ? surface.u_knots : surface.v_knots;
}

ParameterLaw law_of(const BezierSurface& surface, int direction) {
  return direction == 0 ? surface.u_law : surface.v_law;
}

double range_of(const BezierSurface& surface, int direction) {
  const std::vector<double>& knots = knots_of(surface, direction);
  return knots.back() - knots.front();
}

// Of a patch over a straight triangle.
int straight_degree(const RationalBezierPatch& patch) {
  return patch.degree_u() + patch.degree_v();
}

// The curve with ranges of length 1, so that one tolerance serves both directions.
PlanarCurve unit_sized(const PlanarCurve& curve, const BezierSurface& surface) {
  return transformed(curve, {1 / range_of(surface, 0), 1 / range_of(surface, 1)}, {});
}

// Bound on a way in space; none at all costs nothing, however steep the surface may be.
double way_in_space(const Vec2& way, const Vec2& steepest) {
  return (way[0] > 0 ? way[0] * steepest[0] : 0) + (way[1] > 0 ? way[1] * steepest[1] : 0);
}

// Increasing, from end to end of the domain, none nearer than the shortest arc.
void tidy(std::vector<double>& at, const Interval& domain) {
  const double shortest = kShortestArc * length(domain);
  std::ranges::sort(at);
  std::vector<double> kept{domain.from};
  for (const double parameter : at)
    if (parameter > kept.back() + shortest && parameter < domain.to - shortest)
      kept.push_back(parameter);
  kept.push_back(domain.to);
  at = std::move(kept);
}

}  // namespace

BorderArcs::BorderArcs(const BezierSurface& surface, const TrimmedChart& chart,
                       const RegionOptions& options, int cells)
    : surface_(surface), chart_(chart), options_(options), cells_(cells) {
  steepest_ = Grid<Vec2>(surface.patches.rows(), surface.patches.columns());
  for (int i = 0; i < steepest_.rows(); ++i)
    for (int j = 0; j < steepest_.columns(); ++j) {
      steepest_(i, j) = derivative_bounds(surface.patches(i, j));
      if (straight_degree(surface.patches(i, j)) > options.highest_degree)
        throw InvalidInput("trimmed region: a patch of degrees that add up to more than " +
                           std::to_string(options.highest_degree) + " has no triangles");
    }
  for (const Vec2& corner : chart.corners) corners_.push_back(snapped(grid_point(surface, corner)));
  std::vector<BorderStops> stops;
  const int count = static_cast<int>(chart.borders.size());
  for (int i = 0; i < count; ++i) stops.push_back(stops_of(i));
  if (options.common_borders) {
    for (int i = 0; i < count; ++i) join_near(i, stops[index(i)]);
    for (int i = 0; i < count; ++i) settle_corners(i, stops[index(i)]);
    for (int i = 0; i < count; ++i) join_at_corners(i, stops[index(i)]);
  }
  for (int i = 0; i < count; ++i) divide(i, std::move(stops[index(i)]));
}

int BorderArcs::arc_degree(int patch_u, int patch_v) const {
  const int straight = straight_degree(surface_.patches(patch_u, patch_v));
  const int exact = options_.highest_degree / straight;
  return std::max(exact, std::min(kCommonArcs, kMaxComposed / straight));
}

double BorderArcs::tolerance_of(int border) const {
  return std::max(options_.tolerance, chart_.borders[index(border)].tolerance);
}

bool BorderArcs::takes_cells(int border) const {
  return !options_.common_borders || chart_.borders[index(border)].is_point;
}

Vec2 BorderArcs::metric(int patch_u, int patch_v) const {
  const Vec2& steep = steepest_(patch_u, patch_v);
  const auto power = [](double x) { return x > 0 ? std::exp2(std::round(std::log2(x))) : 1.0; };
  return {power(steep[0]), power(steep[1])};
}

int BorderArcs::vertex_at(const Vec2& grid) {
  const auto [known, is_new] =
      vertex_of_.try_emplace({grid[0], grid[1]}, static_cast<int>(vertices_.size()));
  if (is_new) vertices_.push_back(grid);
  return known->second;
}

Vec3 BorderArcs::point_in(const std::array<int, 2>& patch, int vertex) const {
  const Vec2 local =
      vertices_[index(vertex)] - Vec2{static_cast<double>(patch[0]), static_cast<double>(patch[1])};
  return point_at(surface_.patches(patch[0], patch[1]), local[0], local[1]);
}

// On a line between patches, the ends of cells take what is nearer than kOnLine to them.
Vec2 BorderArcs::snapped(Vec2 grid) const {
  for (int k = 0; k < 2; ++k) {
    if (!is_whole(grid[1 - k])) continue;
    const double near = std::round(grid[k] * cells_) / cells_;
    if (std::abs(grid[k] - near) <= kOnLine) grid[k] = near;
  }
  return grid;
}

// On the arc's line, if it runs along one, and on no other: the sides along that lack it.
int BorderArcs::vertex_within(const RegionArc& arc, double parameter) {
  const RegionBorder& border = chart_.borders[index(arc.border)];
  Vec2 grid = unrounded_grid_point(surface_, point_at(border.curve, parameter));
  if (arc.across >= 0) grid[arc.across] = vertices_[index(arc.from)][arc.across];
  return vertex_at(snapped(grid));
}

void BorderArcs::add_line_stops(const RegionBorder& border, int direction, std::vector<double>& at,
                                std::vector<LineStop>& lines) const {
  const std::vector<double>& knots = knots_of(surface_, direction);
  if (knots.size() < 3) return;
  const PlanarCurve unit = unit_sized(border.curve, surface_);
  for (std::size_t k = 1; k + 1 < knots.size(); ++k) {
    const std::size_t before = at.size();
    const std::size_t crossings = add_crossings(border.curve, unit, direction, knots[k],
                                                knots[k] / range_of(surface_, direction), at);
    for (std::size_t i = before; i < before + crossings; ++i)
      lines.push_back({at[i], direction, static_cast<double>(k)});
  }
}

// The place of the vertex at a stop. Of several stops that are as near as kOnLine to a line about a
// crossing the nearest to it is on the line, since other faces tell them apart; the others stay
// where they are.
Vec2 BorderArcs::point_at_stop(const RegionBorder& border, const std::vector<double>& at,
                               std::size_t stop, const std::vector<LineStop>& lines) const {
  const Vec2 uv = point_at(border.curve, at[stop]);
  Vec2 grid = snapped(grid_point(surface_, uv));
  for (int k = 0; k < 2; ++k) {
    bool beside = false, on = false;
    for (const LineStop& line : lines) {
      if (line.direction != k || std::abs(line.line - grid[k]) > 0.5) continue;
      const double way = std::abs(at[stop] - line.at);
      const bool nearest =
          std::ranges::none_of(at, [&](double other) { return std::abs(other - line.at) < way; });
      on = on || (nearest && way <= kShortestArc * length(border.curve.domain()));
      const bool along = way > kCrossing * length(border.curve.domain());
      beside = beside || (!nearest && !along && grid[k] == line.line);
      if (on) grid[k] = line.line;
    }
    if (beside && !on)
      grid[k] = unrounded_grid_coordinate(knots_of(surface_, k), law_of(surface_, k), uv[k]);
  }
  return grid;
}

// A border along a line is divided as the cells beside it are.
void BorderArcs::add_cell_stops(const RegionBorder& border, std::vector<double>& at) const {
  const PlanarCurve unit = unit_sized(border.curve, surface_);
  const PlanarBox box = box_of(unit);
  for (int k = 0; k < 2; ++k) {
    const auto on_line = [&](double knot) {
      const double line = knot / range_of(surface_, k);
      return box.low[k] >= line - kOnLine && box.high[k] <= line + kOnLine;
    };
    if (std::ranges::none_of(knots_of(surface_, k), on_line)) continue;
    const int along = 1 - k;
    const std::vector<double>& knots = knots_of(surface_, along);
    const ParameterLaw law = law_of(surface_, along);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
      for (int cell = 1; cell < cells_; ++cell) {
        const double cut =
            parameter_at(law, {knots[i], knots[i + 1]}, static_cast<double>(cell) / cells_);
        add_crossings(border.curve, unit, along, cut, cut / range_of(surface_, along), at);
      }
  }
}

BorderArcs::BorderStops BorderArcs::stops_of(int number) const {
  const RegionBorder& border = chart_.borders[index(number)];
  BorderStops stops{border.stops, {}};
  for (const PlanarSpan& span : border.curve.spans) stops.at.push_back(span.place.to);
  for (int direction = 0; direction < 2; ++direction)
    add_line_stops(border, direction, stops.at, stops.lines);
  if (takes_cells(number)) add_cell_stops(border, stops.at);
  return stops;
}

// The corner at an end of a border; -1 inside.
int BorderArcs::corner_at(const RegionBorder& border, double parameter) const {
  const Interval domain = border.curve.domain();
  const double same = kShortestArc * length(domain);
  if (parameter <= domain.from + same) return border.reversed ? border.to : border.from;
  if (parameter >= domain.to - same) return border.reversed ? border.from : border.to;
  return -1;
}

// Bound on the way between two points of a border that are in one patch or in neighbours.
double BorderArcs::way_along(const RegionBorder& border, double from, double to) const {
  const Vec2 a = unrounded_grid_point(surface_, point_at(border.curve, from));
  const Vec2 b = unrounded_grid_point(surface_, point_at(border.curve, to));
  Vec2 steepest;
  for (const Vec2& p : {a, b}) {
    const auto patch = [&](int k, int count) {
      return std::clamp(static_cast<int>(std::floor(p[k])), 0, count - 1);
    };
    const int i = patch(0, surface_.patches.rows()), j = patch(1, surface_.patches.columns());
    const Vec2 corner{static_cast<double>(i), static_cast<double>(j)};
    PlanarBox box{a - corner, a - corner};
    for (int k = 0; k < 2; ++k) {
      box.low[k] = std::min(box.low[k], b[k] - corner[k]);
      box.high[k] = std::max(box.high[k], b[k] - corner[k]);
    }
    const Vec2 steep = derivative_bounds(surface_.patches(i, j), box);
    for (int k = 0; k < 2; ++k) steepest[k] = std::max(steepest[k], steep[k]);
  }
  return way_in_space({std::abs(b[0] - a[0]), std::abs(b[1] - a[1])}, steepest);
}

// Crossings within tolerance of another stop are taken to be there: the arc between would be no
// longer than common borders are moved by, and triangles beside it would fold over.
void BorderArcs::join_near(int number, BorderStops& stops) {
  const RegionBorder& border = chart_.borders[index(number)];
  if (border.is_point) return;
  std::set<double> kept(stops.at.begin(), stops.at.end());
  for (const LineStop& line : stops.lines) kept.erase(line.at);
  kept.insert(border.stops.begin(), border.stops.end());
  kept.insert(border.curve.domain().from);
  for (const PlanarSpan& span : border.curve.spans) kept.insert(span.place.to);
  for (LineStop& line : stops.lines) {
    const auto above = kept.lower_bound(line.at);
    double near = above == kept.end() ? *kept.rbegin() : *above;
    if (above != kept.begin() && above != kept.end() &&
        line.at - *std::prev(above) < near - line.at)
      near = *std::prev(above);
    const double way = way_along(border, near, line.at);
    if (near == line.at || way > tolerance_of(number)) {
      kept.insert(line.at);
      continue;
    }
    std::erase(stops.at, line.at);
    line.at = near;
    beyond_ = std::max(beyond_, way);
    const int corner = corner_at(border, near);
    if (corner >= 0) corners_[index(corner)][line.direction] = line.line;
  }
}

// A corner that is on a line now is the crossing of all its borders that are so near.
void BorderArcs::join_at_corners(int number, BorderStops& stops) {
  const RegionBorder& border = chart_.borders[index(number)];
  const Interval domain = border.curve.domain();
  for (LineStop& line : stops.lines)
    for (const double end : {domain.from, domain.to}) {
      const int corner = corner_at(border, end);
      if (line.at == end || corners_[index(corner)][line.direction] != line.line) continue;
      const double way = way_along(border, end, line.at);
      if (way > kCornerReach * tolerance_of(number)) continue;
      std::erase(stops.at, line.at);
      line.at = end;
      beyond_ = std::max(beyond_, way);
    }
}

// The line between patches that a border with neighbours runs along, as far as these let it be
// moved. Points in space are at equal distances from all lines.
LineRun BorderArcs::run_between(int number, const Interval& place) const {
  const RegionBorder& border = chart_.borders[index(number)];
  if (!options_.common_borders || border.is_point) return {};
  return line_run(surface_, border.curve, place, tolerance_of(number));
}

// A corner from which a border runs along a line is on that line, wherever it is in the chart.
void BorderArcs::settle_corners(int number, const BorderStops& stops) {
  const RegionBorder& border = chart_.borders[index(number)];
  std::vector<double> places = stops.at;
  tidy(places, border.curve.domain());
  const std::size_t last = places.size() - 1;
  for (const Interval& place :
       {Interval{places[0], places[1]}, Interval{places[last], places[last - 1]}}) {
    const LineRun run = run_between(number, place);
    if (run.direction >= 0)
      corners_[index(corner_at(border, place.from))][run.direction] = run.line;
  }
}

void BorderArcs::divide(int number, BorderStops stops) {
  const RegionBorder& border = chart_.borders[index(number)];
  tidy(stops.at, border.curve.domain());
  if (border.reversed) std::ranges::reverse(stops.at);
  std::vector<LineRun> runs;  // before each stop
  for (std::size_t k = 0; k < stops.at.size(); ++k)
    runs.push_back(k == 0 ? LineRun{} : run_between(number, {stops.at[k - 1], stops.at[k]}));
  runs.emplace_back();
  const std::size_t first = arcs_.size();
  int from = vertex_at(corners_[index(border.from)]);
  for (std::size_t k = 1; k < stops.at.size(); ++k) {
    Vec2 to = corners_[index(border.to)];
    if (k + 1 < stops.at.size()) {
      to = point_at_stop(border, stops.at, k, stops.lines);
      for (const LineRun& run : {runs[k], runs[k + 1]})
        if (run.direction >= 0) to[run.direction] = run.line;
      to = snapped(to);
    }
    const Interval place{stops.at[k - 1], stops.at[k]};
    const int vertex = vertex_at(to);
    const int across =
        runs[k].direction >= 0 ? runs[k].direction : direction_across(number, place, from, vertex);
    add(number, place, from, vertex, across, first);
    from = vertex;
  }
}

void BorderArcs::add(int number, const Interval& place, int from, int to, int across,
                     std::size_t first) {
  if (arcs_.size() - first > kMaxArcs)
    throw InvalidInput("trimmed region: a border takes more than " + std::to_string(kMaxArcs) +
                       " arcs within the tolerance; a larger one takes fewer");
  const RegionBorder& border = chart_.borders[index(number)];
  const bool shortest = std::abs(length(place)) <= 2 * kShortestArc * length(border.curve.domain());
  if (from == to && shortest) return;
  const RegionArc arc = made(number, place, from, to, across);
  if (shortest || (from != to && arc.fit_error <= tolerance_of(number) && !is_too_long(arc))) {
    arcs_.push_back(arc);
    return;
  }
  const double middle = at(place, 0.5);
  const int vertex = vertex_within(arc, middle);
  add(number, {place.from, middle}, from, vertex, across, first);
  add(number, {middle, place.to}, vertex, to, across, first);
}

int BorderArcs::halve(int number) {
  const RegionArc arc = arcs_[index(number)];
  const RegionBorder& border = chart_.borders[index(arc.border)];
  if (std::abs(length(arc.place)) <= 2 * kShortestArc * length(border.curve.domain())) return -1;
  const double middle = at(arc.place, 0.5);
  const int vertex = vertex_within(arc, middle);
  if (vertex == arc.from || vertex == arc.to) return -1;
  arcs_[index(number)] = made(arc.border, {arc.place.from, middle}, arc.from, vertex, arc.across);
  arcs_.push_back(made(arc.border, {middle, arc.place.to}, vertex, arc.to, arc.across));
  return static_cast<int>(arcs_.size()) - 1;
}

// The direction of a line through both ends of a piece that stays on it in the chart, too.
int BorderArcs::direction_across(int number, const Interval& place, int from, int to) const {
  if (from == to) return -1;
  for (int k = 0; k < 2; ++k) {
    const double line = vertices_[index(from)][k];
    const auto is_on = [&](double t) {
      const Vec2 uv = point_at(chart_.borders[index(number)].curve, at(place, t));
      return grid_point(surface_, uv)[k] == line;
    };
    if (is_whole(line) && vertices_[index(to)][k] == line && is_on(0.25) && is_on(0.5) &&
        is_on(0.75))
      return k;
  }
  return -1;
}

RegionArc BorderArcs::made(int number, const Interval& place, int from, int to, int across) const {
  const PlanarCurve& curve = chart_.borders[index(number)].curve;
  RegionArc arc;
  arc.border = number;
  arc.place = place;
  arc.from = from;
  arc.to = to;
  arc.across = across;
  const Vec2 middle = point_at(curve, at(place, 0.5));
  std::array<int, 2> patch;
  for (int k = 0; k < 2; ++k) {
    const int count = k == 0 ? surface_.patches.rows() : surface_.patches.columns();
    // The middle may be as near to a line as what counts as on it, and yet the arc beside it.
    double beside =
        unrounded_grid_coordinate(knots_of(surface_, k), law_of(surface_, k), middle[k]);
    if (k == across) {
      const double on = vertices_[index(to)][1 - k] - vertices_[index(from)][1 - k];
      // The region lies on the left.
      beside = vertices_[index(from)][k] + (k == 0 ? -0.5 : 0.5) * (on > 0 ? 1 : -1);
    }
    patch[index(k)] = std::clamp(static_cast<int>(std::floor(beside)), 0, count - 1);
  }
  arc.patch_u = patch[0];
  arc.patch_v = patch[1];
  settle_ends(arc, form_in(arc));
  return arc;
}

// An exact one where triangles over it are within the highest degree, else one to be lowered.
ArcForm BorderArcs::form_in(const RegionArc& arc) const {
  const PlanarCurve& curve = chart_.borders[index(arc.border)].curve;
  const PatchChart chart = chart_of(surface_, arc.patch_u, arc.patch_v);
  const int degree = arc_degree(arc.patch_u, arc.patch_v);
  const int direct =
      options_.highest_degree / straight_degree(surface_.patches(arc.patch_u, arc.patch_v));
  if (options_.common_borders) {
    // Common borders are moved anyway, so a low degree is worth a part of the tolerance.
    const double steep = std::max(max_norm(steepest_(arc.patch_u, arc.patch_v)), kArcRounding);
    return arc_form(
        curve, arc.place, chart,
        {degree, true, degree > direct, kLoweringPart * tolerance_of(arc.border) / steep});
  }
  ArcForm form = arc_form(curve, arc.place, chart, {direct, false, false, kArcRounding});
  if (form.exact || degree == direct) return form;
  return arc_form(curve, arc.place, chart, {degree, false, true, kArcRounding});
}

// Takes the ends to their vertices, and a curve along a line onto it.
void BorderArcs::settle_ends(RegionArc& arc, const ArcForm& form) const {
  arc.curve = form.curve;
  const Vec2 corner{static_cast<double>(arc.patch_u), static_cast<double>(arc.patch_v)};
  const Vec2 from = vertices_[index(arc.from)] - corner, to = vertices_[index(arc.to)] - corner;
  Vec2 moved;
  for (int k = 0; k < 2; ++k) {
    std::vector<Vec3>& points = arc.curve.points;
    for (std::size_t i = 0; k == arc.across && i < points.size(); ++i) {
      moved[k] = std::max(moved[k], std::abs(points[i][k] / points[i][2] - from[k]));
      points[i][k] = from[k] * points[i][2];
    }
    moved[k] = std::max(
        {moved[k], std::abs(points.front()[k] - from[k]), std::abs(points.back()[k] - to[k])});
    points.front()[k] = from[k];
    points.back()[k] = to[k];
  }
  const Vec2 error = form.error + moved;
  const PatchChart chart = chart_of(surface_, arc.patch_u, arc.patch_v);
  arc.exact = form.exact && moved[0] * length(chart.u) <= kRounding * range_of(surface_, 0) &&
              moved[1] * length(chart.v) <= kRounding * range_of(surface_, 1);
  if (arc.exact) return;
  const Vec2 steep = steepest_about(arc, error);
  arc.fit_error = way_in_space(form.error, steep);
  arc.error = way_in_space(error, steep);
}

// Bounds of the derivatives wherever the arc and its trim run, also beyond the patch.
Vec2 BorderArcs::steepest_about(const RegionArc& arc, const Vec2& error) const {
  const PlanarBox box = box_of(arc.curve.points);
  std::array<Interval, 2> reach;
  bool is_inside = true;
  for (int k = 0; k < 2; ++k) {
    reach[index(k)] = {std::min(box.low[k] - error[k], 0.0), std::max(box.high[k] + error[k], 1.0)};
    is_inside = is_inside && length(reach[index(k)]) == 1;
  }
  if (is_inside) return steepest_(arc.patch_u, arc.patch_v);
  const Vec2 steep =
      derivative_bounds(sub_patch(surface_.patches(arc.patch_u, arc.patch_v), reach[0], reach[1]));
  return {steep[0] / length(reach[0]), steep[1] / length(reach[1])};
}

bool BorderArcs::is_too_long(const RegionArc& arc) const {
  if (arc.across >= 0 && takes_cells(arc.border)) return false;
  const Vec2& steep = steepest_(arc.patch_u, arc.patch_v);
  const auto leg = [&](std::size_t i, std::size_t j) {
    const Vec2 d = projected(arc.curve.points[j]) - projected(arc.curve.points[i]);
    return Vec2{d[0] * steep[0], d[1] * steep[1]};
  };
  const std::size_t last = arc.curve.points.size() - 1;
  const Vec2 chord = projected(arc.curve.points[last]) - projected(arc.curve.points[0]);
  if (cells_ > 1 && max_norm(chord) * cells_ > kLongest) return true;
  const Vec2 first = leg(0, 1);
  for (std::size_t i = 1; i < last; ++i) {
    const Vec2 next = leg(i, i + 1);
    if (dot(first, next) < kMinCosine * norm(first) * norm(next)) return true;
  }
  return false;
}

}  // namespace blossom
