// SPDX-License-Identifier: LGPL-2.1-or-later
// The work for which Open CASCADE's exchange libraries are needed. They take longer to load than
// many commands take, so the program `blossom` loads them when there is such work; all others link
// them. For this folder and `documents` only.
//
// The two functions below stand in a source of their own each, which is linked unless the program
// has its own: see plugin/modules/loader.cpp.

#pragma once

#include <memory>
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

}  // namespace blossom::occt
