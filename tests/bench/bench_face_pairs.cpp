// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of free-form faces of real models: what Blossom finds against an independent point oracle,
// and its time beside BRepAlgoAPI_Section and GeomAPI_IntSS.
//
//   bench_face_pairs [--seed N] [--pairs N] [--limit SECONDS] [--peers] [--keep FOLDER] FILE...
//
// A file with exactly two faces is itself the pair; of others pairs are drawn. Prints a line a
// pair and a summary; the exit code tells whether a point was missed or a gap was above the
// stated deviation. --keep writes the pairs that failed or did not end as BREP files.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Section.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_IntSS.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/shapes.h"
#include "core/math/segment.h"
#include "tests/bench/command_line.h"
#include "tests/bench/face_pairs_draw.h"
#include "tests/bench/face_pairs_oracle.h"
#include "tests/support/models.h"

namespace blossom::bench {
namespace {

constexpr double kNear = 2e-3;         // of the size: a point so near a curve is on it
constexpr double kTransversal = 0.02;  // sine of the least angle at which a point counts
constexpr int kGapSamples = 51;        // of a curve

struct Outcome {
  Status status = Status::Complete;
  std::size_t curves = 0, points = 0, places = 0;
  std::size_t wanted = 0, missed = 0;
  double gap = 0;       // largest distance of a curve to its images, model units
  double gap_over = 0;  // the same over the stated one
  double seconds = 0, section = 0, intss = 0;
};

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool within(const Place& place, const Vec3& p, double margin) {
  for (int k = 0; k < 3; ++k)
    if (p[k] < place.box_low[k] - margin || p[k] > place.box_high[k] + margin) return false;
  return true;
}

// True if a curve or a listed place tells of the point.
bool is_reported(const occt::ShapeIntersection& found, const Vec3& p, double near,
                 double tolerance) {
  for (const occt::FaceIntersection& pair : found.pairs) {
    for (const IntersectionCurve& curve : pair.found.curves)
      for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i)
        if (segment_gap(p, curve.samples[i].point, curve.samples[i + 1].point) <= near) return true;
    for (const Place& place : pair.found.places)
      if (within(place, p, tolerance)) return true;
  }
  return false;
}

// Of the written curves to both surfaces, by Open CASCADE's evaluation.
void measure_gaps(const occt::ShapeIntersection& found, const FacePair& faces, Outcome& outcome) {
  const BRepAdaptor_Surface a(faces.a, false), b(faces.b, false);
  for (const occt::FaceIntersection& pair : found.pairs)
    for (const occt::EdgeCurves& edge : pair.edges)
      for (int i = 0; i < kGapSamples; ++i) {
        const double from = edge.curve->FirstParameter(), to = edge.curve->LastParameter();
        const double t = from + (to - from) * i / (kGapSamples - 1);
        const gp_Pnt p = edge.curve->Value(t);
        const gp_Pnt2d x = edge.pcurve_a->Value(t), y = edge.pcurve_b->Value(t);
        const double gap =
            std::max(p.Distance(a.Value(x.X(), x.Y())), p.Distance(b.Value(y.X(), y.Y())));
        outcome.gap = std::max(outcome.gap, gap);
        outcome.gap_over = std::max(outcome.gap_over, gap / edge.tolerance);
      }
}

Handle(Geom_Surface) cut_surface(const TopoDS_Face& face) {
  double u0, u1, v0, v1;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  return new Geom_RectangularTrimmedSurface(BRep_Tool::Surface(face), u0, u1, v0, v1);
}

void time_peers(const FacePair& faces, double tolerance, Outcome& outcome) {
  outcome.section = seconds_of([&] {
    BRepAlgoAPI_Section section(faces.a, faces.b, false);
    section.Approximation(true);
    section.ComputePCurveOn1(true);
    section.ComputePCurveOn2(true);
    section.Build();
  });
  outcome.intss = seconds_of(
      [&] { const GeomAPI_IntSS intss(cut_surface(faces.a), cut_surface(faces.b), tolerance); });
}

Outcome run(const FacePair& faces, const PairSettings& settings) {
  const double size = std::min(size_of(faces.a), size_of(faces.b));
  IntersectionOptions options;
  options.tolerances.point = std::max(1e-7, 1e-7 * size);
  options.time_limit = settings.limit;
  occt::ShapeIntersection found;
  Outcome outcome;
  outcome.seconds = seconds_of([&] { found = occt::intersect({faces.a}, {faces.b}, options); });
  outcome.status = found.status;
  for (const occt::FaceIntersection& pair : found.pairs) {
    outcome.curves += pair.found.curves.size();
    outcome.points += pair.found.points.size();
    outcome.places += pair.found.places.size();
  }
  for (const OraclePoint& point : common_points(faces.a, faces.b, size)) {
    if (point.sine < kTransversal) continue;
    ++outcome.wanted;
    const Vec3 p{point.point.X(), point.point.Y(), point.point.Z()};
    if (!is_reported(found, p, kNear * size, options.tolerances.point)) ++outcome.missed;
  }
  measure_gaps(found, faces, outcome);
  if (settings.peers) time_peers(faces, options.tolerances.point, outcome);
  return outcome;
}

struct Summary {
  std::size_t pairs = 0, complete = 0, stopped = 0, missed = 0, gaps = 0, refused = 0;
  std::vector<double> seconds, section, intss;
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void print(const std::string& name, const FacePair& faces, std::size_t number, const Outcome& o) {
  std::printf(
      "%-22s %s %2zu  %-9s %3zu curves %2zu points %3zu places  oracle %4zu missed %4zu  "
      "gap %.1e (%.2f of stated)  %8.4f s",
      name.c_str(), faces.kind.c_str(), number, to_string(o.status), o.curves, o.points, o.places,
      o.wanted, o.missed, o.gap, o.gap_over, o.seconds);
  if (o.section > 0) std::printf("  Section %.4f s  IntSS %.4f s", o.section, o.intss);
  std::printf("%s%s\n", o.missed > 0 ? "  MISSED" : "", o.gap_over > 1 ? "  GAP" : "");
  std::fflush(stdout);
}

void run_file(const std::string& file, const PairSettings& settings, Summary& summary) {
  const occt::Model model = testing::repaired_model(file);
  std::vector<FacePair> pairs;
  if (model.face_count() == 2) {
    pairs.push_back({"--", model.face(1), model.face(2)});
  } else {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 1; i <= model.face_count(); ++i) builder.Add(all, model.face(i));
    pairs = draw_pairs(all, settings.seed, settings.pairs);
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ++summary.pairs;
    try {
      const Outcome o = run(pairs[i], settings);
      print(std::filesystem::path(file).stem(), pairs[i], i, o);
      if (!settings.keep.empty() && (o.missed > 0 || o.gap_over > 1 || o.status == Status::Stopped))
        keep(settings.keep, std::filesystem::path(file).stem(), pairs[i], i);
      summary.complete += o.status == Status::Complete;
      summary.stopped += o.status == Status::Stopped;
      summary.missed += o.missed > 0;
      summary.gaps += o.gap_over > 1;
      summary.seconds.push_back(o.seconds);
      if (settings.peers) {
        summary.section.push_back(o.section);
        summary.intss.push_back(o.intss);
      }
    } catch (const std::exception& error) {
      ++summary.refused;
      std::printf("%s %zu refused: %s\n", file.c_str(), i, error.what());
    }
  }
}

int run_all(const PairSettings& settings) {
  std::printf("seed %llu, %d pairs of a kind and file\n",
              static_cast<unsigned long long>(settings.seed), settings.pairs);
  Summary s;
  for (const std::string& file : settings.files) run_file(file, settings, s);
  double most = 0, total = 0;
  for (const double t : s.seconds) {
    most = std::max(most, t);
    total += t;
  }
  std::printf(
      "%zu pairs: %zu complete, %zu stopped, %zu with missed points, %zu with gaps above "
      "the stated ones, %zu refused; median %.4f s, most %.3f s, all %.2f s\n",
      s.pairs, s.complete, s.stopped, s.missed, s.gaps, s.refused, median(s.seconds), most, total);
  if (settings.peers)
    std::printf("median of Section %.4f s, of IntSS %.4f s\n", median(s.section), median(s.intss));
  return s.missed + s.gaps + s.refused > 0 ? 1 : 0;
}

}  // namespace
}  // namespace blossom::bench

int main(int argc, char** argv) {
  using namespace blossom::bench;
  return run_command(pair_settings({}, "--peers", argc, argv),
                     "bench_face_pairs [--seed N] [--pairs N] [--limit SECONDS] [--peers] "
                     "[--keep FOLDER] FILE...",
                     run_all);
}
