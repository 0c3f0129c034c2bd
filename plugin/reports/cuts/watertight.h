// SPDX-License-Identifier: LGPL-2.1-or-later
// Untrimmed pieces with common sides, as the member `watertight` of reports.

#pragma once

#include <cstddef>
#include <set>

#include "core/watertight/watertight.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

std::size_t triangle_count(const WatertightPieces& pieces);

/// Sides on edges that two or more pieces have.
std::size_t common_count(const WatertightPieces& pieces);

/// Faces with pieces that may fold over, increasing, from 1 on.
std::set<int> folded_faces(const WatertightPieces& pieces);

Json to_json(const WatertightPieces& pieces);

}  // namespace blossom::reports
