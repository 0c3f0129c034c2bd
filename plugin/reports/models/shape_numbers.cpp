// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/shape_numbers.h"

namespace blossom::reports {

Json ShapeNumbers::place(const TopoDS_Shape& on, int face) const {
  const occt::BorderNumber found = numbers_.of(on, face);
  return {{"kind", found.kind}, {"number", found.number}};
}

std::string ShapeNumbers::text(const TopoDS_Shape& on, int face) const {
  const occt::BorderNumber found = numbers_.of(on, face);
  return std::string(found.kind) + " " + std::to_string(found.number);
}

}  // namespace blossom::reports
