// SPDX-License-Identifier: LGPL-2.1-or-later
// How smoothly faces meet along edges, in words: for summaries, and for pages that show them.

#pragma once

#include <string>

#include "adapters/occt/blending/continuity.h"

namespace blossom::reports {

bool is_smooth(const occt::EdgeContinuity& edge);
/// G0, with normals.
bool is_sharp(const occt::EdgeContinuity& edge);
/// The face lies on the other one there, or is turned over.
bool folds_back(const occt::EdgeContinuity& edge);

/// Three digits, as 0.00123 or 1.23e-08.
std::string short_text(double value);

/// "0.5 rad (28.6 degrees)".
std::string angle_text(double radians);

/// "edge 3 (faces 1 2)".
std::string edge_text(const occt::EdgeContinuity& edge);

/// All that is known of an edge, in one line.
std::string edge_line(const occt::EdgeContinuity& edge);

}  // namespace blossom::reports
