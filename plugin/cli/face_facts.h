// SPDX-License-Identifier: LGPL-2.1-or-later
// What `blossom info` tells about a face.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

namespace blossom::cli {

struct FaceFacts {
  int number = 0;       ///< 1-based, in the order of TopExp::MapShapes
  std::string name;     ///< of the face or its part; may be empty
  std::string surface;  ///< "plane", "cylinder", ..., "bezier", "bspline", "offset", "other"
  int degree_u = 0;     ///< 0 when the surface is no Bezier or B-spline surface
  int degree_v = 0;
  int spans_u = 0;  ///< likewise
  int spans_v = 0;
  bool rational = false;
  bool periodic_u = false;
  bool periodic_v = false;
  int wires = 0;
  int edges = 0;
  double tolerance = 0;               ///< of the face, model units
  std::vector<std::string> problems;  ///< empty when the face is valid
};

/// Looks at a face.
/// problems   that are known of it
FaceFacts face_facts(const TopoDS_Face& face, int number, std::vector<std::string> problems);

}  // namespace blossom::cli
