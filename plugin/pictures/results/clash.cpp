// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/clash.h"

#include <set>
#include <utility>
#include <vector>

#include "adapters/occt/intersection_edges.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::pictures {
namespace {

using reports::ClashAnswer;
using reports::ClashRow;
using reports::number_text;
using reports::rounded;
using reports::short_name;

std::string names_of(const ClashRow& row, const ClashAnswer& answer) {
  return displayed_name(answer, row.a) + " and " + displayed_name(answer, row.b);
}

std::set<std::size_t> clashing_parts(const std::vector<ClashRow>& rows) {
  std::set<std::size_t> parts;
  for (const ClashRow& row : rows)
    if (row.clash->common) parts.insert({row.a, row.b});
  return parts;
}

void add_faces(const TopoDS_Shape& shape, const std::string& label, PictureFaces& group) {
  for (const TopoDS_Face& face : occt::faces_of(shape)) {
    group.faces.push_back(face);
    group.labels.push_back(label);
  }
}

// Parts, then what they have in common.
std::vector<PictureFaces> groups_of(const ClashAnswer& answer, const std::vector<ClashRow>& rows) {
  PictureFaces clear{{}, kToolColour, kToolOpacity, "parts that are clear or touch"};
  PictureFaces clashing{{}, kFirstColour, kToolOpacity, "parts that clash"};
  PictureFaces common{{}, kCurveColour, 1, "in common"};
  const std::set<std::size_t> of_clashes = clashing_parts(rows);
  for (std::size_t i = 0; i < answer.parts.size(); ++i)
    add_faces(answer.parts[i].shape, displayed_name(answer, i),
              of_clashes.count(i) > 0 ? clashing : clear);
  for (const ClashRow& row : rows)
    if (row.clash->common)
      for (const TopoDS_Solid& solid : row.clash->common->solids)
        add_faces(solid,
                  names_of(row, answer) + "\nvolume " +
                      number_text(rounded(row.clash->common->volume)) + " mm³",
                  common);
  std::vector<PictureFaces> groups;
  for (PictureFaces* group : {&clear, &clashing, &common})
    if (!group->faces.empty()) groups.push_back(std::move(*group));
  return groups;
}

}  // namespace

Picture clash_picture(const ClashAnswer& answer) {
  const std::vector<ClashRow> rows = reports::rows_of(answer, reports::ClashRows::Near);
  Picture picture;
  picture.title = "clashes of " + short_name(answer.inputs.front()->name);
  if (answer.inputs.size() > 1) picture.title += ", " + short_name(answer.inputs.back()->name);
  picture.subtitle = counted_pairs(answer);
  picture.groups = groups_of(answer, rows);
  PictureLayer contacts{"touching", kTouchColour, LayerStyle::Ring};
  PictureLayer distances{"distance", kOverlapColour, LayerStyle::Net};
  for (const ClashRow& row : rows) {
    const occt::Clash& clash = *row.clash;
    const std::string names = names_of(row, answer) + "\n";
    for (const occt::BodyContact& contact : clash.contacts)
      contacts.items.push_back({{contact.point}, names + to_string(contact.kind)});
    if (clash.relation == occt::Relation::Disjoint && clash.measured)
      distances.items.push_back({{clash.near_a.point, clash.near_b.point},
                                 names + "distance " + number_text(rounded(clash.upper)) + " mm"});
  }
  picture.layers = {std::move(distances), std::move(contacts)};
  return picture;
}

}  // namespace blossom::pictures
