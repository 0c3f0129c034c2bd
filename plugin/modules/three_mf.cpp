// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles as 3MF.

#include "plugin/modules/three_mf.h"

#include "plugin/modules/entry.h"

const void* blossom_module(const char* interface) {
  static constexpr blossom::ThreeMfModule module{blossom::lib3mf::three_mf_bytes};
  return blossom::module_for(interface, &module);
}
