// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_other_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

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

bool same_letters(const std::string& a, const std::string& b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// The file of that name in a folder. CAD systems name files with the folders that they had there,
/// and most systems take capital letters for small ones: such a name means the file, too, if it
/// means no other.
///
/// returns  empty if there is none
std::filesystem::path beside(const std::filesystem::path& folder, const std::string& name) {
  const std::string last = name.substr(name.find_last_of("/\\") + 1);
  if (last.empty() || last == "." || last == "..") return {};
  std::error_code none;
  if (std::filesystem::exists(folder / last, none)) return folder / last;
  std::vector<std::filesystem::path> alike;
  for (auto it = std::filesystem::directory_iterator(folder, none);
       it != std::filesystem::directory_iterator(); it.increment(none))
    if (same_letters(it->path().filename().string(), last)) alike.push_back(it->path());
  return alike.size() == 1 ? alike.front() : std::filesystem::path();
}

/// Why a file is not read; nothing if it is.
std::string why_left(const std::string& name, const std::filesystem::path& file) {
  if (file.empty())
    return name.find_first_of("/\\") != std::string::npos || name == "." || name == ".."
               ? "its file would be outside of the model's folder"
               : "its file is not beside the model";
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return "what it names is no regular file";
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

void take_other_files(const Handle(XSControl_WorkSession) & session, Reading& reading) {
  STEPConstruct_ExternRefs others(session);
  others.LoadExternRefs();
  for (int i = 1; i <= others.NbExternRefs(); ++i) {
    const std::string name = name_of(others, i);
    if (name.empty()) continue;
    if (!has_own_shape(session, others.ProdDef(i))) {
      reading.names_files = true;
      const std::filesystem::path folder = reading.file.parent_path();
      const std::filesystem::path file = beside(folder.empty() ? "." : folder, name);
      const std::string cause = reading.options.names
                                    ? why_left(name, file)
                                    : "its file is followed together with names and colours alone";
      if (cause.empty())
        reading.others.push_back({others.ProdDef(i), file});
      else
        reading.report.add({"part", cause, true, 1, {name}});
    }
    take_out(others, i, session->Graph());
    if (!name_of(others, i).empty()) refuse("has a part in another file", reading.report);
  }
}

}  // namespace blossom::occt
