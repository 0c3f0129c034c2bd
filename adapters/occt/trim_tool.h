// SPDX-License-Identifier: LGPL-2.1-or-later
// The tools that parts and solids are trimmed with.

#pragma once

#include <cstddef>
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
  std::vector<int>
      places{};   ///< of the faces among all of the shape, from 0; empty if they are all
  int loose = 0;  ///< faces of the shape that are none of these: see `trim_tool`
  std::vector<std::string> face_names{};  ///< in messages; empty: by `places`
  TopoDS_Shape wires{};  ///< a shape of edges and vertices without any face; else null

  bool is_solid() const { return !solids.empty(); }
};

/// Whether a solid has faces, and each of their edges bounds two of them, or one twice.
/// Internal edges bound nothing.
bool is_closed_solid(const TopoDS_Shape& solid);

/// A tool of the shape's closed solids. Faces beside them, as of sheets and of solids that are
/// open, are loose and left out. Of a shape without a closed solid all faces make an open
/// tool, and one without any face is taken for its edges and vertices.
///
/// throws   BadModel if faces of a closed solid are turned differently, or all inwards
TrimTool trim_tool(const TopoDS_Shape& shape);

/// What a face is called in messages: "face 3 of the part".
/// owner   "the part", where its faces have no names
std::string face_name(const TrimTool& of, std::size_t face, const std::string& owner);

/// What is to be told of loose faces; empty if there are none.
std::string describe_loose_faces(const TrimTool& tool, const std::string& name);

/// A tool of solids that are known to be closed and turned outwards: nothing is checked.
TrimTool solid_tool(const std::vector<TopoDS_Solid>& solids);

/// What becomes of cuts, or parts of them, that divide nothing since they end inside of the face.
enum class OpenCuts {
  LeaveOut,
  Imprint,  ///< internal edges of the piece in which they lie
};

}  // namespace blossom::occt
