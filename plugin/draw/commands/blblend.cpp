// SPDX-License-Identifier: LGPL-2.1-or-later
// blblend result face_a face_b [border_a border_b [weight_a weight_b]]

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <DBRep.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/strip.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/strip.h"

namespace blossom::draw {
namespace {

std::optional<SurfaceSide> side_of(const std::string& word) {
  static const std::map<std::string, SurfaceSide> kSides = {{"umin", SurfaceSide::UMin},
                                                            {"umax", SurfaceSide::UMax},
                                                            {"vmin", SurfaceSide::VMin},
                                                            {"vmax", SurfaceSide::VMax}};
  if (word == "nearest") return std::nullopt;
  const auto found = kSides.find(word);
  if (found == kSides.end())
    throw occt::BadModel("'" + word + "' is none of nearest, umin, umax, vmin and vmax");
  return found->second;
}

TopoDS_Face face_named(const std::string& name) {
  const std::vector<TopoDS_Face> faces = faces_in(shape_named(name), name);
  if (faces.size() != 1)
    throw occt::BadModel(name + ": one face is wanted, got " + std::to_string(faces.size()));
  return faces.front();
}

std::string blend_answer(const Words& words) {
  require(words.size() == 3 || words.size() == 5 || words.size() == 7);
  const TopoDS_Face a = face_named(words[1]), b = face_named(words[2]);
  occt::FaceStripOptions options;
  if (words.size() > 3) options.side_a = side_of(words[3]);
  if (words.size() > 3) options.side_b = side_of(words[4]);
  if (words.size() > 5) options.strip.weight_a = positive_from(words[5]);
  if (words.size() > 5) options.strip.weight_b = positive_from(words[6]);

  const occt::FaceStrip strip = occt::strip_between(a, b, options);

  DBRep::Set(words[0].c_str(), strip.face);
  const StripContact worst = reports::worst_of(strip.strip);
  return std::string(to_string(strip.side_a)) + " " + to_string(strip.side_b) + " " +
         tcl_number(worst.gap) + " " + tcl_number(worst.normal_angle);
}

int blblend(Draw_Interpretor& interpreter, int count, const char** words) {
  return answered(interpreter, count, words,
                  "result face_a face_b [border_a border_b [weight_a weight_b]]", blend_answer);
}

}  // namespace

void add_blblend(Draw_Interpretor& interpreter) {
  interpreter.Add(
      "blblend",
      "blblend result face_a face_b [border_a border_b [weight_a weight_b]]"
      "\n\t\t: the strip between two faces that continues both with their tangent planes. Borders"
      "\n\t\t: are umin, umax, vmin, vmax, or nearest; weights say how far the tangents reach into"
      "\n\t\t: the strip, 1 is a third of its width. The answer is the borders, the gap, and the"
      "\n\t\t: angle between normals, radians.",
      "plugin/draw/commands/blblend.cpp", blblend, kGroup);
}

}  // namespace blossom::draw
