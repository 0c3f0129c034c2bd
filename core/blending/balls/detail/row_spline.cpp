// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/detail/row_spline.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"

namespace blossom {
namespace {

constexpr std::size_t kDegree = kRowDegree;
constexpr std::size_t kOrder = kDegree + 1;

using Basis = std::array<double, kOrder>;

// Index of the last flat knot that begins a span.
std::size_t flat_index(const RowSpline& spline, std::size_t span) {
  std::size_t count = 0;
  for (std::size_t i = 0; i <= span; ++i)
    count += static_cast<std::size_t>(spline.multiplicities[i]);
  return count - 1;
}

// The B-splines of degree 5 that are not zero between flat[i] and flat[i + 1], and those of degree
// 4. Source: Cox 1972, de Boor 1972, as a triangular scheme.
struct BasisPair {
  Basis value{1}, lower{};
};

BasisPair basis_at(const std::vector<double>& flat, std::size_t i, double t) {
  BasisPair basis;
  std::array<double, kOrder> left{}, right{};
  for (std::size_t j = 1; j < kOrder; ++j) {
    if (j == kDegree) basis.lower = basis.value;
    left[j] = t - flat[i + 1 - j];
    right[j] = flat[i + j] - t;
    double saved = 0;
    for (std::size_t r = 0; r < j; ++r) {
      const double part = basis.value[r] / (right[r + 1] + left[j - r]);
      basis.value[r] = saved + right[r + 1] * part;
      saved = left[j - r] * part;
    }
    basis.value[j] = saved;
  }
  return basis;
}

// The normal equations of the poles from `first` to before `last`, five diagonals below the main
// one: row i holds the entries (i, i - 5 .. i).
class NormalEquations {
 public:
  NormalEquations(std::size_t first, std::size_t last)
      : first_(first), rows_(last - first, Basis{}) {}

  void add(std::size_t pole, const Basis& basis) {
    for (std::size_t i = 0; i < kOrder; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        if (pole + j >= first_ && pole + i < first_ + rows_.size())
          entry(pole + i - first_, pole + j - first_) += basis[i] * basis[j];
  }

  // By Cholesky's factors, in place; diagonals then hold inverses.
  bool factorise() {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t j = low(i); j <= i; ++j) {
        double sum = entry(i, j);
        for (std::size_t k = std::max(low(i), low(j)); k < j; ++k) sum -= entry(i, k) * entry(j, k);
        if (i == j && !(sum > 0)) return false;
        entry(i, j) = i == j ? 1 / std::sqrt(sum) : sum * entry(j, j);
      }
    return true;
  }

  // right: row by row, solved in place.
  void solve(std::vector<double>& right, std::size_t columns) {
    const auto subtract = [&](double factor, std::size_t from, std::size_t to) {
      for (std::size_t c = 0; c < columns; ++c)
        right[to * columns + c] -= factor * right[from * columns + c];
    };
    const auto scale = [&](std::size_t i) {
      for (std::size_t c = 0; c < columns; ++c) right[i * columns + c] *= entry(i, i);
    };
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (std::size_t k = low(i); k < i; ++k) subtract(entry(i, k), k, i);
      scale(i);
    }
    for (std::size_t i = rows_.size(); i-- > 0;) {
      for (std::size_t k = i + 1; k < std::min(rows_.size(), i + kOrder); ++k)
        subtract(entry(k, i), k, i);
      scale(i);
    }
  }

  std::size_t size() const { return rows_.size(); }

 private:
  static std::size_t low(std::size_t i) { return i < kDegree ? 0 : i - kDegree; }
  double& entry(std::size_t i, std::size_t j) { return rows_[i][kDegree - (i - j)]; }

  std::size_t first_;
  std::vector<Basis> rows_;
};

// The ends' poles, and how many there are at each.
std::size_t fix_ends(const RowSamples& samples, RowSpline& spline) {
  const std::size_t m = spline.columns, n = spline.pole_count();
  const bool with_rates = !samples.rates[0].empty();
  const double h0 = spline.knots[1] - spline.knots[0],
               h1 = spline.knots.back() - spline.knots[spline.knots.size() - 2];
  for (std::size_t c = 0; c < m; ++c) {
    spline.poles[c] = samples.ends[0][c];
    spline.poles[(n - 1) * m + c] = samples.ends[1][c];
    if (!with_rates) continue;
    spline.poles[m + c] = samples.ends[0][c] + samples.rates[0][c] * h0 / kRowDegree;
    spline.poles[(n - 2) * m + c] = samples.ends[1][c] - samples.rates[1][c] * h1 / kRowDegree;
  }
  return with_rates ? 2 : 1;
}

struct BasisPlace {
  std::size_t first;  // pole
  Basis basis;
};

std::vector<BasisPlace> places_of(const RowSpline& spline, const std::vector<double>& parameters) {
  std::vector<BasisPlace> places;
  places.reserve(parameters.size());
  std::size_t span = 0, flat = kDegree;
  for (const double t : parameters) {
    while (span + 2 < spline.knots.size() && t > spline.knots[span + 1])
      flat += static_cast<std::size_t>(spline.multiplicities[++span]);
    places.push_back({flat - kDegree, basis_at(spline.flat, flat, t).value});
  }
  return places;
}

}  // namespace

RowSpline least_squares_rows(const std::vector<double>& knots,
                             const std::vector<int>& multiplicities, const RowSamples& samples) {
  RowSpline spline{knots, multiplicities, samples.ends[0].size(), {}, {}};
  for (std::size_t i = 0; i < knots.size(); ++i)
    spline.flat.insert(spline.flat.end(), static_cast<std::size_t>(multiplicities[i]), knots[i]);
  const std::size_t m = spline.columns, n = spline.pole_count();
  spline.poles.assign(n * m, 0);
  const std::size_t fixed = fix_ends(samples, spline);
  const std::vector<BasisPlace> places = places_of(spline, samples.parameters);
  NormalEquations equations(fixed, n - fixed);
  for (const BasisPlace& place : places) equations.add(place.first, place.basis);
  if (!equations.factorise())
    throw InvalidInput("least_squares_rows: too few samples for the knots");
  // The second pass takes what rounding left of the first.
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<double> right(equations.size() * m, 0), rest(m);
    for (std::size_t s = 0; s < places.size(); ++s) {
      const BasisPlace& place = places[s];
      for (std::size_t c = 0; c < m; ++c) rest[c] = samples.values[s * m + c];
      for (std::size_t i = 0; i < kOrder; ++i)
        for (std::size_t c = 0; c < m; ++c)
          rest[c] -= place.basis[i] * spline.poles[(place.first + i) * m + c];
      for (std::size_t i = 0; i < kOrder; ++i) {
        const std::size_t pole = place.first + i;
        if (pole < fixed || pole >= n - fixed) continue;
        for (std::size_t c = 0; c < m; ++c)
          right[(pole - fixed) * m + c] += place.basis[i] * rest[c];
      }
    }
    equations.solve(right, m);
    for (std::size_t k = 0; k < right.size(); ++k) spline.poles[fixed * m + k] += right[k];
  }
  return spline;
}

void evaluate(const RowSpline& spline, std::size_t span, double t, std::span<double> value,
              std::span<double> rate) {
  const std::size_t at = flat_index(spline, span), m = spline.columns;
  const BasisPair basis = basis_at(spline.flat, at, t);
  // The derivative's weights: 5 (N_i / (t_(i+5) - t_i) - N_(i+1) / (t_(i+6) - t_(i+1))) of
  // degree 4.
  Basis slope{};
  for (std::size_t i = 0; i < kDegree; ++i) {
    const std::size_t k = at - kDegree + 1 + i;
    const double part = kRowDegree * basis.lower[i] / (spline.flat[k + kDegree] - spline.flat[k]);
    slope[i] -= part;
    slope[i + 1] += part;
  }
  std::fill(value.begin(), value.end(), 0.0);
  std::fill(rate.begin(), rate.end(), 0.0);
  for (std::size_t i = 0; i < kOrder; ++i) {
    const double* pole = spline.poles.data() + (at - kDegree + i) * m;
    for (std::size_t c = 0; c < m; ++c) {
      value[c] += basis.value[i] * pole[c];
      rate[c] += slope[i] * pole[c];
    }
  }
}

std::vector<double> bezier_points(const RowSpline& spline, std::size_t span) {
  const std::size_t at = flat_index(spline, span), m = spline.columns;
  const double from = spline.knots[span], to = spline.knots[span + 1];
  std::vector<double> points(kOrder * m);
  std::array<double, kOrder> d;
  for (std::size_t c = 0; c < m; ++c)
    for (std::size_t k = 0; k < kOrder; ++k) {
      for (std::size_t j = 0; j < kOrder; ++j) d[j] = spline.poles[(at - kDegree + j) * m + c];
      for (std::size_t r = 1; r <= kDegree; ++r) {
        const double t = r <= k ? to : from;
        for (std::size_t j = kDegree; j >= r; --j) {
          const double low = spline.flat[at - kDegree + j], high = spline.flat[at + 1 + j - r];
          const double s = (t - low) / (high - low);
          d[j] = (1 - s) * d[j - 1] + s * d[j];
        }
      }
      points[k * m + c] = d[kDegree];
    }
  return points;
}

}  // namespace blossom
