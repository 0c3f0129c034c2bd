// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/mesh_meetings.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/work_limit.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/drawings/section_drawing.h"
#include "plugin/meshes/mesh_curves.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/pictures/results/mesh_answers.h"
#include "plugin/reports/queries/plane_cuts.h"

namespace blossom::cli {
namespace {

using meshes::MeshCurves;
using meshes::MeshPair;
using meshes::MeshPolyline;
using meshes::MeshSource;
using meshes::PlaneOfMesh;
using reports::NamedPlane;
using reports::SectionsAnswer;

constexpr double kModelDeviation = 1e-4;  // of a model's size: how near its triangles are

void write_curves(const SectionsAnswer& answer, const std::string& file) {
  if (!reports::has_shape(answer))
    return report_nothing_found(file, "no curve and no point was found");
  if (drawings::is_drawing_file(file)) return drawings::write_section_drawing(answer, file);
  write_model(reports::model_of(answer), file);
}

// ---- what is told

// moved      whose motion decides where they touch
// in_plane   what there may be several of
std::string notes_text(const MeshCurves& found, const char* moved, const char* in_plane) {
  std::string text;
  if (found.touching)
    text += std::string(
                "  they touch along sides or triangles that lie in each other: polylines "
                "there are those of the ") +
            moved + " moved by less than any length\n";
  if (found.in_plane > 0) text += "  " + std::to_string(found.in_plane) + " " + in_plane + "\n";
  if (found.flat > 0) text += "  " + counted(found.flat, "triangle") + " of no area met nothing\n";
  return text;
}

void refuse_options_of_models(const CommonOptions& common) {
  refuse_options(common, {"--tolerance", "--form", "--budget", "--joined", "--repeat"},
                 "triangles are compared exactly");
}

void mesh_model(MeshSource& input) {
  if (!input.is_model()) return;
  const std::function<bool()> cancelled = interrupted;
  const WorkLimit limit(seconds_left(), cancelled);
  const bool made =
      input.refine(kModelDeviation * input.size(), [&] { return limit.reached() == nullptr; });
  stop_if_interrupted();
  if (!made) throw UsageError(input.name() + ": its triangles took longer than --time-limit");
}

MeshCurves with_cgal(std::optional<MeshCurves> found) {
  if (!found) throw UsageError("this needs CGAL, which this program lacks");
  return std::move(*found);
}

std::string text_of(const MeshPair& pair, const std::array<const MeshSource*, 2>& inputs) {
  std::ostringstream text;
  text << pair.a << " x " << pair.b << ": " << to_string(pair.status()) << ", "
       << meshes::counted_curves(pair.found) << ", " << seconds_text(pair.seconds) << "\n";
  for (const MeshSource* const input : inputs) {
    if (input->distance() > 0)
      text << "  " << input->name() << " is meshed within "
           << number_text(rounded(input->distance()))
           << " mm: points are that near to it, and what is nearer to touching may be missing\n";
    text << meshes::notes_text(input->mesh());
  }
  text << notes_text(pair.found, "second", "pairs of triangles in one plane overlap");
  return text.str();
}

std::string text_of(const std::string& input, const SectionsAnswer& answer,
                    const std::vector<PlaneOfMesh>& planes) {
  std::ostringstream text;
  text << input << ": " << to_string(answer.status) << ", " << counted(planes.size(), "plane")
       << ", " << seconds_text(answer.seconds) << "\n";
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::optional<double> area = occt::bounded_area(answer.planes[i].parts.front().section);
    text << "  " << planes[i].name << ": " << meshes::counted_curves(planes[i].found);
    if (area && *area > 0) text << ", area " << number_text(rounded(*area));
    text << "\n" << notes_text(planes[i].found, "plane", "triangles lie in the plane");
  }
  return text.str();
}

}  // namespace

int run_mesh_intersection(const std::string& a, const std::string& b, const CommonOptions& common) {
  refuse_options_of_models(common);
  check_files(common, {a, b});
  MeshSource first = mesh_source_of(a), second = mesh_source_of(b);
  stop_if_interrupted();
  const Stopwatch watch;
  mesh_model(first);
  mesh_model(second);
  MeshPair pair{a, b, first.distance(), second.distance()};
  pair.found =
      with_cgal(meshes::curves_of_meshes(first.mesh(), second.mesh(), stop_if_interrupted));
  pair.seconds = watch.seconds();
  const std::vector<PictureFile> pictures = picture_files(common, [&] {
    return pictures::mesh_pair_picture(pair, {&first, &second}, stop_if_interrupted);
  });
  stop_if_interrupted();
  write_pictures(pictures);
  if (!common.output.empty()) {
    SectionsAnswer answer;
    answer.planes.push_back(
        {{{}, "intersection", {}}, {{"curves", false, {0}, meshes::section_of(pair.found)}}});
    write_curves(answer, common.output);
  }
  if (!common.json.empty()) write_json(meshes::mesh_pair_report(pair), common.json);
  print_summary(text_of(pair, {&first, &second}), common.json);
  const bool any = !pair.found.curves.empty() || !pair.found.points.empty();
  return exit_code(exit_code(pair.status()), findings_of(any), common);
}

int run_mesh_sections(const std::string& input, const std::vector<NamedPlane>& planes,
                      const CommonOptions& common) {
  refuse_options_of_models(common);
  const meshes::FileMesh mesh = read_mesh_input(input);
  stop_if_interrupted();
  const Stopwatch watch;
  SectionsAnswer answer;
  std::vector<PlaneOfMesh> cuts;
  for (const NamedPlane& plane : planes) {
    stop_if_interrupted();
    PlaneOfMesh& cut = cuts.emplace_back(PlaneOfMesh{plane.name, plane.plane, plane.offset});
    cut.found = with_cgal(meshes::curves_in_plane(mesh, plane.plane, stop_if_interrupted));
    const bool solid =
        !cut.found.curves.empty() && std::ranges::all_of(cut.found.curves, &MeshPolyline::closed);
    reports::PartSection part{
        reports::short_name(input), solid, {0}, meshes::section_of(cut.found)};
    occt::orient_wires(part.section, plane.plane);
    answer.status = weaker(answer.status, part.section.status);
    answer.planes.push_back({plane, {std::move(part)}});
  }
  answer.seconds = watch.seconds();
  const std::vector<PictureFile> pictures = picture_files(common, [&] {
    return pictures::mesh_sections_picture(input, mesh, cuts, stop_if_interrupted);
  });
  stop_if_interrupted();
  write_pictures(pictures);
  const Json report = meshes::mesh_sections_report(input, answer.status, cuts, answer.seconds);
  if (ending_of(common.output) == ".json")
    write_json(report, common.output);
  else if (!common.output.empty())
    write_curves(answer, common.output);
  if (!common.json.empty()) write_json(report, common.json);
  print_summary(text_of(input, answer, cuts) + meshes::notes_text(mesh), common.json);
  return exit_code(answer.status);
}

}  // namespace blossom::cli
