// SPDX-License-Identifier: LGPL-2.1-or-later
// A solid divided by a sheet.

#pragma once

#include "adapters/occt/queries/cone_volumes.h"
#include "adapters/occt/solid_trim.h"
#include "adapters/occt/solids/solid_pieces.h"
#include "core/base/work_limit.h"

namespace blossom::occt {

/// Adds the solids that a sheet divides a part into, each closed by what of the sheet lies in the
/// part, whose two sides bound two of them. What of the sheet ends freely in the part, or has one
/// body on both sides, divides nothing and is left out; where nothing is left, the part is as it
/// was.
///
/// pieces   of the part and of the sheet; of the latter on which side of the part they lie
/// result   gets solids, with faces of the part (`tool` is -1) and of the sheet (0), volumes and
///          obstacles
/// throws   Failure when the limit is reached, or a piece cannot be measured
void divide_by_sheet(const SolidPieces& pieces, const TrimTool& part, ConeVolumes& cones,
                     const WorkLimit& limit, SolidTrimResult& result);

}  // namespace blossom::occt
