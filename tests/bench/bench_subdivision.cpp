// SPDX-License-Identifier: LGPL-2.1-or-later
// Bulk subdivision against its rivals on one core: time for a piece, share of the multiply-add
// peak, ratios. README.md says what the rows mean.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "core/blossom/patch_blossom.h"
#include "core/blossom/triangle_blossom.h"
#include "core/subdivision/bulk/bulk.h"
#include "core/subdivision/bulk/bulk_triangles.h"
#include "core/subdivision/subdivision_matrix.h"
#include "tests/bench/subdivision_rivals.h"

#ifdef BLOSSOM_BENCH_OCCT
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#endif

namespace blossom::bench {
namespace {

constexpr int kDegrees[] = {3, 5, 9};
constexpr int kPieces = 64;
constexpr int kPlanes = 3;
constexpr double kTolerance = 1e-7;  // of nets in [-1, 1]

const char* name_of(SimdLevel level) {
  switch (level) {
    case SimdLevel::Avx512: return "avx512";
    case SimdLevel::Avx2: return "avx2";
    case SimdLevel::Plain: break;
  }
  return "plain";
}

std::vector<SimdLevel> levels() {
  std::vector<SimdLevel> result;
  for (SimdLevel level : {SimdLevel::Avx512, SimdLevel::Avx2, SimdLevel::Plain})
    if (is_available(level)) result.push_back(level);
  return result;
}

LaneVector random_values(std::size_t count, double low, double high, unsigned seed) {
  std::mt19937_64 random(seed);
  LaneVector values(count);
  for (double& value : values)
    value = low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  return values;
}

NetShape square(int degree) { return {degree + 1, degree + 1, kPlanes}; }

// One patch and pieces of it, a quarter wide.
struct Input {
  explicit Input(int degree)
      : shape(square(degree)),
        net(random_values(static_cast<std::size_t>(shape.size()), -1, 1, 1)),
        u_from(random_values(kPieces, 0.01, 0.7, 2)),
        v_from(random_values(kPieces, 0.01, 0.7, 3)),
        u_to(u_from),
        v_to(v_from),
        out(kPieces * static_cast<std::size_t>(shape.size())) {
    for (double& t : u_to) t += 0.25;
    for (double& t : v_to) t += 0.25;
  }
  PieceEnds ends() const { return {u_from, u_to, v_from, v_to}; }
  Interval u(std::size_t k) const { return {u_from[k], u_to[k]}; }
  Interval v(std::size_t k) const { return {v_from[k], v_to[k]}; }

  NetShape shape;
  LaneVector net, u_from, v_from, u_to, v_to, out;
};

// The other form of the net, and the sizes of both.
struct Forms {
  explicit Forms(const Input& in) : coefficients(in.net.size()) {
    monomial_from_bezier(in.shape, in.net.data(), coefficients.data());
    sizes = net_sizes(in.shape, in.net, coefficients);
  }
  BothForms view(const Input& in) const { return {in.net, coefficients, sizes}; }

  LaneVector coefficients;
  NetSizes sizes;
};

// Pieces done by one iteration of each benchmark, by name.
std::map<std::string, double>& pieces_of_name() {
  static std::map<std::string, double> pieces;
  return pieces;
}

void add(const std::string& name, double pieces, std::function<void()> work) {
  pieces_of_name()[name] = pieces;
  benchmark::RegisterBenchmark(name.c_str(), [work, name](benchmark::State& state) {
    for (auto _ : state) {
      work();
      benchmark::ClobberMemory();
    }
    state.counters["pieces"] = pieces_of_name().at(name);
  });
}

std::string name(const std::string& what, int degree, const std::string& how = "") {
  return what + "/" + std::to_string(degree) + (how.empty() ? "" : "/" + how);
}

void add_peaks() {
  for (SimdLevel level : levels()) {
    const Peak peak = rivals(level).peak;
    const double count = static_cast<double>(peak(1000));
    add(std::string("peak/") + name_of(level), count,
        [peak] { benchmark::DoNotOptimize(peak(1000)); });
  }
}

void add_grids(int degree) {
  const NetShape shape = square(degree);
  for (SimdLevel level : levels()) {
    const auto net = random_values(static_cast<std::size_t>(shape.size()), -1, 1, 1);
    for (int depth : {3, 4}) {
      const int cells = 1 << depth;
      LaneVector sheet(SheetShape{shape, cells, cells}.size());
      add(name("grid" + std::to_string(cells), degree, name_of(level)), cells * cells,
          [=]() mutable {
            const MatrixStack& stack = dyadic_matrices(degree, depth);
            subdivide_grid(shape, net, stack, stack, sheet, level);
          });
    }
    const auto nets = random_values(4 * block_size(shape), -1, 1, 1);
    LaneVector sheets(nets.size() * 4);
    add(name("blocks", degree, name_of(level)), 4 * kLanes * 4, [=]() mutable {
      const MatrixStack& stack = dyadic_matrices(degree, 1);
      subdivide_blocks(shape, nets, stack, stack, sheets, level);
    });
    LaneVector single(nets.size());
    add(name("one_cell_of_blocks", degree, name_of(level)), 4 * kLanes, [=]() mutable {
      static const std::map<int, MatrixStack> stacks = [] {
        std::map<int, MatrixStack> made;
        const double cuts[] = {0.3, 0.6};
        for (int n : kDegrees) made.emplace(n, MatrixStack(n, cuts));
        return made;
      }();
      subdivide_blocks(shape, nets, stacks.at(degree), stacks.at(degree), single, level);
    });
  }
}

void add_pieces(int degree) {
  for (SimdLevel level : levels()) {
    add(name("pieces_matrices", degree, name_of(level)), kPieces,
        [in = Input(degree), level]() mutable {
          subdivide_pieces(NetForm::Bezier, in.shape, in.net, in.ends(), in.out, level);
        });
    add(name("pieces_pyramid", degree, name_of(level)), kPieces,
        [in = Input(degree), level]() mutable {
          subdivide_pieces_by_pyramid(in.shape, in.net, in.ends(), in.out, level);
        });
    add(name("pieces_within", degree, name_of(level)), kPieces,
        [in = Input(degree), forms = Forms(Input(degree)), level]() mutable {
          subdivide_pieces_within(kTolerance, in.shape, forms.view(in), in.ends(), in.out, level);
        });
    add(name("de_casteljau_lanes", degree, name_of(level)), kPieces,
        [in = Input(degree), level]() mutable {
          rivals(level).de_casteljau(in.shape, in.net.data(), in.ends(), in.out.data());
        });
    add(name("single", degree, name_of(level)), kPieces, [in = Input(degree), level]() mutable {
      const std::size_t size = static_cast<std::size_t>(in.shape.size());
      for (std::size_t k = 0; k < kPieces; ++k)
        subdivide_piece(NetForm::Bezier, in.shape, in.net, in.u(k), in.v(k),
                        std::span(in.out).subspan(k * size, size), level);
    });
  }
  add(name("de_casteljau_plain", degree), kPieces, [in = Input(degree)]() mutable {
    for (std::size_t k = 0; k < kPieces; ++k)
      plain_de_casteljau(in.shape, in.net.data(), in.u(k), in.v(k),
                         in.out.data() + k * static_cast<std::size_t>(in.shape.size()));
  });
}

// The values of a net as the coefficients of a patch.
MonomialPatch coefficients_of(const NetShape& shape, const LaneVector& net) {
  MonomialPatch patch{Grid<Vec3>(shape.rows, shape.columns)};
  for (int k = 0; k < shape.size(); ++k)
    patch.coefficients
        .values()[static_cast<std::size_t>(k % shape.plane_size())][k / shape.plane_size()] =
        net[static_cast<std::size_t>(k)];
  return patch;
}

void add_closed_forms(int degree) {
  const Input in(degree);
  const MonomialPatch patch = coefficients_of(in.shape, in.net);
  const BezierPatch printed = printed_points(patch, in.u(0), in.v(0)),
                    closed = bezier_points(patch, in.u(0), in.v(0));
  for (std::size_t k = 0; k < closed.points.values().size(); ++k)
    if (distance(printed.points.values()[k], closed.points.values()[k]) > 1e-12) {
      std::fprintf(stderr, "formula (9) and its factors differ\n");
      std::exit(1);
    }
  add(name("printed_9", degree), kPieces, [patch, in] {
    for (std::size_t k = 0; k < kPieces; ++k)
      benchmark::DoNotOptimize(printed_points(patch, in.u(k), in.v(k)));
  });
  add(name("closed_form", degree), kPieces, [patch, in] {
    for (std::size_t k = 0; k < kPieces; ++k)
      benchmark::DoNotOptimize(bezier_points(patch, in.u(k), in.v(k)));
  });
}

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void add_eigen(int degree) {
  add(name("eigen", degree), kPieces, [in = Input(degree)]() mutable {
    const int n = in.shape.rows;
    for (std::size_t k = 0; k < kPieces; ++k) {
      const Grid<double> su = subdivision_matrix(n - 1, in.u(k)),
                         sv = subdivision_matrix(n - 1, in.v(k));
      const Eigen::Map<const RowMajor> u(su.values().data(), n, n), v(sv.values().data(), n, n);
      for (int plane = 0; plane < kPlanes; ++plane) {
        const int from = plane * n * n;
        const Eigen::Map<const RowMajor> net(in.net.data() + from, n, n);
        Eigen::Map<RowMajor>(in.out.data() + from, n, n) = u * net * v.transpose();
      }
    }
  });
}

#ifdef BLOSSOM_BENCH_OCCT
void add_occt(int degree) {
  const Input in(degree);
  TColgp_Array2OfPnt poles(1, degree + 1, 1, degree + 1);
  const auto value = [&](int plane, int i, int j) {
    return in.net[static_cast<std::size_t>((plane * (degree + 1) + i) * (degree + 1) + j)];
  };
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      poles(i + 1, j + 1) = gp_Pnt(value(0, i, j), value(1, i, j), value(2, i, j));
  const Handle(Geom_BezierSurface) surface = new Geom_BezierSurface(poles);
  add(name("occt_copy", degree), kPieces, [surface] {
    for (int k = 0; k < kPieces; ++k) benchmark::DoNotOptimize(surface->Copy());
  });
  add(name("occt_copy_and_segment", degree), kPieces, [surface, in] {
    for (std::size_t k = 0; k < kPieces; ++k) {
      const auto copy = Handle(Geom_BezierSurface)::DownCast(surface->Copy());
      copy->Segment(in.u_from[k], in.u_to[k], in.v_from[k], in.v_to[k]);
    }
  });
}
#endif

void add_triangles() {
  constexpr int kDegree = 3, kTriangles = 32;
  const NetShape shape = square(kDegree);
  const auto net = random_values(static_cast<std::size_t>(shape.size()), -1, 1, 1);
  const TrianglePlan plan(kDegree, kDegree);
  std::vector<LaneVector> lists;
  for (unsigned k = 0; k < 6; ++k) lists.push_back(random_values(kTriangles, 0, 1, 10 + k));
  LaneVector out(kTriangles * static_cast<std::size_t>(kPlanes * plan.points()));
  const auto triangles = [](const std::vector<LaneVector>& l) {
    return TriangleLists{l[0], l[1], l[2], l[3], l[4], l[5]};
  };
  for (SimdLevel level : levels()) {
    add(name("triangles_t4", 2 * kDegree, name_of(level)), kTriangles, [=]() mutable {
      subdivide_triangles(NetForm::Bezier, plan, kPlanes, net, triangles(lists), out, level);
    });
    add(name("triangles_t1", 2 * kDegree, name_of(level)), kTriangles, [=]() mutable {
      subdivide_triangles_by_differences(plan, kPlanes, net, triangles(lists), out, level);
    });
  }
  const MonomialPatch patch = coefficients_of(shape, net);
  add(name("triangle_printed_14", 2 * kDegree), 1, [=] {
    benchmark::DoNotOptimize(
        bezier_points(patch, TriangleCorners{Vec2{0.1, 0.2}, Vec2{0.7, 0.3}, Vec2{0.4, 0.9}}));
  });
}

// Keeps the best time of each benchmark, in nanoseconds for a piece.
class BestTimes : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const std::string key = run.run_name.function_name;
      const double time = run.cpu_accumulated_time * 1e9 / static_cast<double>(run.iterations) /
                          pieces_of_name().at(key);
      const auto [place, is_new] = best_.try_emplace(key, time);
      if (!is_new) place->second = std::min(place->second, time);
    }
  }
  /// Not a number where the benchmark did not run.
  double operator()(const std::string& key) const {
    const auto found = best_.find(key);
    return found != best_.end() ? found->second : std::nan("");
  }

 private:
  std::map<std::string, double> best_;
};

void print_peaks(const BestTimes& best) {
  for (SimdLevel level : levels())
    std::printf("peak %-7s %6.1f G multiply-adds/s\n", name_of(level),
                1 / best(std::string("peak/") + name_of(level)));
}

// Nominal multiply-adds of a sub-patch: two full products.
double multiply_adds_of(int degree) {
  const double n = degree + 1;
  return 2 * n * n * n * kPlanes;
}

void print_shared(const BestTimes& best, int degree, SimdLevel level) {
  const std::string how = name_of(level);
  const double peak = multiply_adds_of(degree) * best("peak/" + how);
  std::printf("(%d,%d) %-7s", degree, degree, how.c_str());
  for (const char* what : {"grid8", "grid16", "blocks", "one_cell_of_blocks"}) {
    const double time = best(name(what, degree, how));
    std::printf("  %s %.1f ns, %.0f %% of peak", what, time, 100 * peak / time);
  }
  std::printf("\n");
}

// Which path the pieces of a random net take.
void print_choice(int degree) {
  const Input in(degree);
  const NetSizes sizes = Forms(in).sizes;
  for (const double tolerance : {1e-7, 1e-9, 1e-11}) {
    int pyramid = 0;
    for (std::size_t k = 0; k < kPieces; ++k)
      pyramid += piece_path(degree, degree, sizes, in.u(k), in.v(k), tolerance) ==
                 PiecePath::MonomialPyramid;
    std::printf("(%d,%d) within %.0e: %d of %d pieces by the pyramid\n", degree, degree, tolerance,
                pyramid, kPieces);
  }
}

void print_own(const BestTimes& best, int degree, SimdLevel level) {
  const std::string how = name_of(level);
  const double plain = best(name("de_casteljau_plain", degree));
  const double lanes = best(name("de_casteljau_lanes", degree, how));
  const double segment =
      best(name("occt_copy_and_segment", degree)) - best(name("occt_copy", degree));
  std::printf("(%d,%d) %-7s (9) printed %.0f, closed form %.0f, ", degree, degree, how.c_str(),
              best(name("printed_9", degree)), best(name("closed_form", degree)));
  std::printf("Segment %.0f, plain dC %.0f, lane dC %.1f, Eigen %.0f ns\n", segment, plain, lanes,
              best(name("eigen", degree)));
  for (const char* what : {"pieces_matrices", "pieces_pyramid", "pieces_within", "single"}) {
    const double time = best(name(what, degree, how));
    std::printf("  %-16s %7.1f ns: Segment x%.0f, plain dC x%.1f, lane dC x%.2f\n", what, time,
                segment / time, plain / time, lanes / time);
  }
}

void print_triangles(const BestTimes& best) {
  const double printed = best(name("triangle_printed_14", 6));
  std::printf("triangle of degree 6, formula (14) as printed: %.0f ns\n", printed);
  for (SimdLevel level : levels())
    for (const char* what : {"triangles_t4", "triangles_t1"}) {
      const double time = best(name(what, 6, name_of(level)));
      std::printf("  %-13s %-7s %7.1f ns, x%.0f\n", what, name_of(level), time, printed / time);
    }
}

void register_all() {
  add_peaks();
  for (int degree : kDegrees) {
    add_grids(degree);
    add_pieces(degree);
    add_closed_forms(degree);
    add_eigen(degree);
#ifdef BLOSSOM_BENCH_OCCT
    add_occt(degree);
#endif
  }
  add_triangles();
}

void print_all(const BestTimes& best) {
  std::printf("\nBest times for a piece; all (n, n) nets of %d coordinates.\n", kPlanes);
  print_peaks(best);
  for (SimdLevel level : levels())
    for (int degree : kDegrees) print_shared(best, degree, level);
  for (SimdLevel level : levels())
    for (int degree : kDegrees) print_own(best, degree, level);
  for (int degree : kDegrees) print_choice(degree);
  print_triangles(best);
}

}  // namespace
}  // namespace blossom::bench

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  blossom::bench::register_all();
  blossom::bench::BestTimes best;
  benchmark::RunSpecifiedBenchmarks(&best);
  blossom::bench::print_all(best);
}
