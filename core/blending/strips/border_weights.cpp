// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/strips/border_weights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/forms/algebra/products.h"
#include "core/math/binomial.h"

namespace blossom {
namespace {

/// Two weights are in the same ratio when they differ by no more than the roundings of a product.
constexpr double kSameRatio = 1e-14;

int order_of(const std::vector<BorderPiece>& pieces) {
  return static_cast<int>(pieces.front().rows.size()) - 1;
}

/// r with D_j,w = r q along all pieces.
std::optional<double> ratio_of(const std::vector<BorderPiece>& pieces, std::size_t j) {
  const BorderRows& first = pieces.front().rows;
  const double ratio = first[j].front()[3] / first[0].front()[3];
  double largest = 0;
  for (const BorderPiece& piece : pieces)
    for (const Vec4& vector : piece.rows[j]) largest = std::max(largest, std::abs(vector[3]));
  for (const BorderPiece& piece : pieces)
    for (std::size_t i = 0; i < piece.rows[0].size(); ++i) {
      const double weight = piece.rows[0][i][3];
      const double off = piece.rows[j][i][3] - ratio * weight;
      if (std::abs(off) > kSameRatio * (largest + std::abs(ratio) * weight)) return std::nullopt;
    }
  return ratio;
}

/// The ratios of all orders, 1 first; none if one is not constant.
std::optional<std::vector<double>> ratios_of(const std::vector<BorderPiece>& pieces) {
  std::vector<double> ratios;
  for (std::size_t j = 0; j < pieces.front().rows.size(); ++j) {
    const std::optional<double> ratio = ratio_of(pieces, j);
    if (!ratio) return std::nullopt;
    ratios.push_back(*ratio);
  }
  return ratios;
}

/// The derivatives of 1 / g from those of g, g_0 = 1:  h_j = - sum_(i >= 1) binom(j, i) g_i h_(j-i)
std::vector<double> reciprocal_series(const std::vector<double>& g) {
  std::vector<double> h{1};
  for (int j = 1; j < static_cast<int>(g.size()); ++j) {
    double sum = 0;
    for (int i = 1; i <= j; ++i)
      sum -= binomial(j, i) * g[static_cast<std::size_t>(i)] * h[static_cast<std::size_t>(j - i)];
    h.push_back(sum);
  }
  return h;
}

/// The derivatives of f D by Leibniz's rule, f constant along the border.
void multiply(BorderRows& rows, const std::vector<double>& f) {
  for (std::size_t j = rows.size() - 1; j > 0; --j)
    for (std::size_t i = 1; i <= j; ++i) {
      const double share = binomial(static_cast<int>(j), static_cast<int>(i)) * f[i];
      for (std::size_t k = 0; k < rows[j].size(); ++k) rows[j][k] += share * rows[j - i][k];
    }
}

BezierFunction weights_of(const Row& row) {
  BezierFunction weights;
  for (const Vec4& p : row) weights.points.push_back(p[3]);
  return weights;
}

void add(std::vector<double>& sum, double factor, const std::vector<double>& terms) {
  sum.resize(terms.size());
  for (std::size_t i = 0; i < terms.size(); ++i) sum[i] += factor * terms[i];
}

/// Powers of q up to `most`.
std::vector<BezierFunction> powers_of(const BezierFunction& q, int most) {
  std::vector<BezierFunction> powers{BezierFunction{{1}}};
  for (int j = 1; j <= most; ++j) powers.push_back(product(powers.back(), q));
  return powers;
}

/// The derivatives of q^(k+1) / W: f_j = q^(k-j) P_j with P_0 = 1 and
///   P_j = - sum_(i >= 1) binom(j, i) q^(i-1) D_i,w P_(j-i)
std::vector<BezierFunction> weight_factors(const BorderRows& rows) {
  const int k = static_cast<int>(rows.size()) - 1;
  const std::vector<BezierFunction> powers = powers_of(weights_of(rows[0]), k);
  std::vector<BezierFunction> inner{BezierFunction{{1}}}, factors{powers.back()};
  for (int j = 1; j <= k; ++j) {
    BezierFunction& sum = inner.emplace_back();
    for (int i = 1; i <= j; ++i) {
      const BezierFunction scaled = product(powers[static_cast<std::size_t>(i - 1)],
                                            weights_of(rows[static_cast<std::size_t>(i)]));
      add(sum.points, -binomial(j, i),
          product(scaled, inner[static_cast<std::size_t>(j - i)]).points);
    }
    factors.push_back(product(powers[static_cast<std::size_t>(k - j)], sum));
  }
  return factors;
}

BorderRows multiplied(const BorderRows& rows, const std::vector<BezierFunction>& f) {
  BorderRows result;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    Row& sum = result.emplace_back();
    for (std::size_t i = 0; i <= j; ++i) {
      const Row term = product(f[i].points, rows[j - i]);
      sum.resize(term.size());
      const double share = binomial(static_cast<int>(j), static_cast<int>(i));
      for (std::size_t p = 0; p < term.size(); ++p) sum[p] += share * term[p];
    }
  }
  return result;
}

}  // namespace

int level_degree(const std::vector<BorderPiece>& pieces) {
  std::size_t most = 0;
  for (const BorderPiece& piece : pieces) most = std::max(most, piece.rows[0].size());
  const int degree = static_cast<int>(most) - 1;
  return ratios_of(pieces) ? degree : (order_of(pieces) + 1) * degree;
}

void level_weights(std::vector<BorderPiece>& pieces) {
  const auto ratios = ratios_of(pieces);
  for (BorderPiece& piece : pieces) {
    if (ratios)
      multiply(piece.rows, reciprocal_series(*ratios));
    else
      piece.rows = multiplied(piece.rows, weight_factors(piece.rows));
    for (std::size_t j = 1; j < piece.rows.size(); ++j)
      for (Vec4& vector : piece.rows[j]) vector[3] = 0;
  }
}

}  // namespace blossom
