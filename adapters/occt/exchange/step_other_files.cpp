// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step_other_files.h"

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
#include <TCollection_HAsciiString.hxx>
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

/// Wherever the name may be looked for.
void take_out(const STEPConstruct_ExternRefs& others, int number, const Interface_Graph& graph) {
  const Handle(TCollection_HAsciiString) nothing = new TCollection_HAsciiString;
  const Handle(StepBasic_DocumentFile) document = others.DocFile(number);
  if (document.IsNull()) return;
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
    reading.has_other_files = true;
    const std::string cause = reading.options.names
                                  ? why_left(reading.file.parent_path(), name)
                                  : "its file is followed together with names and colours alone";
    follows = follows || cause.empty();
    if (cause.empty()) continue;
    reading.report.add({"part", cause, true, 1, {name}});
    take_out(others, i, session->Graph());
    if (!name_of(others, i).empty()) refuse("has a part in another file", reading.report);
  }
  return follows;
}

}  // namespace blossom::occt
