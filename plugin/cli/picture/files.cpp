// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/picture/files.h"

#include "adapters/occt/shapes.h"
#include "plugin/cli/page/glb.h"
#include "plugin/cli/page/page.h"
#include "plugin/cli/picture/drawing.h"

namespace blossom::cli {

std::vector<std::string> picture_names(const CommonOptions& options) {
  std::vector<std::string> names = {options.picture, options.look.html, options.look.glb};
  std::erase(names, "");
  return names;
}

std::vector<PictureFile> picture_files(const CommonOptions& options,
                                       const std::function<Picture()>& make) {
  std::vector<PictureFile> files;
  if (picture_names(options).empty()) return files;
  Picture picture = make();
  picture.view = options.look.view;
  picture.width = options.look.width;
  picture.height = options.look.height;
  if (!options.picture.empty()) files.push_back({options.picture, picture_png(picture)});
  if (!options.look.html.empty()) files.push_back({options.look.html, page_html(picture)});
  if (!options.look.glb.empty()) files.push_back({options.look.glb, glb_bytes(picture)});
  return files;
}

void write_pictures(const std::vector<PictureFile>& files) {
  for (const PictureFile& made : files) occt::write_text(made.bytes, made.file);
}

}  // namespace blossom::cli
