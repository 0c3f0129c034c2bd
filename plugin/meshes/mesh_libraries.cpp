// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_libraries.h"

#ifdef BLOSSOM_WITH_LIB3MF
#include "adapters/lib3mf/three_mf.h"
#endif

namespace blossom::meshes {

void load_three_mf() {
#ifdef BLOSSOM_WITH_LIB3MF
  lib3mf::load_three_mf();
#endif
}

}  // namespace blossom::meshes
