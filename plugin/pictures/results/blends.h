// SPDX-License-Identifier: LGPL-2.1-or-later
// Blends as pictures: what was made in a colour of its own.

#pragma once

#include "adapters/occt/strip.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/reports/blends/fill.h"
#include "plugin/reports/blends/fillet.h"
#include "plugin/reports/models/input.h"

namespace blossom::pictures {

/// Also chamfers.
Picture fillet_picture(const reports::Input& part, const reports::FilletAnswer& answer);

Picture fill_picture(const reports::Input& input, const reports::FillAnswer& holes);

Picture strip_picture(const reports::Input& a, const reports::Input& b,
                      const occt::FaceStrip& strip);

}  // namespace blossom::pictures
