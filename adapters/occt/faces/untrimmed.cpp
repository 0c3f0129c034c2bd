// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/untrimmed.h"

#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"

namespace blossom::occt {

UntrimmedFace untrimmed(const TopoDS_Face& face, const RegionOptions& options,
                        TriangleLowering& lowering) {
  UntrimmedFace result{bezier_surface(face), {}};
  result.region =
      triangulated_region(result.surface, trimmed_chart(face_trims(face)), options, lowering);
  return result;
}

UntrimmedFace untrimmed(const TopoDS_Face& face, const RegionOptions& options) {
  TriangleLowering lowering;
  return untrimmed(face, options, lowering);
}

}  // namespace blossom::occt
