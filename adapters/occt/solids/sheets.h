// SPDX-License-Identifier: LGPL-2.1-or-later
// A solid divided by a sheet, and what solids and sheets leave of a sheet.

#pragma once

#include <cstddef>
#include <vector>

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

/// Adds to the result the faces that the operation leaves of a sheet, and to fuse also those of the
/// tool that do not lie on it. Where the pieces' areas do not add up to those of the faces, there
/// is an obstacle.
///
/// pieces   of the part, a sheet, and of the tool, with sides as `find_sides` sets them
/// result   gets faces, of the part (`tool` is -1) and of the tool (0), and obstacles
/// throws   Failure if a piece cannot be measured
void take_sheet_pieces(const SolidPieces& pieces, const TrimTool& part, const TrimTool& tool,
                       SolidOperation operation, SolidTrimResult& result);

/// The place of the first tool that is no solid; their number if all are.
std::size_t first_sheet(const std::vector<TrimTool>& tools);

/// Whether the result consists of sheets.
bool takes_sheets(const TrimTool& part, const std::vector<TrimTool>& tools,
                  SolidOperation operation);

/// As `trim_solids`, where `takes_sheets` says so and nothing is misplaced. Each tool, and each
/// solid of it, divides what those before it left.
/// stated   as of SolidDivisions
SolidTrimResult trim_sheets(const TrimTool& part, const std::vector<TrimTool>& tools,
                            SolidOperation operation, double stated,
                            const IntersectionOptions& options);

}  // namespace blossom::occt
