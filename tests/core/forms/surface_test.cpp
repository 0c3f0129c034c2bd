// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/forms/evaluation.h"
#include "core/forms/spline.h"

namespace blossom {
namespace {

// An arc of the unit circle between two angles in rational quadratic form.
Vec2 arc_point(const Interval& span, double t) {
  const double middle = at(span, 0.5), w = std::cos(0.5 * length(span));
  const double b0 = (1 - t) * (1 - t), b1 = 2 * t * (1 - t) * w, b2 = t * t;
  const double weight = b0 + b1 + b2;
  return {(b0 * std::cos(span.from) + b1 * std::cos(middle) / w + b2 * std::cos(span.to)) / weight,
          (b0 * std::sin(span.from) + b1 * std::sin(middle) / w + b2 * std::sin(span.to)) / weight};
}

TEST(ParameterLaw, AngleIsTheAngleOfTheRationalArc) {
  const Interval span{0.3, 1.7};
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0, angle = parameter_at(ParameterLaw::Angle, span, t);
    const Vec2 p = arc_point(span, t);
    EXPECT_NEAR(std::atan2(p[1], p[0]), angle, 1e-15);
    EXPECT_NEAR(local_parameter(ParameterLaw::Angle, span, angle), t, 1e-15);
  }
}

TEST(ParameterLaw, DerivativesAreThoseOfTheLaw) {
  constexpr double kStep = 1e-5;
  for (const ParameterLaw law :
       {ParameterLaw::Linear, ParameterLaw::Angle, ParameterLaw::Hyperbolic})
    for (const double t : {0.1, 0.5, 0.8}) {
      const Interval span{-0.4, 0.9};
      const double low = parameter_at(law, span, t - kStep), middle = parameter_at(law, span, t),
                   high = parameter_at(law, span, t + kStep);
      EXPECT_NEAR(parameter_derivative(law, span, t), (high - low) / (2 * kStep), 1e-9);
      EXPECT_NEAR(parameter_second_derivative(law, span, t),
                  (high - 2 * middle + low) / (kStep * kStep), 1e-4);
      EXPECT_NEAR(local_parameter(law, span, middle), t, 1e-15);
    }
}

TEST(PatchJet, MatchesDifferencesOfARationalPatch) {
  RationalBezierPatch patch{Grid<Vec4>(3, 4)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      const double w = 1 + 0.3 * std::sin(3.0 * i + j);
      patch.points(i, j) = {w * i, w * j, w * std::cos(1.0 * i * j), w};
    }
  constexpr double kStep = 1e-5;
  const double u = 0.37, v = 0.61;
  const auto value = [&](double s, double t) { return jet_at(patch, s, t, 1).point; };
  const PatchJet jet = jet_at(patch, u, v, 2);
  const auto close = [](const Vec3& a, const Vec3& b, double bound) {
    EXPECT_LE(distance(a, b), bound);
  };
  close(jet.u, (value(u + kStep, v) - value(u - kStep, v)) * (0.5 / kStep), 1e-9);
  close(jet.v, (value(u, v + kStep) - value(u, v - kStep)) * (0.5 / kStep), 1e-9);
  const auto du = [&](double s, double t) { return jet_at(patch, s, t, 1).u; };
  const auto dv = [&](double s, double t) { return jet_at(patch, s, t, 1).v; };
  close(jet.uu, (du(u + kStep, v) - du(u - kStep, v)) * (0.5 / kStep), 1e-8);
  close(jet.uv, (du(u, v + kStep) - du(u, v - kStep)) * (0.5 / kStep), 1e-8);
  close(jet.vv, (dv(u, v + kStep) - dv(u, v - kStep)) * (0.5 / kStep), 1e-8);
}

// A cubic spline with a double and a single inner knot.
Spline some_spline() {
  Spline spline{3, {0, 1, 2.5, 3}, {4, 2, 1, 4}, {}};
  for (int i = 0; i < 7; ++i)
    spline.points.push_back({double(i), std::sin(2.0 * i), std::cos(1.3 * i)});
  return spline;
}

TEST(Spline, BeginsAndEndsInItsEndPoints) {
  const Spline spline = some_spline();
  EXPECT_EQ(point_at(spline, 0), spline.points.front());
  EXPECT_LE(distance(point_at(spline, 3), spline.points.back()), 1e-15);
}

TEST(Spline, DerivativeIsTheLimitOfDifferences) {
  const Spline spline = some_spline();
  for (const double t : {0.2, 0.9, 1.4, 2.2, 2.8}) {
    const Vec3 difference = (point_at(spline, t + 1e-6) - point_at(spline, t - 1e-6)) * 5e5;
    EXPECT_LE(distance(derivative_at(spline, t), difference), 1e-7);
  }
}

TEST(Spline, APartIsTheSameCurve) {
  const Spline spline = some_spline();
  for (const Interval part : {Interval{0, 3}, {0.3, 2.7}, {1, 2.5}, {1.2, 1.3}}) {
    const Spline cut = restricted(spline, part);
    EXPECT_EQ(cut.domain(), part);
    for (int i = 0; i <= 40; ++i) {
      const double t = at(part, i / 40.0);
      EXPECT_LE(distance(point_at(cut, t), point_at(spline, t)), 1e-14) << t;
    }
  }
}

// Far from its ends a part has the very control points of the whole: polynomials of short spans,
// taken far beyond them, would lose all digits. (A curve clipped by trims had been 1e-5 off so.)
TEST(Spline, APartKeepsWhatItsEndsDoNotTouch) {
  const std::vector<double> knots{0, 18, 22, 22.001, 44, 44.08, 66};
  const std::vector<int> multiplicities{6, 1, 3, 3, 3, 3, 6};
  Spline spline{5, knots, multiplicities, {}};
  for (int i = 0; i < 19; ++i)
    spline.points.push_back({3.5 * i, 50 * std::sin(1.7 * i), 20 * std::cos(2.3 * i)});
  for (const Interval part : {Interval{6e-4, 66}, {0, 65}, {6e-4, 65.9}, {18.5, 44.04}}) {
    const Spline cut = restricted(spline, part);
    for (int i = 0; i <= 400; ++i) {
      const double t = at(part, i / 400.0);
      EXPECT_LE(distance(point_at(cut, t), point_at(spline, t)), 2e-13) << t;
    }
  }
  const Spline cut = restricted(spline, {6e-4, 66});
  EXPECT_EQ(std::vector<Vec3>(cut.points.begin() + 5, cut.points.end()),
            std::vector<Vec3>(spline.points.begin() + 5, spline.points.end()));
}

// Two knots that differ by rounding are one to Open CASCADE, which refuses such a curve.
TEST(Spline, APartHasNoKnotWithinRoundingOfItsEnds) {
  const Spline spline = some_spline();
  const Interval part{std::nextafter(1, 0), std::nextafter(2.5, 3)};
  const Spline cut = restricted(spline, part);
  EXPECT_EQ(cut.knots, (std::vector<double>{part.from, part.to}));
  for (int i = 0; i <= 40; ++i) {
    const double t = at(part, i / 40.0);
    EXPECT_LE(distance(point_at(cut, t), point_at(spline, t)), 1e-14) << t;
  }
}

TEST(Spline, PartsJoinToTheWhole) {
  const Spline spline = some_spline();
  const Spline whole = joined(restricted(spline, {0, 1.7}), restricted(spline, {1.7, 3}));
  for (int i = 0; i <= 40; ++i)
    EXPECT_LE(distance(point_at(whole, 3 * i / 40.0), point_at(spline, 3 * i / 40.0)), 1e-14);
}

TEST(Spline, RefusesAPartOutsideTheDomain) {
  EXPECT_ANY_THROW(restricted(some_spline(), {-0.1, 1}));
  EXPECT_ANY_THROW(restricted(some_spline(), {1, 1}));
}

}  // namespace
}  // namespace blossom
