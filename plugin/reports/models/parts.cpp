// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/parts.h"

#include <map>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/trim_tool.h"
#include "plugin/reports/models/measured_input.h"

namespace blossom::reports {
namespace {

// The faces of an input by their places, with the names of their parts.
class PartNames {
 public:
  explicit PartNames(const Input& input) : paths_(input.model.part_paths()), input_(input) {
    for (const TopoDS_Face& face : input.faces) faces_.Add(face);
  }
  std::string of(const TopoDS_Shape& face) const {
    const int place = faces_.FindIndex(face);
    if (place == 0) return {};
    const int number = input_.numbers[static_cast<std::size_t>(place - 1)];
    return given_name(paths_[static_cast<std::size_t>(number - 1)]);
  }

 private:
  std::vector<std::string> paths_;
  const Input& input_;
  TopTools_IndexedMapOfShape faces_;
};

// Where several parts have one name, their numbers tell them apart.
void tell_apart(std::vector<NamedPart>& parts) {
  std::map<std::string, int> uses;
  for (const NamedPart& part : parts) ++uses[part.part];
  for (NamedPart& part : parts) {
    const std::string number =
        part.solid > 0 ? "solid " + std::to_string(part.solid) : std::string("surface");
    part.name = part.part.empty()      ? number
                : uses[part.part] == 1 ? part.part
                                       : part.part + " (" + number + ")";
  }
}

}  // namespace

std::vector<NamedPart> named_parts(const Input& input) {
  const PartNames names(input);
  std::vector<NamedPart> parts;
  TopTools_IndexedMapOfShape solids, bounding;
  const TopoDS_Shape chosen = chosen_shape(input);
  TopExp::MapShapes(chosen, TopAbs_SOLID, solids);
  TopTools_IndexedMapOfShape numbered;
  TopExp::MapShapes(input.model.shape(), TopAbs_SOLID, numbered);
  for (int i = 1; i <= solids.Extent(); ++i) {
    if (!occt::is_closed_solid(solids(i))) continue;
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(solids(i), TopAbs_FACE, own);
    for (int k = 1; k <= own.Extent(); ++k) bounding.Add(own(k));
    parts.push_back(
        {solids(i), &input, {}, names.of(own(1)), numbered.FindIndex(solids(i)), own.Extent()});
  }
  std::map<std::string, std::vector<TopoDS_Face>> rest;
  for (const TopoDS_Face& face : input.faces)
    if (!bounding.Contains(face)) rest[names.of(face)].push_back(face);
  for (const auto& [part, faces] : rest)
    parts.push_back(
        {occt::compound_of(faces), &input, {}, part, 0, static_cast<int>(faces.size())});
  tell_apart(parts);
  return parts;
}

FacesOfPart faces_of(const NamedPart& part) {
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(part.shape, TopAbs_FACE, own);
  FacesOfPart found;
  for (std::size_t i = 0; i < part.input->faces.size(); ++i)
    if (own.Contains(part.input->faces[i])) {
      found.faces.push_back(part.input->faces[i]);
      found.numbers.push_back(part.input->numbers[i]);
    }
  return found;
}

}  // namespace blossom::reports
