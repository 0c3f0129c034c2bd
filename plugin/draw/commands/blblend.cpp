// SPDX-License-Identifier: LGPL-2.1-or-later
// blblend result face_a face_b [border_a border_b [weight_a weight_b]] [G1|G2|G3]

#include <cstddef>
#include <string>
#include <vector>

#include <DBRep.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/strip.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/blends/strip.h"

namespace blossom::draw {
namespace {

/// An edge as a DRAW shape, or a word.
occt::StripStart start_of(const std::string& word, const TopoDS_Face& face,
                          const std::string& name) {
  if (word == "nearest") return {};
  const char* shape_name = word.c_str();
  const TopoDS_Shape shape = DBRep::Get(shape_name, TopAbs_EDGE, false);
  if (!shape.IsNull()) return {.edge = TopoDS::Edge(shape)};
  return reports::strip_start(face, face, name, word);
}

int order_of(const std::string& word) {
  for (const char order : {'1', '2', '3'})
    if (word == std::string("G") + order) return order - '0';
  throw occt::BadModel("'" + word + "' is none of G1, G2 and G3");
}

TopoDS_Face face_named(const std::string& name) {
  const std::vector<TopoDS_Face> faces = faces_in(shape_named(name), name);
  if (faces.size() != 1)
    throw occt::BadModel(name + ": one face is wanted, got " + std::to_string(faces.size()));
  return faces.front();
}

std::string blend_answer(const Words& words) {
  require(words.size() >= 3);
  const TopoDS_Face a = face_named(words[1]), b = face_named(words[2]);
  occt::FaceStripOptions options;
  std::size_t last = words.size();
  if (words.back().front() == 'G') options.strip.order = order_of(words[--last]);
  require(last == 3 || last == 5 || last == 7);
  if (last > 3) options.start_a = start_of(words[3], a, words[1]);
  if (last > 3) options.start_b = start_of(words[4], b, words[2]);
  if (last > 5) options.strip.weight_a = positive_from(words[5]);
  if (last > 5) options.strip.weight_b = positive_from(words[6]);

  const occt::FaceStrip strip = occt::strip_between(a, b, options);

  DBRep::Set(words[0].c_str(), strip.face);
  const StripContact worst = reports::worst_of(strip.strip);
  const auto joined = [](const TopoDS_Face& face, const occt::FaceStripEnd& end) {
    return end.start.side ? to_string(*end.start.side)
                          : "{" + reports::start_text(face, end.start) + "}";
  };
  return joined(a, strip.ends[0]) + " " + joined(b, strip.ends[1]) + " " + tcl_number(worst.gap) +
         " " + tcl_number(worst.normal_angle);
}

}  // namespace

const Command kBlblend{
    "blblend", "result face_a face_b [border_a border_b [weight_a weight_b]] [G1|G2|G3]",
    "\n\t\t: the strip between two faces that continues both: their tangent planes (G1), their"
    "\n\t\t: curvatures (G2), or the derivatives of these too (G3). Borders are edges of the faces,"
    "\n\t\t: their numbers in the face, umin, umax, vmin, vmax, or nearest; weights say how far the"
    "\n\t\t: tangents reach into the strip, 1 is its width over its degree. The answer is the"
    "\n\t\t: borders, the gap, and the angle between normals, radians.",
    blend_answer};

}  // namespace blossom::draw
