// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/documents/parts.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Builder.hxx>
#include <TDataStd_TreeNode.hxx>
#include <TNaming_Builder.hxx>
#include <TopExp.hxx>
#include <TopoDS_Iterator.hxx>
#include <XCAFDoc.hxx>
#include <XCAFDoc_Area.hxx>
#include <XCAFDoc_Centroid.hxx>
#include <XCAFDoc_Editor.hxx>
#include <XCAFDoc_Volume.hxx>

namespace blossom::occt {
namespace {

void copy_components(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& from,
                     const TDF_Label& to) {
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(from, components);
  for (const TDF_Label& component : components) {
    TDF_Label part;
    XCAFDoc_ShapeTool::GetReferredShape(component, part);
    // The same place as a location of its own: STEP files tell instances apart by it.
    const TopLoc_Location place(XCAFDoc_ShapeTool::GetLocation(component).Transformation());
    copy_looks(component, shapes->AddComponent(to, part, place));
  }
}

void copy_shape(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& from,
                const TDF_Label& to) {
  shapes->SetShape(to, XCAFDoc_ShapeTool::GetShape(from));
  TDF_LabelSequence subs;
  XCAFDoc_ShapeTool::GetSubShapes(from, subs);
  for (const TDF_Label& sub : subs) {
    const TDF_Label added = shapes->AddSubShape(to, XCAFDoc_ShapeTool::GetShape(sub));
    if (!added.IsNull()) copy_looks(sub, added);
  }
}

/// What an instance refers to, after a copy of it if others refer to it too.
TDF_Label own_referred(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& instance) {
  TDF_Label part;
  XCAFDoc_ShapeTool::GetReferredShape(instance, part);
  TDF_LabelSequence users;
  if (XCAFDoc_ShapeTool::GetUsers(part, users) <= 1) return part;
  const TDF_Label copy = copy_of(shapes, part);
  Handle(TDataStd_TreeNode) reference;
  instance.FindAttribute(XCAFDoc::ShapeRefGUID(), reference);
  reference->Remove();
  TDataStd_TreeNode::Set(copy, XCAFDoc::ShapeRefGUID())->Append(reference);
  TDF_LabelSequence olds, news;
  XCAFDoc_ShapeTool::GetComponents(part, olds);
  XCAFDoc_ShapeTool::GetComponents(copy, news);
  styles_follow_copy(shapes, instance, olds, news);
  return copy;
}

}  // namespace

void copy_looks(const TDF_Label& from, const TDF_Label& to) {
  set_name(to, name_of(from));
  XCAFDoc_Editor::CloneMetaData(from, to, nullptr, true, true, true, true, false);
}

void forget_properties(const TDF_Label& label) {
  label.ForgetAttribute(XCAFDoc_Area::GetID());
  label.ForgetAttribute(XCAFDoc_Volume::GetID());
  label.ForgetAttribute(XCAFDoc_Centroid::GetID());
}

void forget_assembly_properties(const Handle(XCAFDoc_ShapeTool) & shapes) {
  TDF_LabelSequence labels;
  shapes->GetShapes(labels);
  for (const TDF_Label& label : labels)
    if (XCAFDoc_ShapeTool::IsAssembly(label)) forget_properties(label);
}

void set_shape(const TDF_Label& label, const TopoDS_Shape& shape) {
  TNaming_Builder builder(label);
  builder.Generated(shape);
}

std::string numbered_name(const std::string& name, int number) {
  return name.empty() ? name : name + "." + std::to_string(number);
}

TopoDS_Shape moved_faces(const TopoDS_Shape& shape, const TopLoc_Location& place) {
  if (place.IsIdentity()) return shape;
  if (shape.ShapeType() == TopAbs_FACE) return shape.Moved(place);
  TopoDS_Shape result = shape.EmptyCopied();
  for (TopoDS_Iterator it(shape, false); it.More(); it.Next())
    BRep_Builder().Add(result, moved_faces(it.Value(), place));
  result.Closed(shape.Closed());
  return result;
}

TDF_Label copy_of(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& label) {
  const TDF_Label copy = shapes->NewShape();
  if (XCAFDoc_ShapeTool::IsAssembly(label))
    copy_components(shapes, label, copy);
  else
    copy_shape(shapes, label, copy);
  copy_looks(label, copy);
  return copy;
}

TDF_Label own_part(const Handle(XCAFDoc_ShapeTool) & shapes, const Usage& usage) {
  TDF_Label label = usage.root;
  auto component = usage.components.begin();
  for (;;) {
    if (XCAFDoc_ShapeTool::IsReference(label)) {
      label = own_referred(shapes, label);
    } else if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(label, components);
      label = components(*component++);
    } else {
      return label;
    }
  }
}

void unshare(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part) {
  const TopoDS_Shape whole = XCAFDoc_ShapeTool::GetShape(part);
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(whole, false, false).Shape();
  TopTools_IndexedMapOfShape before, after;
  TopExp::MapShapes(whole, before);
  TopExp::MapShapes(copy, after);
  if (before.Extent() != after.Extent()) return;
  TDF_LabelSequence subs;
  XCAFDoc_ShapeTool::GetSubShapes(part, subs);
  shapes->SetShape(part, copy);
  for (const TDF_Label& sub : subs)
    set_shape(sub, after(before.FindIndex(XCAFDoc_ShapeTool::GetShape(sub))));
}

void remove_part(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part) {
  TDF_LabelSequence users;
  XCAFDoc_ShapeTool::GetUsers(part, users);
  for (const TDF_Label& user : users) {
    forget_styles(shapes, user);
    const TDF_Label assembly = user.Father();
    if (!XCAFDoc_ShapeTool::IsComponent(user)) {
      shapes->RemoveShape(user);
      continue;
    }
    shapes->RemoveComponent(user);
    if (XCAFDoc_ShapeTool::NbComponents(assembly) == 0) remove_part(shapes, assembly);
  }
  shapes->RemoveShape(part);
}

}  // namespace blossom::occt
