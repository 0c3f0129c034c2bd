// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of curves and surfaces as pictures.

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "plugin/nets/net.h"
#include "plugin/nets/whole_parts.h"
#include "plugin/pictures/scene/picture.h"

namespace blossom::pictures {

/// Pieces in two colours by turns, with their control nets when these are few.
/// nets   how many nets they are pieces of
/// stop   throws what ends the work
Picture subdivision_picture(const std::string& name, const std::vector<nets::Net>& made,
                            std::size_t nets, const std::function<void()>& stop);

/// Faces and edges as one B-spline each.
Picture whole_picture(const std::string& name, const std::vector<nets::WholePart>& parts);

}  // namespace blossom::pictures
