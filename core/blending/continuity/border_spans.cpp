// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of control points beside an edge, for the bounds of continuity.h.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/errors.h"
#include "core/blending/border_rows.h"
#include "core/blending/continuity/continuity.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

bool runs_along_v(SurfaceSide side) {
  return side == SurfaceSide::UMin || side == SurfaceSide::UMax;
}

bool is_at_end(SurfaceSide side) { return side == SurfaceSide::UMax || side == SurfaceSide::VMax; }

/// The points of a patch by their depth behind a side, then along it.
Grid<Vec4> turned_net(const RationalBezierPatch& patch, SurfaceSide side) {
  const int along = runs_along_v(side) ? patch.degree_v() : patch.degree_u();
  const int depth = runs_along_v(side) ? patch.degree_u() : patch.degree_v();
  Grid<Vec4> net(depth + 1, along + 1);
  for (int d = 0; d <= depth; ++d)
    for (int k = 0; k <= along; ++k) {
      const int i = is_at_end(side) ? depth - d : d;
      net(d, k) = runs_along_v(side) ? patch.points(i, k) : patch.points(k, i);
    }
  return net;
}

template <class Points>
Vec4 rounding_of(const Points& points, bool rational) {
  Vec4 largest;
  for (const Vec4& p : points)
    for (int c = 0; c < 4; ++c) largest[c] = std::max(largest[c], std::abs(p[c]));
  const double most = std::max({largest[0], largest[1], largest[2]});
  const double unit = kRoundings * kUnitRoundoff;
  return {unit * most, unit * most, unit * most, rational ? unit * largest[3] : 0};
}

/// Y = m (P_1 - P_0), Z = m (m - 1) (P_2 - 2 P_1 + P_0). A difference of r points is off by 2^r
/// times what they are, and its own roundings by no more than once that.
BorderSpan span_of(const Grid<Vec4>& net, bool rational) {
  BorderSpan span;
  const int m = net.rows() - 1;
  for (int k = 0; k < net.columns(); ++k) {
    const Vec4 step = net(1, k) - net(0, k);
    span.edge.push_back(net(0, k));
    span.across.push_back(step * static_cast<double>(m));
    span.bend.push_back(m < 2 ? Vec4{}
                              : (net(2, k) - net(1, k) - step) * static_cast<double>(m * (m - 1)));
  }
  span.error = rounding_of(net.values(), rational);
  span.across_error = span.error * (4.0 * m);
  span.bend_error = span.error * (8.0 * m * (m - 1));
  return span;
}

/// The parameter running the other way: the rows from their ends. Derivatives across stay.
void turn(BorderSpans& spans) {
  std::reverse(spans.begin(), spans.end());
  for (BorderSpan& span : spans) {
    span.place = {1 - span.place.to, 1 - span.place.from};
    for (std::vector<Vec4>* row : {&span.edge, &span.across, &span.bend})
      std::reverse(row->begin(), row->end());
  }
}

Interval place_in(const Interval& domain, double from, double to) {
  return {(from - domain.from) / length(domain), (to - domain.from) / length(domain)};
}

std::vector<double> weights_of(const Row& row) {
  std::vector<double> weights;
  for (const Vec4& p : row) weights.push_back(p[3]);
  return weights;
}

Row derivative_row(const Row& row) {
  Row result;
  for (std::size_t i = 0; i + 1 < row.size(); ++i)
    result.push_back((row[i + 1] - row[i]) * static_cast<double>(row.size() - 1));
  return result;
}

bool has_equal_weights(const Row& row) {
  return std::all_of(row.begin(), row.end(), [&](const Vec4& p) { return p[3] == row[0][3]; });
}

/// n x (w X' - w' X), n x X' of a polynomial: square to the curve in the plane, to its left. It
/// need not be known well, but it has to lie in the plane.
Row left_of(const Row& edge, const Vec3& normal) {
  const Row slope = derivative_row(edge);
  if (has_equal_weights(edge)) {
    Row left;
    for (const Vec4& along : slope) {
      const Vec3 across = cross(normal, Vec3{along[0], along[1], along[2]});
      left.push_back({across[0], across[1], across[2], 0});
    }
    return left;
  }
  const Row first = product(weights_of(edge), slope), second = product(weights_of(slope), edge);
  Row left;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Vec4 along = first[i] - second[i];
    const Vec3 across = cross(normal, Vec3{along[0], along[1], along[2]});
    left.push_back({across[0], across[1], across[2], 0});
  }
  return left;
}

CurveDerivatives<Vec4> derivatives_of(const std::vector<Vec4>& row, double t) {
  return derivatives_at(RationalBezierCurve{row}, t);
}

/// By the quotient rule, u along the edge and v into the face.
PatchJet jet_of(const BorderSpan& span, double t) {
  const auto x = derivatives_of(span.edge, t), y = derivatives_of(span.across, t);
  const Vec4 z = derivatives_of(span.bend, t).point;
  const double r = 1 / x.point[3];
  PatchJet jet{};
  jet.point = r * head(x.point);
  jet.u = r * (head(x.first) - x.first[3] * jet.point);
  jet.v = r * (head(y.point) - y.point[3] * jet.point);
  jet.uu = r * (head(x.second) - 2 * x.first[3] * jet.u - x.second[3] * jet.point);
  jet.uv = r * (head(y.first) - x.first[3] * jet.v - y.point[3] * jet.u - y.first[3] * jet.point);
  jet.vv = r * (head(z) - 2 * y.point[3] * jet.v - z[3] * jet.point);
  return jet;
}

EdgeSide side_at(const BorderSpan& span, double x) {
  const double part = std::clamp((x - span.place.from) / length(span.place), 0.0, 1.0);
  EdgeSide side;
  double speed = 1;
  double t = part;
  if (span.angle != 0) {
    t = local_parameter(ParameterLaw::Angle, {0, span.angle}, part * span.angle);
    speed = span.angle / parameter_derivative(ParameterLaw::Angle, {0, span.angle}, t);
  }
  side.jet = jet_of(span, t);
  side.along = {speed / length(span.place), 0};
  return side;
}

}  // namespace

EdgeSides edge_sides(BorderSpans spans) {
  if (spans.empty()) throw InvalidInput("edge_sides: there is no span");
  return [spans = std::move(spans)](double x) {
    const auto after = std::upper_bound(
        spans.begin() + 1, spans.end(), x,
        [](double value, const BorderSpan& span) { return value < span.place.from; });
    return side_at(*(after - 1), x);
  };
}

BorderSpans border_spans(const BezierSurface& surface, SurfaceSide side, bool backward) {
  validate(surface, "the surface");
  const Grid<RationalBezierPatch>& all = surface.patches;
  const bool along_v = runs_along_v(side);
  const std::vector<double>& knots = along_v ? surface.v_knots : surface.u_knots;
  const int last = (along_v ? all.rows() : all.columns()) - 1;
  const int behind = is_at_end(side) ? last : 0;
  BorderSpans spans;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const int k = static_cast<int>(i);
    const RationalBezierPatch& patch = along_v ? all(behind, k) : all(k, behind);
    BorderSpan& span = spans.emplace_back(span_of(turned_net(patch, side), surface.rational));
    span.place = place_in({knots.front(), knots.back()}, knots[i], knots[i + 1]);
    if ((along_v ? surface.v_law : surface.u_law) == ParameterLaw::Angle)
      span.angle = knots[i + 1] - knots[i];
  }
  if (backward) turn(spans);
  return spans;
}

BorderSpans plane_border(const CurveSpans& curve, const Vec3& normal, bool backward) {
  validate(curve, "the curve");
  BorderSpans spans;
  for (const CurveSpan& of : curve.spans) {
    BorderSpan& span = spans.emplace_back();
    span.place = place_in(curve.domain(), of.place.from, of.place.to);
    if (of.law == ParameterLaw::Angle) span.angle = length(of.place);
    span.edge = of.curve.points;
    span.across = left_of(span.edge, normal);
    span.bend = {Vec4{}};
    span.error = rounding_of(span.edge, curve.rational);
    span.across_error = rounding_of(span.across, false);
  }
  if (backward) turn(spans);
  return spans;
}

}  // namespace blossom
