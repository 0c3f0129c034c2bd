// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of a STEP file that are in other STEP files. For this folder and documents.

#pragma once

#include <Standard_Handle.hxx>

#include "adapters/occt/exchange/detail.h"

class XSControl_WorkSession;

namespace blossom::occt {

/// Open CASCADE follows every name of a file in a model, whatever it leads to, and wherever it
/// happens to find such a file. All names are taken out of the session. Those of regular files in
/// the model's own folder become others of the reading; all else is listed as lost, unless the
/// product has a shape in this file: then the name says where it came from.
///
/// throws    BadModel if a name cannot be taken out
void take_other_files(const Handle(XSControl_WorkSession) & session, Reading& reading);

}  // namespace blossom::occt
