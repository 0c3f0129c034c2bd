// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts made of pieces of other models' faces, with the names and colours that those have.

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Quantity_ColorRGBA.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/parts.h"

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

std::string Model::part_name(int number) const {
  const TopoDS_Face wanted = face(number);
  for (const Usage& usage : all_usages(impl_->document)) {
    const TopoDS_Shape part = XCAFDoc_ShapeTool::GetShape(usage.part).Moved(usage.location);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(part, TopAbs_FACE, faces);
    if (faces.Contains(wanted)) return name_of(usage.part);
  }
  return {};
}

void Model::add_combined(const TopoDS_Shape& shape, const std::string& name,
                         const std::vector<FaceOrigin>& origins) {
  const std::lock_guard guard(exchange_lock());
  add(shape, name);
  std::map<const Model*, std::vector<Looks>> looks;
  PieceNames names;
  for (const FaceOrigin& origin : origins) {
    origin.model->face(origin.number);
    names.count(origin);
    auto& of = looks[origin.model];
    if (of.empty()) of = all_looks(origin.model->impl_->document, origin.model->impl_->faces);
  }
  guarded("naming the faces of '" + name + "'", [&] {
    const Handle(XCAFDoc_ShapeTool) shapes = impl_->document.shapes();
    TDF_LabelSequence parts;
    shapes->GetFreeShapes(parts);
    for (const FaceOrigin& origin : origins) {
      const Looks& of = looks[origin.model][static_cast<std::size_t>(origin.number) - 1];
      if (!of.any()) continue;
      const TDF_Label label = shapes->AddSubShape(parts.Last(), origin.face);
      if (label.IsNull()) continue;
      set_name(label, names.next(origin, of.name));
      paint(impl_->document, label, of);
    }
  });
}

}  // namespace blossom::occt
