// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/cleaning/narrow_spans.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/math/index.h"
#include "core/regions/arc_forms.h"

namespace blossom {
namespace {

constexpr double kMaxError = 1e-4;  // of the size: no surface loses more with narrow spans

BezierSurface transposed(const BezierSurface& surface) {
  BezierSurface result = surface;
  std::swap(result.u_knots, result.v_knots);
  std::swap(result.u_law, result.v_law);
  std::swap(result.closed_u, result.closed_v);
  result.patches = Grid<RationalBezierPatch>(surface.patches.columns(), surface.patches.rows());
  for (int i = 0; i < surface.patches.rows(); ++i)
    for (int j = 0; j < surface.patches.columns(); ++j) {
      const Grid<Vec4>& net = surface.patches(i, j).points;
      Grid<Vec4> turned(net.columns(), net.rows());
      for (int a = 0; a < net.rows(); ++a)
        for (int b = 0; b < net.columns(); ++b) turned(b, a) = net(a, b);
      result.patches(j, i).points = std::move(turned);
    }
  return result;
}

// Spans along u from `first` on that become a part of span `kept` beside them.
struct Run {
  int first = 0;
  int count = 0;
  int kept = 0;
};

bool is_narrow(const std::vector<double>& knots, int span) {
  const double range = knots.back() - knots.front();
  return knots[index(span) + 1] - knots[index(span)] <= kNarrowSpan * range;
}

// The first run of narrow spans; without spans if there is none, or nothing else.
Run narrow_run(const std::vector<double>& knots) {
  const int spans = static_cast<int>(knots.size()) - 1;
  Run run;
  while (run.first < spans && !is_narrow(knots, run.first)) ++run.first;
  while (run.first + run.count < spans && is_narrow(knots, run.first + run.count)) ++run.count;
  if (run.count == spans) run.count = 0;
  run.kept = run.first > 0 ? run.first - 1 : run.first + run.count;
  return run;
}

// The kept patch of a column gets the row of points at the far end of the run. Returns a bound on
// the way of points in all of the spans: the way of the row, what the narrow spans are long, and
// what the change of the kept span's parameter is worth.
double widen(BezierSurface& surface, const Run& run, int column) {
  RationalBezierPatch& kept = surface.patches(run.kept, column);
  const bool after = run.kept > run.first;
  const int far = after ? run.first : run.first + run.count - 1;
  const Grid<Vec4>& end = surface.patches(far, column).points;
  const int row = after ? 0 : kept.points.rows() - 1, from = after ? 0 : end.rows() - 1;
  double error = 0, moved = 0;
  for (int i = run.first; i < run.first + run.count; ++i)
    error += derivative_bounds(surface.patches(i, column))[0];
  const std::vector<double>& knots = surface.u_knots;
  const double width = knots[index(run.first + run.count)] - knots[index(run.first)];
  const double own = knots[index(run.kept) + 1] - knots[index(run.kept)];
  for (int b = 0; b < kept.points.columns(); ++b) {
    moved = std::max(moved, distance(projected(kept.points(row, b)), projected(end(from, b))));
    kept.points(row, b) = end(from, b);
  }
  return error + moved + 2 * derivative_bounds(kept)[0] * width / own;
}

BezierSurface without_run(const BezierSurface& given, const Run& run) {
  BezierSurface surface = given;
  double error = 0;
  for (int j = 0; j < surface.patches.columns(); ++j)
    error = std::max(error, widen(surface, run, j));
  BezierSurface result = surface;
  result.error += error;
  const auto gone = result.u_knots.begin() + run.first + (run.kept > run.first ? 1 : 0);
  result.u_knots.erase(gone, gone + run.count);
  result.patches =
      Grid<RationalBezierPatch>(surface.patches.rows() - run.count, surface.patches.columns());
  for (int i = 0; i < result.patches.rows(); ++i)
    for (int j = 0; j < result.patches.columns(); ++j)
      result.patches(i, j) = std::move(surface.patches(i < run.first ? i : i + run.count, j));
  return result;
}

double size_of(const BezierSurface& surface) {
  const Vec3 start = projected(surface.patches(0, 0).points(0, 0));
  double size = 0;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values())
      size = std::max(size, distance(projected(p), start));
  return size;
}

// Narrow spans that are long in space stay.
BezierSurface without_runs(BezierSurface surface) {
  const double most = surface.error + kMaxError * size_of(surface);
  for (Run run = narrow_run(surface.u_knots); run.count > 0; run = narrow_run(surface.u_knots)) {
    BezierSurface less = without_run(surface, run);
    if (!(less.error <= most)) break;
    surface = std::move(less);
  }
  return surface;
}

}  // namespace

BezierSurface without_narrow_spans(BezierSurface surface) {
  const bool along_u = narrow_run(surface.u_knots).count > 0;
  const bool along_v = narrow_run(surface.v_knots).count > 0;
  if (along_u && surface.u_law == ParameterLaw::Linear) surface = without_runs(std::move(surface));
  if (along_v && surface.v_law == ParameterLaw::Linear)
    surface = transposed(without_runs(transposed(surface)));
  return surface;
}

}  // namespace blossom
