// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/contents.h"

#include <TopExp.hxx>

namespace blossom::occt {

void Contents::refresh() {
  shape = document ? document->shape() : whole_of(parts);
  faces.Clear();
  if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_FACE, faces);
}

}  // namespace blossom::occt
