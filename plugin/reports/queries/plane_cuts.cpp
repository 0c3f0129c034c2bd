// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/queries/plane_cuts.h"

#include <chrono>
#include <string>
#include <utility>

#include "plugin/reports/models/edges.h"
#include "plugin/reports/models/parts.h"

namespace blossom::reports {
namespace {

// A part of the model, with its faces made ready.
struct ReadyPart {
  std::string name;
  bool solid = false;
  std::vector<int> numbers{};
  occt::SectionedFaces faces;
};

std::vector<ReadyPart> ready_parts(const Input& input, double tolerance) {
  std::vector<ReadyPart> parts;
  for (const NamedPart& part : named_parts(input)) {
    const FacesOfPart own = faces_of(part);
    parts.push_back(
        {part.name, part.solid > 0, own.numbers, occt::SectionedFaces(own.faces, tolerance)});
  }
  if (const std::vector<TopoDS_Edge> edges = edges_without_faces(input); !edges.empty())
    parts.push_back({"edges", false, {}, occt::SectionedFaces({}, tolerance, edges)});
  return parts;
}

bool is_empty(const occt::PlaneSection& section) {
  return section.wires.empty() && section.points.empty() && section.places.empty();
}

SectionsOfPlane sections_with(const NamedPlane& plane, std::vector<ReadyPart>& parts,
                              const CutControl& control, Status& status) {
  SectionsOfPlane made{plane, {}};
  for (ReadyPart& part : parts) {
    control.stop();
    PartSection section{part.name, part.solid, part.numbers,
                        part.faces.section(plane.plane, control.engine())};
    status = weaker(status, section.section.status);
    if (is_empty(section.section)) continue;
    occt::orient_wires(section.section, plane.plane);
    made.parts.push_back(std::move(section));
  }
  return made;
}

}  // namespace

SectionsAnswer sections_of(const Input& input, const std::vector<NamedPlane>& planes,
                           const CutControl& control) {
  const auto start = std::chrono::steady_clock::now();
  SectionsAnswer answer;
  answer.tolerance = control.tolerance;
  std::vector<ReadyPart> parts = ready_parts(input, control.tolerance);
  for (const NamedPlane& plane : planes)
    answer.planes.push_back(sections_with(plane, parts, control, answer.status));
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

occt::Model model_of(const SectionsAnswer& answer) {
  occt::Model model;
  for (const SectionsOfPlane& plane : answer.planes) {
    std::vector<std::pair<std::string, TopoDS_Shape>> parts;
    for (const PartSection& part : plane.parts)
      if (!part.section.wires.empty() || !part.section.points.empty())
        parts.emplace_back(part.name, occt::compound_of(part.section));
    if (!parts.empty()) model.add_assembly(parts, plane.plane.name);
  }
  return model;
}

}  // namespace blossom::reports
