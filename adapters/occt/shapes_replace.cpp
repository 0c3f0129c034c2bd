// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces in the place of faces, with the labels of an XDE document following.

#include <string>
#include <utility>
#include <vector>

#include <BRepBuilderAPI_Copy.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDataStd_TreeNode.hxx>
#include <TNaming_Builder.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc.hxx>
#include <XCAFDoc_Area.hxx>
#include <XCAFDoc_Centroid.hxx>
#include <XCAFDoc_Editor.hxx>
#include <XCAFDoc_Volume.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/shapes_detail.h"
#include "adapters/occt/shapes_rebuild.h"

namespace blossom::occt {
namespace {

using Pieces = std::map<int, std::vector<TopoDS_Face>>;

/// Faces to be replaced in one use of a part.
struct Cut {
  Usage usage;
  std::vector<Replacement> replacements;  ///< in the part's coordinates
};

/// The faces by the use of the part in which they lie; each face goes to the first that has it.
std::vector<Cut> cuts_of(const Document& document, const TopTools_IndexedMapOfShape& faces,
                         const Pieces& pieces) {
  std::vector<Cut> cuts;
  std::map<int, bool> placed;
  for (const Usage& usage : all_usages(document)) {
    const TopoDS_Shape part = XCAFDoc_ShapeTool::GetShape(usage.part);
    TopTools_IndexedMapOfShape here;
    TopExp::MapShapes(part.Moved(usage.location), TopAbs_FACE, here);
    const TopLoc_Location back = usage.location.Inverted();
    Cut cut{usage, {}};
    for (const auto& [number, news] : pieces) {
      if (placed[number] || !here.Contains(faces(number))) continue;
      placed[number] = true;
      Replacement replacement{TopoDS::Face(faces(number).Moved(back)), {}};
      for (const TopoDS_Face& piece : news)
        replacement.pieces.push_back(TopoDS::Face(piece.Moved(back)));
      cut.replacements.push_back(std::move(replacement));
    }
    if (!cut.replacements.empty()) cuts.push_back(std::move(cut));
  }
  return cuts;
}

/// Name, colours, layers and materials.
void copy_looks(const TDF_Label& from, const TDF_Label& to) {
  set_name(to, name_of(from));
  XCAFDoc_Editor::CloneMetaData(from, to, nullptr, true, true, true, true, false);
}

/// Areas, volumes and centres that the file gave and that no longer hold.
void forget_properties(const TDF_Label& label) {
  label.ForgetAttribute(XCAFDoc_Area::GetID());
  label.ForgetAttribute(XCAFDoc_Volume::GetID());
  label.ForgetAttribute(XCAFDoc_Centroid::GetID());
}

/// A part or an assembly once more, with the same shapes and instances.
TDF_Label copy_of(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& label) {
  const TDF_Label copy = shapes->NewShape();
  if (XCAFDoc_ShapeTool::IsAssembly(label)) {
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    for (const TDF_Label& component : components) {
      TDF_Label part;
      XCAFDoc_ShapeTool::GetReferredShape(component, part);
      // The same place as a location of its own: STEP files tell instances apart by it.
      const TopLoc_Location place(XCAFDoc_ShapeTool::GetLocation(component).Transformation());
      copy_looks(component, shapes->AddComponent(copy, part, place));
    }
  } else {
    shapes->SetShape(copy, XCAFDoc_ShapeTool::GetShape(label));
    TDF_LabelSequence subs;
    XCAFDoc_ShapeTool::GetSubShapes(label, subs);
    for (const TDF_Label& sub : subs) {
      const TDF_Label added = shapes->AddSubShape(copy, XCAFDoc_ShapeTool::GetShape(sub));
      if (!added.IsNull()) copy_looks(sub, added);
    }
  }
  copy_looks(label, copy);
  return copy;
}

/// What an instance refers to, after a copy of it if others refer to it too.
TDF_Label own_part(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& instance) {
  TDF_Label part;
  XCAFDoc_ShapeTool::GetReferredShape(instance, part);
  TDF_LabelSequence users;
  if (XCAFDoc_ShapeTool::GetUsers(part, users) <= 1) return part;
  const TDF_Label copy = copy_of(shapes, part);
  Handle(TDataStd_TreeNode) reference;
  instance.FindAttribute(XCAFDoc::ShapeRefGUID(), reference);
  reference->Remove();
  TDataStd_TreeNode::Set(copy, XCAFDoc::ShapeRefGUID())->Append(reference);
  return copy;
}

/// The part of a usage, which nobody else uses from then on.
TDF_Label own_part(const Handle(XCAFDoc_ShapeTool) & shapes, const Usage& usage) {
  TDF_Label label = usage.root;
  auto component = usage.components.begin();
  for (;;) {
    if (XCAFDoc_ShapeTool::IsReference(label)) {
      label = own_part(shapes, label);
    } else if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(label, components);
      label = components(*component++);
    } else {
      return label;
    }
  }
}

/// A sub-shape label and what it stood for.
struct OldLabel {
  TDF_Label label;
  TopoDS_Shape shape;
};

void set_shape(const TDF_Label& label, const TopoDS_Shape& shape) {
  TNaming_Builder builder(label);
  builder.Generated(shape);
}

/// The first piece takes over the face's label, the others get one of their own.
void label_pieces(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part,
                  const TDF_Label& label, const std::vector<TopoDS_Face>& pieces) {
  const std::string name = name_of(label);
  set_shape(label, pieces.front());
  if (pieces.size() == 1) return;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const TDF_Label piece = i == 0 ? label : shapes->AddSubShape(part, pieces[i]);
    if (piece.IsNull()) continue;
    if (i > 0) copy_looks(label, piece);
    if (!name.empty()) set_name(piece, name + "." + std::to_string(i + 1));
  }
}

/// Replaces the shape of a part; its labels follow. False if nothing is left of it.
bool replace_in_part(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part,
                     const std::vector<Replacement>& replacements) {
  std::vector<OldLabel> olds;
  TDF_LabelSequence subs;
  XCAFDoc_ShapeTool::GetSubShapes(part, subs);
  for (const TDF_Label& sub : subs) olds.push_back({sub, XCAFDoc_ShapeTool::GetShape(sub)});
  Rebuild rebuild(replacements);
  const TopoDS_Shape whole = rebuild(XCAFDoc_ShapeTool::GetShape(part));
  if (whole.IsNull()) return false;
  shapes->SetShape(part, whole);
  forget_properties(part);
  TopTools_IndexedMapOfShape remaining;
  TopExp::MapShapes(whole, remaining);
  for (const OldLabel& old : olds) {
    const Replacement* replacement = rebuild.find(old.shape);
    if (replacement != nullptr && !replacement->pieces.empty()) {
      forget_properties(old.label);
      label_pieces(shapes, part, old.label, replacement->pieces);
      continue;
    }
    const TopoDS_Shape now = replacement == nullptr ? rebuild(old.shape) : TopoDS_Shape();
    if (now.IsNull() || !remaining.Contains(now)) {
      old.label.ForgetAllAttributes();
    } else if (!now.IsSame(old.shape)) {
      forget_properties(old.label);
      set_shape(old.label, now);
    }
  }
  return true;
}

/// Gives a copied part topology of its own: files tell names and colours by the shape that has
/// them, so a face that two parts share would carry them in one part only.
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

/// Takes out a part of which nothing is left, and its instance.
void remove_part(const Handle(XCAFDoc_ShapeTool) & shapes, const TDF_Label& part) {
  TDF_LabelSequence users;
  XCAFDoc_ShapeTool::GetUsers(part, users);
  for (const TDF_Label& user : users) {
    if (XCAFDoc_ShapeTool::IsComponent(user))
      shapes->RemoveComponent(user);
    else
      shapes->RemoveShape(user);
  }
  shapes->RemoveShape(part);
}

void forget_assembly_properties(const Handle(XCAFDoc_ShapeTool) & shapes) {
  TDF_LabelSequence labels;
  shapes->GetShapes(labels);
  for (const TDF_Label& label : labels)
    if (XCAFDoc_ShapeTool::IsAssembly(label)) forget_properties(label);
}

}  // namespace

void Model::replace_faces(const std::map<int, std::vector<TopoDS_Face>>& pieces) {
  for (const auto& [number, news] : pieces) {
    face(number);
    for (const TopoDS_Face& piece : news)
      if (piece.IsNull())
        throw BadModel("a piece for face " + std::to_string(number) + " is no face");
  }
  const std::lock_guard guard(exchange_lock());
  guarded("replacing faces", [&] {
    const Handle(XCAFDoc_ShapeTool) shapes = impl_->document.shapes();
    std::vector<TDF_Label> emptied;
    for (const Cut& cut : cuts_of(impl_->document, impl_->faces, pieces)) {
      const TDF_Label part = own_part(shapes, cut.usage);
      if (!replace_in_part(shapes, part, cut.replacements))
        emptied.push_back(part);
      else if (part != cut.usage.part)
        unshare(shapes, part);
    }
    for (const TDF_Label& part : emptied) remove_part(shapes, part);
    forget_assembly_properties(shapes);
    shapes->UpdateAssemblies();
    impl_->refresh();
  });
}

}  // namespace blossom::occt
