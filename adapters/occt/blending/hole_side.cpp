// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/hole_side.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/side_sampler.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/forms/algebra/interpolation.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom::occt {
namespace {

/// Places of a pcurve looked at to see whether it is an iso-parameter line.
constexpr int kSamples = 9;

/// Parameters that differ by no more than this part of their range are one: pcurves in files have
/// 12 decimals or more.
constexpr double kSameParameter = 1e-11;

/// Places between the nodes of a fit at which it is measured, for each node.
constexpr int kChecks = 4;

std::string name_of(const HoleEdge& edge) { return "edge " + std::to_string(edge.number); }

/// An iso-parameter line: `constant` in one direction, `along` in the other.
struct IsoLine {
  bool along_v = false;
  double constant = 0;
  Interval along{};
  bool away_is_up = false;  ///< growing parameters lead away from the hole
};

std::optional<IsoLine> iso_line(const EdgeInChart& edge, const BezierSurface& surface) {
  const Vec2 start = edge.at(0), end = edge.at(1);
  for (const bool along_v : {true, false}) {
    const int fixed = along_v ? 0 : 1;
    const auto& knots = along_v ? surface.u_knots : surface.v_knots;
    const double same = kSameParameter * (knots.back() - knots.front());
    bool is_line = true;
    for (int i = 0; i < kSamples; ++i)
      is_line = is_line && std::abs(edge.at(i / (kSamples - 1.0))[fixed] - start[fixed]) <= same;
    if (!is_line) continue;
    const bool rising = end[1 - fixed] > start[1 - fixed];
    // Left of a line along +v lies -u, left of one along +u lies +v.
    const bool left_is_up = along_v ? !rising : rising;
    return IsoLine{along_v,
                   start[fixed],
                   {start[1 - fixed], end[1 - fixed]},
                   edge.away_is_left() == left_is_up};
  }
  return std::nullopt;
}

/// A span of one direction, and local parameters in it.
struct Local {
  int span = 0;
  Interval part{};
};

double snapped(double t) {
  constexpr double kAtSpanEnd = 1e-9;  // part of a span: rounding of what files write
  if (std::abs(t) <= kAtSpanEnd) return 0;
  return std::abs(t - 1) <= kAtSpanEnd ? 1 : t;
}

/// The span that holds both ends; at a knot the one towards `hint`, +1 or -1.
std::optional<Local> local_part(const std::vector<double>& knots, ParameterLaw law,
                                const Interval& part, double hint) {
  const double same = kSameParameter * (knots.back() - knots.front());
  const double low = std::min(part.from, part.to), high = std::max(part.from, part.to);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const bool first = i == 0, last = i + 2 == knots.size();
    const bool after = hint > 0 ? low >= knots[i] - same && (last || low < knots[i + 1] - same)
                                : (first || high > knots[i] + same) && high <= knots[i + 1] + same;
    const bool inside = low >= knots[i] - same && high <= knots[i + 1] + same;
    if (!after || !inside) continue;
    const Interval span{knots[i], knots[i + 1]};
    return Local{static_cast<int>(i),
                 {snapped(local_parameter(law, span, std::clamp(part.from, span.from, span.to))),
                  snapped(local_parameter(law, span, std::clamp(part.to, span.from, span.to)))}};
  }
  return std::nullopt;
}

std::optional<FillSide> exact_side(const IsoLine& line, const BezierSurface& surface,
                                   FillContinuity continuity) {
  const double away = line.away_is_up ? 1 : -1;
  const auto fixed = local_part(line.along_v ? surface.u_knots : surface.v_knots,
                                line.along_v ? surface.u_law : surface.v_law,
                                {line.constant, line.constant}, away);
  const auto along = local_part(line.along_v ? surface.v_knots : surface.u_knots,
                                line.along_v ? surface.v_law : surface.u_law, line.along,
                                line.along.to > line.along.from ? 1 : -1);
  if (!fixed || !along) return std::nullopt;
  const Interval across{fixed->part.from, fixed->part.from + away};
  if (line.along_v)
    return fill_side(sub_patch(surface.patches(fixed->span, along->span), across, along->part),
                     SurfaceSide::UMin, false, continuity);
  return fill_side(sub_patch(surface.patches(along->span, fixed->span), along->part, across),
                   SurfaceSide::VMin, false, continuity);
}

Row homogeneous(const BezierCurve& curve, double weight) {
  Row row;
  for (const Vec3& p : curve.points) row.push_back({p[0], p[1], p[2], weight});
  return row;
}

HoleSide fitted(const SideSampler& sampler, int degree, bool with_face) {
  std::vector<Vec3> points, across, bend;
  for (const double x : extreme_points(degree)) {
    const SideSample sample = sampler.at(x, 2);
    points.push_back(sample.derivatives[0]);
    across.push_back(sample.derivatives[1]);
    bend.push_back(sample.derivatives[2]);
  }
  HoleSide result;
  result.side.edge = homogeneous(bezier_through(points), 1);
  if (with_face) {
    result.side.across = homogeneous(bezier_through(across), 0);
    result.side.bend = homogeneous(bezier_through(bend), 0);
  }
  const int checks = kChecks * (degree + 1);
  for (int i = 0; i < checks; ++i) {
    const double x = (i + 0.5) / checks;
    const SideSample sample = sampler.at(x, 1);
    const SpaceJet jet = jet_at(result.side.edge, x);
    result.error = std::max(result.error, distance(jet.point, sample.derivatives[0]));
    if (!with_face) continue;
    const Vec3 normal = cross(jet.derivative, across_at(result.side.edge, result.side.across, x));
    const double sine = norm(cross(unit(normal), sample.normal));
    result.angle_error = std::max(result.angle_error, std::asin(std::min(1.0, sine)));
  }
  return result;
}

/// Makes the fit finer until it is ten times as near as it has to be, or at least near enough.
HoleSide fitted_side(const HoleEdge& edge, const FitTolerance& tolerance) {
  const bool with_face = !edge.face.IsNull();
  const SideSampler sampler(edge);
  HoleSide best;
  for (int degree = 1; degree <= kMaxFitDegree; ++degree) {
    HoleSide next = fitted(sampler, degree, with_face);
    if (degree == 1 || next.error < best.error || next.angle_error < best.angle_error)
      best = std::move(next);
    if (best.error <= tolerance.point / 10 && best.angle_error <= tolerance.angle / 10) return best;
  }
  if (best.error <= tolerance.point && best.angle_error <= tolerance.angle) return best;
  char figures[96];
  std::snprintf(figures, sizeof figures, "off by %.3g, its normals by %.3g rad", best.error,
                best.angle_error);
  throw BadModel(name_of(edge) + " cannot be followed by polynomials of degree " +
                 std::to_string(kMaxFitDegree) + ": " + figures);
}

}  // namespace

HoleSide hole_side(const HoleEdge& edge, FillContinuity continuity, const FitTolerance& tolerance) {
  if (edge.face.IsNull() && continuity != FillContinuity::G0)
    throw BadModel(name_of(edge) + " has no face to continue with " + to_string(continuity));
  return guarded("looking at " + name_of(edge), [&] {
    if (!edge.face.IsNull()) {
      const BezierSurface surface = bezier_surface(edge.face);
      const std::optional<IsoLine> line = iso_line(EdgeInChart(edge), surface);
      if (line && surface.error == 0)
        if (std::optional<FillSide> side = exact_side(*line, surface, continuity))
          return HoleSide{std::move(*side), true, 0, 0};
    }
    return fitted_hole_side(edge, continuity, tolerance);
  });
}

HoleSide fitted_hole_side(const HoleEdge& edge, FillContinuity continuity,
                          const FitTolerance& tolerance) {
  HoleSide result = fitted_side(edge, tolerance);
  result.side.continuity = continuity;
  return result;
}

}  // namespace blossom::occt
