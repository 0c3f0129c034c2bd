// SPDX-License-Identifier: LGPL-2.1-or-later
// Rays and distances beside Open CASCADE, in one thread, on real models: those named on the command
// line before any option, else the teapot and a model of some 200 faces from the folder that
// BLOSSOM_TEST_DATA names.
//
// rays       the same rays in every iteration, from a sphere round the model at random points of
// its
//            box, beside IntCurvesFace_ShapeIntersector. Counters: rays per second of both, their
//            ratio; hits of both; rays with a hit that only one of them has; the largest distance
//            of a proven hit of ours from its ray or, by Open CASCADE's evaluation, from its
//            surface.
// distance   of the model to a copy of it beside it, and to points round it, beside
//            BRepExtrema_DistShapeShape. Counters: milliseconds of making shapes ready (points:
//            once for all, by either), of our question, of theirs, and their ratio without and with
//            the former; the relative width of our bounds, and the largest relative excess of ours
//            over theirs (negative: ours is less).
// centres    nearest points of the model to centres of curvature of its faces, ours alone: mean and
//            longest milliseconds of a question, those that ended without a proof.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Surface.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Lin.hxx>

#include "adapters/occt/distance.h"
#include "adapters/occt/ray_casting.h"
#include "adapters/occt/shapes.h"
#include "tests/support/models.h"
#include "tests/support/random.h"

namespace {

using namespace blossom;

constexpr int kRays = 2000;

// Of processor time: other work on the machine does not count.
double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::vector<Ray> rays_at(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  double low[3], high[3];
  box.Get(low[0], low[1], low[2], high[0], high[1], high[2]);
  testing::Random random = testing::seeded(1);
  std::vector<Ray> rays;
  for (int i = 0; i < kRays; ++i) {
    Vec3 target, away;
    double size = 0;
    for (int k = 0; k < 3; ++k) {
      target[k] = testing::uniform(random, low[k], high[k]);
      away[k] = testing::uniform(random, -1, 1);
      size = std::max(size, high[k] - low[k]);
    }
    const Vec3 origin = target + 2 * size * unit(away);
    rays.push_back({origin, unit(target - origin)});
  }
  return rays;
}

// How far a hit is from its ray and from the face's own surface, by Open CASCADE's evaluation.
double error_of(const Ray& ray, const occt::ShapeHit& found, const TopoDS_Face& face) {
  const RayHit& hit = found.hit;
  const gp_Pnt p = BRep_Tool::Surface(face)->Value(hit.uv[0], hit.uv[1]);
  const Vec3 on_surface{p.X(), p.Y(), p.Z()};
  return std::max(distance(on_surface, hit.point),
                  norm(cross(on_surface - ray.origin, ray.direction)));
}

struct Found {
  std::vector<std::vector<double>> parameters;  // of each ray, increasing
  std::size_t hits = 0;
  double seconds = 0;
};

Found by_blossom(const occt::ShapeRays& rays, const std::vector<Ray>& all, double& worst) {
  Found found;
  occt::ShapeRayQuery query(rays);
  const auto start = std::clock();
  for (const Ray& ray : all) found.hits += query.all_hits(ray).size();
  found.seconds = seconds_since(start);
  for (const Ray& ray : all) {
    found.parameters.emplace_back();
    for (const occt::ShapeHit& hit : query.all_hits(ray)) {
      found.parameters.back().push_back(hit.hit.parameter);
      if (hit.hit.status == Status::Complete)
        worst = std::max(
            worst, error_of(ray, hit, rays.faces()[static_cast<std::size_t>(hit.hit.surface)]));
    }
  }
  return found;
}

Found by_occt(IntCurvesFace_ShapeIntersector& intersector, const std::vector<Ray>& all) {
  Found found;
  const auto start = std::clock();
  for (const Ray& ray : all) {
    const gp_Lin line({ray.origin[0], ray.origin[1], ray.origin[2]},
                      {ray.direction[0], ray.direction[1], ray.direction[2]});
    intersector.Perform(line, 0, RealLast());
    found.parameters.emplace_back();
    for (int i = 1; i <= intersector.NbPnt(); ++i)
      found.parameters.back().push_back(intersector.WParameter(i));
  }
  found.seconds = seconds_since(start);
  for (auto& parameters : found.parameters) {
    std::sort(parameters.begin(), parameters.end());
    // A point on an edge is found once for each face.
    parameters.erase(std::unique(parameters.begin(), parameters.end(),
                                 [](double a, double b) { return b - a < 1e-6; }),
                     parameters.end());
    found.hits += parameters.size();
  }
  return found;
}

bool has(const std::vector<double>& all, double parameter) {
  return std::any_of(all.begin(), all.end(),
                     [&](double known) { return std::abs(known - parameter) < 1e-4; });
}

int missing(const Found& from, const Found& in) {
  int count = 0;
  for (std::size_t i = 0; i < in.parameters.size(); ++i)
    count += std::any_of(in.parameters[i].begin(), in.parameters[i].end(),
                         [&](double t) { return !has(from.parameters[i], t); });
  return count;
}

void cast_rays(benchmark::State& state, const std::string& file) {
  const occt::Model model = testing::repaired_model(file);
  const std::vector<Ray> all = rays_at(model.shape());
  const auto start = std::clock();
  const occt::ShapeRays rays(model.shape());
  state.counters["prepared_ms"] = 1e3 * seconds_since(start);
  IntCurvesFace_ShapeIntersector intersector;
  intersector.Load(model.shape(), Precision::Confusion());
  double ours = 0, theirs = 0, worst = 0;
  for (auto _ : state) {
    const Found a = by_blossom(rays, all, worst);
    const Found b = by_occt(intersector, all);
    ours += a.seconds;
    theirs += b.seconds;
    state.counters["blossom_hits"] = static_cast<double>(a.hits);
    state.counters["occt_hits"] = static_cast<double>(b.hits);
    state.counters["only_occt"] = missing(a, b);
    state.counters["only_blossom"] = missing(b, a);
  }
  const double count = static_cast<double>(state.iterations()) * kRays;
  state.counters["blossom_rays_per_s"] = count / ours;
  state.counters["occt_rays_per_s"] = count / theirs;
  state.counters["times_faster"] = theirs / ours;
  state.counters["worst_error"] = worst;
}

struct Compared {
  double prepared = 0, ours = 0, theirs = 0;  // seconds
  double width = 0;                           // of our bounds, relative
  double excess = -1;                         // of ours over theirs, relative

  void add(const occt::ShapeDistance& found, double value) {
    width = std::max(width, (found.upper - found.lower) / found.upper);
    excess = std::max(excess, found.upper / value - 1);
  }
};

void report(benchmark::State& state, const Compared& sum) {
  const auto rounds = static_cast<double>(state.iterations());
  state.counters["prepared_ms"] = 1e3 * sum.prepared / rounds;
  state.counters["blossom_ms"] = 1e3 * sum.ours / rounds;
  state.counters["occt_ms"] = 1e3 * sum.theirs / rounds;
  state.counters["times_faster"] = sum.theirs / sum.ours;
  state.counters["times_faster_from_scratch"] = sum.theirs / (sum.ours + sum.prepared);
  state.counters["width"] = sum.width;
  state.counters["excess"] = sum.excess;
}

void measure_copy(benchmark::State& state, const std::string& file) {
  const TopoDS_Shape shape = testing::repaired_model(file).shape();
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 2, 3)), 0.7);
  const double size = std::sqrt(box.SquareExtent());
  move.SetTranslation(gp_Vec(1.1 * size, 0.2 * size, 0.3 * size));
  const TopoDS_Shape copy = BRepBuilderAPI_Transform(shape, move * turn, true).Shape();
  Compared sum;
  for (auto _ : state) {
    const auto start = std::clock();
    const occt::MeasuredShape first(shape), second(copy);
    sum.prepared += seconds_since(start);
    const auto asked = std::clock();
    const occt::ShapeDistance found = occt::least_distance(first, second);
    sum.ours += seconds_since(asked);
    const auto middle = std::clock();
    BRepExtrema_DistShapeShape extrema(shape, copy);
    sum.theirs += seconds_since(middle);
    sum.add(found, extrema.Value());
  }
  report(state, sum);
}

void measure_points(benchmark::State& state, const std::string& file) {
  const TopoDS_Shape shape = testing::repaired_model(file).shape();
  const std::vector<Ray> rays = rays_at(shape);
  const occt::MeasuredShape measured(shape);
  BRepExtrema_DistShapeShape extrema;
  extrema.LoadS1(shape);
  Compared sum;
  std::size_t next = 0;
  for (auto _ : state) {
    const Vec3 p = point_at(rays[next++ % rays.size()], 0);
    const auto start = std::clock();
    const occt::ShapeDistance found = occt::nearest_point(measured, p);
    sum.ours += seconds_since(start);
    const auto middle = std::clock();
    extrema.LoadS2(BRepBuilderAPI_MakeVertex(gp_Pnt(p[0], p[1], p[2])).Vertex());
    extrema.Perform();
    sum.theirs += seconds_since(middle);
    sum.add(found, extrema.Value());
  }
  report(state, sum);
}

// Centres of curvature of the faces, from a few places of each: distances are nearly equal there
// all along a face.
std::vector<Vec3> centres_of(const TopoDS_Shape& shape) {
  constexpr double kFlat = 1e-6;
  std::vector<Vec3> centres;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(face.Current()));
    const Interval u{surface.FirstUParameter(), surface.LastUParameter()};
    const Interval v{surface.FirstVParameter(), surface.LastVParameter()};
    for (const double part : {0.1, 0.47}) {
      BRepLProp_SLProps place(surface, at(u, part), at(v, part), 2, kFlat);
      if (!place.IsCurvatureDefined()) continue;
      for (const double bend : {place.MinCurvature(), place.MaxCurvature()}) {
        if (std::abs(bend) < kFlat) continue;
        const gp_XYZ p = place.Value().XYZ() + place.Normal().XYZ() / bend;
        centres.push_back({p.X(), p.Y(), p.Z()});
      }
    }
  }
  return centres;
}

void measure_centres(benchmark::State& state, const std::string& file) {
  const TopoDS_Shape shape = testing::repaired_model(file).shape();
  const occt::MeasuredShape measured(shape);
  const std::vector<Vec3> centres = centres_of(shape);
  double longest = 0, all = 0, stopped = 0;
  for (auto _ : state) {
    stopped = 0;
    for (const Vec3& p : centres) {
      const auto start = std::clock();
      stopped += occt::nearest_point(measured, p).status == Status::Stopped;
      const double seconds = seconds_since(start);
      longest = std::max(longest, seconds);
      all += seconds;
    }
  }
  state.counters["questions"] = static_cast<double>(centres.size());
  state.counters["mean_ms"] = 1e3 * all / static_cast<double>(state.iterations() * centres.size());
  state.counters["longest_ms"] = 1e3 * longest;
  state.counters["stopped"] = stopped;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> files;
  int used = 1;
  for (; used < argc && argv[used][0] != '-'; ++used) files.push_back(argv[used]);
  argv[used - 1] = argv[0];
  argc -= used - 1;
  argv += used - 1;
  if (const char* data = std::getenv("BLOSSOM_TEST_DATA"); files.empty() && data != nullptr)
    for (const char* name : {"teapot.brep", "boxed_sphere.step"})
      files.push_back((std::filesystem::path(data) / "models" / name).string());
  for (const std::string& file : files) {
    const std::string name = "/" + std::filesystem::path(file).filename().string();
    benchmark::RegisterBenchmark(("queries/rays" + name).c_str(), cast_rays, file);
    benchmark::RegisterBenchmark(("queries/distance_copy" + name).c_str(), measure_copy, file);
    benchmark::RegisterBenchmark(("queries/distance_points" + name).c_str(), measure_points, file);
    benchmark::RegisterBenchmark(("queries/centres" + name).c_str(), measure_centres, file);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
