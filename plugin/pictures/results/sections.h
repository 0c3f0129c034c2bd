// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections with planes as pictures.

#pragma once

#include "adapters/occt/plane_section.h"
#include "core/base/status.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/queries/section.h"

namespace blossom::pictures {

/// stated   the status as it may be said
Picture section_picture(const reports::Input& input, const occt::PlaneSection& section,
                        Status stated);

/// A page tells of each curve and point in which plane and of which part it is.
Picture sections_picture(const reports::Input& input, const reports::SectionsAnswer& answer);

}  // namespace blossom::pictures
