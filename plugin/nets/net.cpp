// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/net.h"

namespace blossom::nets {
namespace {

std::string place_of(const NetSource& source) {
  if (source.face > 0) return "face " + std::to_string(source.face);
  if (source.edge > 0) return "edge " + std::to_string(source.edge);
  return "net " + std::to_string(source.net);
}

}  // namespace

std::string text_of(const NetSource& source) { return source.file + ": " + place_of(source); }

std::string name_of(const NetSource& source) {
  return source.name.empty() ? place_of(source) : source.name;
}

}  // namespace blossom::nets
