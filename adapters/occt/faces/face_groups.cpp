// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_groups.h"

#include <algorithm>
#include <map>
#include <utility>

#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "core/base/disjoint_sets.h"

namespace blossom::occt {

std::vector<FaceGroup> groups_over_edges(
    const std::vector<TopoDS_Shape>& faces,
    const std::function<bool(const TopoDS_Shape& edge)>& divides) {
  DisjointSets sets(faces.size());  // known by the first face of the group
  TopTools_IndexedMapOfShape edges;
  std::vector<std::size_t> user;  // a face with each of the edges
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next()) {
      if (divides(it.Current())) continue;
      const auto edge = static_cast<std::size_t>(edges.Add(it.Current())) - 1;
      if (edge == user.size()) user.push_back(i);
      const auto [first, other] = std::minmax({sets.find(i), sets.find(user[edge])});
      sets.join(other, first);
    }
  std::map<std::size_t, FaceGroup> groups;
  for (std::size_t i = 0; i < faces.size(); ++i) groups[sets.find(i)].push_back(i);
  std::vector<FaceGroup> all;
  for (auto& [first, group] : groups) all.push_back(std::move(group));
  return all;
}

}  // namespace blossom::occt
