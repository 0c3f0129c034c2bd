// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_other_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <STEPConstruct_ExternRefs.hxx>
#include <StepAP214_AppliedExternalIdentificationAssignment.hxx>
#include <StepBasic_DocumentFile.hxx>
#include <StepBasic_ExternalSource.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionWithAssociatedDocuments.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace blossom::occt {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Why a file is not followed; nothing if it is.
std::string why_left(const std::filesystem::path& folder, const std::string& name) {
  if (name.find_first_of("/\\") != std::string::npos || name == "." || name == "..")
    return "its file would be outside of the model's folder";
  const std::filesystem::path file = folder / name;
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return "its file is not beside the model";
  if (!std::filesystem::is_regular_file(file, none)) return "what it names is no regular file";
  if (text_of(file).find("DOCUMENT_FILE") != std::string::npos)
    return "its file names others, which are not followed";
  return {};
}

std::string name_of(const STEPConstruct_ExternRefs& others, int number) {
  const char* const name = others.FileName(number);
  return name == nullptr ? "" : name;
}

/// Whether the product has a shape in this file: then the other one is where it came from.
bool has_own_shape(const Handle(XSControl_WorkSession) & session,
                   const Handle(StepBasic_ProductDefinition) & product) {
  const Handle(Transfer_TransientProcess) made = session->TransferReader()->TransientProcess();
  if (product.IsNull()) return false;
  const TopoDS_Shape shape = TransferBRep::ShapeResult(made->Find(product));
  return !shape.IsNull() && TopoDS_Iterator(shape).More();
}

/// Wherever the name may be looked for.
void take_out(const STEPConstruct_ExternRefs& others, int number, const Interface_Graph& graph) {
  const Handle(TCollection_HAsciiString) nothing = new TCollection_HAsciiString;
  const Handle(StepBasic_DocumentFile) document = others.DocFile(number);
  if (document.IsNull()) {  // the product names documents itself
    const auto product = Handle(StepBasic_ProductDefinitionWithAssociatedDocuments)::DownCast(
        others.ProdDef(number));
    if (product.IsNull()) return;
    for (int i = 1; i <= product->NbDocIds(); ++i) {
      product->DocIdsValue(i)->SetId(nothing);
      product->DocIdsValue(i)->SetName(nothing);
    }
    return;
  }
  document->SetId(nothing);
  document->SetName(nothing);
  for (Interface_EntityIterator it = graph.Sharings(document); it.More(); it.Next()) {
    const auto assigned =
        Handle(StepAP214_AppliedExternalIdentificationAssignment)::DownCast(it.Value());
    if (assigned.IsNull()) continue;
    assigned->SetAssignedId(nothing);
    assigned->SetSource(new StepBasic_ExternalSource);
  }
}

}  // namespace

bool keep_to_own_folder(const Handle(XSControl_WorkSession) & session, Reading& reading) {
  STEPConstruct_ExternRefs others(session);
  others.LoadExternRefs();
  bool follows = false;
  for (int i = 1; i <= others.NbExternRefs(); ++i) {
    const std::string name = name_of(others, i);
    if (name.empty()) continue;
    if (!has_own_shape(session, others.ProdDef(i))) {
      reading.has_other_files = true;
      const std::string cause = reading.options.names
                                    ? why_left(reading.file.parent_path(), name)
                                    : "its file is followed together with names and colours alone";
      follows = follows || cause.empty();
      if (cause.empty()) continue;
      reading.report.add({"part", cause, true, 1, {name}});
    }
    take_out(others, i, session->Graph());
    if (!name_of(others, i).empty()) refuse("has a part in another file", reading.report);
  }
  return follows;
}

}  // namespace blossom::occt
