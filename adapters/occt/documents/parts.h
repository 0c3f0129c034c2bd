// SPDX-License-Identifier: LGPL-2.1-or-later
// Labels of parts in a document: copies, looks, shapes. For this folder only.

#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Quantity_ColorRGBA.hxx>
#include <TDF_LabelSequence.hxx>
#include <XCAFDoc_ColorType.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/exchange/rebuild.h"

namespace blossom::occt {

/// Gives name, colours, layers and materials of one label to another.
void copy_looks(const TDF_Label& from, const TDF_Label& to);

inline constexpr std::array kColourTypes{XCAFDoc_ColorGen, XCAFDoc_ColorSurf};

using Colours = std::array<std::optional<Quantity_ColorRGBA>, kColourTypes.size()>;

/// What a face looks like in its model.
struct Looks {
  std::string name;
  Colours colours;

  bool any() const { return !name.empty() || colours[0] || colours[1]; }
};

/// All faces of a model, by number - 1. Colours of faces go before those of shells, solids, parts.
std::vector<Looks> all_looks(const Document& document, const TopTools_IndexedMapOfShape& faces);

/// The colours that a label has itself.
Colours colours_of(const Document& document, const TDF_Label& label);

/// Gives a label the colours.
void paint(const Document& document, const TDF_Label& label, const Looks& looks);

/// Numbers the pieces of faces.
class PieceNames {
 public:
  void count(const FaceOrigin& piece) { ++pieces_[{piece.model, piece.number}]; }

  /// The name of the next piece of a face: that of the face, numbered if there are several.
  std::string next(const FaceOrigin& piece, const std::string& name);

 private:
  std::map<std::pair<const Model*, int>, int> pieces_, numbered_;
};

/// What the faces of models look like, asked for once a model, and how their pieces are called.
class LooksOfModels {
 public:
  LooksOfModels() = default;
  explicit LooksOfModels(const std::vector<FaceOrigin>& origins);

  /// Of the models of these, too.
  void add(const std::vector<FaceOrigin>& origins);

  /// Of a face that was among them.
  const Looks& operator()(const FaceOrigin& origin) const;

  PieceNames& names() { return names_; }

 private:
  std::map<const Model*, std::vector<Looks>> looks_;
  PieceNames names_;
};

/// Replaces faces in the shape of a part; its labels follow. False if nothing is left of it.
bool replace_in_part(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part,
                     const std::vector<Replacement>& replacements);

/// Drops areas, volumes and centres that the file gave and that no longer hold.
void forget_properties(const TDF_Label& label);

/// The same for all assemblies.
void forget_assembly_properties(const Handle(XCAFDoc_ShapeTool) & shapes);

/// Lets a sub-shape label stand for another shape.
void set_shape(const TDF_Label& label, const TopoDS_Shape& shape);

/// "Top" and 2 make "Top.2"; no name stays none.
std::string numbered_name(const std::string& name, int number);

/// A solid moved to where its part stands. Its faces have the location: STEP files lose the name of
/// a part whose shape has one itself.
TopoDS_Shape moved_faces(const TopoDS_Shape& shape, const TopLoc_Location& place);

/// Faces to be replaced in one use of a part.
struct PartCut {
  Usage usage;
  std::vector<int> numbers;               ///< of the faces in the model
  std::vector<Replacement> replacements;  ///< in the part's coordinates, likewise
};

/// The faces by the use of the part in which they lie, in the order of uses; each face goes to the
/// first that has it.
std::vector<PartCut> cuts_of(const Document& document, const TopTools_IndexedMapOfShape& faces,
                             const std::map<int, std::vector<TopoDS_Shape>>& pieces);

/// A part or an assembly once more, with the same shapes, instances and looks.
TDF_Label copy_of(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& label);

/// The part of a usage, which nobody else uses from then on: parts and assemblies on the way that
/// others use too are copied.
TDF_Label own_part(const Handle(XCAFDoc_ShapeTool) & shapes, const Usage& usage);

/// Gives a copied part topology of its own: files tell names and colours by the shape that has
/// them, so a face that two parts share would carry them in one part only.
void unshare(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part);

/// Takes out a part of which nothing is left, its instances, and assemblies that are empty then.
void remove_part(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part);

/// Styles of single parts at one place of an assembly ("the left front wheel is red") go by the
/// path of instances to the part. After an instance got a copy of what it refers to, with
/// components `news` instead of `olds`, its styles follow, and those from within are in both.
void styles_follow_copy(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& instance,
                        const TDF_LabelSequence& olds, const TDF_LabelSequence& news);

/// Gives `twin`, another component of the same assembly, the styles that pass through a component.
void styles_of_twin(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& component,
                    const TDF_Label& twin);

/// Takes out the styles that pass through a component.
void forget_styles(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& component);

}  // namespace blossom::occt
