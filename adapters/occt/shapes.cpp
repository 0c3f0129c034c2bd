// SPDX-License-Identifier: LGPL-2.1-or-later
// A model in memory: what it holds, its shape and the numbers of its faces.

#include "adapters/occt/shapes.h"

#include <algorithm>
#include <cctype>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <TopoDS.hxx>

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

void Model::Impl::refresh() {
  Contents::refresh();
  repairer.reset();
}

Contents& contents_of(const Model& model) { return *model.impl_; }

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
    if (colour.empty() && !impl_->document)
      impl_->parts.push_back({shape, name});
    else
      document_of(*impl_).add(shape, name, colour);
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
    document_of(*impl_).add_assembly(parts, name);
    impl_->refresh();
  });
}

void Model::add_combined(const TopoDS_Shape& shape, const std::string& name,
                         const std::vector<FaceOrigin>& origins) {
  if (shape.IsNull()) throw BadModel("the part '" + name + "' has no shape");
  for (const FaceOrigin& origin : origins) origin.model->face(origin.number);
  const std::lock_guard guard(exchange_lock());
  guarded("naming the faces of '" + name + "'", [&] {
    document_of(*impl_).add_combined(shape, name, origins);
    impl_->refresh();
  });
}

void Model::replace_faces(const std::map<int, std::vector<TopoDS_Face>>& pieces) {
  for (const auto& [number, news] : pieces) {
    face(number);
    for (const TopoDS_Face& piece : news)
      if (piece.IsNull())
        throw BadModel("a piece for face " + std::to_string(number) + " is no face");
  }
  const std::lock_guard guard(exchange_lock());
  guarded("replacing faces", [&] {
    document_of(*impl_).replace_faces(impl_->faces, pieces);
    impl_->refresh();
  });
}

void Model::replace_solids(const std::vector<CombinedSolid>& solids, CommonFaces common) {
  for (const CombinedSolid& solid : solids) {
    if (solid.faces.empty()) throw BadModel("a solid has no faces");
    for (const FaceOrigin& face : solid.faces) face.model->face(face.number);
  }
  const std::lock_guard guard(exchange_lock());
  guarded("replacing solids", [&] {
    document_of(*impl_).replace_solids(*this, solids, common);
    impl_->refresh();
  });
}

Model Model::copy() const {
  const std::lock_guard guard(exchange_lock());
  Model made;
  guarded("copying the model", [&] {
    made.impl_->parts = impl_->parts;
    if (impl_->document) made.impl_->document = impl_->document->copy();
    made.impl_->unit = impl_->unit;
    made.impl_->beside = impl_->beside;
    made.impl_->stated = impl_->stated;
    made.impl_->refresh();
  });
  return made;
}

std::vector<std::string> Model::face_names() const {
  return impl_->document ? impl_->document->face_names(impl_->faces)
                         : occt::face_names(impl_->parts, impl_->faces);
}

std::vector<std::string> Model::part_paths() const {
  return impl_->document ? impl_->document->part_paths(impl_->faces)
                         : occt::part_paths(impl_->parts, impl_->faces);
}

std::vector<AssemblyNode> Model::assembly() const {
  return impl_->document ? impl_->document->assembly(shape(), impl_->faces)
                         : occt::assembly(impl_->parts, shape(), impl_->faces);
}

std::string Model::part_name(int number) const {
  const TopoDS_Face wanted = face(number);
  return impl_->document ? impl_->document->part_name(wanted)
                         : occt::part_name(impl_->parts, wanted);
}

const std::string& Model::file_unit() const { return impl_->unit; }

void quiet_messages() {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const Handle(Message_PrinterOStream) printer =
      new Message_PrinterOStream("cerr", false, Message_Warning);
  printer->SetToColorize(false);
  Message::DefaultMessenger()->AddPrinter(printer);
}

}  // namespace blossom::occt
