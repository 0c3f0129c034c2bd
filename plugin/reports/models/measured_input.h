// SPDX-License-Identifier: LGPL-2.1-or-later
// Models of questions about distances, and how reports speak of their bodies and places.

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "adapters/occt/bodies.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/models/shape_numbers.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// The number of a face among those of the input; 0 of what is no such face.
int face_number(const Input& input, const TopoDS_Shape& on);

/// The part that a face belongs to, or a face with the edge or vertex; empty if it has no name.
std::string part_with(const Input& input, const TopoDS_Shape& on);

/// The part of a body by its first face; empty if it has none, or no name.
std::string part_of(const Input& input, const occt::Body& body);

/// The number of a body that is a solid, in the order of TopExp::MapShapes of the model.
int solid_number(const Input& input, const occt::Body& body);

/// What the user names; the whole model, with free edges and vertices, if that is all.
TopoDS_Shape chosen_shape(const Input& input);

/// One model of a question.
struct MeasuredInput {
  Input input;
  ShapeNumbers numbers;
  std::optional<occt::Bodies> bodies{};  ///< once it is prepared

  explicit MeasuredInput(Input given);
  void prepare();

  /// {"point", "on", "uv" of a face}: where a distance is taken.
  Json json(const occt::ShapePoint& place) const;

  int solids() const;         ///< closed ones
  int surface_faces() const;  ///< that bound no closed solid

  /// {"solid": 2, "part": "bolt"}; the solid is null of a surface.
  Json body_json(std::size_t body) const;
};

}  // namespace blossom::reports
