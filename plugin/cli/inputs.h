// SPDX-License-Identifier: LGPL-2.1-or-later
// Inputs of commands: a file, or some faces of a file, as in `wing.step#3,5-9`.

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/shapes.h"

namespace blossom::cli {

/// What the user wrote, taken apart. No ranges means all faces.
struct InputName {
  std::filesystem::path file;
  std::vector<std::pair<int, int>> faces;  ///< first and last number of each range, 1-based
};

/// Takes `FILE`, `FILE#3` or `FILE#3,5-9` apart. A file that is really called so wins.
/// throws   UsageError if what follows the last '#' is no list of face numbers
InputName parse_input(const std::string& text);

/// Opening such a file might wait for ever.
/// throws   UsageError if there is a file of that name that is neither a regular one nor a folder
void refuse_special(const std::filesystem::path& file);

/// A model with the faces that the user means.
struct Input {
  std::string name;                    ///< as the user wrote it
  std::shared_ptr<occt::Model> owner;  ///< shared by inputs from the same file
  occt::Model& model;                  ///< the owner's
  std::vector<int> numbers{};          ///< face numbers, 1-based as `info` prints them, each once
  std::vector<TopoDS_Face> faces{};    ///< likewise
  TopoDS_Shape shape{};                ///< of the model that the faces belong to
  occt::Repairs repairs{};             ///< what was changed to use the faces
};

/// Whether a model without any face is an input at all.
enum class Faces { Required, Optional };

/// What is repaired of a model.
enum class Repair {
  Used,  ///< the faces that the user means; all of the model if no faces are named
  None,
};

/// Reads the file and picks the faces. Files are read once as long as an input from them is there,
/// so that edges which faces of two inputs share are known to be the same. What was repaired is
/// told in one line, and with -v where.
/// throws   UsageError as parse_input; occt::BadModel if the file cannot be read, has no face
///          though they are required, or a face number does not exist
Input read_input(const std::string& text, Faces need = Faces::Required,
                 Repair repair = Repair::Used);

/// The name of a part, or of a face; empty if it is only what Open CASCADE's writer puts there for
/// none.
std::string given_name(const std::string& part);

/// Faces as results name them: "face 12 (Bolt)", the part's name if it has one.
class FaceLabels {
 public:
  explicit FaceLabels(const Input& input) : parts_(input.model.part_paths()) {}
  std::string of(int number) const;

 private:
  std::vector<std::string> parts_;  // by number - 1
};

/// Readers of other systems leave such faces out or fill them with all of their surface.
/// throws   occt::BadModel, with the file and the face, if a wire that bounds a face is open
void refuse_open_wires(const Input& input);

}  // namespace blossom::cli
