// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/picture/files.h"

#include <map>

#include "adapters/occt/shapes.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/page/glb.h"
#include "plugin/cli/page/page.h"
#include "plugin/cli/picture/drawing.h"
#include "plugin/cli/picture/scene.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/reports/text/json.h"

namespace blossom::cli {
namespace {

void report_faces_not_filled(const std::vector<SceneMesh>& meshes) {
  std::map<std::string, std::size_t> faces;  // by the reason
  for (const SceneMesh& item : meshes)
    if (!item.mesh().obstacle.empty()) ++faces[item.mesh().obstacle];
  for (const auto& [reason, count] : faces)
    note("the picture shows " + reports::counted(count, "face") + " by edges alone: " + reason);
}

}  // namespace

std::vector<std::string> picture_names(const CommonOptions& options) {
  std::vector<std::string> names = {options.picture, options.look.html, options.look.glb};
  std::erase(names, "");
  return names;
}

std::vector<PictureFile> picture_files(const CommonOptions& options,
                                       const std::function<Picture()>& make) {
  std::vector<PictureFile> files;
  if (picture_names(options).empty()) return files;
  enter(Phase::Working, "drawing pictures");
  Picture picture = make();
  picture.view = options.look.view;
  picture.width = options.look.width;
  picture.height = options.look.height;
  const std::vector<SceneMesh> meshes = scene_meshes(picture);
  report_faces_not_filled(meshes);
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
