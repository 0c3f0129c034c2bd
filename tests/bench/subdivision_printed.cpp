// SPDX-License-Identifier: LGPL-2.1-or-later
// Formula (9) of Vlachkova 2025 as it is printed: four nested sums for every control point.
#include <algorithm>
#include <array>

#include "core/math/binomial.h"
#include "tests/bench/subdivision_rivals.h"

namespace blossom::bench {
namespace {

using Powers = std::array<double, kMaxDegree + 1>;

Powers powers_of(double x) {
  Powers powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = powers[k - 1] * x;
  return powers;
}

struct Ends {
  explicit Ends(const Interval& interval)
      : from(powers_of(interval.from)), to(powers_of(interval.to)) {}
  Powers from, to;
};

double power(const Powers& powers, int k) { return powers[static_cast<std::size_t>(k)]; }

// The two inner sums, over k and r.
double inner_sums(int n, int m, int nu, int mu, int i, int j, const Ends& u, const Ends& v) {
  double sum = 0;
  for (int k = std::max(0, i + nu - n); k <= std::min(i, nu); ++k)
    for (int r = std::max(0, j + mu - m); r <= std::min(j, mu); ++r)
      sum += binomial(nu, k) * binomial(n - nu, i - k) * binomial(mu, r) * binomial(m - mu, j - r) *
             power(u.to, k) * power(u.from, i - k) * power(v.to, r) * power(v.from, j - r);
  return sum;
}

}  // namespace

BezierPatch printed_points(const MonomialPatch& patch, const Interval& along_u,
                           const Interval& along_v) {
  const int n = patch.degree_u(), m = patch.degree_v();
  const Ends u(along_u), v(along_v);
  BezierPatch result{Grid<Vec3>(n + 1, m + 1)};
  for (int nu = 0; nu <= n; ++nu)
    for (int mu = 0; mu <= m; ++mu)
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= m; ++j)
          result.points(nu, mu) +=
              patch.coefficients(i, j) *
              (inner_sums(n, m, nu, mu, i, j, u, v) / (binomial(n, i) * binomial(m, j)));
  return result;
}

}  // namespace blossom::bench
