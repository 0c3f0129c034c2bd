// SPDX-License-Identifier: LGPL-2.1-or-later
// The texts that every page carries; they are files, put into the program when it is built.

#pragma once

#include <string_view>

namespace blossom::pictures {

/// A text, and the hash by which a page's security policy allows it, hexadecimal.
struct PageText {
  std::string_view text, sha256;
};

/// three.js: the renderer, lines with a width, and the camera's controls; its licence first.
PageText three_script();
/// scene.js and viewer.js, which go on where three.js ends.
PageText viewer_script();
PageText viewer_style();

}  // namespace blossom::pictures
