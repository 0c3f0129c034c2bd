// SPDX-License-Identifier: LGPL-2.1-or-later
// The work for which Open CASCADE's exchange libraries are needed. They take longer to load than
// many commands take, so the program `blossom` loads them when there is such work; all others link
// them. For this folder and `documents` only.
//
// The two functions below stand in a source of their own each, which is linked unless the program
// has its own: see plugin/modules/loader.cpp.

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Standard_Transient.hxx>

#include "adapters/occt/exchange/contents.h"
#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

/// Shapes and names from STEP; no document.
struct StepModule {
  /// Reads the shapes into the plain parts of the reading, and the names if nothing more is wanted
  /// and the parts are in no assembly.
  /// returns  the work session that read them, for DocumentModule::add_step; null if all is done
  /// throws   BadModel with the cause, without the file's name
  Handle(Standard_Transient) (*read)(Reading& reading);
};

/// Documents, with all formats that need them.
struct DocumentModule {
  std::shared_ptr<DocumentInterface> (*make)(const PlainParts& parts);

  /// Puts what a work session has read into a document; if that fails, which is then reported, the
  /// plain parts stay.
  void (*add_step)(const Handle(Standard_Transient) & session, Reading& reading);

  /// throws   BadModel with the cause, without the file's name
  void (*read_iges)(Reading& reading);
};

const StepModule& step_module();
const DocumentModule& document_module();

/// A document as bytes for the same program in another process, with its shapes to the last bit;
/// nothing if the bytes would not give it again. Only programs link this that read in a child.
std::optional<std::string> document_bytes(const DocumentInterface& document);

/// throws   std::ios_base::failure or Standard_Failure if it is not what `document_bytes` made
std::shared_ptr<DocumentInterface> document_of_bytes(const std::string& bytes);

}  // namespace blossom::occt
