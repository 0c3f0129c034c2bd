// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/measured_input.h"

#include <utility>

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/compounds.h"

namespace blossom::reports {

int face_number(const Input& input, const TopoDS_Shape& on) {
  for (std::size_t i = 0; i < input.faces.size(); ++i)
    if (input.faces[i].IsSame(on)) return input.numbers[i];
  return 0;
}

std::string part_with(const Input& input, const TopoDS_Shape& on) {
  for (std::size_t i = 0; i < input.faces.size() && !on.IsNull(); ++i)
    for (TopExp_Explorer it(input.faces[i], on.ShapeType()); it.More(); it.Next())
      if (it.Current().IsSame(on))
        return given_name(input.model.part_paths()[static_cast<std::size_t>(input.numbers[i] - 1)]);
  return {};
}

std::string part_of(const Input& input, const occt::Body& body) {
  const TopExp_Explorer first(body.shape, TopAbs_FACE);
  for (std::size_t i = 0; i < input.faces.size() && first.More(); ++i)
    if (input.faces[i].IsSame(first.Current()))
      return given_name(input.model.part_paths()[static_cast<std::size_t>(input.numbers[i] - 1)]);
  return {};
}

int solid_number(const Input& input, const occt::Body& body) {
  if (input.selected.IsNull()) return body.solid;
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(input.model.shape(), TopAbs_SOLID, solids);
  return solids.FindIndex(body.shape);
}

TopoDS_Shape chosen_shape(const Input& input) {
  if (!input.selected.IsNull()) return input.selected;
  if (input.faces.empty() || static_cast<int>(input.faces.size()) == input.model.face_count())
    return input.model.shape();
  return occt::compound_of(input.faces);
}

MeasuredInput::MeasuredInput(Input given) : input(std::move(given)), numbers(input.model.shape()) {}

void MeasuredInput::prepare() { bodies.emplace(chosen_shape(input)); }

Json MeasuredInput::json(const occt::ShapePoint& place) const {
  const int face = face_number(input, place.on);
  Json json = {{"point", place.point.coordinates},
               {"on", numbers.place(face > 0 ? TopoDS_Shape() : place.on, face)}};
  if (face > 0) json["uv"] = place.uv.coordinates;
  if (const std::string part = part_with(input, place.on); !part.empty()) json["part"] = part;
  return json;
}

int MeasuredInput::solids() const {
  int count = 0;
  for (const occt::Body& body : bodies->all()) count += body.is_solid() ? 1 : 0;
  return count;
}

int MeasuredInput::surface_faces() const {
  for (const occt::Body& body : bodies->all())
    if (!body.is_solid()) return body.faces;
  return 0;
}

Json MeasuredInput::body_json(std::size_t body) const {
  const occt::Body& of = bodies->all()[body];
  Json json = {{"solid", of.is_solid() ? Json(solid_number(input, of)) : Json()}};
  if (const std::string part = part_of(input, of); of.is_solid() && !part.empty())
    json["part"] = part;
  return json;
}

}  // namespace blossom::reports
