// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/face_colours.h"

#include "adapters/occt/exchange/contents.h"

namespace blossom::occt {

std::vector<std::optional<FaceColour>> face_colours(const Model& model) {
  const Contents& contents = contents_of(model);
  // Parts in no document have no colours.
  if (!contents.document)
    return std::vector<std::optional<FaceColour>>(static_cast<std::size_t>(model.face_count()));
  return contents.document->face_colours(contents.faces);
}

}  // namespace blossom::occt
