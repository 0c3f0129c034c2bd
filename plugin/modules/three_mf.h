// SPDX-License-Identifier: LGPL-2.1-or-later
// The module that writes 3MF: its library brings those of zip files and of ciphers with it.

#pragma once

#include "adapters/lib3mf/three_mf.h"

namespace blossom {

struct ThreeMfModule {
  decltype(&lib3mf::three_mf_bytes) bytes;
};

}  // namespace blossom
