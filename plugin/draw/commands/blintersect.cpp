// SPDX-License-Identifier: LGPL-2.1-or-later
// blintersect result shapeA shapeB [tolerance]

#include <cmath>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include <DBRep.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/border_numbers.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "plugin/draw/commands/commands.h"

namespace blossom::draw {
namespace {

TopoDS_Shape shape_named(const char* name) {
  const TopoDS_Shape shape = DBRep::Get(name);
  if (shape.IsNull()) throw occt::BadModel(std::string(name) + ": there is no such shape");
  return shape;
}

std::vector<TopoDS_Face> faces_in(const TopoDS_Shape& shape, const char* name) {
  std::vector<TopoDS_Face> faces = occt::faces_of(shape);
  if (faces.empty()) throw occt::BadModel(std::string(name) + ": there is no face in it");
  return faces;
}

double tolerance_from(const std::string& text) {
  try {
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used == text.size() && std::isfinite(value) && value > 0) return value;
  } catch (const std::logic_error&) {  // no number: answered below
  }
  throw occt::BadModel("'" + text + "' is no positive number");
}

// Each as {{x y z} {edge 3} {face 1}}: where it is and what of a and b it is on.
void append_contacts(Draw_Interpretor& interpreter, const occt::ShapeIntersection& found,
                     const occt::BorderNumbers& a, const occt::BorderNumbers& b) {
  for (const occt::FaceIntersection& pair : found.pairs)
    for (std::size_t i = 0; i < pair.found.points.size(); ++i) {
      const Vec3& p = pair.found.points[i].point;
      const occt::BorderNumber on_a = a.of(pair.borders[i].on_a, pair.face_a + 1);
      const occt::BorderNumber on_b = b.of(pair.borders[i].on_b, pair.face_b + 1);
      interpreter << " {{" << p[0] << " " << p[1] << " " << p[2] << "} {" << on_a.kind << " "
                  << on_a.number << "} {" << on_b.kind << " " << on_b.number << "}}";
    }
}

void intersect_named(Draw_Interpretor& interpreter, int count, const char** words) {
  IntersectionOptions options;
  if (count == 5) options.tolerances.point = tolerance_from(words[4]);
  // The result may take the name of a or b: both are fetched before it is set.
  const TopoDS_Shape a = shape_named(words[2]), b = shape_named(words[3]);

  const occt::ShapeIntersection found =
      occt::intersect(faces_in(a, words[2]), faces_in(b, words[3]), options);

  std::size_t curves = 0;  // one across seams counts once
  for (const occt::FaceIntersection& pair : found.pairs) curves += pair.chains.size();
  DBRep::Set(words[1], occt::compound_of(found));
  interpreter << static_cast<int>(curves) << " " << to_string(found.status);
  append_contacts(interpreter, found, occt::BorderNumbers(a), occt::BorderNumbers(b));
}

/// 0, or 1 for a Tcl error whose text is the message.
int blintersect(Draw_Interpretor& interpreter, int count, const char** words) {
  if (count != 4 && count != 5) {
    interpreter << "usage: " << words[0] << " result shapeA shapeB [tolerance]";
    return 1;
  }
  try {
    intersect_named(interpreter, count, words);
    return 0;
  } catch (const std::exception& error) {
    interpreter << words[0] << ": " << error.what();
  } catch (...) {  // Open CASCADE's exceptions are no std::exception
    const std::string text = occt::current_failure_text();
    interpreter << words[0] << ": internal error: " << text.c_str();
  }
  return 1;
}

}  // namespace

void add_blintersect(Draw_Interpretor& interpreter) {
  interpreter.Add("blintersect",
                  "blintersect result shapeA shapeB [tolerance]"
                  "\n\t\t: all intersections of the faces of two shapes, as a compound of edges"
                  "\n\t\t: (and vertices at isolated contacts). The answer is the number of"
                  "\n\t\t: curves, one across seams counted once, and complete, tolerance or"
                  "\n\t\t: stopped; then for each isolated contact where it is and what of A and"
                  "\n\t\t: B it is on: {{x y z} {edge 3} {face 1}}.",
                  "plugin/draw/commands/blintersect.cpp", blintersect, kGroup);
}

}  // namespace blossom::draw
