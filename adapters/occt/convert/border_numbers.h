// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of what is not a face, as every door gives them.

#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

struct BorderNumber {
  const char* kind = "face";  ///< face, edge or vertex
  int number = 0;             ///< 1-based
};

/// Numbers of a model's edges and vertices, 1-based in the order of TopExp::MapShapes.
class BorderNumbers {
 public:
  explicit BorderNumbers(const TopoDS_Shape& shape);

  /// The face with its given number where `on` is null.
  BorderNumber of(const TopoDS_Shape& on, int face) const;

 private:
  TopTools_IndexedMapOfShape edges_;
  TopTools_IndexedMapOfShape vertices_;
};

}  // namespace blossom::occt
