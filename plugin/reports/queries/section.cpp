// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/queries/section.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "plugin/reports/cuts/intersection.h"
#include "plugin/reports/models/repairs.h"
#include "plugin/reports/models/shape_numbers.h"

namespace blossom::reports {
namespace {

// faces   their numbers, in the order in which the section has them
Json curve_json(const std::vector<int>& faces, const ShapeNumbers& numbers,
                const occt::SectionCurve& curve) {
  const int face = curve.face < 0 ? 0 : faces[static_cast<std::size_t>(curve.face)];
  Json json = {{"on", numbers.place(curve.edge, face)},
               {"nodes", curve.nodes},
               {"closed", curve.closed},
               {"tangential", curve.tangential},
               {"length", curve.length},
               {"conic", to_json(curve.conic, curve.range)},
               {"deviation", curve.deviation},
               {"deviation_proven", curve.deviation_proven}};
  json["points"] = Json::array();
  for (const Vec3& p : curve.samples) json["points"].push_back(p.coordinates);
  return json;
}

Json node_json(const ShapeNumbers& numbers, const occt::SectionNode& node) {
  return {{"point", node.point.coordinates},
          {"on", node.on.IsNull() ? Json() : numbers.place(node.on, 0)},
          {"reach", node.reach},
          {"proven", node.proven}};
}

Json wire_json(const occt::SectionWire& wire) {
  Json json = {{"closed", wire.closed},
               {"bounding", wire.bounding},
               {"length", wire.length},
               {"area", wire.area ? Json(std::abs(*wire.area)) : Json()},
               {"curves", Json::array()}};
  for (const occt::CurveUse& use : wire.uses)
    json["curves"].push_back({{"curve", use.curve}, {"forward", use.forward}});
  return json;
}

// What was found, after the members of the question.
void add_section(const occt::PlaneSection& section, const std::vector<int>& faces,
                 const ShapeNumbers& numbers, Json& report) {
  for (const char* list : {"wires", "curves", "nodes", "points", "faces_in_plane", "places"})
    report[list] = Json::array();
  for (const occt::SectionWire& wire : section.wires) report["wires"].push_back(wire_json(wire));
  for (const occt::SectionCurve& curve : section.curves)
    report["curves"].push_back(curve_json(faces, numbers, curve));
  for (const occt::SectionNode& node : section.nodes)
    report["nodes"].push_back(node_json(numbers, node));
  for (const std::size_t node : section.points) report["points"].push_back(node);
  for (const int face : section.faces_in_plane)
    report["faces_in_plane"].push_back(faces[static_cast<std::size_t>(face)]);
  for (const occt::SectionPlace& place : section.places) {
    Json json = to_json(place.place);
    json["face"] = faces[static_cast<std::size_t>(place.face)];
    report["places"].push_back(json);
  }
  report["certificate"] = to_json(section.certificate);
  report["certificate"]["faces_searched"] = section.faces_searched;
}

Json plane_json(const SectionsOfPlane& of, const ShapeNumbers& numbers) {
  const NamedPlane& plane = of.plane;
  Json json = {{"name", plane.name},
               {"point", plane.plane.point.coordinates},
               {"normal", plane.plane.normal.coordinates},
               {"offset", plane.offset ? Json(*plane.offset) : Json()},
               {"parts", Json::array()}};
  for (const PartSection& part : of.parts) {
    const std::optional<double> area = occt::bounded_area(part.section);
    Json section = {{"part", part.name},
                    {"solid", part.solid},
                    {"status", to_string(part.section.status)},
                    {"area", area ? Json(*area) : Json()}};
    add_section(part.section, part.numbers, numbers, section);
    json["parts"].push_back(std::move(section));
  }
  return json;
}

}  // namespace

Json section_report(const Input& input, const occt::Plane& plane, double tolerance,
                    const occt::PlaneSection& section, double seconds) {
  Json report = {{"schema", "blossom.query/1"},
                 {"kind", "plane"},
                 {"file", input.name},
                 {"point", plane.point.coordinates},
                 {"normal", plane.normal.coordinates},
                 {"tolerance", tolerance},
                 {"status", to_string(section.status)},
                 {"seconds", seconds}};
  add_section(section, input.numbers, ShapeNumbers(input.model.shape()), report);
  report["repairs"] = Json::array({repairs_json(input)});
  return report;
}

bool has_shape(const SectionsAnswer& answer) {
  return std::ranges::any_of(answer.planes, [](const SectionsOfPlane& plane) {
    return std::ranges::any_of(plane.parts, [](const PartSection& part) {
      return !part.section.wires.empty() || !part.section.points.empty();
    });
  });
}

Json sections_report(const Input& input, const SectionsAnswer& answer) {
  const ShapeNumbers numbers(input.model.shape());
  Json report = {{"schema", "blossom.sections/1"}, {"file", input.name},
                 {"tolerance", answer.tolerance},  {"status", to_string(answer.status)},
                 {"seconds", answer.seconds},      {"planes", Json::array()}};
  for (const SectionsOfPlane& plane : answer.planes)
    report["planes"].push_back(plane_json(plane, numbers));
  report["repairs"] = Json::array({repairs_json(input)});
  return report;
}

}  // namespace blossom::reports
