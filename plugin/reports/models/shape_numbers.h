// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of what is not a face, as reports give them.

#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/convert/border_numbers.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// Numbers of a model's edges and vertices, 1-based in the order of TopExp::MapShapes.
class ShapeNumbers {
 public:
  explicit ShapeNumbers(const TopoDS_Shape& shape) : numbers_(shape) {}

  /// {"kind": "edge", "number": 3}; kind "face" with the given number where `on` is null.
  Json place(const TopoDS_Shape& on, int face) const;
  /// "face 2", "edge 3".
  std::string text(const TopoDS_Shape& on, int face) const;

 private:
  occt::BorderNumbers numbers_;
};

}  // namespace blossom::reports
