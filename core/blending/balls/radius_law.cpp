// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/radius_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
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

const char* to_string(LawKind kind) {
  switch (kind) {
    case LawKind::Constant: return "constant";
    case LawKind::Linear: return "linear";
    case LawKind::Smooth: return "smooth";
    case LawKind::Table: break;
  }
  return "table";
}

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

std::size_t RadiusLaw::piece_at(double parameter) const {
  const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end(), parameter);
  return static_cast<std::size_t>(above - breaks_.begin()) - 1;
}

RadiusJet RadiusLaw::at(double parameter) const {
  const std::size_t piece = piece_at(parameter);
  const auto& c = pieces_[piece];
  const double t = parameter - breaks_[piece];
  return {c[0] + t * (c[1] + t * (c[2] + t * c[3])), c[1] + t * (2 * c[2] + t * 3 * c[3]),
          2 * c[2] + t * 6 * c[3]};
}

std::vector<double> RadiusLaw::knots() const { return {breaks_.begin() + 1, breaks_.end()}; }

Interval RadiusLaw::extremes(const Interval& range) const {
  Interval found{at(range.from).value, at(range.from).value};
  const auto look = [&](double parameter) {
    if (!(parameter >= range.from && parameter <= range.to)) return;
    const double value = at(parameter).value;
    found = {std::min(found.from, value), std::max(found.to, value)};
  };
  look(range.to);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    look(breaks_[i]);
    // Where c_1 + 2 c_2 t + 3 c_3 t^2 vanishes; a root of another piece does no harm.
    const auto& c = pieces_[i];
    const double q =
        -(c[2] + std::copysign(std::sqrt(std::max(0.0, c[2] * c[2] - 3 * c[1] * c[3])), c[2]));
    if (c[3] != 0) look(breaks_[i] + q / (3 * c[3]));
    if (q != 0) look(breaks_[i] + c[1] / q);
  }
  return found;
}

RadiusLaw RadiusLaw::over(const Interval& part, const Interval& range) const {
  check(range);
  if (part.from == part.to) return constant(at(part.from).value);
  const double scale = (part.to - part.from) / length(range);
  std::vector<double> starts{part.from};
  for (std::size_t i = 1; i < breaks_.size(); ++i)
    if ((breaks_[i] - part.from) * (breaks_[i] - part.to) < 0) starts.push_back(breaks_[i]);
  if (scale < 0) std::sort(starts.begin() + 1, starts.end(), std::greater<>());
  RadiusLaw law;
  law.kind_ = kind_;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const double end = i + 1 < starts.size() ? starts[i + 1] : part.to;
    const auto& c = pieces_[piece_at((starts[i] + end) / 2)];
    const double t = starts[i] - breaks_[piece_at((starts[i] + end) / 2)];
    law.breaks_.push_back(range.from + (starts[i] - part.from) / scale);
    law.pieces_.push_back({c[0] + t * (c[1] + t * (c[2] + t * c[3])),
                           scale * (c[1] + t * (2 * c[2] + 3 * t * c[3])),
                           scale * scale * (c[2] + 3 * t * c[3]), scale * scale * scale * c[3]});
  }
  return law;
}

// With s = x - range.from, h its length and d_0, d_1 what the rates lack:
//   s (1 - s / h)^2 d_0 - s^2 / h (1 - s / h) d_1
RadiusLaw RadiusLaw::with_rates(const Interval& range, double first, double last) const {
  check(range);
  const double h = length(range);
  const double d0 = first - at(range.from).first, d1 = last - at(range.to).first;
  const double c1 = d0, c2 = -(2 * d0 + d1) / h, c3 = (d0 + d1) / (h * h);
  RadiusLaw law = *this;
  if (law.kind_ == LawKind::Constant) law.kind_ = LawKind::Table;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double s = breaks_[i] - range.from;
    auto& piece = law.pieces_[i];
    piece[0] += s * (c1 + s * (c2 + s * c3));
    piece[1] += c1 + s * (2 * c2 + s * 3 * c3);
    piece[2] += c2 + 3 * s * c3;
    piece[3] += c3;
  }
  return law;
}

}  // namespace blossom
