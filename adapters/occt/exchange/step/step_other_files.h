// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of a STEP file that are in other STEP files. For this folder and documents.

#pragma once

#include <Standard_Handle.hxx>

#include "adapters/occt/exchange/detail.h"

class XSControl_WorkSession;

namespace blossom::occt {

/// Open CASCADE follows every name of a file in a model, whatever it leads to. Followed are those
/// of regular files in the model's own folder that name no others; all else is taken out of the
/// session and listed as lost, unless the product has a shape in this file: then the name says
/// where it came from.
///
/// returns   whether a name is left to follow
/// throws    BadModel if one cannot be taken out
bool keep_to_own_folder(const Handle(XSControl_WorkSession) & session, Reading& reading);

}  // namespace blossom::occt
