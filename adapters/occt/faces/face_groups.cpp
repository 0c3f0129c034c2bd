// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_groups.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace blossom::occt {

std::vector<FaceGroup> groups_over_edges(
    const std::vector<TopoDS_Shape>& faces,
    const std::function<bool(const TopoDS_Shape& edge)>& divides) {
  std::vector<std::size_t> next(faces.size());  // towards the first face of the group
  std::iota(next.begin(), next.end(), std::size_t{0});
  const auto first_of = [&](std::size_t face) {
    while (next[face] != face) face = next[face] = next[next[face]];
    return face;
  };
  TopTools_IndexedMapOfShape edges;
  std::vector<std::size_t> user;  // a face with each of the edges
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next()) {
      if (divides(it.Current())) continue;
      const auto edge = static_cast<std::size_t>(edges.Add(it.Current())) - 1;
      if (edge == user.size()) user.push_back(i);
      const std::size_t a = first_of(i), b = first_of(user[edge]);
      next[std::max(a, b)] = std::min(a, b);
    }
  std::map<std::size_t, FaceGroup> groups;
  for (std::size_t i = 0; i < faces.size(); ++i) groups[first_of(i)].push_back(i);
  std::vector<FaceGroup> all;
  for (auto& [first, group] : groups) all.push_back(std::move(group));
  return all;
}

}  // namespace blossom::occt
