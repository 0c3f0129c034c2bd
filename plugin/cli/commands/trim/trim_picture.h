// SPDX-License-Identifier: LGPL-2.1-or-later
// Trims and combined solids as pictures: each piece in a colour of its own, with what cut it.

#pragma once

#include <string>
#include <vector>

#include "adapters/occt/solid_trim.h"
#include "adapters/occt/trim.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/picture/picture.h"

namespace blossom::cli {

/// The pieces that are kept, the tools, and the curves that cut.
Picture trim_picture(const Input& part, const std::vector<const Input*>& tools,
                     const occt::TrimResult& made);

/// "above", "inside", ...; "side undecided" if it is not known.
std::string side_text(occt::PieceSide side);

/// The solids of the result, and the curves in which faces of the part meet those of tools.
Picture solids_picture(const std::string& title, const occt::SolidTrimResult& made);

}  // namespace blossom::cli
