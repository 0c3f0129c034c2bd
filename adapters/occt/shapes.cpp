// SPDX-License-Identifier: LGPL-2.1-or-later
// A model in memory: an XDE document, its shape and the numbers of its faces.

#include "adapters/occt/shapes.h"

#include <algorithm>
#include <cctype>

#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Quantity_Color.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

Format format_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".step" || ending == ".stp") return Format::Step;
  if (ending == ".iges" || ending == ".igs") return Format::Iges;
  if (ending == ".brep" || ending == ".brp") return Format::Brep;
  if (ending == ".glb") return Format::Glb;
  throw BadModel(file.string() + ": the ending '" + ending +
                 "' is not known; known are .step .stp .iges .igs .brep .brp");
}

std::recursive_mutex& exchange_lock() {
  static std::recursive_mutex lock;
  return lock;
}

Document::Document() {
  const std::lock_guard guard(exchange_lock());
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", handle_);
}

Document::~Document() {
  const std::lock_guard guard(exchange_lock());
  try {
    XCAFApp_Application::GetApplication()->Close(handle_);
  } catch (...) {
    // A destructor has nobody to tell; the application keeps the document then.
  }
}

void Document::renew() {
  const std::lock_guard guard(exchange_lock());
  XCAFApp_Application::GetApplication()->Close(handle_);
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", handle_);
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

void Model::Impl::refresh() {
  TDF_LabelSequence roots;
  document.shapes()->GetFreeShapes(roots);
  shape = TopoDS_Shape();
  if (roots.Length() == 1) {
    shape = assembled(roots.First());
  } else if (roots.Length() > 1) {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const TDF_Label& root : roots)
      if (const TopoDS_Shape part = assembled(root); !part.IsNull()) builder.Add(all, part);
    shape = all;
  }
  repairer.reset();
  faces.Clear();
  if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_FACE, faces);
}

Model::Model() : impl_(std::make_unique<Impl>()) {}
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;
Model::~Model() = default;

const TopoDS_Shape& Model::shape() const { return impl_->shape; }
int Model::face_count() const { return impl_->faces.Extent(); }
const std::filesystem::path& Model::file() const { return impl_->file; }
const ReadingReport& Model::reading() const { return impl_->reading; }

TopoDS_Face Model::face(int number) const {
  if (number < 1 || number > face_count()) {
    const std::string name = file().empty() ? "the model" : file().string();
    throw BadModel(name + ": there is no face " + std::to_string(number) + ", faces are 1 to " +
                   std::to_string(face_count()));
  }
  return TopoDS::Face(impl_->faces(number));
}

Repairer& Model::Impl::repairs() {
  if (!repairer) repairer = std::make_unique<Repairer>(shape, stated);
  return *repairer;
}

Repairs Model::repair(const std::vector<int>& faces, const std::function<void()>& stop) {
  for (const int number : faces) face(number);
  if (shape().IsNull()) return {};
  return guarded("repairing " + file().string(),
                 [&] { return impl_->repairs().repair(faces, stop); });
}

Repairs Model::repair(const std::function<void()>& stop) {
  if (shape().IsNull()) return {};
  return guarded("repairing " + file().string(), [&] { return impl_->repairs().repair_all(stop); });
}

void Model::add(const TopoDS_Shape& shape, const std::string& name,
                const std::vector<double>& colour) {
  if (shape.IsNull()) throw BadModel("the part '" + name + "' has no shape");
  if (!colour.empty() && colour.size() != 3)
    throw BadModel("the colour of '" + name + "' has " + std::to_string(colour.size()) +
                   " numbers instead of 3");
  const std::lock_guard guard(exchange_lock());
  guarded("adding the part '" + name + "'", [&] {
    const TDF_Label label = impl_->document.shapes()->NewShape();
    impl_->document.shapes()->SetShape(label, shape);
    TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
    if (!colour.empty())
      XCAFDoc_DocumentTool::ColorTool(impl_->document.main())
          ->SetColor(label, Quantity_Color(colour[0], colour[1], colour[2], Quantity_TOC_sRGB),
                     XCAFDoc_ColorGen);
    impl_->refresh();
  });
}

void Model::add_assembly(const std::vector<std::pair<std::string, TopoDS_Shape>>& parts,
                         const std::string& name) {
  if (parts.empty()) throw BadModel("the assembly '" + name + "' has no part");
  for (const auto& [part, shape] : parts)
    if (shape.IsNull()) throw BadModel("the part '" + part + "' has no shape");
  const std::lock_guard guard(exchange_lock());
  guarded("adding the assembly '" + name + "'", [&] {
    const Handle(XCAFDoc_ShapeTool) shapes = impl_->document.shapes();
    const TDF_Label whole = shapes->NewShape();
    set_name(whole, name);
    for (const auto& [part, shape] : parts) {
      const TDF_Label label = shapes->NewShape();
      shapes->SetShape(label, shape);
      set_name(label, part);
      set_name(shapes->AddComponent(whole, label, TopLoc_Location()), part);
    }
    shapes->UpdateAssemblies();
    impl_->refresh();
  });
}

void quiet_messages() {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const Handle(Message_PrinterOStream) printer =
      new Message_PrinterOStream("cerr", false, Message_Warning);
  printer->SetToColorize(false);
  Message::DefaultMessenger()->AddPrinter(printer);
}

}  // namespace blossom::occt
