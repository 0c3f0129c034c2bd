// SPDX-License-Identifier: LGPL-2.1-or-later
// What a user may say about pictures, beside --picture.

#pragma once

#include <string>

#include <CLI/App.hpp>

namespace blossom::cli {

struct PictureLook {
  std::string html;  ///< --html: a page; empty for none
  std::string glb;   ///< --glb: a model of triangles and lines; empty for none
  std::string view;  ///< --view: as view_direction takes it; empty for the default
  int width = 1200;  ///< --size, pixels
  int height = 900;
};

/// --picture, --html, --glb, --view, --size.
void add_picture_options(CLI::App& command, std::string& picture, PictureLook& look,
                         const std::string& shows = "write a picture (PNG)");

}  // namespace blossom::cli
