// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures as images.

#pragma once

#include <string>

#include "plugin/cli/picture/picture.h"
#include "plugin/cli/picture/png.h"

namespace blossom::cli {

/// The picture as an image.
/// throws   occt::Failure if a face cannot be triangulated; UsageError if the view is none
Image picture_image(const Picture& picture);

/// The bytes of a PNG file.
/// throws   likewise
std::string picture_png(const Picture& picture);

}  // namespace blossom::cli
