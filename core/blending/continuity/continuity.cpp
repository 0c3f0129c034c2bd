// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/continuity/continuity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "core/base/errors.h"
#include "core/blending/continuity/edge_frame.h"
#include "core/math/functions/golden_section.h"

namespace blossom {
namespace {

constexpr int kMinSamples = 97;      // of an edge
constexpr int kSamplesPerSpan = 13;  // odd, so that the middle is one of them

/// How far inside of a span its ends are looked at, as a part of it: second derivatives may jump at
/// breaks, and rounding moves them.
constexpr double kInside = 1e-6;

/// |N| and |T| below this part of their largest are those of a pole: directions lose as many
/// digits.
constexpr double kSingular = 1e-7;

constexpr double kRefined = 1e-8;  // of the distance of two samples: where a figure is largest
constexpr int kNewtonSteps = 8;
constexpr double kOfRounding = 0x1p-50;  // of a coordinate: no nearer point can be told

enum Figure { kGap, kAngle, kDifference, kCurvature, kFigures };
using Figures = std::array<double, kFigures>;

EdgeJet<double> edge_jet(const EdgeSide& side) {
  return {side.jet.point, side.jet.u,  side.jet.v, side.jet.uu,
          side.jet.uv,    side.jet.vv, side.along};
}

Vec3 tangent(const EdgeSide& side) {
  return side.along[0] * side.jet.u + side.along[1] * side.jet.v;
}

Vec3 normal(const EdgeSide& side) { return cross(side.jet.u, side.jet.v); }

/// Twice the arc sine of half the chord, for all angles.
double angle_of_units(const Vec3& a, const Vec3& b) {
  return 2 * std::atan2(norm(a - b), norm(a + b));
}

struct MeasuredBorder {
  const EdgeSides& side_at;
  Interval range;
  double most_normal = 0;
  double most_tangent = 0;

  void look(const EdgeSide& side) {
    most_normal = std::max(most_normal, norm(normal(side)));
    most_tangent = std::max(most_tangent, norm(tangent(side)));
  }
  bool is_singular(const EdgeSide& side) const {
    return !(norm(normal(side)) > kSingular * most_normal) ||
           !(norm(tangent(side)) > kSingular * most_tangent);
  }
};

/// The place of a border next to a point, from t on.
struct Foot {
  EdgeSide side;
  double distance = 0;
};

Foot foot_of(const Vec3& point, const MeasuredBorder& border, double t, const EdgeSide& start) {
  Foot best{start, distance(point, start.jet.point)};
  const double rounding = kOfRounding * max_norm(point);
  for (int step = 0; step < kNewtonSteps && best.distance > rounding; ++step) {
    const Vec3 along = tangent(best.side);
    const double speed = dot(along, along);
    if (!(speed > 0)) break;
    const double move = dot(point - best.side.jet.point, along) / speed;
    const double next = std::clamp(t + move, border.range.from, border.range.to);
    if (next == t) break;
    Foot nearer{border.side_at(next)};
    nearer.distance = distance(point, nearer.side.jet.point);
    if (!(nearer.distance < best.distance)) break;
    best = nearer;
    t = next;
  }
  return best;
}

/// The figures at one parameter; NaN but for the gap where a side is singular.
Figures figures_at(const MeasuredBorder& a, const MeasuredBorder& b, double t, double flat) {
  const EdgeSide side_a = a.side_at(t), side_b = b.side_at(t);
  const Foot on_b = foot_of(side_a.jet.point, b, t, side_b);
  const Foot on_a = foot_of(side_b.jet.point, a, t, side_a);
  Figures figures;
  figures.fill(std::nan(""));
  figures[kGap] = std::max(on_a.distance, on_b.distance);
  if (a.is_singular(side_a) || b.is_singular(on_b.side)) return figures;
  const auto of_a = edge_frame(edge_jet(side_a), side_a.left ? -1 : 1);
  const auto of_b = edge_frame(edge_jet(on_b.side), on_b.side.left ? 1 : -1);
  const auto norm_of = [](const std::array<double, 3>& s) {
    return spectral_norm(s[0], s[1], s[2]);
  };
  std::array<double, 3> difference;
  for (std::size_t i = 0; i < 3; ++i) difference[i] = of_a.shape[i] - of_b.shape[i];
  figures[kAngle] = angle_of_units(of_a.normal, of_b.normal);
  figures[kDifference] = norm_of(difference);
  figures[kCurvature] =
      figures[kDifference] / std::max({norm_of(of_a.shape), norm_of(of_b.shape), flat});
  return figures;
}

struct Sample {
  double t;
  std::size_t span;
  Figures figures;
};

/// Evenly over every span, ends included.
std::vector<Sample> places_in(std::span<const double> breaks) {
  const int spans = static_cast<int>(breaks.size()) - 1;
  const int each = std::max(kSamplesPerSpan, (kMinSamples + spans - 1) / spans);
  std::vector<Sample> samples;
  for (std::size_t span = 0; span + 1 < breaks.size(); ++span)
    for (int k = 0; k < each; ++k) {
      const double x = std::clamp(k / (each - 1.0), kInside, 1 - kInside);
      samples.push_back({at({breaks[span], breaks[span + 1]}, x), span, {}});
    }
  return samples;
}

/// Raises the largest values by those at t.
class Largest {
 public:
  Largest(const MeasuredBorder& a, const MeasuredBorder& b, double flat)
      : a_(a), b_(b), flat_(flat) {}

  Figures look(double t) {
    const Figures figures = figures_at(a_, b_, t, flat_);
    for (std::size_t i = 0; i < kFigures; ++i)
      if (figures[i] > value_[i] || !seen_[i]) {
        if (std::isnan(figures[i])) continue;
        seen_[i] = true;
        value_[i] = figures[i];
        parameter_[i] = t;
      }
    return figures;
  }

  LargestFound of(Figure figure) const {
    if (!seen_[figure]) return {};
    return {value_[figure], parameter_[figure], a_.side_at(parameter_[figure]).jet.point};
  }

 private:
  const MeasuredBorder& a_;
  const MeasuredBorder& b_;
  double flat_;
  Figures value_{}, parameter_{};
  std::array<bool, kFigures> seen_{};
};

/// Golden sections for the largest value of a figure in a range.
void refine(Largest& largest, std::size_t figure, Interval range) {
  extremum([&](double t) { return largest.look(t)[figure]; }, range, -1, kRefined);
}

/// Between the neighbours of the largest sample, in its span.
void refine_at_largest(Largest& largest, const std::vector<Sample>& samples, std::size_t figure) {
  std::size_t best = samples.size();
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (const double value = samples[i].figures[figure];
        !std::isnan(value) && (best == samples.size() || value > samples[best].figures[figure]))
      best = i;
  if (best == samples.size() || !(samples[best].figures[figure] > 0)) return;
  const auto neighbour = [&](std::size_t i) {
    return i < samples.size() && samples[i].span == samples[best].span ? samples[i].t
                                                                       : samples[best].t;
  };
  const Interval around{neighbour(best - 1), neighbour(best + 1)};
  if (around.to > around.from) refine(largest, figure, around);
}

void check(std::span<const double> breaks, double flat) {
  if (breaks.size() < 2) throw InvalidInput("measured_continuity: at least two breaks are wanted");
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    if (!(breaks[i] < breaks[i + 1]) || !std::isfinite(breaks[i + 1] - breaks[i]))
      throw InvalidInput("measured_continuity: breaks have to increase, break " +
                         std::to_string(i + 1) + " does not");
  if (!(flat > 0)) throw InvalidInput("measured_continuity: flat has to be positive");
}

}  // namespace

MeasuredContinuity measured_continuity(const EdgeSides& a, const EdgeSides& b,
                                       std::span<const double> breaks, double flat) {
  check(breaks, flat);
  const Interval range{breaks.front(), breaks.back()};
  MeasuredBorder border_a{a, range}, border_b{b, range};
  std::vector<Sample> samples = places_in(breaks);
  for (const Sample& sample : samples) {
    border_a.look(a(sample.t));
    border_b.look(b(sample.t));
  }
  Largest largest(border_a, border_b, flat);
  MeasuredContinuity found;
  for (Sample& sample : samples) {
    sample.figures = largest.look(sample.t);
    found.singular += std::isnan(sample.figures[kAngle]) ? 1 : 0;
  }
  found.samples = static_cast<int>(samples.size());
  for (std::size_t figure = 0; figure < kFigures; ++figure)
    refine_at_largest(largest, samples, figure);
  found.gap = largest.of(kGap);
  found.angle = largest.of(kAngle);
  found.difference = largest.of(kDifference);
  found.curvature = largest.of(kCurvature);
  return found;
}

const char* to_string(Smoothness smoothness) {
  switch (smoothness) {
    case Smoothness::None: return "none";
    case Smoothness::G0: return "G0";
    case Smoothness::G1: return "G1";
    case Smoothness::G2: break;
  }
  return "G2";
}

Smoothness smoothness(const MeasuredContinuity& found, const ContinuityTolerances& tolerances) {
  if (!(found.gap.value <= tolerances.gap)) return Smoothness::None;
  if (found.singular == found.samples || !(found.angle.value <= tolerances.angle))
    return Smoothness::G0;
  return found.curvature.value <= tolerances.curvature ? Smoothness::G2 : Smoothness::G1;
}

bool is_proven(Smoothness smoothness, const ContinuityBounds& bounds,
               const ContinuityTolerances& tolerances) {
  if (smoothness >= Smoothness::G0 && !(bounds.gap <= tolerances.gap)) return false;
  if (smoothness >= Smoothness::G1 && !(bounds.angle <= tolerances.angle)) return false;
  return smoothness < Smoothness::G2 || bounds.curvature <= tolerances.curvature;
}

}  // namespace blossom
