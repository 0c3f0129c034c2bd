// SPDX-License-Identifier: LGPL-2.1-or-later
// The parts of a model: closed solids, and faces that bound none.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "plugin/reports/models/input.h"

namespace blossom::reports {

/// A closed solid of a model, or the faces of one of its parts that bound none.
struct NamedPart {
  TopoDS_Shape shape;
  const Input* input = nullptr;
  std::string name;  ///< what tells it from all others of the model
  std::string part;  ///< the names of instances that lead to it; may be empty
  int solid = 0;     ///< 1-based in the order of TopExp::MapShapes; 0 of faces
  int faces = 0;
};

/// The parts of an input in their order, solids first.
std::vector<NamedPart> named_parts(const Input& input);

/// The faces of a part, as its input has them.
struct FacesOfPart {
  std::vector<TopoDS_Face> faces;
  std::vector<int> numbers;
};
FacesOfPart faces_of(const NamedPart& part);

}  // namespace blossom::reports
