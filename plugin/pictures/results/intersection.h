// SPDX-License-Identifier: LGPL-2.1-or-later
// An intersection as a picture: what crosses, touches, coincides or is unresolved in colours of its
// own.

#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/results/result.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/reports/cuts/intersection.h"

namespace blossom::pictures {

/// findings   of one object as a and b for an input with itself
/// stated     the status as it may be said
Picture intersection_picture(const reports::IntersectionFindings& findings, Status stated);

/// What a page tells of a certificate, line by line.
std::vector<std::string> certificate_facts(const Certificate& certificate);

}  // namespace blossom::pictures
