// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/planar_curves.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {
namespace {

void check(const Spline2& spline) {
  int sum = 0;
  for (const int multiplicity : spline.multiplicities) sum += multiplicity;
  const bool fits = spline.degree >= 1 && spline.degree <= kMaxDegree && spline.knots.size() >= 2 &&
                    spline.knots.size() == spline.multiplicities.size() &&
                    sum == static_cast<int>(spline.points.size()) + spline.degree + 1;
  if (!fits)
    throw InvalidInput("planar_curve: a spline of degree " + std::to_string(spline.degree) +
                       " with " + std::to_string(spline.points.size()) +
                       " points does not fit its " + std::to_string(sum) + " knots");
}

// The blossom of a spline's span at `arguments`; `knots` repeats each knot, `span` is the place
// of the span's lower knot in it.
Vec2 spline_blossom(const Spline2& spline, std::span<const double> knots, std::size_t span,
                    std::span<const double> arguments) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::size_t first = span - p;
  std::array<Vec2, kMaxDegree + 1> d;
  for (std::size_t i = 0; i <= p; ++i) d[i] = spline.points[first + i];
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t j = p; j >= r; --j) {
      const double low = knots[first + j];
      const double high = knots[span + 1 + j - r];
      const double s = (arguments[r - 1] - low) / (high - low);
      d[j] = (1 - s) * d[j - 1] + s * d[j];
    }
  return d[p];
}

const PlanarSpan& span_at(const PlanarCurve& curve, double parameter) {
  const auto after = std::upper_bound(
      curve.spans.begin() + 1, curve.spans.end(), parameter,
      [](double value, const PlanarSpan& span) { return value < span.place.from; });
  return *(after - 1);
}

// Homogeneous value and derivatives by the local parameter.
std::array<Vec3, 3> homogeneous_jet(const PlanarBezier& curve, double t) {
  const int n = curve.degree();
  if (n == 1)  // most wires of models
    return {(1 - t) * curve.points[0] + t * curve.points[1], curve.points[1] - curve.points[0], {}};
  std::array<Vec3, kMaxDegree + 1> b;
  std::copy(curve.points.begin(), curve.points.end(), b.begin());
  const auto step = [&](int level) {
    for (int i = 0; i <= n - level; ++i) {
      const auto k = static_cast<std::size_t>(i);
      b[k] = (1 - t) * b[k] + t * b[k + 1];
    }
  };
  std::array<Vec3, 3> jet{};
  for (int level = 1; level <= n - 2; ++level) step(level);
  if (n >= 2) {
    jet[2] = (n * (n - 1.0)) * (b[2] - 2.0 * b[1] + b[0]);
    step(n - 1);
  }
  if (n >= 1) {
    jet[1] = static_cast<double>(n) * (b[1] - b[0]);
    step(n);
  }
  jet[0] = b[0];
  return jet;
}

// Quotient rule: X = x / w, X' = (x' - X w') / w, X'' = (x'' - 2 X' w' - X w'') / w.
PlanarJet projected_jet(const std::array<Vec3, 3>& h) {
  PlanarJet jet;
  const double w = h[0][2];
  for (int k = 0; k < 2; ++k) {
    jet.point[k] = h[0][k] / w;
    jet.first[k] = (h[1][k] - jet.point[k] * h[1][2]) / w;
    jet.second[k] = (h[2][k] - 2 * jet.first[k] * h[1][2] - jet.point[k] * h[2][2]) / w;
  }
  return jet;
}

PlanarBezier reversed(PlanarBezier curve) {
  std::reverse(curve.points.begin(), curve.points.end());
  return curve;
}

// Samples per span from which a nearest point is improved; a span's curve turns less than that.
constexpr int kFootSamples = 12;
constexpr int kFootSteps = 12;

// Pieces of a range shorter than this fraction of it come of rounding at a span's end; they have
// no direction.
constexpr double kSliver = 1e-11;

// Newton's method on the derivative of the squared distance, kept inside the domain.
PlanarFoot improved_foot(const PlanarCurve& curve, const Vec2& target, PlanarFoot foot) {
  const Interval domain = curve.domain();
  for (int k = 0; k < kFootSteps; ++k) {
    const PlanarJet jet = jet_at(curve, foot.parameter);
    const Vec2 gap = jet.point - target;
    double slope = dot(jet.first, jet.first) + dot(gap, jet.second);
    if (slope <= 0) slope = dot(jet.first, jet.first);
    if (slope <= 0) break;
    const double next =
        std::clamp(foot.parameter - dot(gap, jet.first) / slope, domain.from, domain.to);
    const double reached = distance(point_at(curve, next), target);
    if (reached >= foot.distance) break;
    foot = {next, reached};
  }
  return foot;
}

}  // namespace

PlanarCurve planar_curve(const Spline2& spline) {
  check(spline);
  std::vector<double> knots;
  PlanarCurve result;
  const auto p = static_cast<std::size_t>(spline.degree);
  for (std::size_t i = 0; i < spline.knots.size(); ++i)
    knots.insert(knots.end(), static_cast<std::size_t>(spline.multiplicities[i]), spline.knots[i]);
  for (std::size_t k = p; k + p + 1 < knots.size(); ++k) {
    if (!(knots[k] < knots[k + 1])) continue;
    PlanarSpan span{{}, {knots[k], knots[k + 1]}, ParameterLaw::Linear};
    std::vector<double> arguments(p, knots[k]);
    for (std::size_t i = 0; i <= p; ++i) {
      if (i > 0) arguments[p - i] = knots[k + 1];
      const Vec2 point = spline_blossom(spline, knots, k, arguments);
      span.curve.points.push_back({point[0], point[1], 1});
    }
    result.spans.push_back(std::move(span));
  }
  return result;
}

PlanarCurve planar_line(const Vec2& from, const Vec2& to, const Interval& place) {
  PlanarCurve line;
  line.spans.push_back({{{{from[0], from[1], 1}, {to[0], to[1], 1}}}, place, ParameterLaw::Linear});
  return line;
}

PlanarCurve transformed(PlanarCurve curve, const Vec2& scale, const Vec2& shift) {
  for (PlanarSpan& span : curve.spans)
    for (Vec3& p : span.curve.points)
      p = {p[0] * scale[0] + p[2] * shift[0], p[1] * scale[1] + p[2] * shift[1], p[2]};
  return curve;
}

PlanarJet jet_at(const PlanarBezier& curve, double t) {
  return projected_jet(homogeneous_jet(curve, t));
}

PlanarJet jet_at(const PlanarCurve& curve, double parameter) {
  const Interval domain = curve.domain();
  const double at = std::clamp(parameter, domain.from, domain.to);
  const PlanarSpan& span = span_at(curve, at);
  const double t = std::clamp(local_parameter(span.law, span.place, at), 0.0, 1.0);
  PlanarJet jet = jet_at(span.curve, t);
  const double rate = parameter_derivative(span.law, span.place, t);
  jet.first *= 1 / rate;
  jet.second = (jet.second - parameter_second_derivative(span.law, span.place, t) * jet.first) *
               (1 / (rate * rate));
  return jet;
}

Vec2 point_at(const PlanarCurve& curve, double parameter) { return jet_at(curve, parameter).point; }

PlanarBezier bezier_piece(const PlanarBezier& curve, const Interval& local) {
  if (local.from > local.to) return reversed(bezier_piece(curve, {local.to, local.from}));
  const NetShape shape{curve.degree() + 1, 3, 1};
  PlanarBezier piece = curve;
  PlanarBezier rest = curve;
  PlanarBezier source = curve;
  const auto data = [](PlanarBezier& c) { return c.points.front().coordinates.data(); };
  if (local.to < 1) {
    halve_bezier_u(shape, data(source), local.to, data(piece), data(rest));
    source = piece;
  }
  if (local.from > 0 && local.to > 0) {
    halve_bezier_u(shape, data(source), std::min(local.from / std::min(local.to, 1.0), 1.0),
                   data(rest), data(piece));
  }
  return piece;
}

double chord_length(const PlanarCurve& curve, const Interval& piece) {
  const Vec2 middle = point_at(curve, at(piece, 0.5));
  return distance(point_at(curve, piece.from), middle) +
         distance(middle, point_at(curve, piece.to));
}

std::vector<PlanarBezier> bezier_pieces(const PlanarCurve& curve, const Interval& range) {
  const double low = std::min(range.from, range.to);
  const double high = std::max(range.from, range.to);
  std::vector<PlanarBezier> pieces;
  for (const PlanarSpan& span : curve.spans) {
    const double covered = std::min(span.place.to, high) - std::max(span.place.from, low);
    if (covered <= kSliver * (high - low)) continue;
    const double from = low <= span.place.from ? 0.0 : local_parameter(span.law, span.place, low);
    const double to = high >= span.place.to ? 1.0 : local_parameter(span.law, span.place, high);
    pieces.push_back(
        bezier_piece(span.curve, {std::clamp(from, 0.0, 1.0), std::clamp(to, 0.0, 1.0)}));
  }
  if (range.from > range.to) {
    std::reverse(pieces.begin(), pieces.end());
    for (PlanarBezier& piece : pieces) piece = reversed(std::move(piece));
  }
  return pieces;
}

PlanarBox box_of(std::span<const Vec3> points) {
  const Vec2 first = projected(points.front());
  PlanarBox box{first, first};
  for (const Vec3& point : points) {
    const Vec2 p = projected(point);
    for (int k = 0; k < 2; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  }
  return box;
}

PlanarBox united(const PlanarBox& a, const PlanarBox& b) {
  return {{std::min(a.low[0], b.low[0]), std::min(a.low[1], b.low[1])},
          {std::max(a.high[0], b.high[0]), std::max(a.high[1], b.high[1])}};
}

PlanarBox box_of(const PlanarCurve& curve) {
  PlanarBox box = box_of(curve.spans.front().curve.points);
  for (const PlanarSpan& span : curve.spans) box = united(box, box_of(span.curve.points));
  return box;
}

PlanarFoot nearest(const PlanarCurve& curve, const Vec2& target) {
  PlanarFoot best{curve.domain().from, kInfinity};
  for (const PlanarSpan& span : curve.spans) {
    const PlanarBox box = box_of(span.curve.points);
    Vec2 outside;
    for (int k = 0; k < 2; ++k)
      outside[k] = std::max({0.0, box.low[k] - target[k], target[k] - box.high[k]});
    if (norm(outside) >= best.distance) continue;
    PlanarFoot local{span.place.from, kInfinity};
    for (int i = 0; i <= kFootSamples; ++i) {
      const double parameter = at(span.place, static_cast<double>(i) / kFootSamples);
      const double reached = distance(point_at(curve, parameter), target);
      if (reached < local.distance) local = {parameter, reached};
    }
    local = improved_foot(curve, target, local);
    if (local.distance < best.distance) best = local;
  }
  return best;
}

}  // namespace blossom
