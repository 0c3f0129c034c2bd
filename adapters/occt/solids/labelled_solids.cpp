// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/labelled_solids.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/compounds.h"

namespace blossom::occt {

InputFaceNames names_of_faces(const TrimTool& part, const std::vector<TrimTool>& tools) {
  InputFaceNames names;
  const auto add = [&](const TrimTool& input, const std::string& owner) {
    std::vector<std::string>& own = names.emplace_back();
    for (std::size_t face = 0; face < input.faces.size(); ++face)
      own.push_back(face_name(input, face, owner));
  };
  add(part, "the part");
  for (std::size_t i = 0; i < tools.size(); ++i)
    add(tools[i], tools.size() == 1 ? "the tool" : "tool " + std::to_string(i + 1));
  return names;
}

LabelledSolid labelled(const std::vector<TopoDS_Solid>& solids, const std::vector<SolidFace>& known,
                       const InputFaceNames& names) {
  TopTools_IndexedMapOfShape numbers;
  for (const SolidFace& face : known) numbers.Add(face.face);
  LabelledSolid made{solid_tool(solids), {}};
  for (const TopoDS_Face& face : made.solid.faces) {
    const SolidFace& origin = known[static_cast<std::size_t>(numbers.FindIndex(face)) - 1];
    made.faces.push_back({face, origin.tool, origin.from});
    made.solid.face_names.push_back(
        names[static_cast<std::size_t>(origin.tool + 1)][static_cast<std::size_t>(origin.from)]);
  }
  return made;
}

LabelledInputs::LabelledInputs(const TrimTool& part, const std::vector<TrimTool>& tools,
                               const InputFaceNames& names, double tolerance,
                               const SharedLimit& limit)
    : names_(names) {
  const auto add = [this](const TrimTool& input) {
    const int tool = static_cast<int>(faces_.size()) - 1;
    std::vector<SolidFace>& faces = faces_.emplace_back();
    for (const TopoDS_Face& face : input.faces)
      faces.push_back({face, tool, static_cast<int>(faces.size())});
    solids_.insert(solids_.end(), input.solids.begin(), input.solids.end());
    input_.resize(solids_.size(), tool + 1);
  };
  add(part);
  for (const TrimTool& tool : tools) add(tool);
  contacts_.emplace(solids_, tolerance, limit);
  SolidPlaces all(solids_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  layers_.push_back(layers_of(all, 0));
  for (std::size_t i = 0; i < tools.size(); ++i)
    layers_.push_back(tools[i].is_solid() ? layers_of(all, static_cast<int>(i) + 1)
                                          : LabelledSolids{{tools[i], faces_[i + 1]}});
}

LabelledSolids LabelledInputs::layers_of(const SolidPlaces& places, int input) {
  SolidPlaces own;
  std::ranges::copy_if(places, std::back_inserter(own),
                       [&](std::size_t place) { return input_[place] == input; });
  LabelledSolids made;
  for (const SolidPlaces& layer : contacts_->layers(own)) {
    std::vector<TopoDS_Solid> solids;
    for (const std::size_t place : layer) solids.push_back(solids_[place]);
    made.push_back(labelled(solids, faces_[static_cast<std::size_t>(input)], names_));
  }
  return made;
}

LabelledSolids LabelledInputs::gathered_tools() {
  struct Group {
    SolidPlaces places;
    std::vector<SolidFace> known;
  };
  std::vector<Group> groups;
  for (std::size_t input = 1; input < layers_.size(); ++input) {
    Group own{{}, faces_[input]};
    for (std::size_t place = 0; place < solids_.size(); ++place)
      if (input_[place] == static_cast<int>(input)) own.places.push_back(place);
    if (own.places.empty() || layers_[input].size() != 1) return {};
    const auto meets_none = [&](const Group& group) {
      return std::ranges::none_of(group.places, [&](std::size_t other) {
        return std::ranges::any_of(
            own.places, [&](std::size_t place) { return contacts_->meet(place, other); });
      });
    };
    const auto group = std::ranges::find_if(groups, meets_none);
    if (group == groups.end()) {
      groups.push_back(std::move(own));
      continue;
    }
    group->places.insert(group->places.end(), own.places.begin(), own.places.end());
    group->known.insert(group->known.end(), own.known.begin(), own.known.end());
  }
  LabelledSolids made;
  for (const Group& group : groups) {
    std::vector<TopoDS_Solid> solids;
    for (const std::size_t place : group.places) solids.push_back(solids_[place]);
    made.push_back(labelled(solids, group.known, names_));
  }
  return made;
}

std::vector<std::vector<LabelledSolids>> LabelledInputs::joined() {
  // Without solids that must not become one there is nothing to tell apart.
  if (std::ranges::all_of(layers_, [](const LabelledSolids& layers) { return layers.size() == 1; }))
    return {layers_};
  std::vector<std::vector<LabelledSolids>> sets;
  for (const SolidPlaces& set : contacts_->joined(input_)) {
    sets.emplace_back();
    for (std::size_t input = 0; input < faces_.size(); ++input)
      if (LabelledSolids layers = layers_of(set, static_cast<int>(input)); !layers.empty())
        sets.back().push_back(std::move(layers));
  }
  return sets;
}

}  // namespace blossom::occt
