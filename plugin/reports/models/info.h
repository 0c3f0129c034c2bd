// SPDX-License-Identifier: LGPL-2.1-or-later
// What a model is made of, and its JSON report; see plugin/cli/schemas/info-1.md.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/convert/kept_forms.h"
#include "adapters/occt/face_colours.h"
#include "adapters/occt/queries/least_box.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// Planes have a normal, cylinders a radius and an axis, cones half an angle instead, spheres a
/// radius and a centre, tori both radii, a centre and an axis.
struct Measures {
  std::vector<double> radii;         ///< of a torus that of the ring first, model units
  std::optional<double> half_angle;  ///< radians
  std::optional<Vec3> point;         ///< the centre, or one of the axis
  std::optional<Vec3> direction;     ///< of the axis; of a plane its outward normal
  bool hollow = false;               ///< the outward normal points to the axis or the centre
};

struct FaceFacts {
  int number = 0;       ///< 1-based, in the order of TopExp::MapShapes
  std::string name;     ///< of the face or its part; may be empty
  std::string surface;  ///< "plane", "cylinder", ..., "bezier", "bspline", "offset", "other"
  int degree_u = 0;     ///< 0 when the surface is no Bezier or B-spline surface
  int degree_v = 0;
  int spans_u = 0;  ///< likewise
  int spans_v = 0;
  bool rational = false;
  Interval u, v;  ///< the box of the trims in the surface's parameters
  bool periodic_u = false;
  bool periodic_v = false;
  int wires = 0;
  int edges = 0;
  double tolerance = 0;  ///< of the face, model units
  Measures measures;
  std::optional<double> area;              ///< if it is asked for and the face is valid
  std::optional<occt::FaceColour> colour;  ///< of the face, its shell, solid or part
  std::vector<std::string> problems;       ///< empty when the face is valid
};

struct ModelFacts {
  std::vector<FaceFacts> faces;
  std::map<std::string, int> surfaces;  ///< faces per surface type
  std::optional<occt::LeastBox> box;
  double least_tolerance = 0;  ///< of faces, edges and vertices, model units
  double largest_tolerance = 0;
  bool valid = true;  ///< every listed face is
};

/// Whether faces have their areas, which take longer than all the rest, and colours, which not all
/// that read models want.
enum class FaceDetail { Brief, Full };

/// problems    that are known of each face
/// cancelled   asked while faces are measured and the box is made, which then are left
/// forms       of faces; those that are taken from there are gone
ModelFacts model_facts(const Input& input, const std::vector<std::vector<std::string>>& problems,
                       FaceDetail detail, const std::function<bool()>& cancelled,
                       occt::KeptForms* forms = nullptr);

/// What is asked about: the whole model, or what the user names of it.
TopoDS_Shape subject_of(const Input& input);

/// How many of a kind there are in a shape, with its noun: {2, "solids"}.
struct ShapeCount {
  int count = 0;
  const char* one = "";
  const char* many = "";
};
std::vector<ShapeCount> shape_counts(const TopoDS_Shape& shape);

/// The whole object, schema "blossom.info/1".
Json info_report(const Input& input, const ModelFacts& facts);

/// "1, 0, -2.5": coordinates, what is nothing beside them as 0.
std::string triple(const Vec3& vector);

/// "radius 5, hollow": what lines of faces tell of it.
std::string measures_text(const Measures& of);

}  // namespace blossom::reports
