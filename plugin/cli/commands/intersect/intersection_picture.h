// SPDX-License-Identifier: LGPL-2.1-or-later
// An intersection as a picture: what crosses, touches, coincides or is unresolved in colours of its
// own.

#pragma once

#include <string>
#include <vector>

#include "adapters/occt/intersection.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/picture/picture.h"
#include "plugin/reports/cuts/intersection.h"

namespace blossom::cli {

/// a, b      one object for an input with itself
Picture intersection_picture(const reports::IntersectionFindings& findings);

/// What a page tells of faces: "face 12 (Bolt), cylinder".
std::vector<std::string> face_labels(const Input& input);

/// What a page tells of a certificate, line by line.
std::vector<std::string> certificate_facts(const Certificate& certificate);

}  // namespace blossom::cli
