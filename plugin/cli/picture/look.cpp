// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/picture/look.h"

#include <charconv>

#include "core/base/errors.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/pictures/scene/view.h"

namespace blossom::cli {
namespace {

using pictures::kMaxSide;
using pictures::kMinSide;

// One side of a picture and what follows it; 0 if it is none.
int side_of(const char*& at, const char* end) {
  int pixels = 0;
  const auto read = std::from_chars(at, end, pixels);
  at = read.ptr;
  return read.ec == std::errc{} && pixels >= kMinSide && pixels <= kMaxSide ? pixels : 0;
}

void take_size(const std::string& text, PictureLook& look) {
  const char* at = text.data();
  const char* const end = at + text.size();
  look.width = side_of(at, end);
  const bool separated = at != end && *at == 'x';
  if (separated) look.height = side_of(++at, end);
  if (!separated || look.width == 0 || look.height == 0 || at != end)
    throw UsageError("--size takes WIDTHxHEIGHT in pixels, each from " + std::to_string(kMinSide) +
                     " to " + std::to_string(kMaxSide) + ", not '" + text + "'");
}

void check_view(const std::string& text) {
  try {
    pictures::view_direction(text);
  } catch (const InvalidInput& wrong) {
    throw UsageError("--" + std::string(wrong.what()));
  }
}

}  // namespace

void add_picture_options(CLI::App& command, std::string& picture, PictureLook& look,
                         const std::string& shows) {
  command.add_option("--picture", picture, shows)->type_name("FILE");
  command.add_option("--html", look.html, "write a page to turn and to click into")
      ->type_name("FILE");
  command.add_option("--glb", look.glb, "write what is shown as a model of triangles (glTF)")
      ->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--view",
          [&look](const std::string& text) {
            check_view(text);  // a wrong one is told before the work
            look.view = text;
          },
          "where the picture is seen from: " + listed(pictures::view_words()) +
              ", or a direction to the eye")
      ->type_name("VIEW");
  command
      .add_option_function<std::string>(
          "--size", [&look](const std::string& text) { take_size(text, look); },
          "of the picture in pixels; 1200x900 without")
      ->type_name("WxH");
}

}  // namespace blossom::cli
