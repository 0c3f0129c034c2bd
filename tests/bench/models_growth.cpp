// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/models_growth.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/intersection.h"
#include "core/base/parallel.h"
#include "core/forms/surface.h"
#include "core/surface_intersection.h"
#include "tests/bench/models_measure.h"

namespace blossom::bench {
namespace {

constexpr int kRounds = 5;
constexpr int kThreadRounds = 15;

// Bezier points of one cubic span of the uniform B-spline with coefficients f(i), i = 0..3.
void to_bezier(const double (&f)[4], double (&b)[4]) {
  b[0] = (f[0] + 4 * f[1] + f[2]) / 6;
  b[1] = (2 * f[1] + f[2]) / 3;
  b[2] = (f[1] + 2 * f[2]) / 3;
  b[3] = (f[1] + 4 * f[2] + f[3]) / 6;
}

using Height = std::function<double(double, double)>;

// A bicubic C2 B-spline height field over the unit square with n x n spans; control heights are
// samples of a smooth function, so that the shape does not depend on n.
BezierSurface height_field(int n, const Height& height) {
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

// Bumps of both signs, m in each direction: they cross half of their height in m^2 / 2 loops.
BezierSurface bumps(int spans, int m) {
  return height_field(spans, [m](double u, double v) {
    return 0.2 / m * std::sin(std::numbers::pi * m * u) * std::sin(std::numbers::pi * m * v);
  });
}

BezierSurface flat(double height) {
  BezierSurface surface = height_field(1, wave);
  for (Vec4& p : surface.patches(0, 0).points.values()) p[2] = height;
  return surface;
}

// A family of pairs of one size: what there is, what of it the curves meet, and what comes out.
struct Growth {
  const char* family = "";
  int size = 0;
  std::size_t all = 0;
  std::size_t met = 0;
  std::size_t output = 0;  // poles of curves
  std::size_t curves = 0;
  double seconds = 1e300;
  Status status = Status::Complete;
};

std::size_t patches_met(const SurfaceIntersection& found, int n, int m) {
  constexpr int kSamples = 4000;
  std::vector<char> a(static_cast<std::size_t>(n * n)), b(static_cast<std::size_t>(m * m));
  const auto mark = [](std::vector<char>& met, int count, const Vec2& uv) {
    const auto place = [&](double x) {
      return std::clamp(static_cast<int>(x * count), 0, count - 1);
    };
    met[static_cast<std::size_t>(place(uv[0]) * count + place(uv[1]))] = 1;
  };
  for (const IntersectionCurve& curve : found.curves)
    for (int i = 0; i <= kSamples; ++i) {
      const double t = at(curve.curve.domain(), static_cast<double>(i) / kSamples);
      mark(a, n, point_at(curve.chart_a, t));
      mark(b, m, point_at(curve.chart_b, t));
    }
  return static_cast<std::size_t>(std::count(a.begin(), a.end(), 1) +
                                  std::count(b.begin(), b.end(), 1));
}

void add_output(const SurfaceIntersection& found, Growth& growth) {
  growth.curves += found.curves.size();
  for (const IntersectionCurve& curve : found.curves) growth.output += curve.curve.points.size();
}

Growth of_surfaces(const char* family, int size, const BezierSurface& a, const BezierSurface& b) {
  IntersectionOptions options;
  options.threads = 1;
  Growth growth{family, size};
  growth.all = a.patches.values().size() + b.patches.values().size();
  for (int round = 0; round < kRounds; ++round) {
    const double start = processor_seconds();
    const SurfaceIntersection found = intersect(a, b, options);
    growth.seconds = std::min(growth.seconds, processor_seconds() - start);
    if (round > 0) continue;
    growth.status = found.status;
    growth.met = patches_met(found, a.patches.rows(), b.patches.rows());
    add_output(found, growth);
  }
  return growth;
}

// A height field of 4 n x 4 n spans as n x n faces, wider by a part of itself: so borders of one
// field do not lie over those of another.
std::vector<TopoDS_Face> faces_of_field(int n, const Height& height, double wider) {
  BezierSurface whole = height_field(4 * n, height);
  for (RationalBezierPatch& patch : whole.patches.values())
    for (Vec4& p : patch.points.values())
      for (int k = 0; k < 2; ++k) p[k] += wider * (p[k] - 0.47);
  std::vector<TopoDS_Face> faces;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      BezierSurface part;
      part.patches = Grid<RationalBezierPatch>(4, 4);
      for (int k = 0; k <= 4; ++k) {
        part.u_knots.push_back(whole.u_knots[static_cast<std::size_t>(4 * i + k)]);
        part.v_knots.push_back(whole.v_knots[static_cast<std::size_t>(4 * j + k)]);
      }
      for (int k = 0; k < 16; ++k)
        part.patches(k / 4, k % 4) = whole.patches(4 * i + k / 4, 4 * j + k % 4);
      faces.push_back(BRepBuilderAPI_MakeFace(occt::to_occt(part), 1e-7).Face());
    }
  return faces;
}

Growth of_faces(int n) {
  const std::vector<TopoDS_Face> a = faces_of_field(n, wave, 0);
  const std::vector<TopoDS_Face> b = faces_of_field(n, saddle, 0.037);
  IntersectionOptions options;
  options.threads = 1;
  Growth growth{"faces", n};
  growth.all = a.size() + b.size();
  for (int round = 0; round < kRounds; ++round) {
    const double start = processor_seconds();
    const occt::ShapeIntersection found = occt::intersect(a, b, options);
    growth.seconds = std::min(growth.seconds, processor_seconds() - start);
    if (round > 0) continue;
    growth.status = found.status;
    growth.met = static_cast<std::size_t>(found.face_pairs);
    for (const occt::FaceIntersection& pair : found.pairs) add_output(pair.found, growth);
  }
  return growth;
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
  constexpr long kSteps = 5'000'000;
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

double clock_seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

IntersectionOptions with(int threads) {
  IntersectionOptions options;
  options.threads = threads;
  return options;
}

ThreadJob of_spans(int n) {
  return {std::to_string(n) + " x " + std::to_string(n) + " spans",
          [a = height_field(n, wave), b = height_field(n, saddle)](int threads) {
            intersect(a, b, with(threads));
          }};
}

std::vector<ThreadJob> large_fields() {
  std::vector<ThreadJob> jobs{of_spans(64), of_spans(256)};
  jobs.push_back({"64 x 64 spans, 128 loops", [a = bumps(64, 16), b = flat(0.1 / 16)](int threads) {
                    intersect(a, b, with(threads));
                  }});
  jobs.push_back({"1024 faces with as many",
                  [a = faces_of_field(32, wave, 0), b = faces_of_field(32, saddle, 0.037)](
                      int threads) { occt::intersect(a, b, with(threads)); }});
  return jobs;
}

// A line each, and the exponents against all there is and against what is met and comes out.
void print_family(const std::vector<Growth>& rows, std::ofstream& table) {
  std::vector<double> all, matter, seconds;
  for (const Growth& g : rows) {
    std::printf("%-9s %4d %8zu %8zu %8zu %8zu %10.5f %s\n", g.family, g.size, g.all, g.met,
                g.output, g.curves, g.seconds, to_string(g.status));
    table << g.family << "," << g.size << "," << g.all << "," << g.met << "," << g.output << ","
          << g.curves << "," << g.seconds << "," << to_string(g.status) << "\n";
    all.push_back(static_cast<double>(g.all));
    matter.push_back(static_cast<double>(g.met + g.output));
    seconds.push_back(g.seconds);
  }
  std::printf("%s: exponent against what is met and poles %.3f", rows[0].family,
              exponent(matter, seconds));
  if (all.front() < all.back()) std::printf(", against all %.3f", exponent(all, seconds));
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

void print_growth(const std::string& csv) {
  std::ofstream table;
  if (!csv.empty()) table.open(csv);
  table << "family,size,all,met,poles,curves,seconds,status\n";
  std::printf(
      "\nGrowth (least processor time of %d, one thread)\n%-9s %4s %8s %8s %8s %8s %10s %s\n",
      kRounds, "family", "size", "all", "met", "poles", "curves", "seconds", "status");
  std::vector<Growth> spans, faces, branches, alike;
  for (const int n : {8, 16, 32, 64})
    spans.push_back(of_surfaces("spans", n, height_field(n, wave), height_field(n, saddle)));
  print_family(spans, table);
  for (const int n : {2, 4, 8, 16}) faces.push_back(of_faces(n));
  print_family(faces, table);
  for (const int m : {2, 4, 8, 16})
    branches.push_back(of_surfaces("branches", m, bumps(64, m), flat(0.1 / m)));
  print_family(branches, table);
  for (const int m : {4, 8, 16, 32})  // 4 x 4 spans a bump: loops of one shape
    alike.push_back(of_surfaces("alike", m, bumps(4 * m, m), flat(0.1 / m)));
  print_family(alike, table);
}

void print_threads(const std::vector<ThreadJob>& more) {
  std::vector<ThreadJob> jobs = large_fields();
  jobs.insert(jobs.end(), more.begin(), more.end());
  start_threads(2);
  std::printf(
      "\nThreads (least seconds of the clock of %d rounds; multiply-adds: twice the work)\n"
      "%-28s %9s %9s %6s %14s %6s\n",
      kThreadRounds, "input", "1 thread", "2", "gain", "multiply-adds", "part");
  for (const ThreadJob& job : jobs) {
    double ours[2] = {1e300, 1e300}, base[2] = {1e300, 1e300};
    for (int round = 0; round < kThreadRounds; ++round)
      for (const int threads : {1, 2}) {
        double &own = ours[threads - 1], &plain = base[threads - 1];
        own = std::min(own, clock_seconds([&] { job.work(threads); }));
        plain = std::min(plain, clock_seconds([&] { multiply_add(threads); }));
      }
    const double gain = ours[0] / ours[1], most = 2 * base[0] / base[1];
    std::printf("%-28s %9.4f %9.4f %6.2f %14.2f %6.2f\n", job.name.c_str(), ours[0], ours[1], gain,
                most, gain / most);
    std::fflush(stdout);
  }
}

}  // namespace blossom::bench
