// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/result.h"

namespace blossom {

const char* to_string(PlaceKind kind) {
  switch (kind) {
    case PlaceKind::Touch: return "touch";
    case PlaceKind::Node: return "node";
    case PlaceKind::Cusp: return "cusp";
    case PlaceKind::Tangential: return "tangential";
    case PlaceKind::Overlap: return "overlap";
    case PlaceKind::Open: break;
  }
  return "open";
}

}  // namespace blossom
