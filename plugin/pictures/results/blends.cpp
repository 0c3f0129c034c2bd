// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/blends.h"

#include <string>
#include <vector>

#include "plugin/reports/text/json.h"

namespace blossom::pictures {

using reports::counted;
using reports::Input;
using reports::short_name;

Picture fillet_picture(const Input& part, const reports::FilletAnswer& answer) {
  const occt::FilletResult& made = answer.made;
  const std::string kind = answer.of.chamfer ? "chamfer" : "fillet";
  Picture picture;
  picture.title = kind + "s of " + short_name(part.name);
  picture.subtitle = done_text(answer);
  picture.groups = {{{}, kFirstColour, 1, "faces"}, {{}, kSecondColour, 1, kind + "s"}};
  const reports::FaceLabels labels(part);
  if (made.solids.empty()) picture.groups.front().faces = part.faces;
  for (const occt::FilletedSolid& solid : made.solids)
    for (const occt::FilletFace& face : solid.faces) {
      PictureFaces& group = picture.groups[face.from > 0 ? 0 : 1];
      group.faces.push_back(face.face);
      group.labels.push_back(face.from > 0   ? labels.of(face.from)
                             : face.edge > 0 ? kind + " of edge " + std::to_string(face.edge)
                                             : kind + " of a corner");
    }
  return picture;
}

Picture fill_picture(const Input& input, const reports::FillAnswer& holes) {
  std::vector<TopoDS_Face> faces;
  for (const reports::Hole& hole : holes.all)
    faces.insert(faces.end(), hole.filled.faces.begin(), hole.filled.faces.end());
  Picture picture;
  picture.title = "fill of " + short_name(input.name);
  picture.subtitle = counted(holes.filled(), "hole") + " filled";
  picture.groups = {{input.faces, kFirstColour, 1, short_name(input.name)},
                    {faces, kSecondColour, 1, "patches"}};
  return picture;
}

Picture strip_picture(const Input& a, const Input& b, const occt::FaceStrip& strip) {
  Picture picture;
  picture.title = "strip from " + short_name(a.name) + " to " + short_name(b.name);
  picture.groups = {{a.faces, kFirstColour, 1, short_name(a.name)},
                    {b.faces, kFirstColour, 1, short_name(b.name)},
                    {{strip.face}, kSecondColour, 1, "strip"}};
  return picture;
}

}  // namespace blossom::pictures
