// SPDX-License-Identifier: LGPL-2.1-or-later
// Styles of parts at single places of an assembly, STEP's specified higher usage occurrences.

#include <algorithm>
#include <vector>

#include <TDF_AttributeSequence.hxx>
#include <XCAFDoc_GraphNode.hxx>

#include "adapters/occt/documents/parts.h"

namespace blossom::occt {
namespace {

using Path = std::vector<TDF_Label>;

struct PlacedStyle {
  TDF_Label label;  ///< that has the colours
  Path path;        ///< components, from the assembly that gives the style down to the part
};

void add_paths(const TDF_Label& label, const TDF_Label& occurrence, Path path,
               std::vector<PlacedStyle>& found) {
  path.push_back(occurrence.Father());
  TDF_LabelSequence next;
  XCAFDoc_ShapeTool::GetSHUONextUsage(occurrence, next);
  if (next.IsEmpty()) found.push_back({label, path});
  for (const TDF_Label& lower : next) add_paths(label, lower, path, found);
}

std::vector<PlacedStyle> all_styles(const Handle(XCAFDoc_ShapeTool) & shapes) {
  std::vector<PlacedStyle> found;
  TDF_LabelSequence labels;
  shapes->GetShapes(labels);
  for (const TDF_Label& assembly : labels) {
    if (!XCAFDoc_ShapeTool::IsAssembly(assembly)) continue;
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(assembly, components);
    for (const TDF_Label& component : components) {
      TDF_AttributeSequence occurrences;
      XCAFDoc_ShapeTool::GetAllComponentSHUO(component, occurrences);
      for (const Handle(TDF_Attribute) & occurrence : occurrences) {
        TDF_LabelSequence upper;
        if (XCAFDoc_ShapeTool::GetSHUOUpperUsage(occurrence->Label(), upper)) continue;
        add_paths(occurrence->Label(), occurrence->Label(), {}, found);
      }
    }
  }
  return found;
}

void add_style(const Handle(XCAFDoc_ShapeTool) & shapes, const PlacedStyle& like,
               const Path& path) {
  TDF_LabelSequence labels;
  for (const TDF_Label& label : path) labels.Append(label);
  Handle(XCAFDoc_GraphNode) node;
  if (shapes->SetSHUO(labels, node)) copy_looks(like.label, node->Label());
}

}  // namespace

void styles_follow_copy(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& instance,
                        const TDF_LabelSequence& olds, const TDF_LabelSequence& news) {
  for (const PlacedStyle& style : all_styles(shapes)) {
    for (int i = 1; i <= olds.Length(); ++i) {
      const auto at = std::find(style.path.begin(), style.path.end(), olds(i));
      if (at == style.path.end()) continue;
      const bool within = at == style.path.begin();
      if (!within && *(at - 1) != instance) continue;
      Path path = style.path;
      path[static_cast<std::size_t>(at - style.path.begin())] = news(i);
      add_style(shapes, style, path);
      if (!within) shapes->RemoveSHUO(style.label);
      break;
    }
  }
}

void styles_of_twin(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& component,
                    const TDF_Label& twin) {
  for (const PlacedStyle& style : all_styles(shapes)) {
    Path path = style.path;
    std::replace(path.begin(), path.end(), component, twin);
    if (path != style.path) add_style(shapes, style, path);
  }
}

void forget_styles(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& component) {
  for (const PlacedStyle& style : all_styles(shapes))
    if (std::find(style.path.begin(), style.path.end(), component) != style.path.end())
      shapes->RemoveSHUO(style.label);
}

}  // namespace blossom::occt
