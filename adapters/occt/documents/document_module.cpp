// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/documents/document.h"
#include "adapters/occt/documents/files.h"
#include "adapters/occt/exchange/modules.h"

namespace blossom::occt {
namespace {

std::shared_ptr<DocumentInterface> make(const PlainParts& parts) {
  return std::make_shared<Document>(parts);
}

}  // namespace

const DocumentModule& document_module() {
  static constexpr DocumentModule module{make, add_step, read_iges};
  return module;
}

}  // namespace blossom::occt
