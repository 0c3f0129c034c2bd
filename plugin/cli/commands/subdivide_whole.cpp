// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/subdivide_whole.h"

#include <array>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/tolerances.h"
#include "plugin/cli/commands/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/picture/mesh.h"
#include "plugin/nets/net_json.h"
#include "plugin/nets/whole.h"
#include "plugin/reports/repairs.h"

namespace blossom::cli {
namespace {

struct WholePart {
  nets::NetSource source;
  TopoDS_Shape shape;  // an untrimmed face, or an edge
  Json json;
};

WholePart whole_face(const Input& input, std::size_t i, const std::vector<std::string>& names,
                     const std::vector<double>& r) {
  WholePart part;
  part.source.file = input.model.file().string();
  part.source.face = input.numbers[i];
  part.source.name = names[static_cast<std::size_t>(part.source.face) - 1];
  std::optional<std::array<Interval, 2>> rectangle;
  if (!r.empty()) rectangle = {Interval{r[0], r[1]}, Interval{r[2], r[3]}};
  const auto surface = nets::whole_surface(input.faces[i], part.source, rectangle);
  BRepBuilderAPI_MakeFace maker(surface, Tolerances{}.point);
  if (!maker.IsDone()) throw occt::BadModel(nets::text_of(part.source) + ": gives no face");
  part.shape = maker.Shape().Oriented(input.faces[i].Orientation());
  part.json = nets::spline_json(*surface);
  part.json["face"] = part.source.face;
  return part;
}

std::vector<WholePart> whole_edges(const Input& input, const std::vector<double>& interval) {
  TopTools_IndexedMapOfShape numbered, wanted;
  TopExp::MapShapes(input.model.shape(), TopAbs_EDGE, numbered);
  for (const TopoDS_Face& face : input.faces) TopExp::MapShapes(face, TopAbs_EDGE, wanted);
  for (const int number : input.edges) wanted.Add(numbered(number));
  const bool all = parse_input(input.name).is_whole();
  std::vector<WholePart> parts;
  for (int number = 1; number <= numbered.Extent(); ++number) {
    if (!all && !wanted.Contains(numbered(number))) continue;
    stop_if_interrupted();
    WholePart part;
    part.source.file = input.model.file().string();
    part.source.edge = number;
    const auto curve = nets::whole_curve(TopoDS::Edge(numbered(number)), part.source,
                                         Interval{interval[0], interval[1]});
    if (curve.IsNull()) continue;
    BRepBuilderAPI_MakeEdge maker(curve);
    if (!maker.IsDone())
      throw occt::BadModel(nets::text_of(part.source) + ": gives no edge: is it a point?");
    part.shape = maker.Shape();
    part.json = nets::spline_json(*curve);
    part.json["edge"] = number;
    parts.push_back(std::move(part));
  }
  if (parts.empty())
    throw occt::BadModel(input.model.file().string() + ": there is no edge with a curve in it");
  return parts;
}

std::vector<WholePart> whole_parts(const Input& input, const WholeQuestion& question) {
  if (!question.interval.empty()) return whole_edges(input, question.interval);
  const std::vector<std::string> names = input.model.face_names();
  std::vector<WholePart> parts;
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    stop_if_interrupted();
    parts.push_back(whole_face(input, i, names, question.rectangle));
  }
  return parts;
}

// Faces take the places of theirs, with names and colours; edges are parts of their own.
void write_parts(const Input& input, const std::vector<WholePart>& parts, const std::string& file) {
  if (parts.front().source.face == 0) {
    occt::Model model;
    for (const WholePart& part : parts) model.add(part.shape, nets::name_of(part.source));
    return write_model(model, file);
  }
  std::map<int, std::vector<TopoDS_Face>> faces;
  for (int number = 1; number <= input.model.face_count(); ++number) faces[number];
  for (const WholePart& part : parts) faces[part.source.face] = {TopoDS::Face(part.shape)};
  input.model.replace_faces(faces);
  write_model(input.model, file);
}

Picture picture_of(const std::string& name, const std::vector<WholePart>& parts) {
  Picture picture;
  picture.title = "B-splines of " + short_name(name);
  picture.groups = {{{}, kFirstColour}};
  PictureLayer curves{"curve", kCurveColour};
  PictureFaces& surfaces = picture.groups.front();
  for (const WholePart& part : parts)
    if (part.source.face > 0) {
      surfaces.faces.push_back(TopoDS::Face(part.shape));
      surfaces.labels.push_back(nets::name_of(part.source));
    } else if (auto points = edge_points(TopoDS::Edge(part.shape)); !points.empty()) {
      curves.items.push_back({std::move(points), nets::name_of(part.source)});
    }
  picture.layers = {std::move(curves)};
  return picture;
}

std::string summary_of(const std::string& name, const std::vector<WholePart>& parts,
                       double seconds) {
  std::ostringstream text;
  text << name << ": " << parts.size() << " B-spline "
       << (parts.front().source.face > 0 ? "surface" : "curve") << (parts.size() == 1 ? "" : "s")
       << ", " << seconds << " s\n";
  return text.str();
}

Json report_of(const Input& input, const WholeQuestion& question,
               const std::vector<WholePart>& parts, double seconds) {
  const auto list_or_null = [](const std::vector<double>& values) {
    return values.empty() ? Json(nullptr) : Json(values);
  };
  Json json = {{"schema", "blossom.subdivision/1"},
               {"file", input.name},
               {"whole", true},
               {"interval", list_or_null(question.interval)},
               {"rectangle", list_or_null(question.rectangle)},
               {"seconds", seconds},
               {"pieces", parts.size()},
               {"splines", Json::array()},
               {"repairs", Json::array({repairs_json(input)})}};
  for (const WholePart& part : parts) json["splines"].push_back(part.json);
  return json;
}

}  // namespace

int run_whole(const WholeQuestion& question) {
  check_files(question.common, {question.input});
  if (nets::is_net_file(parse_input(question.input).file))
    throw UsageError(question.input + ": --whole takes models; nets are one piece already");
  const bool edges = !question.interval.empty();
  const Input input = read_input(question.input, edges ? Faces::Optional : Faces::Required);
  const Stopwatch watch;
  const std::vector<WholePart> parts = whole_parts(input, question);
  const double seconds = watch.seconds();
  const Json report = report_of(input, question, parts, seconds);
  const std::vector<PictureFile> pictures =
      picture_files(question.common, [&] { return picture_of(question.input, parts); });
  stop_if_interrupted();
  if (!question.common.output.empty()) write_parts(input, parts, question.common.output);
  write_pictures(pictures);
  if (!question.common.json.empty()) write_json(report, question.common.json);
  print_summary(summary_of(question.input, parts, seconds), question.common.json);
  return kExitComplete;
}

}  // namespace blossom::cli
