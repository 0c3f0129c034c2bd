// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <span>
#include <string>

#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "core/forms/evaluation.h"
#include "core/math/four.h"
#include "core/math/spans.h"

namespace blossom {
namespace {

constexpr std::size_t kPatchGrain = 256;  // that one thread validates in a row
constexpr double kBeside = 1e-6;          // of a span

// tan(alpha / 2): the range of the stereographic parameter of an arc is [-k, k].
// Of the arc of a conic: tan or tanh of half its half.
double arc_range(ParameterLaw law, const Interval& span) {
  const double quarter = 0.25 * length(span);
  return law == ParameterLaw::Angle ? std::tan(quarter) : std::tanh(quarter);
}

// Hyperbolas are ellipses with an imaginary angle: squares of x change their sign.
double turn_sign(ParameterLaw law) { return law == ParameterLaw::Angle ? 1 : -1; }

struct PatchPlace {
  const RationalBezierPatch* patch;
  double s, t;  // its parameters
};

PatchPlace place_of(const BezierSurface& surface, const Vec2& uv) {
  const double u = std::clamp(uv[0], surface.u_knots.front(), surface.u_knots.back());
  const double v = std::clamp(uv[1], surface.v_knots.front(), surface.v_knots.back());
  const std::size_t i = span_of(surface.u_knots, u), j = span_of(surface.v_knots, v);
  return {&surface.patches(static_cast<int>(i), static_cast<int>(j)),
          local_parameter(surface.u_law, {surface.u_knots[i], surface.u_knots[i + 1]}, u),
          local_parameter(surface.v_law, {surface.v_knots[j], surface.v_knots[j + 1]}, v)};
}

[[noreturn]] void refuse(const char* name, const std::string& cause) {
  throw InvalidInput(std::string("surface ") + name + ": " + cause);
}

void validate_knots(const std::vector<double>& knots, int spans, const char* name,
                    const char* direction) {
  if (static_cast<int>(knots.size()) != spans + 1)
    refuse(name, std::to_string(spans) + " spans in " + direction + " take " +
                     std::to_string(spans + 1) + " knots, got " + std::to_string(knots.size()));
  for (std::size_t i = 0; i < knots.size(); ++i)
    if (!std::isfinite(knots[i]) || (i > 0 && knots[i] <= knots[i - 1]))
      refuse(name, std::string("the knots in ") + direction + " are not finite and increasing");
}

// Without branches: 0 times what is not finite is not 0.
BLOSSOM_HOT bool are_sound(std::span<const Vec4> points) {
  Four zeros{}, least{1, 1, 1, 1};
  for (const Vec4& p : points) {
    Four x;
    std::memcpy(&x, &p, sizeof x);
    zeros += 0 * x;
    least = x < least ? x : least;
  }
  return zeros[0] + zeros[1] + zeros[2] + zeros[3] == 0 && least[3] > 0;
}

bool has_sound_degrees(const RationalBezierPatch& patch) {
  return std::min(patch.degree_u(), patch.degree_v()) >= 1 &&
         std::max(patch.degree_u(), patch.degree_v()) <= kMaxDegree;
}

void validate_patch(const RationalBezierPatch& patch, const char* name) {
  if (!has_sound_degrees(patch))
    refuse(name, "degrees must be in 1.." + std::to_string(kMaxDegree) + ", got " +
                     std::to_string(patch.degree_u()) + " x " + std::to_string(patch.degree_v()));
  for (const Vec4& p : patch.points.values()) {
    for (int k = 0; k < 4; ++k)
      if (!std::isfinite(p[k])) refuse(name, "a control point is not finite");
    if (!(p[3] > 0)) refuse(name, "a weight is not positive: " + std::to_string(p[3]));
  }
}

}  // namespace

double parameter_at(ParameterLaw law, const Interval& span, double t) {
  if (law == ParameterLaw::Linear || t == 0 || t == 1) return at(span, t);
  const double x = arc_range(law, span) * (2 * t - 1);
  return at(span, 0.5) + 2 * (law == ParameterLaw::Angle ? std::atan(x) : std::atanh(x));
}

double parameter_derivative(ParameterLaw law, const Interval& span, double t) {
  if (law == ParameterLaw::Linear) return length(span);
  const double k = arc_range(law, span), x = k * (2 * t - 1);
  return 4 * k / (1 + turn_sign(law) * x * x);
}

double parameter_second_derivative(ParameterLaw law, const Interval& span, double t) {
  if (law == ParameterLaw::Linear) return 0;
  const double k = arc_range(law, span), x = k * (2 * t - 1), sign = turn_sign(law);
  return -16 * sign * k * k * x / ((1 + sign * x * x) * (1 + sign * x * x));
}

double local_parameter(ParameterLaw law, const Interval& span, double parameter) {
  if (law == ParameterLaw::Linear) return (parameter - span.from) / length(span);
  const double half = 0.5 * (parameter - at(span, 0.5));
  const double x = law == ParameterLaw::Angle ? std::tan(half) : std::tanh(half);
  return 0.5 * (1 + x / arc_range(law, span));
}

Vec3 point_at(const BezierSurface& surface, const Vec2& uv) {
  const PatchPlace place = place_of(surface, uv);
  return point_at(*place.patch, place.s, place.t);
}

std::array<Vec3, 4> one_sided_normals(const BezierSurface& surface, const Vec2& uv) {
  const auto beside = [](const std::vector<double>& knots, double x) {
    x = std::clamp(x, knots.front(), knots.back());
    const std::size_t span = span_of(knots, x);
    const double step = kBeside * (knots[span + 1] - knots[span]);
    // The span before may be a shorter one.
    const double back =
        span == 0 ? step : std::min(step, kBeside * (knots[span] - knots[span - 1]));
    return std::array{x - back, x + step};
  };
  std::array<Vec3, 4> normals;
  std::size_t count = 0;
  for (const double u : beside(surface.u_knots, uv[0]))
    for (const double v : beside(surface.v_knots, uv[1])) {
      const PatchPlace place = place_of(surface, {u, v});
      const PatchJet jet = jet_at(*place.patch, place.s, place.t, 1);
      normals[count++] = cross(jet.u, jet.v);
    }
  return normals;
}

bool is_valid(const RationalBezierPatch& patch) {
  return has_sound_degrees(patch) && are_sound(patch.points.values());
}

void validate_frame(const BezierSurface& surface, const char* name) {
  if (surface.patches.empty()) refuse(name, "it has no patches");
  validate_knots(surface.u_knots, surface.patches.rows(), name, "u");
  validate_knots(surface.v_knots, surface.patches.columns(), name, "v");
  if (!(surface.error >= 0)) refuse(name, "its error bound is not a number");
}

void validate(const BezierSurface& surface, const char* name) {
  validate_frame(surface, name);
  const auto patches = surface.patches.values();
  std::atomic<bool> sound = true;
  parallel_for(patches.size(), kPatchGrain, [&](std::size_t i) {
    if (!is_valid(patches[i])) sound.store(false, std::memory_order_relaxed);
  });
  if (!sound)  // the first one that is not tells what is wrong
    for (const RationalBezierPatch& patch : patches) validate_patch(patch, name);
}

}  // namespace blossom
