// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts made of pieces of other models' faces, with the names and colours that those have.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Quantity_ColorRGBA.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/documents/parts.h"

namespace blossom::occt {

Colours colours_of(const Document& document, const TDF_Label& label) {
  const Handle(XCAFDoc_ColorTool) tool = XCAFDoc_DocumentTool::ColorTool(document.main());
  Colours found;
  for (std::size_t i = 0; i < kColourTypes.size(); ++i)
    if (Quantity_ColorRGBA colour; tool->GetColor(label, kColourTypes[i], colour))
      found[i] = colour;
  return found;
}

std::vector<Looks> all_looks(const Document& document, const TopTools_IndexedMapOfShape& faces) {
  std::vector<Looks> looks(static_cast<std::size_t>(faces.Extent()));
  const auto look = [&](const TDF_Label& label, const TopLoc_Location& place) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label).Moved(place);
    const Colours colours = colours_of(document, label);
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
      const int number = faces.FindIndex(it.Current());
      if (number == 0) continue;
      Looks& of = looks[static_cast<std::size_t>(number) - 1];
      for (std::size_t i = 0; i < colours.size(); ++i)
        if (colours[i]) of.colours[i] = colours[i];
      if (shape.ShapeType() == TopAbs_FACE) of.name = name_of(label);
    }
  };
  for (const Usage& usage : all_usages(document)) {
    look(usage.part, usage.location);
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(usage.part, subs);
    for (int kind = TopAbs_COMPOUND; kind <= TopAbs_FACE; ++kind)
      for (const TDF_Label& sub : subs)
        if (XCAFDoc_ShapeTool::GetShape(sub).ShapeType() == kind) look(sub, usage.location);
  }
  return looks;
}

std::vector<std::optional<FaceColour>> Document::face_colours(const Faces& faces) const {
  std::vector<std::optional<FaceColour>> found;
  for (const Looks& looks : all_looks(*this, faces)) {
    // That of surfaces goes before the general one.
    const auto& colour = looks.colours[1] ? looks.colours[1] : looks.colours[0];
    if (!colour) {
      found.emplace_back();
      continue;
    }
    FaceColour parts{};
    colour->GetRGB().Values(parts[0], parts[1], parts[2], Quantity_TOC_sRGB);
    found.emplace_back(parts);
  }
  return found;
}

void paint(const Document& document, const TDF_Label& label, const Looks& looks) {
  const auto colours = XCAFDoc_DocumentTool::ColorTool(document.main());
  for (std::size_t i = 0; i < kColourTypes.size(); ++i)
    if (looks.colours[i]) colours->SetColor(label, *looks.colours[i], kColourTypes[i]);
}

std::string PieceNames::next(const FaceOrigin& piece, const std::string& name) {
  const std::pair<const Model*, int> key{piece.model, piece.number};
  const int number = ++numbered_[key];
  return pieces_[key] > 1 ? numbered_name(name, number) : name;
}

LooksOfModels::LooksOfModels(const std::vector<FaceOrigin>& origins) { add(origins); }

void LooksOfModels::add(const std::vector<FaceOrigin>& origins) {
  for (const FaceOrigin& origin : origins) {
    names_.count(origin);
    auto& of = looks_[origin.model];
    if (of.empty()) of = all_looks(document_of(*origin.model), contents_of(*origin.model).faces);
  }
}

const Looks& LooksOfModels::operator()(const FaceOrigin& origin) const {
  return looks_.at(origin.model)[static_cast<std::size_t>(origin.number) - 1];
}

void Document::add_combined(const TopoDS_Shape& shape, const std::string& name,
                            const std::vector<FaceOrigin>& origins) {
  LooksOfModels looks(origins);
  const TDF_Label part = add_label(shape, name);
  for (const FaceOrigin& origin : origins) {
    const Looks& of = looks(origin);
    if (!of.any()) continue;
    const TDF_Label label = shapes()->AddSubShape(part, origin.face);
    if (label.IsNull()) continue;
    set_name(label, looks.names().next(origin, of.name));
    paint(*this, label, of);
  }
}

}  // namespace blossom::occt
