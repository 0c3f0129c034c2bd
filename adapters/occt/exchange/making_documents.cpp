// SPDX-License-Identifier: LGPL-2.1-or-later
// A document where plain parts are no longer enough.

#include "adapters/occt/exchange/contents.h"
#include "adapters/occt/exchange/modules.h"

namespace blossom::occt {

DocumentInterface& document_of(Contents& contents) {
  if (!contents.document) {
    contents.document = document_module().make(contents.parts);
    contents.parts.clear();
  }
  return *contents.document;
}

}  // namespace blossom::occt
