// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/image_series.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <span>

#include "core/base/not_zero.h"
#include "core/math/binomial.h"
#include "core/math/four.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

constexpr int kLong = static_cast<int>(kSeriesDegree);
constexpr int kShort = static_cast<int>(kShortSeriesDegree);
constexpr int kChartDegree = kSeriesChartDegree;
constexpr int kLinearDegree = 5;   // of chart curves where no angle is a parameter
constexpr double kOutside = 1.06;  // (1 + 2e-3)^25: of the weights of a point 1e-3 off its patch

// x - x(0).
struct ChartStep {
  explicit ChartStep(const PowerSeries<double>& series) {
    for (int p = kChartDegree; p > 0; --p) {
      term[p] = series.terms[static_cast<std::size_t>(p)];
      beyond[p] = (p < kChartDegree ? beyond[p + 1] : 0) + std::abs(term[p]);
      if (term[p] != 0) degree = std::max(degree, p);
    }
    reach = beyond[1];
  }

  double term[kChartDegree + 1] = {};
  double beyond[kChartDegree + 1] = {};  // sums of |term| from there on
  double reach = 0;
  int degree = 1;
};

double power(double x, int n) {
  double result = 1;
  for (; n > 0; --n) result *= x;
  return result;
}

// Of Taylor's polynomial of degree n round a point, by one parameter within `reach` of it: how many
// terms count; bounds on the others, their slope and all of them, by the size of the points.
struct Kept {
  Kept(int n, double reach, double limit) : highest(n) {
    for (; highest > 1; --highest) {
      const double factor = 2 * binomial(n, highest) * power(2 * reach, highest - 1);
      if (!(rest + factor * reach <= limit)) break;
      rest += factor * reach;
      slope += highest * factor;
    }
  }

  int highest;
  double rest = 0, slope = 0;
};

// Row i holds the weights of the control points in the i-th Taylor coefficient at t: differences
// of the Bernstein polynomials of degree n - i. The degree is N if that is not negative.
template <int N = -1>
[[gnu::always_inline]] inline void taylor_weights(int degree, int highest, double t, double* rows) {
  const int n = N < 0 ? degree : N;
  double b[kMaxDegree + 1] = {1};
  for (int k = 0; k <= n; ++k) {
    const int i = n - k;
    if (i <= highest) {
      double* row = rows + i * (n + 1);
      std::copy_n(b, k + 1, row);
      for (int length = k + 1; length <= n; ++length) {
        row[length] = row[length - 1];
        for (int l = length - 1; l > 0; --l) row[l] = row[l - 1] - row[l];
        row[0] = -row[0];
      }
      for (int l = 0; l <= n; ++l) row[l] *= binomial(n, i);
    }
    double carried = 0;
    for (int l = 0; l <= k; ++l) {
      const double value = b[l];
      b[l] = carried + (1 - t) * value;
      carried = t * value;
    }
    if (k < n) b[k + 1] = carried;
  }
}

void make_taylor_weights(int n, int highest, double t, double* rows) {
  n == 3 ? taylor_weights<3>(n, highest, t, rows) : taylor_weights(n, highest, t, rows);
}

struct Net {
  Four points[(kMaxDegree + 1) * (kMaxDegree + 1)];
  Four size{};  // largest absolute coordinates
  int n, m;
};

[[gnu::always_inline]] inline void add_absolute(double factor, const Four& a, Four& sum) {
  sum += factor * (a < 0 ? -a : a);
}

BLOSSOM_HOT void make_net(const RationalBezierPatch& patch, const Vec3& origin, Net& net) {
  const Four shift{origin[0], origin[1], origin[2], 0};
  const Vec4* p = patch.points.values().data();
  const std::size_t count = patch.points.values().size();
  Four size{};
  for (std::size_t k = 0; k < count; ++k) {
    Four x;
    std::memcpy(&x, p + k, sizeof x);
    x -= x[3] * shift;
    net.points[k] = x;
    const Four a = x < 0 ? -x : x;
    size = a > size ? a : size;
  }
  net.size = size;
  net.n = patch.degree_u();
  net.m = patch.degree_v();
}

// Coefficient (i, j) of Taylor's polynomial, i <= rows and j <= columns; of the degrees (N, M) if
// they are not negative.
template <int N = -1, int M = -1>
[[gnu::always_inline]] inline void coefficients(const Net& net, const double* in_u, int rows,
                                                const double* in_v, int columns, Four* a) {
  const int n = N < 0 ? net.n : N, width = 1 + (M < 0 ? net.m : M);
  Four line[(M < 0 ? kMaxDegree : M) + 1];
  for (int i = 0; i <= rows; ++i) {
    const double* wu = in_u + i * (n + 1);
    for (int l = 0; l < width; ++l) line[l] = wu[0] * net.points[l];
    for (int k = 1; k <= n; ++k)
      for (int l = 0; l < width; ++l) line[l] += wu[k] * net.points[k * width + l];
    for (int j = 0; j <= columns; ++j) {
      const double* wv = in_v + j * width;
      Four sum = wv[0] * line[0];
      for (int l = 1; l < width; ++l) sum += wv[l] * line[l];
      a[i * (columns + 1) + j] = sum;
    }
  }
}

BLOSSOM_HOT void make_coefficients(const Net& net, const double* in_u, int rows, const double* in_v,
                                   int columns, Four* a) {
  net.n == 3 && net.m == 3 ? coefficients<3, 3>(net, in_u, rows, in_v, columns, a)
                           : coefficients(net, in_u, rows, in_v, columns, a);
}

// B_k^n at t with every sign turned to plus, anywhere within `reach` of t: bounds the sum of the
// absolute terms that a control point has in Taylor's polynomial round t.
void make_absolute_weights(int n, double t, double reach, double* row) {
  const double up = std::abs(t) + reach, down = std::abs(1 - t) + reach;
  double power = 1;
  for (int k = 0; k <= n; ++k, power *= up) row[k] = binomial(n, k) * power;
  power = down;
  for (int k = n; k-- > 0; power *= down) row[k] *= power;
}

// The control points' absolute values times such weights: far from large weights and heights of
// the net it is far less than its largest point.
BLOSSOM_HOT void make_local_size(const Net& net, const double* in_u, const double* in_v,
                                 Four& size) {
  for (int k = 0; k <= net.n; ++k)
    for (int l = 0; l <= net.m; ++l)
      add_absolute(in_u[k] * in_v[l], net.points[k * (net.m + 1) + l], size);
}

// Powers of a step from the first one on, of which K + 1 coefficients are kept; rest[j] bounds what
// is cut off the j-th.
template <int K>
struct Powers {
  double term[kMaxDegree + 1][K + 1];
  double rest[kMaxDegree + 1];
};

// D is no less than the step's degree, and no more than K. So here and below: loops of a known
// length cost far less.
template <int K, int D>
[[gnu::always_inline]] inline void make_powers(const ChartStep& step, int highest,
                                               Powers<K>& powers) {
  for (int q = 0; q <= K; ++q) powers.term[1][q] = q <= D ? step.term[q] : 0;
  powers.rest[1] = 0;
  for (int j = 1; j < highest; ++j) {
    const double* from = powers.term[j];
    double* to = powers.term[j + 1];
    std::fill_n(to, K + 1, 0.0);
    for (int p = 1; p <= D; ++p)
      for (int q = 1; q + p <= K; ++q) to[q + p] += step.term[p] * from[q];
    double cut = powers.rest[j] * step.reach;
    for (int q = K + 1 - D; q <= K; ++q) cut += std::abs(from[q]) * step.beyond[K + 1 - q];
    powers.rest[j + 1] = cut;
  }
}

// c times the J-th power, which has no terms below J, and none above J D.
template <int K, int D, int J>
[[gnu::always_inline]] inline void add_power(const Powers<K>& powers, const Four& c, Four* sum) {
  for (int k = J; k <= std::min(K, J * D); ++k) sum[k] += powers.term[J][k] * c;
}

// Horner's scheme in u, its coefficients the sums over powers of v.
template <int K, int D>
[[gnu::always_inline]] inline void compose_to(const Four* a, int rows, int columns,
                                              const ChartStep& u, const ChartStep& in_v,
                                              Four* result, Four& rest) {
  Powers<K> v;
  make_powers<K, D>(in_v, columns, v);
  Four sum[K + 1] = {};
  for (int i = rows; i >= 0; --i) {
    if (i < rows) {
      rest *= u.reach;
      for (int q = K + 1 - D; q <= K; ++q) add_absolute(u.beyond[K + 1 - q], sum[q], rest);
      for (int k = K; k >= 0; --k) {
        Four next{};
        for (int p = 1; p <= std::min(D, k); ++p) next += u.term[p] * sum[k - p];
        sum[k] = next;
      }
    }
    const Four* c = a + i * (columns + 1);
    sum[0] += c[0];
    if (columns > 0) add_power<K, D, 1>(v, c[1], sum);
    if (columns > 1) add_power<K, D, 2>(v, c[2], sum);
    if (columns > 2) add_power<K, D, 3>(v, c[3], sum);
    for (int j = 4; j <= columns; ++j)
      for (int k = 4; k <= K; ++k) sum[k] += v.term[j][k] * c[j];
    for (int j = 2; j <= columns; ++j) add_absolute(v.rest[j], c[j], rest);
  }
  std::copy_n(sum, K + 1, result);
}

BLOSSOM_HOT void compose_short(const Four* a, int rows, int columns, const ChartStep& u,
                               const ChartStep& v, Four* sum, Four& rest) {
  if (std::max(u.degree, v.degree) <= kLinearDegree)
    compose_to<kShort, kLinearDegree>(a, rows, columns, u, v, sum, rest);
  else
    compose_to<kShort, kChartDegree>(a, rows, columns, u, v, sum, rest);
}

BLOSSOM_HOT void compose_long(const Four* a, int rows, int columns, const ChartStep& u,
                              const ChartStep& v, Four* sum, Four& rest) {
  if (std::max(u.degree, v.degree) <= kLinearDegree)
    compose_to<kLong, kLinearDegree>(a, rows, columns, u, v, sum, rest);
  else
    compose_to<kLong, kChartDegree>(a, rows, columns, u, v, sum, rest);
}

// Sums of absolute values of the terms, differentiated by u.
BLOSSOM_HOT void add_slopes(const Four* a, int rows, int columns, int step, int width, double u,
                            double v, Four& slope) {
  double by_u = 1;
  for (int i = 1; i <= rows; ++i, by_u *= u) {
    double by_v = i * by_u;
    for (int j = 0; j <= columns; ++j, by_v *= v)
      add_absolute(by_v, a[i * step + j * width], slope);
  }
}

// Entry (k, l): the k-th Bezier coefficient of x^l, x = 2 t - 1: its blossom at k times 1 and K - k
// times -1.
template <int K>
constexpr auto kBezierOfPower = [] {
  std::array<std::array<double, K + 1>, K + 1> m{};
  for (int k = 0; k <= K; ++k)
    for (int l = 0; l <= K; ++l) {
      double sum = 0;
      for (int minus = std::max(0, l - k); minus <= std::min(l, K - k); ++minus)
        sum += (minus % 2 == 0 ? 1 : -1) * binomial(K - k, minus) * binomial(k, l - minus);
      m[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)] = sum / binomial(K, l);
    }
  return m;
}();

// The even powers are the same at -x, the odd ones change their sign.
template <int K>
[[gnu::always_inline]] inline SeriesForm bezier_form_of(const PowerSeries<Vec3>& series) {
  constexpr auto& kWeights = kBezierOfPower<K>;
  SeriesForm form;
  form.count = K + 1;
  Four terms[K + 1];
  for (std::size_t l = 0; l <= K; ++l) {
    const Vec3& x = series.terms[l];
    terms[l] = Four{x[0], x[1], x[2], 0};
  }
  for (std::size_t k = 0; 2 * k <= K; ++k) {
    Four even{}, odd{};
    for (std::size_t l = 0; l <= K; l += 2) even += kWeights[k][l] * terms[l];
    for (std::size_t l = 1; l <= K; l += 2) odd += kWeights[k][l] * terms[l];
    const Four here = even + odd, there = even - odd;
    form.values[k] = {here[0], here[1], here[2]};
    form.values[K - k] = {there[0], there[1], there[2]};
  }
  return form;
}

// Row k holds the weights of the points of a form of degree n in its coefficient of x^k: 2^-k
// binom(n, k) times the mean of the k-th differences by binom(n - k, .) 2^(k - n). Exact.
using PowerWeights = std::array<std::array<double, kChartDegree + 1>, kChartDegree + 1>;

constexpr std::array<PowerWeights, kChartDegree + 1> kPowerOfBezier = [] {
  std::array<PowerWeights, kChartDegree + 1> all{};
  for (int n = 0; n <= kChartDegree; ++n)
    for (int k = 0; k <= n; ++k)
      for (int i = 0; i <= n; ++i) {
        double sum = 0;
        for (int d = std::max(0, i - (n - k)); d <= std::min(i, k); ++d)
          sum += ((k - d) % 2 == 0 ? 1 : -1) * binomial(k, d) * binomial(n - k, i - d);
        all[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] =
            sum * binomial(n, k) / static_cast<double>(1 << n);
      }
  return all;
}();

// Of points less the first one; of degree N if that is not negative.
template <class Point, int N = -1>
[[gnu::always_inline]] inline void add_powers(std::span<const Point> points,
                                              std::array<Point, kSeriesDegree + 1>& terms) {
  const std::size_t n = N < 0 ? points.size() - 1 : N;
  std::array<Point, kChartDegree + 1> p;
  for (std::size_t i = 1; i <= n; ++i) p[i] = points[i] - points[0];
  for (std::size_t k = 0; k <= n; ++k)
    for (std::size_t i = 1; i <= n; ++i) terms[k] += kPowerOfBezier[n][k][i] * p[i];
  terms[0] += points[0];
}

template <class Point>
[[gnu::always_inline]] inline PowerSeries<Point> powers_of(std::span<const Point> points) {
  assert(points.size() <= kChartDegree + 1);
  PowerSeries<Point> result;
  points.size() == kLinearDegree + 1 ? add_powers<Point, kLinearDegree>(points, result.terms)
                                     : add_powers<Point>(points, result.terms);
  return result;
}

}  // namespace

BLOSSOM_HOT PowerSeries<double> power_series(std::span<const double> points) {
  return powers_of(points);
}

BLOSSOM_HOT PowerSeries<Vec3> power_series(std::span<const Vec3> points) {
  return powers_of(points);
}

BLOSSOM_HOT SeriesForm bezier_form(const PowerSeries<Vec3>& series, std::size_t degree) {
  return degree <= kShortSeriesDegree ? bezier_form_of<kShort>(series)
                                      : bezier_form_of<kLong>(series);
}

ImageSeries image_series(const RationalBezierPatch& patch, const Vec3& origin,
                         const PowerSeries<double>& u, const PowerSeries<double>& v,
                         double negligible, std::size_t degree) {
  Net net;
  make_net(patch, origin, net);
  const double size = std::max(std::max(net.size[0], net.size[1]), net.size[2]);
  const ChartStep in_u(u), in_v(v);
  const double limit = 0.25 * negligible / std::max(size, kNotZero);
  const double all_u = power(1 + 2 * in_u.reach, net.n);
  const double all_v = power(1 + 2 * in_v.reach, net.m);
  const Kept kept_u(net.n, in_u.reach, limit / all_v), kept_v(net.m, in_v.reach, limit / all_u);
  double rows[(kMaxDegree + 1) * (kMaxDegree + 1)], columns[(kMaxDegree + 1) * (kMaxDegree + 1)];
  make_taylor_weights(net.n, kept_u.highest, u.terms[0], rows);
  make_taylor_weights(net.m, kept_v.highest, v.terms[0], columns);
  Four a[(kMaxDegree + 1) * (kMaxDegree + 1)];
  make_coefficients(net, rows, kept_u.highest, columns, kept_v.highest, a);
  Four sum[kLong + 1] = {}, rest{};
  (degree <= kShortSeriesDegree ? compose_short : compose_long)(a, kept_u.highest, kept_v.highest,
                                                                in_u, in_v, sum, rest);
  rest += kOutside * (kept_u.rest * all_v + kept_v.rest * all_u) * net.size;

  Four slope_u = kOutside * kept_u.slope * all_v * net.size;
  Four slope_v = kOutside * kept_v.slope * all_u * net.size;
  const int width = kept_v.highest + 1;
  add_slopes(a, kept_u.highest, kept_v.highest, width, 1, in_u.reach, in_v.reach, slope_u);
  add_slopes(a, kept_v.highest, kept_u.highest, 1, width, in_v.reach, in_u.reach, slope_v);

  double absolute_u[kMaxDegree + 1], absolute_v[kMaxDegree + 1];
  make_absolute_weights(net.n, u.terms[0], in_u.reach, absolute_u);
  make_absolute_weights(net.m, v.terms[0], in_v.reach, absolute_v);
  Four local{};
  make_local_size(net, absolute_u, absolute_v, local);

  // Longest chain of roundings: weights 4 (n + m), sums n + m, powers of v and Horner 9 (n + m).
  const double chain = (16 * (net.n + net.m) + 64) * kUnitRoundoff;
  const auto plain = [](const Four& f) { return Vec4{f[0], f[1], f[2], f[3]}; };
  ImageSeries result{{}, plain(slope_u), plain(slope_v), plain(chain * local), plain(local)};
  for (std::size_t k = 0; k <= kLong; ++k) result.image.terms[k] = plain(sum[k]);
  result.image.rest = plain(rest);
  return result;
}

}  // namespace blossom
