// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/series/taylor_model.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

constexpr std::size_t kTerms = TaylorModel::kDegree + 1;
/// A bound is a sum of at most kTerms^2 positive products and a few more: its own roundings are
/// below 600 units, 2^-43.
constexpr double kOfBounds = 1 + 0x1p-43;

double finite_or_infinite(double bound) { return std::isfinite(bound) ? bound : kInfinity; }

double terms_sum(const TaylorModel& f, std::size_t first = 0) {
  double sum = 0;
  for (std::size_t k = first; k < kTerms; ++k) sum += std::abs(f.terms[k]);
  return sum;
}

}  // namespace

TaylorModel& TaylorModel::operator+=(const TaylorModel& g) {
  for (std::size_t k = 0; k < kTerms; ++k) terms[k] += g.terms[k];
  rest = kOfBounds * (rest + g.rest + kUnitRoundoff * terms_sum(*this));
  return *this;
}

TaylorModel& TaylorModel::operator-=(const TaylorModel& g) {
  for (std::size_t k = 0; k < kTerms; ++k) terms[k] -= g.terms[k];
  rest = kOfBounds * (rest + g.rest + kUnitRoundoff * terms_sum(*this));
  return *this;
}

// A kept term is a sum of up to kTerms products: kTerms + 1 roundings of each. What is cut from the
// p-th row are the terms of g from kTerms - p on.
TaylorModel& TaylorModel::operator*=(const TaylorModel& g) {
  std::array<double, kTerms + 1> sums_from{};
  for (std::size_t q = kTerms; q-- > 0;) sums_from[q] = sums_from[q + 1] + std::abs(g.terms[q]);
  TaylorModel product;
  double cut = 0, of_f = 0;
  for (std::size_t p = 0; p < kTerms; ++p) {
    const double factor = terms[p];
    if (factor == 0) continue;
    for (std::size_t q = 0; q < kTerms - p; ++q) product.terms[p + q] += factor * g.terms[q];
    cut += std::abs(factor) * sums_from[kTerms - p];
    of_f += std::abs(factor);
  }
  const double of_g = sums_from[0];
  double left = cut + (kTerms + 1) * kUnitRoundoff * of_f * of_g;
  if (rest != 0) left += rest * (of_g + g.rest);
  if (g.rest != 0) left += of_f * g.rest;
  product.rest = kOfBounds * left;
  return *this = product;
}

TaylorModel operator-(TaylorModel f) {
  for (double& term : f.terms) term = -term;
  return f;
}

// With the first terms r of 1 / f and d = 1 - f r:  |1 / f - r| = |r d / (1 - d)|.
TaylorModel reciprocal(const TaylorModel& f) {
  TaylorModel r;
  r.terms[0] = 1 / f.terms[0];
  for (std::size_t k = 1; k < kTerms; ++k) {
    double sum = 0;
    for (std::size_t p = 1; p <= k; ++p) sum += f.terms[p] * r.terms[k - p];
    r.terms[k] = -sum * r.terms[0];
  }
  const double defect = size_bound(TaylorModel(1) - f * r);
  r.rest = defect < 0.5 ? kOfBounds * size_bound(r) * defect / (1 - defect) : kInfinity;
  return r;
}

// With the first terms s of the root and e = f - s^2:  |root - s| = |e| / (root + s) <= |e| / s.
TaylorModel sqrt(const TaylorModel& f) {
  TaylorModel s;
  s.terms[0] = std::sqrt(f.terms[0]);
  for (std::size_t k = 1; k < kTerms; ++k) {
    double sum = f.terms[k];
    for (std::size_t p = 1; p < k; ++p) sum -= s.terms[p] * s.terms[k - p];
    s.terms[k] = sum / (2 * s.terms[0]);
  }
  const double defect = size_bound(f - s * s);
  const double least = (s.terms[0] - change_bound(s)) / kOfBounds;
  const bool positive = least > 0 && defect < least * least / 2;
  s.rest = positive ? kOfBounds * defect / least : kInfinity;
  return s;
}

// The largest of |c_0 + c_1 x + c_2 x^2| is at an end or where its slope vanishes.
double size_bound(const TaylorModel& f) {
  const double c = f.terms[0], b = f.terms[1], a = f.terms[2];
  double most = std::abs(c + a) + std::abs(b);
  const double roundings = 8 * kUnitRoundoff * (std::abs(a) + std::abs(b) + std::abs(c));
  if (std::abs(b) < 2 * std::abs(a)) most = std::max(most, std::abs(c - b * (b / (4 * a))));
  return finite_or_infinite(kOfBounds * (most + roundings + terms_sum(f, 3) + f.rest));
}

double change_bound(const TaylorModel& f) {
  return finite_or_infinite(kOfBounds * (terms_sum(f, 1) + f.rest));
}

}  // namespace blossom
