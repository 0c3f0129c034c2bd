// SPDX-License-Identifier: LGPL-2.1-or-later
// What `blossom clash` shows: parts, what they have in common, where they touch, how far they are
// apart.

#pragma once

#include "plugin/pictures/scene/picture.h"
#include "plugin/reports/queries/clash.h"

namespace blossom::pictures {

/// Parts can be seen through, those that clash in a colour of their own; common bodies are solid.
/// Rings are on contacts, thin lines along distances that were measured.
Picture clash_picture(const reports::ClashAnswer& answer);

}  // namespace blossom::pictures
