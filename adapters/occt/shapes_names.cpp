// SPDX-License-Identifier: LGPL-2.1-or-later
// What the parts and faces of a model are called, and where parts are used.

#include <utility>

#include <TCollection_AsciiString.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>

#include "adapters/occt/shapes_detail.h"

namespace blossom::occt {
namespace {

// Names go to the faces below a label, which stands at a place in the model.
class FaceNames {
 public:
  explicit FaceNames(const TopTools_IndexedMapOfShape& faces)
      : faces_(faces),
        names_(static_cast<std::size_t>(faces.Extent())),
        paths_(static_cast<std::size_t>(faces.Extent())) {}

  // path   of the instances that lead here
  void visit(const TDF_Label& label, const TopLoc_Location& place, const std::string& path) {
    TDF_Label part;
    if (XCAFDoc_ShapeTool::GetReferredShape(label, part)) {
      const std::string own = name_of(label).empty() ? name_of(part) : name_of(label);
      const std::string between = path.empty() || own.empty() ? "" : "/";
      return visit(part, place * XCAFDoc_ShapeTool::GetLocation(label), path + between + own);
    }
    TDF_LabelSequence below;
    if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      XCAFDoc_ShapeTool::GetComponents(label, below);
      for (const TDF_Label& component : below) visit(component, place, path);
      return;
    }
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    name_all(shape, place, name_of(label), names_);
    name_all(shape, place, path.empty() ? name_of(label) : path, paths_);
    XCAFDoc_ShapeTool::GetSubShapes(label, below);
    for (const TDF_Label& face : below)
      name_all(XCAFDoc_ShapeTool::GetShape(face), place, name_of(face), names_);
  }

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& paths() const { return paths_; }

 private:
  void name_all(TopoDS_Shape shape, const TopLoc_Location& place, const std::string& name,
                std::vector<std::string>& all) {
    if (shape.IsNull() || name.empty()) return;
    shape.Location(place * shape.Location(), false);
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      if (const int number = faces_.FindIndex(it.Current()); number > 0)
        all[static_cast<std::size_t>(number - 1)] = name;
  }

  const TopTools_IndexedMapOfShape& faces_;
  std::vector<std::string> names_;
  std::vector<std::string> paths_;
};

void add_usages(const TDF_Label& label, Usage usage, std::vector<Usage>& found) {
  TDF_Label referred;
  if (XCAFDoc_ShapeTool::GetReferredShape(label, referred)) {
    usage.location = usage.location * XCAFDoc_ShapeTool::GetLocation(label);
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
  for (const TDF_Label& root : roots) add_usages(root, {root, {}, {}, {}}, found);
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

namespace {

FaceNames all_names(const Document& document, const TopTools_IndexedMapOfShape& faces) {
  FaceNames found(faces);
  TDF_LabelSequence parts;
  document.shapes()->GetFreeShapes(parts);
  for (const TDF_Label& part : parts) found.visit(part, TopLoc_Location(), "");
  return found;
}

}  // namespace

std::vector<std::string> Model::face_names() const {
  return all_names(impl_->document, impl_->faces).names();
}

std::vector<std::string> Model::part_paths() const {
  return all_names(impl_->document, impl_->faces).paths();
}

const std::string& Model::file_unit() const { return impl_->document.unit; }

}  // namespace blossom::occt
