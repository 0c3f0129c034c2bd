// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/drawings/section_drawing.h"

#include <string>
#include <utility>
#include <vector>

#include "adapters/occt/shapes.h"
#include "core/bounds/box_tree.h"
#include "plugin/drawings/drawing.h"
#include "plugin/drawings/dxf.h"
#include "plugin/drawings/svg.h"
#include "plugin/reports/text/lower_case.h"

namespace blossom::drawings {
namespace {

using reports::PartSection;
using reports::SectionsAnswer;
using reports::SectionsOfPlane;

// Of the size of all sections: how far polylines may be off their curves.
constexpr double kDrawnDeviation = 1e-5;

double size_of(const SectionsAnswer& answer) {
  Box box;
  for (const SectionsOfPlane& plane : answer.planes)
    for (const PartSection& part : plane.parts)
      for (const occt::SectionCurve& curve : part.section.curves)
        for (const Vec3& point : curve.samples) box = joined(box, Box{point, point});
  return box.low[0] > box.high[0] ? 1 : diagonal(box);
}

std::vector<DrawnPlane> drawn_planes(const SectionsAnswer& answer) {
  const double deviation = kDrawnDeviation * size_of(answer);
  std::vector<DrawnPlane> planes;
  for (const SectionsOfPlane& of : answer.planes) {
    const DrawingFrame frame(of.plane.plane);
    DrawnPlane& plane = planes.emplace_back();
    plane.name = of.plane.name;
    plane.layer = of.plane.named ? of.plane.name : "plane " + std::to_string(planes.size());
    plane.elevation = dot(frame.normal, of.plane.plane.point);
    for (const PartSection& part : of.parts) {
      DrawnPart made = drawn(part.section, frame, deviation);
      made.name = part.name;
      made.solid = part.solid;
      plane.parts.push_back(std::move(made));
    }
  }
  return planes;
}

}  // namespace

bool is_drawing_file(const std::filesystem::path& file) {
  const std::string ending = reports::lower_ending(file);
  return ending == ".dxf" || ending == ".svg";
}

void write_section_drawing(const SectionsAnswer& answer, const std::filesystem::path& file,
                           const std::function<void()>& stop) {
  const std::vector<DrawnPlane> planes = drawn_planes(answer);
  const bool as_svg = reports::lower_ending(file) == ".svg";
  occt::write_text(as_svg ? svg_text(planes) : dxf_text(planes), file, stop);
}

}  // namespace blossom::drawings
