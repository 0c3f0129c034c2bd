// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/edges.h"

namespace blossom::reports {

Json edges_json(const std::vector<occt::EdgeFacts>& edges) {
  Json list = Json::array();
  for (const occt::EdgeFacts& edge : edges)
    list.push_back({{"number", edge.number},
                    {"faces", edge.faces},
                    {"kind", to_string(edge.kind)},
                    {"angle", edge.angle},
                    {"length", edge.length},
                    {"middle", edge.middle.coordinates}});
  return list;
}

}  // namespace blossom::reports
