// SPDX-License-Identifier: LGPL-2.1-or-later
// The files that show a result: made before the first file is written, written with the others.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugin/cli/arguments/options.h"
#include "plugin/pictures/scene/picture.h"

namespace blossom::cli {

struct PictureFile {
  std::string file;
  std::string bytes;
};

/// The files that --picture, --html and --glb name.
std::vector<std::string> picture_names(const CommonOptions& options);

/// What these ask for; nothing is made if none of them does.
/// throws   as picture_png
std::vector<PictureFile> picture_files(const CommonOptions& options,
                                       const std::function<pictures::Picture()>& make);

/// Writes them.
/// throws   occt::Failure if one cannot be written
void write_pictures(const std::vector<PictureFile>& files);

}  // namespace blossom::cli
