// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/line_runs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/forms/evaluation.h"
#include "core/plane/planar_crossings.h"

namespace blossom {
namespace {

constexpr int kRunSamples = 9;      // of a piece, its ends among them
constexpr double kMaxSlope = 1e-3;  // of a run: how far it may leave its line, to its length

constexpr double kMinSlope = 1e-3;  // of a crossing, across the line, that is improved
constexpr int kNewtonSteps = 3;     // from a crossing within kOnLine to one within rounding

using Samples = std::array<Vec2, kRunSamples>;  // grid coordinates

double improved(const PlanarCurve& curve, int direction, double value, double parameter) {
  const Interval domain = curve.domain();
  for (int step = 0; step < kNewtonSteps; ++step) {
    const PlanarJet jet = jet_at(curve, parameter);
    if (std::abs(jet.first[direction]) <= kMinSlope * norm(jet.first)) break;
    parameter = std::clamp(parameter - (jet.point[direction] - value) / jet.first[direction],
                           domain.from, domain.to);
  }
  return parameter;
}

Vec3 in_space(const BezierSurface& surface, const Vec2& grid) {
  std::array<int, 2> patch;
  for (int k = 0; k < 2; ++k) {
    const int count = k == 0 ? surface.patches.rows() : surface.patches.columns();
    patch[static_cast<std::size_t>(k)] =
        std::clamp(static_cast<int>(std::floor(grid[k])), 0, count - 1);
  }
  return point_at(surface.patches(patch[0], patch[1]), grid[0] - patch[0], grid[1] - patch[1]);
}

bool keeps_to(const BezierSurface& surface, const Samples& samples, const LineRun& run,
              double within) {
  double farthest = 0, way = 0;
  Vec3 last;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Vec2 foot = samples[i];
    foot[run.direction] = run.line;
    const Vec3 on = in_space(surface, foot);
    farthest = std::max(farthest, distance(in_space(surface, samples[i]), on));
    if (farthest > within) return false;
    if (i > 0) way += distance(last, on);
    last = on;
  }
  return way > 0 && farthest <= kMaxSlope * way;
}

}  // namespace

std::size_t add_crossings(const PlanarCurve& curve, const PlanarCurve& unit, int direction,
                          double value, double unit_value, std::vector<double>& at) {
  const PlanarBox box = box_of(unit);
  if (unit_value < box.low[direction] - kOnLine || unit_value > box.high[direction] + kOnLine)
    return 0;
  const int other = 1 - direction;
  Vec2 from, to;
  from[direction] = to[direction] = unit_value;
  from[other] = box.low[other] - 1;
  to[other] = box.high[other] + 1;
  const PlanarCrossings found = crossings(unit, planar_line(from, to, {0, 1}), kOnLine);
  for (const PlanarCrossing& point : found.points)
    at.push_back(improved(curve, direction, value, point.a));
  for (const PlanarOverlap& run : found.overlaps) at.insert(at.end(), {run.a.from, run.a.to});
  return found.points.size();
}

LineRun line_run(const BezierSurface& surface, const PlanarCurve& curve, const Interval& place,
                 double within) {
  Samples samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / (kRunSamples - 1);
    samples[i] = unrounded_grid_point(surface, point_at(curve, at(place, t)));
  }
  for (int k = 0; k < 2; ++k) {
    const int lines = k == 0 ? surface.patches.rows() : surface.patches.columns();
    const LineRun run{k, std::round(samples[kRunSamples / 2][k])};
    if (run.line < 1 || run.line >= lines) continue;
    if (keeps_to(surface, samples, run, within)) return run;
  }
  return {};
}

}  // namespace blossom
