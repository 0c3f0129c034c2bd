// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/mesh_commands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/tessellation.h"
#include "core/base/work_limit.h"
#include "core/bounds/box_tree.h"
#include "core/tessellation/mesh_distance.h"
#include "plugin/cli/commands/meshed_input.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/mesh_judge.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/output.h"
#include "plugin/cli/supervision.h"

namespace blossom::cli {
namespace {

// Of the size of both: how near a mesh is to its model at first, and by how much it gets nearer
// until the bounds are as near as a part of the distance.
constexpr double kFirstDeviation = 1e-3;
constexpr double kFiner = 0.2;
constexpr double kGoodPart = 0.1;
constexpr int kRounds = 4;
constexpr double kSearchPart = 0.05;  // of the deviation: what the search of meshes leaves open

constexpr std::size_t kNamedPairs = 10;
constexpr int kDeepRounds = 3;  // of finer triangles, as long as some cross

Json check_json(const std::string& file, const FileMesh& mesh, const JudgedMesh& found) {
  return {{"schema", "blossom.mesh-check/1"},
          {"file", file},
          {"points", mesh.points.size()},
          {"triangles", mesh.triangles.size()},
          {"parts", found.parts},
          {"closed", found.closed()},
          {"open_sides", found.open_sides},
          {"non_manifold_sides", found.crowded_sides},
          {"turned_sides", found.turned_sides},
          {"degenerate", found.degenerate},
          {"crossings", found.crossings},
          {"crossing_triangles", found.crossing_pairs},
          {"area", found.area},
          {"volume", found.closed() ? Json(found.volume) : Json(nullptr)}};
}

std::string check_text(const std::string& file, const FileMesh& mesh, const JudgedMesh& found) {
  const bool sound =
      found.closed() && found.degenerate == 0 && found.crossings == 0 && found.volume > 0;
  std::ostringstream text;
  text.precision(12);
  text << file << ": " << (sound ? "sound" : "not sound") << ", "
       << counted(mesh.triangles.size(), "triangle") << ", " << counted(mesh.points.size(), "point")
       << ", " << counted(found.parts, "part") << "\n  "
       << (found.closed() ? "closed, volume " : "not closed") << (found.closed() ? "" : ", area ")
       << (found.closed() ? found.volume : found.area) << "\n";
  const auto line = [&](std::size_t count, const char* noun, const char* what) {
    if (count > 0) text << "  " << counted(count, noun) << " " << what << "\n";
  };
  line(found.open_sides, "side", "of one triangle: the mesh is open");
  line(found.crowded_sides, "side", "of more than two triangles");
  line(found.turned_sides, "side", "whose two triangles are turned against each other");
  line(found.degenerate, "triangle", "of no area");
  line(found.crossings, "pair", "of triangles that cross");
  for (std::size_t k = 0; k < found.crossing_pairs.size() && k < kNamedPairs; ++k)
    text << "    triangles " << found.crossing_pairs[k][0] + 1 << " and "
         << found.crossing_pairs[k][1] + 1 << "\n";
  if (found.closed() && found.volume < 0) text << "  it is turned inside out\n";
  return text.str();
}

DeepCheck deep_answer(const FileMesh& mesh, const JudgedMesh& found, double distance,
                      const std::set<std::array<int, 2>>& faces) {
  DeepCheck check;
  check.wrong = found.crossings > 0 || found.turned_sides > 0;
  check.report = {{"triangles", mesh.triangles.size()},
                  {"distance", distance},
                  {"closed", found.closed()},
                  {"turned_sides", found.turned_sides},
                  {"volume", found.closed() ? Json(found.volume) : Json(nullptr)},
                  {"crossings", found.crossings},
                  {"crossing_faces", faces}};
  std::ostringstream text;
  text << "  as " << counted(mesh.triangles.size(), "triangle") << " within " << distance << ": "
       << (found.closed() ? "closed, volume " + std::to_string(found.volume) : "not closed");
  text << ", " << counted(found.crossings, "pair") << " of triangles that cross";
  std::size_t named = 0;
  for (const auto& [a, b] : faces) {
    if (++named > kNamedPairs) break;
    text << (named == 1 ? ", of faces " : ", ") << a << " and " << b;
  }
  text << "\n";
  check.text = text.str();
  return check;
}

// ---- distances

struct Farthest {
  double lower = 0, upper = 0;
  Vec3 point;
};

// Both sets may be off their meshes by what these are off.
Farthest farthest(const MeshedInput& from, const MeshedInput& to, double accuracy,
                  const std::function<bool()>& ask) {
  const FarthestPoint found = farthest_point(from.mesh().points, from.mesh().triangles,
                                             to.mesh().points, to.mesh().triangles, accuracy, ask);
  const double off = from.distance() + to.distance();
  return {std::max(0.0, found.lower - off), found.upper + off, found.point};
}

struct BothWays {
  Farthest a_to_b, b_to_a;
  Status status = Status::Complete;

  double lower() const { return std::max(a_to_b.lower, b_to_a.lower); }
  double upper() const { return std::max(a_to_b.upper, b_to_a.upper); }
};

BothWays distance_of(MeshedInput& a, MeshedInput& b, double tolerance) {
  const std::function<bool()> cancelled = interrupted;
  const WorkLimit limit(seconds_left(), cancelled);
  const std::function<bool()> ask = [&] { return limit.reached() == nullptr; };
  BothWays found;
  double deviation = kFirstDeviation * std::max(a.size(), b.size());
  for (int round = 0; round < kRounds; ++round, deviation *= kFiner) {
    if (!a.refine(deviation, ask) || !b.refine(deviation, ask)) break;
    const double accuracy = std::max(tolerance, kSearchPart * deviation);
    const Farthest forth = farthest(a, b, accuracy, ask), back = farthest(b, a, accuracy, ask);
    if (round > 0 && !ask()) break;
    found.a_to_b = forth;
    found.b_to_a = back;
    if (found.upper() - found.lower() <= std::max(tolerance, kGoodPart * found.upper())) break;
    if (!a.is_model() && !b.is_model()) break;
  }
  if (!ask()) found.status = Status::Stopped;
  return found;
}

Json json_of(const Farthest& way) {
  return {{"lower", way.lower}, {"upper", way.upper}, {"at", way.point.coordinates}};
}

Json distance_json(const MeshedInput& a, const MeshedInput& b, const BothWays& found,
                   double seconds) {
  return {{"schema", "blossom.mesh-distance/1"},
          {"a", a.name()},
          {"b", b.name()},
          {"status", to_string(found.status)},
          {"lower", found.lower()},
          {"upper", found.upper()},
          {"a_to_b", json_of(found.a_to_b)},
          {"b_to_a", json_of(found.b_to_a)},
          {"seconds", seconds}};
}

std::string distance_text(const MeshedInput& a, const MeshedInput& b, const BothWays& found) {
  std::ostringstream text;
  text.precision(6);
  const auto between = [&](double lower, double upper) {
    text << "between " << lower << " and " << upper;
  };
  text << a.name() << " - " << b.name() << ": " << to_string(found.status)
       << ", farthest from each other ";
  between(found.lower(), found.upper());
  const auto way = [&](const char* words, const Farthest& one) {
    text << "\n  " << words << ": ";
    between(one.lower, one.upper);
    text << ", at (" << one.point[0] << ", " << one.point[1] << ", " << one.point[2] << ")";
  };
  way("of the first from the second", found.a_to_b);
  way("of the second from the first", found.b_to_a);
  text << "\n";
  return text.str();
}

}  // namespace

int run_mesh_check(const std::string& input, const CommonOptions& common) {
  check_files(common, {input});
  const FileMesh mesh = meshes::read_mesh_file(parse_input(input).file);
  stop_if_interrupted();
  const auto found = judged_mesh(mesh);
  if (!found) throw UsageError("check of triangles needs CGAL, which this program lacks");
  stop_if_interrupted();
  if (!common.json.empty()) write_json(check_json(input, mesh, *found), common.json);
  print_summary(check_text(input, mesh, *found), common.json);
  const bool wrong = !found->closed() || found->degenerate + found->crossings > 0;
  return exit_code(kExitComplete, findings_of(wrong), common);
}

DeepCheck deep_check(const Input& input) {
  const TopoDS_Shape& shape = input.model.shape();
  FacetOptions options;
  Box box;
  for (const Vec3& p : occt::tessellation(shape, {.deviation = 1e6}).facets.points)
    box = joined(box, {p, p});
  options.deviation = kFirstDeviation * diagonal(box);
  DeepCheck check;
  for (int round = 0; round < kDeepRounds; ++round, options.deviation *= kFiner) {
    std::vector<int> face_of;
    const occt::ShapeTessellation made = occt::tessellation(shape, options);
    const FileMesh mesh{made.facets.points, occt::triangles_of(made, &face_of)};
    const auto found = judged_mesh(mesh);
    if (!found) throw UsageError("--deep needs CGAL, which this program lacks");
    std::set<std::array<int, 2>> faces;
    for (const auto& [a, b] : found->crossing_pairs) {
      const int i = face_of[static_cast<std::size_t>(a)], j = face_of[static_cast<std::size_t>(b)];
      faces.insert({std::min(i, j) + 1, std::max(i, j) + 1});
    }
    check = deep_answer(mesh, *found, made.facets.distance, faces);
    stop_if_interrupted();
    if (found->crossings == 0) break;
  }
  return check;
}

int run_mesh_distance(const std::string& first, const std::string& second,
                      const QueryOptions& options) {
  check_files(options, {first, second});
  MeshedInput a(first), b(second);
  stop_if_interrupted();
  const Stopwatch watch;
  const BothWays found = distance_of(a, b, options.tolerance);
  stop_if_interrupted();
  write_answer(distance_json(a, b, found, watch.seconds()), distance_text(a, b, found), options);
  return exit_code(found.status);
}

}  // namespace blossom::cli
