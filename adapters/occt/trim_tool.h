// SPDX-License-Identifier: LGPL-2.1-or-later
// The tools that parts and solids are trimmed with.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

namespace blossom::occt {

/// What parts are trimmed with. Faces are oriented: above is where their normals point.
struct TrimTool {
  std::vector<TopoDS_Face> faces;
  std::vector<TopoDS_Solid> solids;  ///< those that the faces bound; empty for an open tool
  std::string name{};                ///< in messages; empty: "the part" or "the tool"

  bool is_solid() const { return !solids.empty(); }
};

/// Whether a solid has faces, and each of their edges bounds two of them, or one twice.
/// Internal edges bound nothing.
bool is_closed_solid(const TopoDS_Shape& solid);

/// A tool of all the shape's faces; solid if all belong to closed solids. Empty ones are left out.
/// throws   BadModel if faces of a closed solid are turned differently, or all inwards
TrimTool trim_tool(const TopoDS_Shape& shape);

/// The same of solids that are known to be closed and turned outwards: nothing is checked.
TrimTool solid_tool(const std::vector<TopoDS_Solid>& solids);

/// What becomes of cuts, or parts of them, that divide nothing since they end inside of the face.
enum class OpenCuts {
  LeaveOut,
  Imprint,  ///< internal edges of the piece in which they lie
};

}  // namespace blossom::occt
