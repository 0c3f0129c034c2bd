// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/mesh_commands.h"

#include <algorithm>
#include <functional>
#include <sstream>
#include <utility>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/tessellation.h"
#include "core/base/work_limit.h"
#include "core/bounds/box_tree.h"
#include "core/math/index.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/meshes/mesh_distance.h"
#include "plugin/meshes/mesh_info.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/meshes/part_crossings.h"
#include "plugin/pictures/results/mesh_answers.h"
#include "plugin/pictures/results/meshes.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::cli {
namespace {

using meshes::FileMesh;

constexpr double kFirstDeviation = 1e-3;  // of the size
constexpr double kFiner = 0.2;
constexpr std::size_t kNamedPairs = 10;
constexpr int kDeepRounds = 3;  // of finer triangles, as long as some cross

DeepCheck deep_answer(const FileMesh& mesh, const meshes::JudgedMesh& found, double distance,
                      const meshes::Crossings& crossings, const FaceLabels& labels) {
  const meshes::Crossings::Faces& faces = crossings.faces_inside;
  DeepCheck check;
  check.wrong = crossings.inside > 0 || found.turned_sides > 0;
  check.report = {{"triangles", mesh.triangles.size()},
                  {"distance", distance},
                  {"closed", found.closed()},
                  {"turned_sides", found.turned_sides},
                  {"volume", found.closed() ? Json(found.volume) : Json(nullptr)},
                  {"crossings", crossings.inside},
                  {"crossing_faces", faces},
                  {"crossings_between_parts", crossings.between}};
  std::ostringstream text;
  text << "  as " << counted(mesh.triangles.size(), "triangle") << " within " << distance << ": "
       << (found.closed() ? "closed, volume " + std::to_string(found.volume) : "not closed");
  text << ", " << counted(crossings.inside, "pair") << " of triangles that cross";
  std::size_t named = 0;
  for (const auto& [a, b] : faces) {
    if (++named > kNamedPairs) break;
    text << (named == 1 ? ", of " : ", ") << labels.of(a) << " and " << labels.of(b);
  }
  text << "\n";
  if (crossings.between > 0)
    text << "  " << counted(crossings.between, "pair")
         << " of triangles of different parts that cross, which clash looks at\n";
  check.text = text.str();
  return check;
}

std::string distance_text(const meshes::MeshDistance& found) {
  std::ostringstream text;
  text.precision(6);
  // No more is done than tells whether they are within: only one of the bounds means much then.
  const std::optional<bool> is_within = found.is_within();
  const auto between = [&](double lower, double upper) {
    if (!is_within)
      text << "between " << lower << " and " << upper;
    else if (*is_within)
      text << "at most " << upper;
    else
      text << "at least " << lower;
  };
  const auto answer = [&]() -> std::string {
    if (!found.within) return "";
    return std::string(!is_within   ? "perhaps"
                       : *is_within ? "yes, they are"
                                    : "no, they are not") +
           " within " + reports::number_text(*found.within) + ", ";
  };
  text << found.a << " - " << found.b << ": " << answer() << to_string(found.status)
       << ", farthest from each other ";
  between(found.lower(), found.upper());
  const auto way = [&](const char* words, const meshes::FarthestOfMesh& one) {
    text << "\n  " << words << ": ";
    between(one.lower, one.upper);
    text << ", at (" << one.point[0] << ", " << one.point[1] << ", " << one.point[2] << ")";
  };
  way("of the first from the second", found.a_to_b);
  way("of the second from the first", found.b_to_a);
  text << "\n";
  return text.str();
}

std::string notes_of(const meshes::MeshSource& source) {
  const std::string notes = meshes::notes_text(source.mesh());
  return notes.empty() ? "" : "  " + source.name() + ":\n" + notes;
}

}  // namespace

int run_mesh_info(const std::string& input, bool groups, const CommonOptions& common) {
  check_files(common, {input});
  const FileMesh mesh = read_mesh_input(input);
  stop_if_interrupted();
  const MeshFacts facts = meshes::facts_of(mesh, stop_if_interrupted);
  const std::vector<PictureFile> pictures = picture_files(common, [&] {
    return pictures::mesh_picture(input, mesh, meshes::enclosed_text(facts), stop_if_interrupted);
  });
  stop_if_interrupted();
  write_pictures(pictures);
  if (!common.json.empty()) write_json(meshes::mesh_info_report(input, mesh, facts), common.json);
  print_summary(meshes::mesh_info_text(input, mesh, facts, groups), common.json);
  return kExitComplete;
}

int run_mesh_check(const std::string& input, const CommonOptions& common) {
  check_files(common, {input});
  refuse_options(common, {"--deep"}, input + " is of triangles already");
  const FileMesh mesh = read_mesh_input(input);
  stop_if_interrupted();
  const auto found = meshes::judged_mesh(mesh, stop_if_interrupted);
  if (!found) throw UsageError("check of triangles needs CGAL, which this program lacks");
  const std::vector<PictureFile> pictures = picture_files(common, [&] {
    return pictures::mesh_check_picture(input, mesh, *found, stop_if_interrupted);
  });
  stop_if_interrupted();
  write_pictures(pictures);
  if (!common.json.empty()) write_json(meshes::mesh_check_report(input, mesh, *found), common.json);
  print_summary(meshes::mesh_check_text(input, mesh, *found), common.json);
  return exit_code(kExitComplete, findings_of(!found->sound()), common);
}

DeepCheck deep_check(const Input& input) {
  const TopoDS_Shape& shape = input.model.shape();
  FacetOptions options;
  Box box;
  for (const Vec3& p : occt::tessellation(shape, {.deviation = 1e6}).facets.points)
    box = joined(box, {p, p});
  options.deviation = kFirstDeviation * diagonal(box);
  const std::vector<int> parts = meshes::parts_of_faces(input);
  const FaceLabels labels(input);
  DeepCheck check;
  for (int round = 0; round < kDeepRounds; ++round, options.deviation *= kFiner) {
    std::vector<int> face_of;
    const occt::ShapeTessellation made = occt::tessellation(shape, options);
    const FileMesh mesh{made.facets.points, occt::triangles_of(made, &face_of)};
    for (int& face : face_of) ++face;  // its number
    const auto found = meshes::judged_parts(mesh, face_of, parts, stop_if_interrupted);
    if (!found) throw UsageError("--deep needs CGAL, which this program lacks");
    check = deep_answer(mesh, found->mesh, made.facets.distance, found->crossings, labels);
    stop_if_interrupted();
    if (found->crossings.inside == 0) break;
  }
  return check;
}

int run_mesh_distance(const std::string& first, const std::string& second,
                      std::optional<double> within, const QueryOptions& options) {
  check_files(options, {first, second});
  refuse_options(options, {"--budget"}, "farthest points of triangles are told");
  meshes::MeshSource a = mesh_source_of(first), b = mesh_source_of(second);
  stop_if_interrupted();
  const std::function<bool()> cancelled = interrupted;
  const WorkLimit limit(seconds_left(), cancelled);
  const meshes::MeshDistance found = meshes::distance_of(
      a, b, options.tolerance, [&] { return limit.reached() == nullptr; }, within);
  stop_if_interrupted();
  write_answer(meshes::mesh_distance_report(found),
               distance_text(found) + notes_of(a) + notes_of(b), options);
  return exit_code(exit_code(found.status), findings_of(found.is_within() == false), options);
}

}  // namespace blossom::cli
