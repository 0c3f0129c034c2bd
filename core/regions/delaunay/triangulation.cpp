// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/delaunay/triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/regions/delaunay/constrained_delaunay.h"

namespace blossom {
namespace {

constexpr int kNone = ConstrainedDelaunay::kNone;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void check(std::span<const Vec2> points, std::span<const BorderSide> sides) {
  for (const auto& [from, to] : sides)
    for (const int end : {from, to}) {
      if (end < 0 || at(end) >= points.size())
        throw InvalidInput("triangulate: there is no point " + std::to_string(end));
      if (!std::isfinite(points[at(end)][0]) || !std::isfinite(points[at(end)][1]))
        throw InvalidInput("triangulate: a coordinate is not finite");
      if (from == to) throw InvalidInput("triangulate: a side has equal ends");
    }
}

SideWindings windings_of(std::span<const BorderSide> sides) {
  SideWindings result;
  for (const auto& [from, to] : sides) {
    ++result[{from, to}];
    --result[{to, from}];
  }
  return result;
}

void collect(ConstrainedDelaunay& mesh, const SideWindings& windings, const std::vector<int>& names,
             Triangulation& result) {
  result.consistent = mesh.mark_region(windings);
  for (const ConstrainedDelaunay::Face& face : mesh.faces())
    if (face.inside) {
      std::array<int, 3> triangle = face.corner;
      for (int& corner : triangle) corner = names[at(corner)];
      result.triangles.push_back(triangle);
    }
}

}  // namespace

Triangulation triangulate(std::span<const Vec2> points, std::span<const BorderSide> sides) {
  check(points, sides);
  Triangulation result;
  if (sides.empty()) return result;
  std::vector<int> names, place(points.size(), kNone);  // of the points that sides use
  const auto place_of = [&](int point) {
    if (place[at(point)] == kNone) {
      place[at(point)] = static_cast<int>(names.size());
      names.push_back(point);
    }
    return place[at(point)];
  };
  std::vector<BorderSide> used;
  std::vector<Vec2> own;
  for (const auto& [from, to] : sides) used.push_back({place_of(from), place_of(to)});
  for (const int name : names) own.push_back(points[at(name)]);

  ConstrainedDelaunay mesh(std::move(own));
  std::map<std::pair<int, int>, int> known;  // sides by their ends
  std::vector<bool> in_conflict(used.size(), false);
  for (std::size_t i = 0; i < used.size(); ++i) {
    const auto [from, to] = used[i];
    if (const auto same = known.find({from, to}); same != known.end()) {
      in_conflict[i] = in_conflict[at(same->second)] = true;
      continue;
    }
    known[{from, to}] = static_cast<int>(i);
    std::pair<int, int> obstacle{kNone, kNone};
    if (mesh.fix(from, to, obstacle)) continue;
    in_conflict[i] = true;
    for (const auto& ends : {obstacle, std::pair{obstacle.second, obstacle.first}})
      if (const auto side = known.find(ends); side != known.end())
        in_conflict[at(side->second)] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (in_conflict[i]) result.conflicts.push_back(static_cast<int>(i));
  if (result.conflicts.empty()) collect(mesh, windings_of(used), names, result);
  return result;
}

}  // namespace blossom
