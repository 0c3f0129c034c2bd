// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes as tools that cut a whole part: above is where the normal points.

#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/plane_section.h"
#include "adapters/occt/trim_tool.h"

namespace blossom::occt {

/// A rectangle of the plane that goes beyond the box of the part, on all sides, by the diagonal of
/// that box. Its surface is the plane through the given point with the given normal.
/// throws   BadModel if the normal is zero or a number is not finite, or the part has no extent
TrimTool plane_tool(const Plane& plane, const TopoDS_Shape& part, const std::string& name);

/// What is above the plane, as far as the part goes: a box with that rectangle as its first face,
/// whose other faces are all beyond the box of the part by its diagonal at least.
/// throws   as plane_tool
TrimTool half_space_tool(const Plane& plane, const TopoDS_Shape& part, const std::string& name);

}  // namespace blossom::occt
