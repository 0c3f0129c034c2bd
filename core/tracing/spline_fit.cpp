// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/spline_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/tracing/packed_vec7.h"

namespace blossom {
namespace {

constexpr std::size_t kOrder = kFitDegree + 1;
constexpr std::size_t kFixed = 3;  // poles at each end that its jet decides

using Basis = std::array<double, kOrder>;

// sum weights[i] points[i] over one order of both.
[[gnu::always_inline]] inline Vec7 sum_of(const Basis& weights, const Vec7* points) {
  PackedVec7 sum;
  for (std::size_t i = 0; i < kOrder; ++i) add(weights[i], points[i], sum);
  Vec7 result;
  store(sum, result);
  return result;
}

// What the scheme divides by on span `i` of simple knots, inverted.
using InverseWidths = std::array<std::array<double, kOrder>, kOrder>;

InverseWidths inverse_widths(const std::vector<double>& flat, std::size_t span) {
  InverseWidths result;
  for (std::size_t j = 1; j < kOrder; ++j)
    for (std::size_t r = 0; r < j; ++r)
      result[j][r] = 1 / (flat[span + r + 1] - flat[span + r + 1 - j]);
  return result;
}

// The six B-splines that are not zero on span `i`, at a parameter in it.
// Source: Cox 1972, de Boor 1972, as a triangular scheme.
Basis basis_at(const std::vector<double>& flat, std::size_t span, const InverseWidths& inverse,
               double t) {
  Basis basis{1};
  std::array<double, kOrder> left{}, right{};
  for (std::size_t j = 1; j < kOrder; ++j) {
    left[j] = t - flat[span + 1 - j];
    right[j] = flat[span + j] - t;
    double saved = 0;
    for (std::size_t r = 0; r < j; ++r) {
      const double part = basis[r] * inverse[j][r];
      basis[r] = saved + right[r + 1] * part;
      saved = left[j - r] * part;
    }
    basis[j] = saved;
  }
  return basis;
}

// The normal equations of a spline's poles: a symmetric positive definite matrix with five
// diagonals below the main one, and seven right hand sides. Row i holds the entries (i, i - 5 ..
// i). The poles at the ends are known: their rows are made, but not solved.
class BandedSystem {
 public:
  explicit BandedSystem(std::size_t poles) : rows_(poles), right_(poles) {}

  // Those of one span, whose poles begin with `from`: its B-splines and what is left at the checks.
  [[gnu::always_inline]] void add_span(std::size_t from, const Basis* basis, const Vec7* rest) {
    std::array<Basis, kOrder> products{};
    std::array<PackedVec7, kOrder> sums{};
    for (std::size_t s = 0; s < kFitChecks.size(); ++s)
      for (std::size_t i = 0; i < kOrder; ++i) {
        for (std::size_t j = 0; j < kOrder; ++j) products[i][j] += basis[s][i] * basis[s][j];
        add(basis[s][i], rest[s], sums[i]);
      }
    for (std::size_t i = 0; i < kOrder; ++i) {
      for (std::size_t j = 0; j <= i; ++j) entry(from + i, from + j) += products[i][j];
      Vec7 sum;
      store(sums[i], sum);
      right_[from + i] += sum;
    }
  }

  // By Cholesky's factors, in place. Returns false when a pivot is not positive.
  [[gnu::always_inline]] bool solve() {
    const std::size_t end = rows_.size() - kFixed;
    for (std::size_t i = kFixed; i < end; ++i)
      for (std::size_t j = first(i); j <= i; ++j) {
        double sum = entry(i, j);
        for (std::size_t k = std::max(first(i), first(j)); k < j; ++k)
          sum -= entry(i, k) * entry(j, k);
        if (i == j && !(sum > 0)) return false;
        entry(i, j) = i == j ? 1 / std::sqrt(sum) : sum * entry(j, j);
      }
    // The diagonal holds inverses.
    for (std::size_t i = kFixed; i < end; ++i) {
      for (std::size_t k = first(i); k < i; ++k) subtract(entry(i, k), k, i);
      right_[i] *= entry(i, i);
    }
    for (std::size_t i = end; i-- > kFixed;) {
      for (std::size_t k = i + 1; k < std::min(end, i + kOrder); ++k) subtract(entry(k, i), k, i);
      right_[i] *= entry(i, i);
    }
    return true;
  }

  const Vec7& solution(std::size_t i) const { return right_[i]; }

 private:
  static std::size_t first(std::size_t i) {
    return i < kFixed + kFitDegree ? kFixed : i - kFitDegree;
  }

  double& entry(std::size_t i, std::size_t j) { return rows_[i][kFitDegree - (i - j)]; }

  [[gnu::always_inline]] void subtract(double factor, std::size_t from, std::size_t to) {
    PackedVec7 x;
    load(right_[to], x);
    add(-factor, right_[from], x);
    store(x, right_[to]);
  }

  std::vector<std::array<double, kOrder>> rows_;
  std::vector<Vec7> right_;
};

// All samples of the run: values of the pieces, and the B-splines there.
struct Sampled {
  std::vector<Basis> basis;
  std::vector<Vec7> values;
};

Sampled sampled(const std::vector<QuinticPiece>& pieces, const std::vector<double>& knots,
                const std::vector<double>& flat) {
  Sampled result;
  const std::size_t count = (knots.size() - 1) * kFitChecks.size();
  result.basis.reserve(count);
  result.values.reserve(count);
  std::size_t piece = 0;
  for (std::size_t span = 0; span + 1 < knots.size(); ++span) {
    const InverseWidths inverse = inverse_widths(flat, span + kFitDegree);
    for (const double fraction : kFitChecks) {
      const double t = at(Interval{knots[span], knots[span + 1]}, fraction);
      while (piece + 1 < pieces.size() && t > pieces[piece].place.to) ++piece;
      const Interval& place = pieces[piece].place;
      result.values.push_back(value_at(pieces[piece].points, (t - place.from) / length(place)));
      result.basis.push_back(basis_at(flat, span + kFitDegree, inverse, t));
    }
  }
  return result;
}

// The three poles next to an end, from its jet; `k1`, `k2` are the first two knots beyond it.
std::array<Vec7, kFixed> end_poles(const std::array<Vec7, 3>& jet, double k1, double k2) {
  const Vec7 later = jet[1] + jet[2] * (k1 / (kFitDegree - 1));
  const Vec7 next = jet[0] + jet[1] * (k1 / kFitDegree);
  return {jet[0], next, next + later * (k2 / kFitDegree)};
}

void fix_ends(const std::vector<QuinticPiece>& pieces, RunSpline& spline) {
  const auto jet = [](const QuinticPiece& piece, bool reversed) {
    const auto point = [&](std::size_t i) { return piece.points[reversed ? 5 - i : i]; };
    const double width = length(piece.place);
    return std::array{point(0), (point(1) - point(0)) * (kFitDegree / width),
                      (point(2) - 2 * point(1) + point(0)) * (20 / (width * width))};
  };
  const std::vector<double>& k = spline.knots;
  const std::size_t n = spline.poles.size(), spans = k.size() - 1,
                    second = std::min<std::size_t>(spans, 2);
  const auto start = end_poles(jet(pieces.front(), false), k[1] - k[0], k[second] - k[0]);
  const auto stop =
      end_poles(jet(pieces.back(), true), k[spans] - k[spans - 1], k[spans] - k[spans - second]);
  for (std::size_t i = 0; i < kFixed; ++i) {
    spline.poles[i] = start[i];
    spline.poles[n - 1 - i] = stop[i];
  }
}

// Least squares on what the poles leave. Poles that are near the curve lose less to rounding.
BLOSSOM_HOT void improve(const Sampled& samples, RunSpline& spline) {
  constexpr std::size_t kChecks = kFitChecks.size();
  BandedSystem system(spline.poles.size());
  for (std::size_t span = 0; span + 1 < spline.knots.size(); ++span) {
    const Basis* basis = samples.basis.data() + span * kChecks;
    std::array<Vec7, kChecks> rest;
    for (std::size_t s = 0; s < kChecks; ++s)
      rest[s] = samples.values[span * kChecks + s] - sum_of(basis[s], spline.poles.data() + span);
    system.add_span(span, basis, rest.data());
  }
  if (!system.solve()) return;
  for (std::size_t i = kFixed; i + kFixed < spline.poles.size(); ++i)
    spline.poles[i] += system.solution(i);
}

}  // namespace

BLOSSOM_HOT Vec7 value_at(const QuinticPoints& points, double t) {
  const double s = 1 - t, s2 = s * s, t2 = t * t;
  const Basis basis{s2 * s2 * s,      5 * s2 * s2 * t, 10 * s2 * s * t2,
                    10 * s2 * t2 * t, 5 * s * t2 * t2, t2 * t2 * t};
  return sum_of(basis, points.data());
}

RunSpline least_squares_spline(const std::vector<QuinticPiece>& pieces,
                               const std::vector<double>& knots) {
  if (pieces.empty()) throw InvalidInput("least_squares_spline: there are no pieces");
  if (knots.size() < 2 || !std::is_sorted(knots.begin(), knots.end(), std::less_equal<double>()))
    throw InvalidInput("least_squares_spline: the knots must be at least 2 and increase");
  RunSpline spline{knots, std::vector<Vec7>(knots.size() - 1 + kFitDegree), {}};
  std::vector<double> flat;
  flat.reserve(knots.size() + 2 * kFitDegree);
  flat.assign(kFitDegree, knots.front());
  flat.insert(flat.end(), knots.begin(), knots.end());
  flat.insert(flat.end(), kFitDegree, knots.back());
  fix_ends(pieces, spline);
  const Sampled samples = sampled(pieces, knots, flat);
  // A pole is near the sample beside the middle of its five knots.
  for (std::size_t i = kFixed; i + kFixed < spline.poles.size(); ++i)
    spline.poles[i] = samples.values[(i - 2) * kFitChecks.size()];
  if (spline.poles.size() > 2 * kFixed) improve(samples, spline);
  spline.values.reserve((knots.size() - 1) * kJudgedChecks.size());
  for (std::size_t span = 0; span + 1 < knots.size(); ++span)
    for (const std::size_t check : kJudgedChecks)
      spline.values.push_back(
          sum_of(samples.basis[span * kFitChecks.size() + check], spline.poles.data() + span));
  return spline;
}

}  // namespace blossom
