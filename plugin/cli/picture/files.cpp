// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/picture/files.h"

#include "adapters/occt/shapes.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/pictures/image/drawing.h"
#include "plugin/pictures/page/glb.h"
#include "plugin/pictures/page/page.h"
#include "plugin/pictures/scene/scene.h"

namespace blossom::cli {
std::vector<std::string> picture_names(const CommonOptions& options) {
  std::vector<std::string> names = {options.picture, options.look.html, options.look.glb};
  std::erase(names, "");
  return names;
}

std::vector<PictureFile> picture_files(const CommonOptions& options,
                                       const std::function<pictures::Picture()>& make) {
  std::vector<PictureFile> files;
  if (picture_names(options).empty()) return files;
  enter(Phase::Working, "drawing pictures");
  pictures::Picture picture = make();
  picture.view = options.look.view;
  picture.width = options.look.width;
  picture.height = options.look.height;
  const std::vector<pictures::SceneMesh> meshes = pictures::scene_meshes(picture);
  for (const std::string& text : pictures::notes_on(meshes)) note(text);
  if (!options.picture.empty()) files.push_back({options.picture, picture_png(picture, meshes)});
  if (!options.look.html.empty()) files.push_back({options.look.html, page_html(picture, meshes)});
  if (!options.look.glb.empty()) files.push_back({options.look.glb, glb_bytes(picture, meshes)});
  return files;
}

void write_pictures(const std::vector<PictureFile>& files) {
  for (const PictureFile& made : files) {
    enter(Phase::Writing, made.file);
    occt::write_text(made.bytes, made.file);
  }
}

}  // namespace blossom::cli
