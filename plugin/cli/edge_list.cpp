// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/edge_list.h"

#include <iomanip>
#include <numbers>
#include <sstream>

#include "adapters/occt/edge_facts.h"
#include "plugin/cli/values.h"

namespace blossom::cli {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

Json edge_json(const occt::EdgeFacts& edge) {
  return {{"number", edge.number}, {"faces", edge.faces},   {"kind", to_string(edge.kind)},
          {"angle", edge.angle},   {"length", edge.length}, {"middle", edge.middle.coordinates}};
}

std::string edge_line(const occt::EdgeFacts& edge) {
  std::ostringstream faces, line, middle;
  for (std::size_t i = 0; i < edge.faces.size(); ++i)
    faces << (i == 0 ? "" : ", ") << edge.faces[i];
  middle << "[" << number_text(rounded(edge.middle[0])) << ", "
         << number_text(rounded(edge.middle[1])) << ", " << number_text(rounded(edge.middle[2]))
         << "]";
  line << std::setw(6) << edge.number << "  " << std::left << std::setw(10) << faces.str()
       << std::setw(10) << to_string(edge.kind) << std::setw(10)
       << number_text(rounded(edge.angle * kDegrees)) << std::setw(12)
       << number_text(rounded(edge.length)) << middle.str() << "\n";
  return line.str();
}

}  // namespace

EdgeList edge_list(const TopoDS_Shape& shape) {
  EdgeList list{Json::array(), "  edge  faces     kind      angle°    length      middle\n"};
  for (const occt::EdgeFacts& edge : occt::edge_facts(shape)) {
    list.json.push_back(edge_json(edge));
    list.text += edge_line(edge);
  }
  return list;
}

}  // namespace blossom::cli
