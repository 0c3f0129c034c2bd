// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts in no assembly, without colours, layers and dimensions: all that many files and commands
// need. For this folder and `documents` only.

#pragma once

#include <string>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/shapes.h"

namespace blossom::occt {

/// A shape in a part that has a name of its own.
struct NamedShape {
  TopoDS_Shape shape;
  std::string name;
};

struct PlainPart {
  TopoDS_Shape shape;
  std::string name = {};
  std::vector<NamedShape> named = {};  ///< solids before shells before faces
};

using PlainParts = std::vector<PlainPart>;

/// The shape of all parts, in one compound if there are several; null if there are none.
TopoDS_Shape whole_of(const PlainParts& parts);

// As the functions of Model are; face numbers are those of the whole shape.
std::vector<std::string> face_names(const PlainParts& parts,
                                    const TopTools_IndexedMapOfShape& faces);
std::vector<std::string> part_paths(const PlainParts& parts,
                                    const TopTools_IndexedMapOfShape& faces);
std::vector<AssemblyNode> assembly(const PlainParts& parts, const TopoDS_Shape& whole,
                                   const TopTools_IndexedMapOfShape& faces);
std::string part_name(const PlainParts& parts, const TopoDS_Face& face);

/// Solids and faces of a model by their numbers.
struct NumberedShapes {
  TopTools_IndexedMapOfShape solids;
  const TopTools_IndexedMapOfShape& faces;

  NumberedShapes(const TopoDS_Shape& whole, const TopTools_IndexedMapOfShape& all_faces);

  /// Gives a node the numbers of those in a shape.
  void put(const TopoDS_Shape& shape, AssemblyNode& node) const;
};

/// Gives the faces of a shape a name, by number - 1, unless it is empty.
void name_faces(const TopoDS_Shape& shape, const std::string& name,
                const TopTools_IndexedMapOfShape& faces, std::vector<std::string>& names);

}  // namespace blossom::occt
