// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/documents/other_files.h"

#include <map>
#include <string>

#include <NCollection_DataMap.hxx>
#include <TDF_LabelDataMap.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_TreeNode.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc.hxx>
#include <XCAFDoc_Editor.hxx>
#include <XCAFDoc_VisMaterial.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "adapters/occt/documents/parts.h"

namespace blossom::occt {
namespace {

/// Where the document has a product; null if it has no place for it.
TDF_Label label_of(const Handle(Standard_Transient) & product,
                   const STEPCAFControl_Reader& reader) {
  const Handle(Transfer_Binder) made =
      reader.Reader().WS()->TransferReader()->TransientProcess()->Find(product);
  const TopoDS_Shape shape = made.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(made);
  const XCAFDoc_DataMapOfShapeLabel& labels = reader.GetShapeLabelMap();
  return !shape.IsNull() && labels.IsBound(shape) ? labels.Find(shape) : TDF_Label();
}

/// A root of another document in this one, with its parts and all looks. A shape that is there
/// already, as of a file that two others name, stays one part.
TDF_Label root_taken_in(const TDF_Label& root, const Document& other, const Document& document) {
  TDF_LabelDataMap copies;
  const TDF_Label copy =
      XCAFDoc_Editor::CloneShapeLabel(root, other.shapes(), document.shapes(), copies);
  NCollection_DataMap<Handle(XCAFDoc_VisMaterial), Handle(XCAFDoc_VisMaterial)> materials;
  for (TDF_LabelDataMap::Iterator it(copies); it.More(); it.Next()) {
    set_name(it.Value(), name_of(it.Key()));
    XCAFDoc_Editor::CloneMetaData(it.Key(), it.Value(), &materials, true, true, true, true, false);
  }
  return copy;
}

/// One label for all of a document; null if it is empty.
TDF_Label taken_in(const Document& other, const std::string& name, const Document& document) {
  TDF_LabelSequence roots, taken;
  other.shapes()->GetFreeShapes(roots);
  for (const TDF_Label& root : roots)
    if (const TDF_Label copy = root_taken_in(root, other, document); !copy.IsNull())
      taken.Append(copy);
  TDF_Label whole = taken.IsEmpty() ? TDF_Label() : taken.First();
  if (taken.Size() == 1 && name_of(roots.First()).empty()) set_name(whole, name);
  if (taken.Size() > 1) {
    whole = document.shapes()->NewShape();
    set_name(whole, name);
    for (const TDF_Label& copy : taken)
      document.shapes()->AddComponent(whole, copy, TopLoc_Location());
  }
  document.shapes()->UpdateAssemblies();
  return whole;
}

/// All instances of one part become instances of another, with their places and looks.
void refer_to(const TDF_Label& from, const TDF_Label& to) {
  TDF_LabelSequence users;
  XCAFDoc_ShapeTool::GetUsers(from, users);
  const Handle(TDataStd_TreeNode) used = TDataStd_TreeNode::Set(to, XCAFDoc::ShapeRefGUID());
  for (const TDF_Label& user : users) {
    Handle(TDataStd_TreeNode) node;
    if (!user.FindAttribute(XCAFDoc::ShapeRefGUID(), node)) continue;
    node->Remove();
    used->Append(node);
    set_shape(user, XCAFDoc_ShapeTool::GetShape(to).Moved(XCAFDoc_ShapeTool::GetLocation(user)));
  }
}

void list(const OtherFile& other, const char* cause, ReadingReport& report) {
  report.add({"part", cause, true, 1, {other.file.filename().string()}});
}

}  // namespace

void put_other_files(const STEPCAFControl_Reader& reader, Reading& reading, Document& document) {
  std::map<const Model*, TDF_Label> taken;
  for (const OtherFile& other : reading.others) {
    if (!other.model) continue;  // which is listed
    const TDF_Label place = label_of(other.product, reader);
    TDF_Label& part = taken[other.model.get()];
    if (part.IsNull())
      part = taken_in(document_of(*other.model), place.IsNull() ? "" : name_of(place), document);
    if (part.IsNull()) {
      list(other, "nothing of its file can be taken over", reading.report);
      continue;
    }
    if (place.IsNull() || place == part) continue;
    refer_to(place, part);
    document.shapes()->RemoveShape(place);
  }
  document.shapes()->UpdateAssemblies();
}

void list_others(Reading& reading) {
  for (const OtherFile& other : reading.others)
    if (other.model)
      list(other, "its file is followed together with names and colours alone", reading.report);
}

}  // namespace blossom::occt
