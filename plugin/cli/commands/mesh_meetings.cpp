// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/mesh_meetings.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include "core/base/work_limit.h"
#include "plugin/cli/commands/meshed_input.h"
#include "plugin/cli/commands/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/mesh_curves.h"
#include "plugin/cli/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/supervision.h"
#include "plugin/cli/values.h"
#include "plugin/drawings/section_drawing.h"
#include "plugin/reports/plane_cuts.h"

namespace blossom::cli {
namespace {

using reports::NamedPlane;
using reports::SectionsAnswer;

constexpr double kModelDeviation = 1e-4;  // of a model's size: how near its triangles are
constexpr double kEdgeTolerance = 1e-7;   // of edges that are made, model units

// ---- polylines as sections, which have writers

Handle(Geom_BSplineCurve) polygon_curve(const std::vector<Vec3>& points) {
  const auto count = static_cast<int>(points.size());
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal knots(1, count);
  TColStd_Array1OfInteger multiplicities(1, count);
  multiplicities.Init(1);
  multiplicities.SetValue(1, 2);
  multiplicities.SetValue(count, 2);
  double at = 0;
  for (int i = 1; i <= count; ++i) {
    const Vec3& p = points[static_cast<std::size_t>(i - 1)];
    if (i > 1) at += norm(p - points[static_cast<std::size_t>(i - 2)]);
    poles.SetValue(i, {p[0], p[1], p[2]});
    knots.SetValue(i, at);
  }
  return new Geom_BSplineCurve(poles, knots, multiplicities, 1);
}

occt::PlaneSection section_of(const MeshCurves& found) {
  occt::PlaneSection section;
  section.status = found.touching ? Status::Tolerance : Status::Complete;
  const auto node = [&](const Vec3& point) {
    section.nodes.push_back({.point = point, .on = {}});
    return static_cast<int>(section.nodes.size()) - 1;
  };
  for (const MeshPolyline& polyline : found.curves) {
    occt::SectionCurve curve;
    curve.face = 0;
    curve.curve = polygon_curve(polyline.points);
    curve.range = {curve.curve->FirstParameter(), curve.curve->LastParameter()};
    curve.samples = polyline.points;
    curve.closed = polyline.closed;
    curve.length = polyline.length;
    curve.tolerance = kEdgeTolerance;
    if (!polyline.closed)
      curve.nodes = {node(polyline.points.front()), node(polyline.points.back())};
    section.wires.push_back({{{section.curves.size(), true}}, polyline.closed, polyline.length});
    section.curves.push_back(std::move(curve));
  }
  for (const Vec3& point : found.points)
    section.points.push_back(static_cast<std::size_t>(node(point)));
  return section;
}

void write_curves(const SectionsAnswer& answer, const std::string& file) {
  const bool any = std::ranges::any_of(answer.planes, [](const auto& plane) {
    return std::ranges::any_of(plane.parts, [](const reports::PartSection& part) {
      return !part.section.wires.empty() || !part.section.points.empty();
    });
  });
  if (!any) return tell_unwritten(file, "no curve and no point was found");
  if (drawings::is_drawing_file(file)) return drawings::write_section_drawing(answer, file);
  write_model(reports::model_of(answer), file);
}

// ---- what is told

Json curves_json(const MeshCurves& found) {
  Json json = {{"touching", found.touching},
               {"in_plane", found.in_plane},
               {"curves", Json::array()},
               {"points", Json::array()}};
  for (const MeshPolyline& curve : found.curves) {
    Json points = Json::array();
    for (const Vec3& p : curve.points) points.push_back(p.coordinates);
    json["curves"].push_back(
        {{"closed", curve.closed}, {"length", curve.length}, {"points", std::move(points)}});
  }
  for (const Vec3& p : found.points) json["points"].push_back(p.coordinates);
  return json;
}

std::string counts_text(const MeshCurves& found) {
  std::size_t closed = 0;
  double length = 0;
  for (const MeshPolyline& curve : found.curves) {
    closed += curve.closed;
    length += curve.length;
  }
  std::string text = counted(found.curves.size(), "polyline");
  if (closed < found.curves.size())
    text += " (" + std::to_string(found.curves.size() - closed) + " open)";
  if (!found.curves.empty()) text += " of length " + number_text(rounded(length));
  if (!found.points.empty()) text += ", " + counted(found.points.size(), "point");
  return text;
}

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

void refuse_pictures(const CommonOptions& common) {
  if (!picture_names(common).empty())
    throw UsageError("--picture, --html and --glb show models, not files of triangles");
}

void mesh_model(MeshedInput& input) {
  if (!input.is_model()) return;
  const std::function<bool()> cancelled = interrupted;
  const WorkLimit limit(seconds_left(), cancelled);
  const bool made =
      input.refine(kModelDeviation * input.size(), [&] { return limit.reached() == nullptr; });
  stop_if_interrupted();
  if (!made) throw UsageError(input.name() + ": its triangles took longer than --time-limit");
}

struct TwoMeshes {
  MeshedInput a, b;
  MeshCurves found{};
  double seconds = 0;

  double within() const { return std::max(a.distance(), b.distance()); }
  // Of models curves may be missing, or meet in another way, where they nearly touch.
  Status status() const {
    return found.touching || within() > 0 ? Status::Tolerance : Status::Complete;
  }
};

Json report_of(const TwoMeshes& of) {
  Json json = {{"schema", "blossom.mesh-intersection/1"},
               {"a", of.a.name()},
               {"b", of.b.name()},
               {"status", to_string(of.status())},
               {"within", of.within()},
               {"rounding", of.found.rounding},
               {"flat", of.found.flat},
               {"seconds", of.seconds}};
  json.update(curves_json(of.found));
  return json;
}

std::string text_of(const TwoMeshes& of) {
  std::ostringstream text;
  text << of.a.name() << " x " << of.b.name() << ": " << to_string(of.status()) << ", "
       << counts_text(of.found) << ", " << of.seconds << " s\n";
  for (const MeshedInput* const input : {&of.a, &of.b})
    if (input->distance() > 0)
      text << "  " << input->name() << " is meshed within "
           << number_text(rounded(input->distance()))
           << " mm: points are that near to it, and what is nearer to touching may be missing\n";
  text << notes_text(of.found, "second", "pairs of triangles in one plane overlap");
  return text.str();
}

struct PlaneOfMesh {
  NamedPlane plane;
  MeshCurves found;
};

Json report_of(const std::string& input, const SectionsAnswer& answer,
               const std::vector<PlaneOfMesh>& planes) {
  Json json = {{"schema", "blossom.mesh-sections/1"},
               {"file", input},
               {"status", to_string(answer.status)},
               {"rounding", planes.front().found.rounding},
               {"flat", planes.front().found.flat},
               {"seconds", answer.seconds},
               {"planes", Json::array()}};
  for (const auto& [plane, found] : planes) {
    Json of = {{"name", plane.name},
               {"point", plane.plane.point.coordinates},
               {"normal", plane.plane.normal.coordinates},
               {"offset", plane.offset ? Json(*plane.offset) : Json()}};
    of.update(curves_json(found));
    json["planes"].push_back(std::move(of));
  }
  return json;
}

std::string text_of(const std::string& input, const SectionsAnswer& answer,
                    const std::vector<PlaneOfMesh>& planes) {
  std::ostringstream text;
  text << input << ": " << to_string(answer.status) << ", " << counted(planes.size(), "plane")
       << ", " << answer.seconds << " s\n";
  for (const auto& [plane, found] : planes)
    text << "  " << plane.name << ": " << counts_text(found) << "\n"
         << notes_text(found, "plane", "triangles lie in the plane");
  return text.str();
}

}  // namespace

int run_mesh_intersection(const std::string& a, const std::string& b, const CommonOptions& common) {
  refuse_pictures(common);
  check_files(common, {a, b});
  TwoMeshes both{MeshedInput(a), MeshedInput(b)};
  stop_if_interrupted();
  const Stopwatch watch;
  mesh_model(both.a);
  mesh_model(both.b);
  both.found = curves_of_meshes(both.a.mesh(), both.b.mesh());
  both.seconds = watch.seconds();
  stop_if_interrupted();
  if (!common.output.empty()) {
    SectionsAnswer answer;
    answer.planes.push_back(
        {{{}, "intersection", {}}, {{"curves", false, {0}, section_of(both.found)}}});
    write_curves(answer, common.output);
  }
  if (!common.json.empty()) write_json(report_of(both), common.json);
  print_summary(text_of(both), common.json);
  const bool any = !both.found.curves.empty() || !both.found.points.empty();
  return exit_code(exit_code(both.status()), findings_of(any), common);
}

int run_mesh_sections(const std::string& input, const std::vector<NamedPlane>& planes,
                      const CommonOptions& common) {
  refuse_pictures(common);
  const meshes::FileMesh mesh = meshes::read_mesh_file(parse_input(input).file);
  stop_if_interrupted();
  const Stopwatch watch;
  SectionsAnswer answer;
  std::vector<PlaneOfMesh> cuts;
  for (const NamedPlane& plane : planes) {
    stop_if_interrupted();
    PlaneOfMesh& cut = cuts.emplace_back(PlaneOfMesh{plane, curves_in_plane(mesh, plane.plane)});
    const bool solid =
        !cut.found.curves.empty() && std::ranges::all_of(cut.found.curves, &MeshPolyline::closed);
    reports::PartSection part{short_name(input), solid, {0}, section_of(cut.found)};
    occt::orient_wires(part.section, plane.plane);
    answer.status = weaker(answer.status, part.section.status);
    answer.planes.push_back({plane, {std::move(part)}});
  }
  answer.seconds = watch.seconds();
  const Json report = report_of(input, answer, cuts);
  if (ending_of(common.output) == ".json")
    write_json(report, common.output);
  else if (!common.output.empty())
    write_curves(answer, common.output);
  if (!common.json.empty()) write_json(report, common.json);
  print_summary(text_of(input, answer, cuts), common.json);
  return exit_code(answer.status);
}

}  // namespace blossom::cli
