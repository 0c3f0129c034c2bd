// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/blends/strip.h"

#include <algorithm>
#include <optional>
#include <set>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/reports/models/entity_words.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::reports {
namespace {

TopTools_IndexedMapOfShape edges_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  return edges;
}

/// The edge of a model's face with a number of the model.
TopoDS_Edge edge_numbered(const TopoDS_Shape& model, const TopoDS_Face& face,
                          const std::string& name, int number) {
  const TopTools_IndexedMapOfShape all = edges_of(model), own = edges_of(face);
  std::set<int> numbers;
  for (int i = 1; i <= own.Extent(); ++i) numbers.insert(all.FindIndex(own(i)));
  if (numbers.count(number) != 0) return TopoDS::Edge(all(number));
  std::string known;
  for (const int each : numbers) known += (known.empty() ? "" : ", ") + std::to_string(each);
  throw occt::BadModel(name + ": edge " + std::to_string(number) +
                       " is none of the face, which has " + known);
}

Json contact_json(const StripContact& contact) {
  return {{"gap", contact.gap},
          {"normal_angle", contact.normal_angle},
          {"curvature_difference", contact.curvature},
          {"scale", contact.scale}};
}

Json start_json(const Input& input, const occt::StripStart& start) {
  if (start.side) return to_string(*start.side);
  return edges_of(input.shape).FindIndex(start.edge);
}

Json end_json(const Input& input, const occt::FaceStripEnd& end, double weight) {
  return {{"file", input.name},
          {"face", input.numbers.front()},
          {"edge", start_json(input, end.start)},
          {"weight", weight},
          {"exact", end.exact},
          {"fit_error", end.fit_error}};
}

}  // namespace

occt::StripStart strip_start(const TopoDS_Shape& model, const TopoDS_Face& face,
                             const std::string& name, const std::string& border) {
  if (border.empty()) return {};
  for (const SurfaceSide side :
       {SurfaceSide::UMin, SurfaceSide::UMax, SurfaceSide::VMin, SurfaceSide::VMax})
    if (border == to_string(side)) return {.side = side};
  const std::optional<int> number = entity_number(border, "edge");
  if (!number)
    throw InvalidInput("a border is umin, umax, vmin, vmax or the number of an edge, not '" +
                       border + "'");
  return {.edge = edge_numbered(model, face, name, *number)};
}

std::string start_text(const TopoDS_Shape& model, const occt::StripStart& start) {
  if (start.side) return to_string(*start.side);
  return "edge " + std::to_string(edges_of(model).FindIndex(start.edge));
}

occt::FaceStrip strip_between(const Input& a, const Input& b, const StripWishes& wishes) {
  const TopoDS_Face &face_a = a.faces.front(), &face_b = b.faces.front();
  return occt::strip_between(face_a, face_b,
                             {.start_a = strip_start(a.shape, face_a, a.name, wishes.border_a),
                              .start_b = strip_start(b.shape, face_b, b.name, wishes.border_b),
                              .strip = wishes.strip});
}

StripContact worst_of(const Strip& strip) {
  const auto& [a, b] = strip.contacts;
  return {std::max(a.gap, b.gap), std::max(a.normal_angle, b.normal_angle),
          std::max(a.curvature, b.curvature), 0};
}

Json strip_report(const Input& a, const Input& b, const StripWishes& wishes,
                  const occt::FaceStrip& made, double seconds) {
  const StripContact worst = worst_of(made.strip);
  return {{"schema", "blossom.blend/1"},
          {"kind", "strip"},
          {"a", end_json(a, made.ends[0], wishes.strip.weight_a)},
          {"b", end_json(b, made.ends[1], wishes.strip.weight_b)},
          {"backward", made.strip.backward},
          {"degree", {made.surface->UDegree(), made.surface->VDegree()}},
          {"spans", {made.surface->NbUKnots() - 1, made.surface->NbVKnots() - 1}},
          {"rational", made.strip.surface.rational},
          {"continuity",
           {{"order", wishes.strip.order},
            {"gap", worst.gap},
            {"normal_angle", worst.normal_angle},
            {"curvature_difference", worst.curvature},
            {"a", contact_json(made.strip.contacts[0])},
            {"b", contact_json(made.strip.contacts[1])}}},
          {"source_error", made.strip.surface.error},
          {"seconds", seconds},
          {"repairs", Json::array({repairs_json(a), repairs_json(b)})}};
}

}  // namespace blossom::reports
