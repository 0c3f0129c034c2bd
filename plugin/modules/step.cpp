// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes and names from STEP.

#include <stdexcept>

#include "adapters/occt/exchange/modules.h"
#include "plugin/modules/entry.h"

const void* blossom_module(const char* interface) {
  return blossom::module_for(interface, &blossom::occt::step_module());
}

/// Linked instead of the library's, so that none of it is here.
const blossom::occt::DocumentModule& blossom::occt::document_module() {
  throw std::logic_error("the module of STEP was asked for a document");
}
