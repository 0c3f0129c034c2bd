// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts made of pieces of other models' faces, with the names and colours that those have.

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Quantity_ColorRGBA.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/shapes_detail.h"

namespace blossom::occt {
namespace {

constexpr std::array kColourTypes{XCAFDoc_ColorGen, XCAFDoc_ColorSurf};
using Colours = std::array<std::optional<Quantity_ColorRGBA>, kColourTypes.size()>;

/// What a face looks like in its model.
struct Looks {
  std::string name;
  Colours colours;
};

Colours colours_of(const Document& document, const TDF_Label& label) {
  const Handle(XCAFDoc_ColorTool) tool = XCAFDoc_DocumentTool::ColorTool(document.main());
  Colours found;
  for (std::size_t i = 0; i < kColourTypes.size(); ++i)
    if (Quantity_ColorRGBA colour; tool->GetColor(label, kColourTypes[i], colour))
      found[i] = colour;
  return found;
}

/// All faces of a model, by number - 1. Colours of faces go before those of shells, solids, parts.
std::vector<Looks> all_looks(const Document& document, const TopTools_IndexedMapOfShape& faces) {
  std::vector<Looks> looks(static_cast<std::size_t>(faces.Extent()));
  const auto paint = [&](const TDF_Label& label, const TopLoc_Location& place) {
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
    paint(usage.part, usage.location);
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(usage.part, subs);
    for (int kind = TopAbs_COMPOUND; kind <= TopAbs_FACE; ++kind)
      for (const TDF_Label& sub : subs)
        if (XCAFDoc_ShapeTool::GetShape(sub).ShapeType() == kind) paint(sub, usage.location);
  }
  return looks;
}

}  // namespace

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
  std::map<std::pair<const Model*, int>, int> pieces, numbered;
  for (const FaceOrigin& origin : origins) {
    origin.model->face(origin.number);
    ++pieces[{origin.model, origin.number}];
    auto& of = looks[origin.model];
    if (of.empty()) of = all_looks(origin.model->impl_->document, origin.model->impl_->faces);
  }
  guarded("naming the faces of '" + name + "'", [&] {
    const Handle(XCAFDoc_ShapeTool) shapes = impl_->document.shapes();
    const auto colours = XCAFDoc_DocumentTool::ColorTool(impl_->document.main());
    TDF_LabelSequence parts;
    shapes->GetFreeShapes(parts);
    for (const FaceOrigin& origin : origins) {
      const Looks& of = looks[origin.model][static_cast<std::size_t>(origin.number) - 1];
      const bool coloured = std::any_of(of.colours.begin(), of.colours.end(),
                                        [](const auto& colour) { return colour.has_value(); });
      if (of.name.empty() && !coloured) continue;
      const TDF_Label label = shapes->AddSubShape(parts.Last(), origin.face);
      if (label.IsNull()) continue;
      const int number = ++numbered[{origin.model, origin.number}];
      const bool several = pieces[{origin.model, origin.number}] > 1;
      if (!of.name.empty())
        set_name(label, several ? of.name + "." + std::to_string(number) : of.name);
      for (std::size_t i = 0; i < of.colours.size(); ++i)
        if (of.colours[i]) colours->SetColor(label, *of.colours[i], kColourTypes[i]);
    }
  });
}

}  // namespace blossom::occt
