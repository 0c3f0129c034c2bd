// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/radius_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "core/base/errors.h"

namespace blossom {
namespace {

void check(double radius) {
  if (!(radius > 0) || !std::isfinite(radius))
    throw InvalidInput("RadiusLaw: a radius has to be positive and finite, got " +
                       std::to_string(radius));
}

void check(const Interval& range) {
  if (!(length(range) > 0) || !std::isfinite(length(range)))
    throw InvalidInput("RadiusLaw: the range is empty or not finite");
}

// Second derivatives at the nodes of the natural cubic spline, by elimination without exchanges:
// the matrix is diagonally dominant.
std::vector<double> second_derivatives(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> second(n, 0), factor(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i];
    const double pivot = 2 * (h0 + h1) - h0 * factor[i - 1];
    factor[i] = h1 / pivot;
    second[i] =
        (6 * ((y[i + 1] - y[i]) / h1 - (y[i] - y[i - 1]) / h0) - h0 * second[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) second[i] -= factor[i] * second[i + 1];
  return second;
}

}  // namespace

RadiusLaw RadiusLaw::constant(double radius) {
  check(radius);
  RadiusLaw law;
  law.breaks_ = {0};
  law.pieces_ = {{radius, 0, 0, 0}};
  return law;
}

RadiusLaw RadiusLaw::linear(const Interval& range, double first, double last) {
  check(first);
  check(last);
  check(range);
  RadiusLaw law;
  law.kind_ = LawKind::Linear;
  law.breaks_ = {range.from};
  law.pieces_ = {{first, (last - first) / length(range), 0, 0}};
  return law;
}

RadiusLaw RadiusLaw::smooth(const Interval& range, double first, double last) {
  check(first);
  check(last);
  check(range);
  const double h = length(range);
  RadiusLaw law;
  law.kind_ = LawKind::Smooth;
  law.breaks_ = {range.from};
  law.pieces_ = {{first, 0, 3 * (last - first) / (h * h), -2 * (last - first) / (h * h * h)}};
  return law;
}

RadiusLaw RadiusLaw::table(const std::vector<double>& parameters,
                           const std::vector<double>& radii) {
  if (parameters.size() < 2 || parameters.size() != radii.size())
    throw InvalidInput("RadiusLaw::table: wants as many radii as parameters, and at least 2");
  for (const double radius : radii) check(radius);
  for (std::size_t i = 1; i < parameters.size(); ++i)
    check(Interval{parameters[i - 1], parameters[i]});
  RadiusLaw law;
  law.kind_ = LawKind::Table;
  const std::vector<double> second = second_derivatives(parameters, radii);
  for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
    const double h = parameters[i + 1] - parameters[i];
    law.breaks_.push_back(parameters[i]);
    law.pieces_.push_back({radii[i],
                           (radii[i + 1] - radii[i]) / h - h * (2 * second[i] + second[i + 1]) / 6,
                           second[i] / 2, (second[i + 1] - second[i]) / (6 * h)});
  }
  return law;
}

RadiusJet RadiusLaw::at(double parameter) const {
  const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end(), parameter);
  const auto piece = static_cast<std::size_t>(above - breaks_.begin()) - 1;
  const auto& c = pieces_[piece];
  const double t = parameter - breaks_[piece];
  return {c[0] + t * (c[1] + t * (c[2] + t * c[3])), c[1] + t * (2 * c[2] + t * 3 * c[3]),
          2 * c[2] + t * 6 * c[3]};
}

std::vector<double> RadiusLaw::knots() const { return {breaks_.begin() + 1, breaks_.end()}; }

}  // namespace blossom
