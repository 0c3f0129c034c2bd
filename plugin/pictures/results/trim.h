// SPDX-License-Identifier: LGPL-2.1-or-later
// Trims and combined solids as pictures: each piece in a colour of its own, with what cut it.

#pragma once

#include <vector>

#include "adapters/occt/trim.h"
#include "core/base/status.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/reports/cuts/solids.h"
#include "plugin/reports/models/input.h"

namespace blossom::pictures {

/// The pieces that are kept, the tools, and the curves that cut.
/// stated   the status as it may be said
Picture trim_picture(const reports::Input& part, const std::vector<const reports::Input*>& tools,
                     const occt::TrimResult& made, Status stated);

/// The solids of the result, and the curves in which faces of the part meet those of tools.
Picture solids_picture(const reports::SolidAnswer& answer);

}  // namespace blossom::pictures
