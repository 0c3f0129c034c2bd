// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace blossom {
namespace {

using Vec7 = Vec<double, 7>;
using Quintic = std::array<Vec7, 6>;

constexpr int kDegree = 5;
constexpr int kDeepest = 12;                 // halvings of a segment between two breaks
constexpr std::size_t kMostSegments = 5000;  // where the fit ends whatever its deviation
constexpr double kLongestTurn = 1.0;         // radians of the tangent in one segment
constexpr double kToleranceShare = 0.2;      // of the wanted tolerance, left to one fit
constexpr double kLengthShare = 1.5e-7;      // of a curve's length: small loops keep their shape
constexpr double kRounding = 1e-12;          // of the size: no fit is asked for more
constexpr double kLeastSine = 1e-3;          // below it, agreement is not tightened further
constexpr std::size_t kLeastSamples = 49;
constexpr double kKink = 1e-7;           // tangents farther apart than this: a kink
constexpr double kCurvatureJump = 1e-6;  // relative; curvatures farther apart: tangent continuous
constexpr std::array kChecks{0.11, 0.31, 0.5, 0.69, 0.89};

struct Jet7 {
  Vec7 value, first, second;
};

Vec7 seven(const Vec3& x, const Vec2& a, const Vec2& b) {
  return {x[0], x[1], x[2], a[0], a[1], b[0], b[1]};
}

Jet7 jet_of(const CurvePoint& p) {
  return {seven(p.point, p.a, p.b), seven(p.first, p.a_first, p.b_first),
          seven(p.second, p.a_second, p.b_second)};
}

Vec3 space(const Vec7& x) { return {x[0], x[1], x[2]}; }
Vec2 chart_a(const Vec7& x) { return {x[3], x[4]}; }
Vec2 chart_b(const Vec7& x) { return {x[5], x[6]}; }

Quintic hermite(const Jet7& p, const Jet7& q, double width) {
  Quintic c;
  c[0] = p.value;
  c[1] = c[0] + p.first * (width / 5);
  c[2] = 2 * c[1] - c[0] + p.second * (width * width / 20);
  c[5] = q.value;
  c[4] = c[5] - q.first * (width / 5);
  c[3] = 2 * c[4] - c[5] + q.second * (width * width / 20);
  return c;
}

// The blossom of a Bezier segment on [from, to] at five parameters.
Vec7 blossom_value(Quintic c, const Interval& place, const double* parameters) {
  for (std::size_t level = 0; level < kDegree; ++level) {
    const double t = (parameters[level] - place.from) / length(place);
    for (std::size_t i = 0; i + level < kDegree; ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
  }
  return c[0];
}

Vec7 value_at(const Quintic& c, double t) {
  const std::array<double, 5> same{t, t, t, t, t};
  return blossom_value(c, {0, 1}, same.data());
}

// Length in space by five-point Gauss quadrature of the hodograph.
double arc_length(const Quintic& c) {
  constexpr std::array<std::array<double, 2>, 5> kGauss{{{0.046910077030668, 0.118463442528095},
                                                         {0.230765344947158, 0.239314335249683},
                                                         {0.5, 0.284444444444444},
                                                         {0.769234655052842, 0.239314335249683},
                                                         {0.953089922969332, 0.118463442528095}}};
  double sum = 0;
  for (const auto& [t, weight] : kGauss) {
    std::array<Vec3, 5> d;
    for (std::size_t i = 0; i < 5; ++i) d[i] = 5 * (space(c[i + 1]) - space(c[i]));
    for (std::size_t level = 4; level > 0; --level)
      for (std::size_t i = 0; i < level; ++i) d[i] = (1 - t) * d[i] + t * d[i + 1];
    sum += weight * norm(d[0]);
  }
  return sum;
}

struct Segment {
  double from = 0, to = 0;  // stations of the tracer
  Jet7 start, stop;
  double width = 0;  // arc length
  Quintic curve{};
  double turn = 0;  // angle between the end tangents
  double sine = 1;  // least of the ends'
};

class Fitter {
 public:
  Fitter(const ChainTracer& tracer, const BezierSurface& a, const BezierSurface& b,
         const FitOptions& options)
      : tracer_(tracer),
        a_(a),
        b_(b),
        options_(options),
        wanted_(std::max(
            std::min(kToleranceShare * options.tolerance, kLengthShare * tracer.stations().back()),
            kRounding * options.size)) {}

  IntersectionCurve run() {
    make_segments();
    IntersectionCurve curve;
    write_splines(curve);
    sample(curve);
    measure(curve.deviation);
    return curve;
  }

 private:
  // Kinks, where surfaces have creases, and jumps of curvature end a segment.
  void make_segments() {
    const std::vector<double>& stations = tracer_.stations();
    std::vector<double> breaks{stations.front()};
    for (std::size_t i = 1; i + 1 < stations.size(); ++i)
      if (multiplicity(tracer_.at(stations[i], false), tracer_.at(stations[i], true)) > 3)
        breaks.push_back(stations[i]);
    breaks.push_back(stations.back());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) fit(breaks[i], breaks[i + 1], 0);
  }

  // Of a knot where one link meets the next: in space and in both charts.
  static int multiplicity(const CurvePoint& before, const CurvePoint& after) {
    if (distance(before.first, after.first) > kKink ||
        jumps(before.a_first, after.a_first, 0, kKink) ||
        jumps(before.b_first, after.b_first, 0, kKink))
      return kDegree;
    if (jumps(before.second, after.second, 1, kCurvatureJump) ||
        jumps(before.a_second, after.a_second, norm(after.a_first), kCurvatureJump) ||
        jumps(before.b_second, after.b_second, norm(after.b_first), kCurvatureJump))
      return kDegree - 1;
    return kDegree - 2;
  }

  // A difference beyond rounding, measured against the values and a part of `scale`.
  template <int Dim>
  static bool jumps(const Vec<double, Dim>& x, const Vec<double, Dim>& y, double scale,
                    double relative) {
    return distance(x, y) > relative * std::max(norm(x) + norm(y), 1e-3 * scale);
  }

  void fit(double from, double to, int depth) {
    const CurvePoint p = tracer_.at(from, true), q = tracer_.at(to, false);
    Segment segment{from, to, jet_of(p), jet_of(q), 0, {}, 0, std::min(p.sine, q.sine)};
    segment.turn = std::acos(std::clamp(dot(p.first, q.first), -1.0, 1.0));
    segment.width = distance(p.point, q.point);
    // The parameter is arc length, which the curve itself has to tell: three rounds settle it.
    for (int round = 0; round < 3; ++round) {
      segment.curve = hermite(segment.start, segment.stop, segment.width);
      segment.width = arc_length(segment.curve);
    }
    segment.curve = hermite(segment.start, segment.stop, segment.width);
    if (depth < kDeepest && segments_.size() < kMostSegments && !good(segment)) {
      const double middle = 0.5 * (from + to);
      fit(from, middle, depth + 1);
      fit(middle, to, depth + 1);
      return;
    }
    segments_.push_back(segment);
  }

  bool good(const Segment& segment) const {
    if (segment.turn > kLongestTurn) return false;
    const double between = wanted_ * std::clamp(segment.sine, kLeastSine, 1.0);
    for (const double t : kChecks) {
      const Vec7 x = value_at(segment.curve, t);
      const Vec3 on_a = point_at(a_, chart_a(x)), on_b = point_at(b_, chart_b(x));
      if (distance(on_a, on_b) > between || distance(space(x), on_a) > wanted_ ||
          distance(space(x), on_b) > wanted_)
        return false;
    }
    return passes_middle(segment);
  }

  // All three images may agree on another branch: the true middle point has to be near.
  bool passes_middle(const Segment& segment) const {
    const Vec3 middle = tracer_.at(0.5 * (segment.from + segment.to), true).point;
    double best = 1e300;
    double t = 0.5;
    for (int step = 0; step < 6; ++step) {
      const Vec3 x = space(value_at(segment.curve, t));
      best = std::min(best, distance(x, middle));
      const Vec3 ahead = space(value_at(segment.curve, std::min(t + 1e-4, 1.0)));
      const Vec3 rate = (ahead - x) * 1e4;
      const double square = dot(rate, rate);
      if (square == 0) break;
      t = std::clamp(t + dot(middle - x, rate) / square, 0.0, 0.9999);
    }
    return best <= 4 * wanted_ / std::clamp(segment.sine, 0.1, 1.0);
  }

  void write_splines(IntersectionCurve& curve) const {
    std::vector<double> knots{0};
    std::vector<int> multiplicities{kDegree + 1};
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      knots.push_back(knots.back() + segments_[i].width);
      const bool last = i + 1 == segments_.size();
      multiplicities.push_back(last ? kDegree + 1
                                    : multiplicity(tracer_.at(segments_[i].to, false),
                                                   tracer_.at(segments_[i].to, true)));
    }
    curve.length = knots.back();
    curve.curve = {kDegree, knots, multiplicities, {}};
    curve.chart_a = {kDegree, knots, multiplicities, {}};
    curve.chart_b = {kDegree, knots, multiplicities, {}};

    std::vector<double> flat;
    std::vector<std::size_t> segment_of;  // by the index of a knot of `flat`: where it starts one
    for (std::size_t i = 0; i < knots.size(); ++i)
      for (int m = 0; m < multiplicities[i]; ++m) {
        flat.push_back(knots[i]);
        segment_of.push_back(std::min(i, segments_.size() - 1));
      }
    // Control point i is the blossom at the knots i + 1 .. i + 5, of any segment they reach.
    for (std::size_t i = 0; i + kDegree + 1 < flat.size(); ++i) {
      std::size_t span = i + kDegree / 2;
      while (span > i && !(flat[span] < flat[span + 1])) --span;
      while (!(flat[span] < flat[span + 1])) ++span;
      const std::size_t s = segment_of[span];
      const Vec7 x =
          blossom_value(segments_[s].curve, {knots[s], knots[s + 1]}, flat.data() + i + 1);
      curve.curve.points.push_back(space(x));
      curve.chart_a.points.push_back(chart_a(x));
      curve.chart_b.points.push_back(chart_b(x));
    }
  }

  // The largest distances between the three images, over 13 parameters of each span.
  void measure(Deviation& worst) const {
    constexpr int kParts = 12;
    for (const Segment& segment : segments_)
      for (int k = 0; k <= kParts; ++k) {
        const Vec7 x = value_at(segment.curve, k / static_cast<double>(kParts));
        const Vec3 on_a = point_at(a_, chart_a(x)), on_b = point_at(b_, chart_b(x));
        worst.a = std::max(worst.a, distance(space(x), on_a));
        worst.b = std::max(worst.b, distance(space(x), on_b));
        worst.between = std::max(worst.between, distance(on_a, on_b));
      }
  }

  // Exact points, dense enough to draw and to compare the curve by its chords.
  void sample(IntersectionCurve& curve) const {
    Vec3 low = space(segments_.front().start.value), high = low;
    for (const Segment& segment : segments_)
      for (const double t : {0.25, 0.5, 0.75, 1.0}) {
        const Vec3 x = space(value_at(segment.curve, t));
        for (int k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], x[k]);
          high[k] = std::max(high[k], x[k]);
        }
      }
    const double sag = std::min(1e-4 * options_.size, 1e-3 * distance(low, high));
    curve.least_angle = 1;
    const auto add = [&](const CurvePoint& p, double parameter) {
      curve.samples.push_back({p.point, p.a, p.b});
      curve.sample_parameters.push_back(parameter);
      curve.least_angle = std::min(curve.least_angle, p.sine);
    };
    double reached = 0;
    for (const Segment& segment : segments_) {
      const double bend =
          std::max({norm(space(segment.start.second)), norm(space(segment.stop.second)),
                    segment.turn / segment.width});
      const double by_sag = segment.width * std::sqrt(bend / (6 * std::max(sag, 1e-300)));
      const double by_count = static_cast<double>(kLeastSamples) * segment.width / curve.length;
      const int count =
          static_cast<int>(std::ceil(std::clamp(std::max(by_sag, by_count), 1.0, 1e4)));
      for (int i = 0; i < count; ++i) {
        const double fraction = i / static_cast<double>(count);
        add(tracer_.at(segment.from + (segment.to - segment.from) * fraction, true),
            reached + segment.width * fraction);
      }
      reached += segment.width;
    }
    add(tracer_.at(segments_.back().to, false), reached);
    curve.least_angle = std::asin(std::min(curve.least_angle, 1.0));
  }

  const ChainTracer& tracer_;
  const BezierSurface& a_;
  const BezierSurface& b_;
  const FitOptions& options_;
  const double wanted_;  // agreement of a segment's images, model units
  std::vector<Segment> segments_;
};

}  // namespace

IntersectionCurve fitted(const ChainTracer& tracer, const BezierSurface& a, const BezierSurface& b,
                         const FitOptions& options) {
  return Fitter(tracer, a, b, options).run();
}

}  // namespace blossom
