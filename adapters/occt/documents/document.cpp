// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/documents/document.h"

#include <mutex>

#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

Document::Document(const PlainParts& parts) {
  const std::lock_guard guard(exchange_lock());
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", handle_);
  for (const PlainPart& part : parts) {
    const TDF_Label label = add_label(part.shape, part.name);
    for (const NamedShape& named : part.named)
      if (const TDF_Label sub = shapes()->AddSubShape(label, named.shape); !sub.IsNull())
        set_name(sub, named.name);
  }
}

Document::~Document() {
  const std::lock_guard guard(exchange_lock());
  try {
    XCAFApp_Application::GetApplication()->Close(handle_);
  } catch (...) {
    // A destructor has nobody to tell; the application keeps the document then.
  }
}

Handle(XCAFDoc_ShapeTool) Document::shapes() const {
  return XCAFDoc_DocumentTool::ShapeTool(main());
}

TopoDS_Shape assembled(const TDF_Label& label) {
  TDF_Label part;
  if (XCAFDoc_ShapeTool::GetReferredShape(label, part)) {
    TopoDS_Shape shape = assembled(part);
    if (!shape.IsNull())
      shape.Location(XCAFDoc_ShapeTool::GetLocation(label) * shape.Location(), false);
    return shape;
  }
  if (!XCAFDoc_ShapeTool::IsAssembly(label)) return XCAFDoc_ShapeTool::GetShape(label);
  TopoDS_Compound whole;
  const BRep_Builder builder;
  builder.MakeCompound(whole);
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(label, components);
  for (const TDF_Label& component : components)
    if (const TopoDS_Shape shape = assembled(component); !shape.IsNull()) builder.Add(whole, shape);
  return whole;
}

TopoDS_Shape Document::shape() const {
  TDF_LabelSequence roots;
  shapes()->GetFreeShapes(roots);
  PlainParts parts;
  for (const TDF_Label& root : roots) parts.push_back({assembled(root)});
  return whole_of(parts);
}

Document& document_of(const Model& model) {
  return static_cast<Document&>(document_of(contents_of(model)));
}

TDF_Label Document::add_label(const TopoDS_Shape& shape, const std::string& name) const {
  const TDF_Label label = shapes()->NewShape();
  shapes()->SetShape(label, shape);
  set_name(label, name);
  return label;
}

void Document::add(const TopoDS_Shape& shape, const std::string& name,
                   const std::vector<double>& colour) {
  const TDF_Label label = add_label(shape, name);
  if (!colour.empty())
    XCAFDoc_DocumentTool::ColorTool(main())->SetColor(
        label, Quantity_Color(colour[0], colour[1], colour[2], Quantity_TOC_sRGB),
        XCAFDoc_ColorGen);
}

void Document::add_assembly(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts,
                            const std::string& name) {
  const TDF_Label whole = shapes()->NewShape();
  set_name(whole, name);
  for (const auto& [part, shape] : parts)
    set_name(shapes()->AddComponent(whole, add_label(shape, part), TopLoc_Location()), part);
  shapes()->UpdateAssemblies();
}

}  // namespace blossom::occt
