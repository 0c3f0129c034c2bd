// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/sections.h"

#include <cstddef>
#include <string>
#include <utility>

#include "plugin/reports/text/json.h"

namespace blossom::pictures {

using reports::counted;
using reports::Input;
using reports::short_name;

Picture section_picture(const Input& input, const occt::PlaneSection& section, Status stated) {
  Picture picture;
  picture.title = "section of " + short_name(input.name);
  picture.subtitle = std::string(to_string(stated)) + ": " + counted(section.wires.size(), "wire");
  picture.groups = {{input.faces, kFirstColour, kFirstOpacity, short_name(input.name)}};
  PictureLayer curves{"section", kCurveColour};
  PictureLayer points{"isolated point", kCurveColour, LayerStyle::Dot};
  for (const occt::SectionCurve& curve : section.curves) curves.items.push_back({curve.samples});
  for (const std::size_t node : section.points)
    points.items.push_back({{section.nodes[node].point}});
  picture.layers = {std::move(curves), std::move(points)};
  return picture;
}

Picture sections_picture(const Input& input, const reports::SectionsAnswer& answer) {
  Picture picture;
  picture.title = "sections of " + short_name(input.name);
  picture.subtitle = counted(answer.planes.size(), "plane");
  picture.groups = {{input.faces, kFirstColour, kFirstOpacity, short_name(input.name)}};
  PictureLayer curves{"section", kCurveColour};
  PictureLayer points{"isolated point", kCurveColour, LayerStyle::Dot};
  for (const reports::SectionsOfPlane& plane : answer.planes)
    for (const reports::PartSection& part : plane.parts) {
      const std::string label = plane.plane.name + "\n" + part.name;
      for (const occt::SectionCurve& curve : part.section.curves)
        curves.items.push_back({curve.samples, label});
      for (const std::size_t node : part.section.points)
        points.items.push_back({{part.section.nodes[node].point}, label});
    }
  picture.layers = {std::move(curves), std::move(points)};
  return picture;
}

}  // namespace blossom::pictures
