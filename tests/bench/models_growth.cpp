// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/models_growth.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <thread>
#include <vector>

#include "core/base/parallel.h"
#include "core/forms/surface.h"
#include "core/surface_intersection.h"
#include "tests/bench/models_measure.h"

namespace blossom::bench {
namespace {

constexpr int kRounds = 5;

// Bezier points of one cubic span of the uniform B-spline with coefficients f(i), i = 0..3.
void to_bezier(const double (&f)[4], double (&b)[4]) {
  b[0] = (f[0] + 4 * f[1] + f[2]) / 6;
  b[1] = (2 * f[1] + f[2]) / 3;
  b[2] = (f[1] + 2 * f[2]) / 3;
  b[3] = (f[1] + 4 * f[2] + f[3]) / 6;
}

// A bicubic C2 B-spline height field over the unit square with n x n spans; control heights are
// samples of a smooth function, so that the shape does not depend on n.
BezierSurface height_field(int n, double (*height)(double, double)) {
  BezierSurface surface;
  for (int i = 0; i <= n; ++i) surface.u_knots.push_back(static_cast<double>(i) / n);
  surface.v_knots = surface.u_knots;
  surface.patches = Grid<RationalBezierPatch>(n, n);
  const double h = 1.0 / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      double rows[4][4];
      for (int k = 0; k < 4; ++k) {
        double f[4];
        for (int l = 0; l < 4; ++l) f[l] = height((i + k - 1) * h, (j + l - 1) * h);
        to_bezier(f, rows[k]);
      }
      Grid<Vec4> net(4, 4);
      for (int l = 0; l < 4; ++l) {
        const double f[4] = {rows[0][l], rows[1][l], rows[2][l], rows[3][l]};
        double b[4];
        to_bezier(f, b);
        for (int k = 0; k < 4; ++k) net(k, l) = {(i + k / 3.0) * h, (j + l / 3.0) * h, b[k], 1};
      }
      surface.patches(i, j).points = std::move(net);
    }
  return surface;
}

double wave(double u, double v) {
  return 0.08 * std::sin(5 * u + 1) * std::cos(4 * v) + 0.3 * (u - 0.45);
}
double saddle(double u, double v) { return 0.1 * (u - 0.5) * (v - 0.4) + 0.03 * std::cos(6 * v); }

struct Growth {
  int spans = 0;
  double seconds = 0;
  std::size_t curves = 0;
  std::size_t met = 0;  // patches of either surface that the curve runs through
  std::size_t output = 0;
  Status status = Status::Complete;
};

std::size_t patches_met(const SurfaceIntersection& found, int n) {
  constexpr int kSamples = 4000;
  std::vector<char> a(static_cast<std::size_t>(n * n)), b(a);
  const auto mark = [n](std::vector<char>& met, const Vec2& uv) {
    const auto place = [n](double x) { return std::clamp(static_cast<int>(x * n), 0, n - 1); };
    met[static_cast<std::size_t>(place(uv[0]) * n + place(uv[1]))] = 1;
  };
  for (const IntersectionCurve& curve : found.curves)
    for (int i = 0; i <= kSamples; ++i) {
      const double t = at(curve.curve.domain(), static_cast<double>(i) / kSamples);
      mark(a, point_at(curve.chart_a, t));
      mark(b, point_at(curve.chart_b, t));
    }
  return static_cast<std::size_t>(std::count(a.begin(), a.end(), 1) +
                                  std::count(b.begin(), b.end(), 1));
}

Growth growth_of(int n) {
  const BezierSurface a = height_field(n, wave), b = height_field(n, saddle);
  IntersectionOptions options;
  options.threads = 1;
  Growth result{n, 1e300};
  for (int round = 0; round < kRounds; ++round) {
    const double start = processor_seconds();
    const SurfaceIntersection found = intersect(a, b, options);
    result.seconds = std::min(result.seconds, processor_seconds() - start);
    result.status = found.status;
    result.curves = found.curves.size();
    result.output = 0;
    for (const IntersectionCurve& curve : found.curves) result.output += curve.curve.points.size();
    if (round == 0) result.met = patches_met(found, n);
  }
  return result;
}

// Slope of log y against log x, by least squares.
double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0, mean_y = 0, above = 0, below = 0;
  const double count = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / count;
    mean_y += std::log(y[i]) / count;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    above += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
    below += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
  }
  return above / below;
}

// What a core does at best: dependent multiply-adds, a fixed number by each thread.
void multiply_add(int threads) {
  constexpr long kSteps = 60'000'000;
  std::vector<std::thread> all;
  for (int k = 0; k < threads; ++k)
    all.emplace_back([k] {
      double x[4] = {1.0 + k, 2, 3, 4};
      for (long i = 0; i < kSteps; ++i)
        for (double& y : x) y = y * 0.999999 + 1e-6;
      volatile double kept = x[0] + x[1] + x[2] + x[3];
      static_cast<void>(kept);
    });
  for (std::thread& thread : all) thread.join();
}

double clock_seconds(const auto& work) {
  double best = 1e300;
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

}  // namespace

void print_growth() {
  std::printf("\nGrowth (least processor time of %d, one thread)\n%-10s %10s %8s %8s %8s %s\n",
              kRounds, "spans", "seconds", "curves", "met", "poles", "status");
  std::vector<double> spans, matter, seconds;
  for (const int n : {8, 16, 32, 64}) {
    const Growth g = growth_of(n);
    std::printf("%3d x %-4d %10.5f %8zu %8zu %8zu %s\n", n, n, g.seconds, g.curves, g.met, g.output,
                to_string(g.status));
    std::fflush(stdout);
    spans.push_back(2.0 * n * n);
    matter.push_back(static_cast<double>(g.met + g.output));
    seconds.push_back(g.seconds);
  }
  std::printf("exponent against all spans %.3f, against spans met and poles %.3f\n",
              exponent(spans, seconds), exponent(matter, seconds));
}

void print_threads() {
  const BezierSurface a = height_field(64, wave), b = height_field(64, saddle);
  const auto ours = [&](int threads) {
    IntersectionOptions options;
    options.threads = threads;
    start_threads(threads);
    return clock_seconds([&] { intersect(a, b, options); });
  };
  const double one = ours(1), two = ours(2);
  const double base_one = clock_seconds([] { multiply_add(1); });
  const double base_two = clock_seconds([] { multiply_add(2); });
  std::printf("\nThreads (least time of the clock of %d)\n", kRounds);
  std::printf("intersection, 64 x 64 spans: 1 thread %.4f s, 2 threads %.4f s, %.2f times faster\n",
              one, two, one / two);
  std::printf("multiply-adds: 1 thread %.4f s, 2 threads with twice the work %.4f s, %.2f times\n",
              base_one, base_two, 2 * base_one / base_two);
}

}  // namespace blossom::bench
