// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures as pages to turn and to click into: one file, which needs no network and no other file.

#pragma once

#include <string>
#include <vector>

#include "plugin/pictures/scene/picture.h"
#include "plugin/pictures/scene/scene.h"

namespace blossom::pictures {

/// Pages are below this, bytes; faces get coarser triangles for it where they have to.
inline constexpr std::size_t kPageLimit = 5'000'000;

/// The bytes of an HTML file. Its content security policy allows the two scripts and the one
/// style sheet in it, by their hashes, and nothing to be fetched or sent.
/// meshes   of its scene; with coarser ones the page is made if it has to
/// throws   InvalidInput if the view is none; occt::Failure if it would exceed the limit with the
/// coarsest triangles
std::string page_html(const Picture& picture, const std::vector<SceneMesh>& meshes);

}  // namespace blossom::pictures
