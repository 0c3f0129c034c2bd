// SPDX-License-Identifier: LGPL-2.1-or-later
// Inputs of commands: a file, or something in it, as in `wing.step#3,5-9` or `wing.step#Rib/Face3`.

#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "plugin/reports/models/input.h"
#include "plugin/reports/models/selection.h"

namespace blossom::cli {

using reports::FaceLabels;
using reports::given_name;
using reports::Input;
using reports::is_of_solids;
using reports::selection_mark;

/// What the user wrote, taken apart. No ranges and no words means all faces.
struct InputName {
  std::filesystem::path file;
  std::vector<std::pair<int, int>> faces;  ///< first and last number of each range, 1-based
  std::vector<std::string> words{};        ///< that name parts, faces, solids or edges, see
                                           ///< `reports::selection_of`
  std::string list{};                      ///< both of them, as they were written

  bool is_whole() const { return faces.empty() && words.empty(); }
};

/// Takes `FILE`, `FILE#3,5-9`, `FILE#Shaft` or `FILE#Shaft/Face3,solid:2` apart. A file that is
/// really called so wins. Names with commas are in pieces, see `reports::words_in`.
/// throws   UsageError if an entry after the '#' is empty, or a bad number and none of a name
InputName parse_input(const std::string& text);

/// Opening such a file might wait for ever.
/// throws   UsageError if there is a file of that name that is neither a regular one nor a folder
void refuse_special(const std::filesystem::path& file);

/// Whether a model without any face is an input at all.
enum class Faces { Required, Optional };

/// Reads the file and picks the faces. Where words name something in a file, or --sew-gap is given,
/// loose faces are sewn in any case, unless by --sew-gap 0. Files are read once as long as an input
/// from them is there, so that edges which faces of two inputs share are known to be the same. What
/// was sewn and what was repaired is told in a line each, and with -v where.
///
/// throws   UsageError as parse_input, or if edges are named where faces are required;
///          occt::BadModel if the file cannot be read, has no face though they are required, or
///          what is named does not exist
Input read_input(const std::string& text, Faces need = Faces::Required,
                 reports::Repairing repair = reports::Repairing::Used,
                 reports::LooseFaces loose = reports::LooseFaces::Sewn);

/// For what looks at one face after the other: without those that a damaged file has left without a
/// border, which a line names, unless the user names faces.
Input read_usable_input(const std::string& text, Faces need = Faces::Required,
                        reports::Repairing repair = reports::Repairing::Used,
                        reports::LooseFaces loose = reports::LooseFaces::Sewn);

/// What becomes of the parts that an input does not name.
enum class OtherParts { LeftOut, Kept };

/// "5 other parts are written as they were"; empty if there is none. To be asked before the model
/// is changed.
///
/// tools   faces of the same file that other inputs name
std::string other_parts_text(const Input& input, OtherParts fate, const std::set<int>& tools = {});

}  // namespace blossom::cli
