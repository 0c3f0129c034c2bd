// SPDX-License-Identifier: LGPL-2.1-or-later
// The models that answers are about.

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/shapes.h"

namespace blossom::reports {

/// What is repaired of a model before it is used.
enum class Repairing {
  Used,  ///< the faces that the user means; all of the model if no faces are named
  None,
};

/// What becomes of faces that bound no closed solid: sewn into the solids that they close, see
/// occt::Model::sew, or not. Closed sheets stay where open ones alone are sewn.
enum class LooseFaces { Kept, OpenSewn, Sewn };

/// A model with the faces that the user means.
struct Input {
  std::string name;                    ///< as the user wrote it
  std::shared_ptr<occt::Model> owner;  ///< shared by inputs from the same file
  occt::Model& model;                  ///< the owner's
  std::vector<int> numbers{};          ///< face numbers, 1-based as `info` prints them, each once
  std::vector<TopoDS_Face> faces{};    ///< likewise
  TopoDS_Shape shape{};                ///< of the model that the faces belong to
  std::vector<int> solids{};           ///< that the user names as such, or by their parts
  std::vector<int> edges{};            ///< that the user names; with them, and no faces, no faces
  TopoDS_Shape selected{};             ///< solids, other faces and edges; null if none are named
  occt::Repairs repairs{};             ///< what was changed to use the faces
  occt::Sewing sewing{};               ///< what became of loose faces, if they were looked at
};

/// Readers of other systems leave such faces out or fill them with all of their surface.
/// throws   occt::BadModel, with the file and the face, if a wire that bounds a face is open
void refuse_open_wires(const Input& input);

/// Numbers of faces that cannot be searched, and so were taken out of an input.
struct UnusableFaces {
  std::vector<int> open{};   ///< of a damaged file: they have lost a border
  std::vector<int> lines{};  ///< their wires have no width
};

/// Takes such faces out of an input: of a damaged file those whose wires are open, or that have
/// none and no end; of any file those without a width. None if the user names faces, or if no other
/// face is left. Solids that lose no face are selected and keep their inside.
UnusableFaces drop_unusable_faces(Input& input);

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

/// What a page tells of all faces of an input, in their order.
std::vector<std::string> face_labels(const Input& input);

/// The place of the '#' that ends the file's name: the last one before which there is such a file,
/// as names of parts and of files may have that letter themselves; else the last one of all.
std::size_t selection_mark(const std::string& text);

/// An input as titles name it: without the folder that its file lies in.
std::string short_name(const std::string& input);

}  // namespace blossom::reports
