// SPDX-License-Identifier: LGPL-2.1-or-later
// What `trim --watertight` makes of a trimmed model.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/watertight.h"
#include "core/base/status.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/output/output.h"
#include "plugin/nets/net.h"
#include "plugin/reports/cuts/watertight.h"

namespace blossom::cli {

/// The shape as pieces with common sides.
///
/// engine      of it the tolerance, what counts as one point: pieces may lie ten times as far from
///             the faces
/// seconds     that are left of the time limit; 0 if there is none
/// returns     without a shape, and with faces that are open, if the time limit is reached
/// throws      occt::BadModel if the faces have no such pieces, naming the obstacle; Interrupted if
///             the user wants an end
occt::WatertightShape watertight_of(const TopoDS_Shape& shape, const EngineOptions& engine,
                                    double seconds);

/// Why nothing is written though there is no obstacle: the time limit; empty if it was not reached.
std::string reason_of(const WatertightPieces& pieces);

/// The status of a result that was made watertight: at best `tolerance` if pieces may fold over,
/// `stopped` if faces are open.
Status status_with(Status status, const WatertightPieces& pieces);

/// A line about the pieces, and one about those that may fold over.
std::string summary_of(const WatertightPieces& pieces);

/// The pieces as nets: patches and triangles, by the faces' numbers in the trimmed model.
std::vector<nets::Net> nets_of(const WatertightPieces& pieces, const std::string& file);

}  // namespace blossom::cli
