// SPDX-License-Identifier: LGPL-2.1-or-later
// Documents from files and to files. For this folder only.

#pragma once

#include <functional>
#include <string>

#include <Standard_Transient.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

/// As DocumentModule has them.
void add_step(const Handle(Standard_Transient) & session, Reading& reading);
void read_iges(Reading& reading);

/// Puts the shapes that `transfer` gives with names and colours into a document, unless they are
/// not wanted or fail, which is then reported; the plain parts stay in that case.
void add_with_names(Reading& reading, const std::function<bool(Document&)>& transfer);

/// What files are to hold. throws Failure
FileContent step_content(const Document& document, const std::string& unit);
FileContent iges_content(const Document& document, const std::string& unit);
std::string glb_bytes(const Document& document);

}  // namespace blossom::occt
