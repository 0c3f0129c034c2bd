// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/spline_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"

namespace blossom {
namespace {

constexpr std::size_t kOrder = kFitDegree + 1;
constexpr std::size_t kFixed = 3;  // poles at each end that its jet decides

using Basis = std::array<double, kOrder>;

// The six B-splines that are not zero on span `i` of simple knots, at a parameter in it.
// Source: Cox 1972, de Boor 1972, as a triangular scheme.
Basis basis_at(const std::vector<double>& flat, std::size_t span, double t) {
  Basis basis{1};
  std::array<double, kOrder> left{}, right{};
  for (std::size_t j = 1; j < kOrder; ++j) {
    left[j] = t - flat[span + 1 - j];
    right[j] = flat[span + j] - t;
    double saved = 0;
    for (std::size_t r = 0; r < j; ++r) {
      const double part = basis[r] / (right[r + 1] + left[j - r]);
      basis[r] = saved + right[r + 1] * part;
      saved = left[j - r] * part;
    }
    basis[j] = saved;
  }
  return basis;
}

// A symmetric positive definite matrix with five diagonals below the main one, and seven right
// hand sides. Row i holds the entries (i, i - 5 .. i).
class BandedSystem {
 public:
  explicit BandedSystem(std::size_t size) : rows_(size), right_(size) {}

  double& entry(std::size_t i, std::size_t j) { return rows_[i][kFitDegree - (i - j)]; }
  Vec7& right(std::size_t i) { return right_[i]; }

  // By Cholesky's factors, in place. Returns false when a pivot is not positive.
  bool solve() {
    const std::size_t n = rows_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = first(i); j <= i; ++j) {
        double sum = entry(i, j);
        for (std::size_t k = std::max(first(i), first(j)); k < j; ++k)
          sum -= entry(i, k) * entry(j, k);
        if (i == j && !(sum > 0)) return false;
        entry(i, j) = i == j ? std::sqrt(sum) : sum / entry(j, j);
      }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = first(i); k < i; ++k) right_[i] -= entry(i, k) * right_[k];
      right_[i] *= 1 / entry(i, i);
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < std::min(n, i + kOrder); ++k)
        right_[i] -= entry(k, i) * right_[k];
      right_[i] *= 1 / entry(i, i);
    }
    return true;
  }

 private:
  static std::size_t first(std::size_t i) { return i < kFitDegree ? 0 : i - kFitDegree; }

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
  for (std::size_t span = 0; span + 1 < knots.size(); ++span)
    for (const double fraction : kFitChecks) {
      const double t = at(Interval{knots[span], knots[span + 1]}, fraction);
      while (piece + 1 < pieces.size() && t > pieces[piece].place.to) ++piece;
      const Interval& place = pieces[piece].place;
      result.values.push_back(value_at(pieces[piece].points, (t - place.from) / length(place)));
      result.basis.push_back(basis_at(flat, span + kFitDegree, t));
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

Vec7 sum_at(const std::vector<Vec7>& poles, std::size_t span, const Basis& basis) {
  Vec7 sum = basis[0] * poles[span];
  for (std::size_t i = 1; i < kOrder; ++i) sum += basis[i] * poles[span + i];
  return sum;
}

// Least squares on what the poles leave. Poles that are near the curve lose less to rounding.
void improve(const Sampled& samples, RunSpline& spline) {
  const std::size_t unknown = spline.poles.size() - 2 * kFixed;
  BandedSystem system(unknown);
  for (std::size_t s = 0; s < samples.values.size(); ++s) {
    const std::size_t span = s / kFitChecks.size();
    const Basis& basis = samples.basis[s];
    const Vec7 rest = samples.values[s] - sum_at(spline.poles, span, basis);
    for (std::size_t i = 0; i < kOrder; ++i) {
      if (span + i < kFixed || span + i >= kFixed + unknown) continue;
      const std::size_t row = span + i - kFixed;
      system.right(row) += basis[i] * rest;
      for (std::size_t j = 0; j <= i; ++j)
        if (span + j >= kFixed) system.entry(row, span + j - kFixed) += basis[i] * basis[j];
    }
  }
  if (!system.solve()) return;
  for (std::size_t i = 0; i < unknown; ++i) spline.poles[kFixed + i] += system.right(i);
}

}  // namespace

Vec7 value_at(const QuinticPoints& points, double t) {
  const double s = 1 - t, s2 = s * s, t2 = t * t;
  const Basis basis{s2 * s2 * s,      5 * s2 * s2 * t, 10 * s2 * s * t2,
                    10 * s2 * t2 * t, 5 * s * t2 * t2, t2 * t2 * t};
  Vec7 sum = basis[0] * points[0];
  for (std::size_t i = 1; i < kOrder; ++i) sum += basis[i] * points[i];
  return sum;
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
          sum_at(spline.poles, span, samples.basis[span * kFitChecks.size() + check]));
  return spline;
}

}  // namespace blossom
