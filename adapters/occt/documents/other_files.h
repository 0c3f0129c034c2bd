// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts that a STEP file has in other files, in its document. For this folder only.

#pragma once

#include <STEPCAFControl_Reader.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

/// Puts the others of a reading where the document has their products, which are empty there.
/// What finds no place is listed as lost.
void put_other_files(const STEPCAFControl_Reader& reader, Reading& reading, Document& document);

/// Lists all of them as lost: there is no document for them.
void list_others(Reading& reading);

}  // namespace blossom::occt
