// SPDX-License-Identifier: LGPL-2.1-or-later
// What the parts and faces of a model are called, and where parts are used.

#include <cstddef>
#include <utility>

#include <TCollection_AsciiString.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_ChildIterator.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/documents/document.h"

namespace blossom::occt {
namespace {

// What an instance is called, or the part that it is one of.
std::string instance_name(const TDF_Label& label, const TDF_Label& referred) {
  const std::string own = name_of(label);
  return own.empty() || own.starts_with("=>[") ? name_of(referred) : own;
}

void add_usages(const TDF_Label& label, Usage usage, std::vector<Usage>& found) {
  TDF_Label referred;
  if (XCAFDoc_ShapeTool::GetReferredShape(label, referred)) {
    usage.location = usage.location * XCAFDoc_ShapeTool::GetLocation(label);
    const std::string own = instance_name(label, referred);
    usage.instances.push_back(label);
    usage.path += (usage.path.empty() || own.empty() ? "" : "/") + own;
    return add_usages(referred, std::move(usage), found);
  }
  if (!XCAFDoc_ShapeTool::IsAssembly(label)) {
    usage.part = label;
    found.push_back(std::move(usage));
    return;
  }
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(label, components);
  for (int i = 1; i <= components.Length(); ++i) {
    usage.components.push_back(i);
    add_usages(components(i), usage, found);
    usage.components.pop_back();
  }
}

}  // namespace

std::vector<Usage> all_usages(const Document& document) {
  TDF_LabelSequence roots;
  document.shapes()->GetFreeShapes(roots);
  std::vector<Usage> found;
  for (const TDF_Label& root : roots) add_usages(root, {root, {}, {}, {}, {}, {}}, found);
  return found;
}

void set_name(const TDF_Label& label, const std::string& name) {
  if (!name.empty()) TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  return TCollection_AsciiString(name->Get()).ToCString();
}

void name_instances(const Document& document) {
  for (TDF_ChildIterator label(document.shapes()->Label(), true); label.More(); label.Next()) {
    TDF_Label referred;
    if (!XCAFDoc_ShapeTool::GetReferredShape(label.Value(), referred)) continue;
    const std::string name = instance_name(label.Value(), referred);
    label.Value().ForgetAttribute(TDataStd_Name::GetID());
    set_name(label.Value(), name);
  }
}

std::string part_path(const Usage& usage) {
  return usage.path.empty() ? name_of(usage.part) : usage.path;
}

namespace {

TopoDS_Shape placed(TopoDS_Shape shape, const TopLoc_Location& place) {
  if (!shape.IsNull()) shape.Location(place * shape.Location(), false);
  return shape;
}

AssemblyNode node_of(const TDF_Label& label, const TopLoc_Location& place, const std::string& path,
                     const NumberedShapes& all) {
  TDF_Label referred;
  if (XCAFDoc_ShapeTool::GetReferredShape(label, referred)) {
    const std::string own = instance_name(label, referred);
    AssemblyNode node = node_of(referred, place * XCAFDoc_ShapeTool::GetLocation(label),
                                path + (path.empty() || own.empty() ? "" : "/") + own, all);
    node.name = own;
    return node;
  }
  AssemblyNode node;
  node.name = node.product = name_of(label);
  node.path = path.empty() ? node.name : path;
  if (!XCAFDoc_ShapeTool::IsAssembly(label)) {
    all.put(placed(XCAFDoc_ShapeTool::GetShape(label), place), node);
    return node;
  }
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(label, components);
  for (const TDF_Label& component : components)
    node.parts.push_back(node_of(component, place, path, all));
  return node;
}

}  // namespace

std::vector<std::string> Document::face_names(const Faces& faces) const {
  std::vector<std::string> names(static_cast<std::size_t>(faces.Extent()));
  const auto name_all = [&](const TDF_Label& label, const TopLoc_Location& place) {
    name_faces(placed(XCAFDoc_ShapeTool::GetShape(label), place), name_of(label), faces, names);
  };
  for (const Usage& usage : all_usages(*this)) {
    name_all(usage.part, usage.location);
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(usage.part, subs);
    for (const TDF_Label& sub : subs) name_all(sub, usage.location);
  }
  return names;
}

std::vector<std::string> Document::part_paths(const Faces& faces) const {
  std::vector<std::string> paths(static_cast<std::size_t>(faces.Extent()));
  for (const Usage& usage : all_usages(*this))
    name_faces(placed(XCAFDoc_ShapeTool::GetShape(usage.part), usage.location), part_path(usage),
               faces, paths);
  return paths;
}

std::vector<AssemblyNode> Document::assembly(const TopoDS_Shape& whole, const Faces& faces) const {
  const NumberedShapes all(whole, faces);
  TDF_LabelSequence roots;
  shapes()->GetFreeShapes(roots);
  std::vector<AssemblyNode> nodes;
  for (const TDF_Label& root : roots) nodes.push_back(node_of(root, {}, {}, all));
  return nodes;
}

std::string Document::part_name(const TopoDS_Face& face) const {
  for (const Usage& usage : all_usages(*this)) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(placed(XCAFDoc_ShapeTool::GetShape(usage.part), usage.location), TopAbs_FACE,
                      faces);
    if (faces.Contains(face)) return name_of(usage.part);
  }
  return {};
}

}  // namespace blossom::occt
