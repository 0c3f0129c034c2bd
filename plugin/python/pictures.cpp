// SPDX-License-Identifier: LGPL-2.1-or-later
// Answers as files to look at.

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/pictures/image/drawing.h"
#include "plugin/pictures/page/glb.h"
#include "plugin/pictures/page/page.h"
#include "plugin/pictures/scene/scene.h"
#include "plugin/pictures/scene/view.h"
#include "plugin/pictures/scene/zebra.h"
#include "plugin/python/answers.h"

namespace blossom::python {
namespace {

using pictures::Picture;
using pictures::SceneMesh;

std::string shown_bytes(const Picture& picture, const std::vector<SceneMesh>& meshes,
                        const std::string& form) {
  if (form == "png") return pictures::picture_png(picture, meshes);
  if (form == "html") return pictures::page_html(picture, meshes);
  return pictures::glb_bytes(picture, meshes);
}

void check_look(const Look& look) {
  if (!look.view.empty()) pictures::view_direction(look.view);  // before the work
  for (const int side : {look.width, look.height})
    if (side < pictures::kMinSide || side > pictures::kMaxSide)
      throw InvalidInput("size: pixels from " + std::to_string(pictures::kMinSide) + " to " +
                         std::to_string(pictures::kMaxSide) + " are wanted, got " +
                         std::to_string(side));
}

}  // namespace

std::vector<std::string> show(const Answer& answer, const std::string& file, const Look& look,
                              const Control& control) {
  check_look(look);
  return interruptible(control, [&](const Watch& watch) {
    Picture picture = answer.picture(watch);
    watch.stop();
    picture.view = look.view;
    picture.width = look.width;
    picture.height = look.height;
    if (look.zebra) pictures::paint_zebra(picture);
    const std::vector<SceneMesh> meshes = pictures::scene_meshes(picture);
    if (meshes.empty() && pictures::all_layers(picture).empty())
      throw occt::Failure(file + ": there is nothing to see in this answer");
    watch.stop();
    const std::string bytes = shown_bytes(picture, meshes, look.form);
    watch.stop();
    occt::write_text(bytes, file);
    return pictures::notes_on(meshes);
  });
}

}  // namespace blossom::python
