// SPDX-License-Identifier: LGPL-2.1-or-later
// What stands round a picture: title, legend, axes and scale bar. The scene keeps clear of it.

#pragma once

#include "plugin/pictures/image/raster/png.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/pictures/scene/view.h"

namespace blossom::pictures {

/// What annotations leave of the image to the scene, pixels; all of it if there are none.
Frame free_frame(const Picture& picture);

/// Draws marks of the scene, title, legend, axes and scale bar on an image that shows the scene.
/// view     of samples, as the canvas had it
void annotate(const Picture& picture, const View& view, Image& image);

}  // namespace blossom::pictures
