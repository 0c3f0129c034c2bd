// SPDX-License-Identifier: LGPL-2.1-or-later
// Documents for another process: Open CASCADE's binary form, in which directions and places change
// in the last bit, and all shapes and places of labels once more as they are in memory.

#include <ios>
#include <mutex>
#include <sstream>
#include <utility>
#include <vector>

#include <BRep_Builder.hxx>
#include <BinXCAFDrivers.hxx>
#include <TDF_ChildIterator.hxx>
#include <TNaming_Builder.hxx>
#include <TNaming_Iterator.hxx>
#include <TNaming_NamedShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_Location.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/exact/exact_bytes.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/modules.h"
#include "adapters/occt/exchange/value_bytes.h"

namespace blossom::occt {
namespace {

constexpr const char* kBinary = "BinXCAF";

Handle(TDocStd_Application) application_with_binary_form() {
  const Handle(TDocStd_Application) application = XCAFApp_Application::GetApplication();
  BinXCAFDrivers::DefineFormat(application);
  return application;
}

/// Calls visit(label, shape) and place(label, location) for those that labels have, in their order.
template <class OnShape, class OnPlace>
void visit_shapes(const TDF_Label& root, const OnShape& visit, const OnPlace& place) {
  for (TDF_ChildIterator it(root, true); it.More(); it.Next()) {
    const TDF_Label label = it.Value();
    Handle(TNaming_NamedShape) named;
    if (label.FindAttribute(TNaming_NamedShape::GetID(), named) && !named->Get().IsNull())
      visit(label, *named);
    Handle(XCAFDoc_Location) location;
    if (label.FindAttribute(XCAFDoc_Location::GetID(), location)) place(label, location->Get());
  }
}

/// What TNaming_Builder::Generated makes of a shape, of which alone exact shapes are put back.
bool is_plain(const TNaming_NamedShape& named) {
  TNaming_Iterator it(named.Label());
  if (named.Evolution() != TNaming_PRIMITIVE || !it.More() || !it.OldShape().IsNull()) return false;
  it.Next();
  return !it.More();
}

/// A place as that of a compound of nothing.
TopoDS_Shape carrier_of(const TopLoc_Location& location) {
  TopoDS_Compound carrier;
  BRep_Builder().MakeCompound(carrier);
  carrier.Location(location, false);
  return carrier;
}

struct DocumentParts {
  std::string document, shapes;
};

template <class Way>
void each_member(Way& way, DocumentParts& parts) {
  way(parts.document), way(parts.shapes);
}

}  // namespace

std::optional<std::string> document_bytes(const DocumentInterface& document) {
  const std::lock_guard guard(exchange_lock());
  const Handle(TDocStd_Document)& own = static_cast<const Document&>(document).handle();
  std::vector<TopoDS_Shape> shapes;
  bool plain = true;
  visit_shapes(
      own->Main().Root(),
      [&](const TDF_Label&, const TNaming_NamedShape& named) {
        plain = plain && is_plain(named);
        shapes.push_back(named.Get());
      },
      [&](const TDF_Label&, const TopLoc_Location& at) { shapes.push_back(carrier_of(at)); });
  std::optional<std::string> exact = plain ? exact_bytes(shapes) : std::nullopt;
  if (!exact) return std::nullopt;
  const TCollection_ExtendedString format = own->StorageFormat();
  own->ChangeStorageFormat(kBinary);
  std::ostringstream out(std::ios::out | std::ios::binary);
  const PCDM_StoreStatus status = application_with_binary_form()->SaveAs(own, out);
  own->ChangeStorageFormat(format);
  if (status != PCDM_SS_OK) return std::nullopt;
  return value_bytes(DocumentParts{std::move(out).str(), std::move(*exact)});
}

std::shared_ptr<DocumentInterface> document_of_bytes(const std::string& bytes) {
  const std::lock_guard guard(exchange_lock());
  const DocumentParts parts = value_of<DocumentParts>(bytes);
  std::istringstream in(parts.document, std::ios::in | std::ios::binary);
  Handle(TDocStd_Document) handle;
  if (application_with_binary_form()->Open(in, handle) != PCDM_RS_OK)
    throw std::ios_base::failure("the document cannot be read");
  auto document = std::make_shared<Document>(handle);
  const std::vector<TopoDS_Shape> shapes = shapes_of_exact_bytes(parts.shapes);
  // Labels change while shapes are put to them, so all are found first.
  std::vector<std::pair<TDF_Label, bool>> labels;
  visit_shapes(
      handle->Main().Root(),
      [&](const TDF_Label& label, const TNaming_NamedShape&) { labels.emplace_back(label, true); },
      [&](const TDF_Label& label, const TopLoc_Location&) { labels.emplace_back(label, false); });
  if (labels.size() != shapes.size()) throw std::ios_base::failure("shapes of labels are missing");
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto& [label, has_shape] = labels[i];
    if (has_shape)
      TNaming_Builder(label).Generated(shapes[i]);
    else
      XCAFDoc_Location::Set(label, shapes[i].Location());
  }
  return document;
}

}  // namespace blossom::occt
