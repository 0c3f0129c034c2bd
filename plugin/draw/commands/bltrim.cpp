// SPDX-License-Identifier: LGPL-2.1-or-later
// bltrim result part above|below|inside|outside|all|N tool [tool ...]

#include <string>
#include <vector>

#include <DBRep.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/trim.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/cuts/trim.h"

namespace blossom::draw {
namespace {

// A side by its word, or a piece by its number.
occt::TrimOptions options_of(const std::string& word) {
  auto options = reports::trim_options(word);
  if (!options)
    throw occt::BadModel("'" + word +
                         "' is none of above, below, inside, outside, all, and no piece");
  if (options->keep == occt::Keep::Number) options->piece = count_from(word);
  return *options;
}

std::string answer_to_bltrim(const Words& words) {
  require(words.size() >= 4);
  const TopoDS_Shape part = sewn_shape(words[1]);
  faces_in(part, words[1]);
  std::vector<occt::TrimTool> tools;
  for (std::size_t i = 3; i < words.size(); ++i) tools.push_back(tool_named(words[i]));
  occt::Model model;
  model.add(part, words[1]);
  std::vector<occt::PartFace> faces;
  for (int number = 1; number <= model.face_count(); ++number)
    faces.push_back({number, model.face(number)});

  const occt::TrimResult made = occt::trim(faces, tools, options_of(words[2]));

  model.replace_faces(made.replacements);
  std::size_t kept = 0;
  for (const occt::TrimPiece& piece : made.pieces) kept += piece.kept ? 1 : 0;
  DBRep::Set(words[0].c_str(), model.shape());
  std::string list = std::to_string(kept) + " " + to_string(made.status);
  for (const occt::TrimPiece& piece : made.pieces)
    list += " {" + std::to_string(piece.face) + " " + to_string(piece.side) + " " +
            tcl_number(piece.area) + "}";
  return list;
}

}  // namespace

const Command kBltrim{
    "bltrim", "result part above|below|inside|outside|all|N tool [tool ...]",
    "\n\t\t: the faces of a part cut by tools, and the pieces on one side; or piece N alone."
    "\n\t\t: The answer is the number of pieces kept and complete, tolerance or stopped; then for"
    "\n\t\t: each piece of which face it is, its side and its area: {3 above 12.5}.",
    answer_to_bltrim};

}  // namespace blossom::draw
