// SPDX-License-Identifier: LGPL-2.1-or-later
// Documents, and the formats that need them.

#include "adapters/occt/exchange/modules.h"
#include "plugin/modules/entry.h"

const void* blossom_module(const char* interface) {
  return blossom::module_for(interface, &blossom::occt::document_module());
}
