// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/open_rings.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "core/base/errors.h"
#include "core/math/index.h"

namespace blossom {
namespace {

int previous_side(int side) { return side % 3 == 0 ? side + 2 : side - 1; }

// The open side that ends where this one begins, in the fan of triangles round that point; kWrong
// if the fan has a side that goes on in no one way.
int side_before(int side, const std::vector<int>& across) {
  int at = previous_side(side);
  for (std::size_t steps = 0; steps < across.size(); ++steps) {
    const int other = across[index(at)];
    if (other == MeshSides::kOpen) return at;
    if (other == MeshSides::kWrong) return MeshSides::kWrong;
    at = previous_side(other);
  }
  return MeshSides::kWrong;
}

class RingWalk {
 public:
  RingWalk(std::span<const std::array<int, 3>> triangles, const MeshSides& sides)
      : triangles_(triangles), across_(sides.across), seen_(sides.across.size(), false) {}

  OpenRings rings() {
    for (std::size_t side = 0; side < across_.size(); ++side)
      if (across_[side] == MeshSides::kOpen && !seen_[side]) walk(static_cast<int>(side));
    return std::move(made_);
  }

 private:
  int begin_of(int side) const { return triangles_[index(side / 3)][index(side % 3)]; }

  // Backwards along the triangles, so forwards along what fills the hole. Where it comes to a point
  // again, the way since then is a ring of its own.
  void walk(int first) {
    OpenRing way;
    std::unordered_map<int, std::size_t> place;
    int side = first;
    do {
      seen_[index(side)] = true;
      const int point = begin_of(side);
      if (const auto found = place.find(point); found != place.end()) {
        way.points.push_back(point);
        way.sides.push_back(side);
        take(way, found->second + 1, place);
      } else {
        place[point] = way.points.size();
        way.points.push_back(point);
        way.sides.push_back(side);
      }
      side = side_before(side, across_);
      if (side == MeshSides::kWrong || (seen_[index(side)] && side != first)) {
        made_.left_sides += way.points.size();
        return;
      }
    } while (side != first);
    take(way, 0, place);
  }

  void take(OpenRing& way, std::size_t from, std::unordered_map<int, std::size_t>& place) {
    const auto at = static_cast<std::ptrdiff_t>(from);
    OpenRing ring{{way.points.begin() + at, way.points.end()},
                  {way.sides.begin() + at, way.sides.end()}};
    for (std::size_t k = from; k + 1 < way.points.size(); ++k) place.erase(way.points[k]);
    way.points.resize(from);
    way.sides.resize(from);
    if (ring.points.size() < 3)
      made_.left_sides += ring.points.size();
    else
      made_.rings.push_back(std::move(ring));
  }

  std::span<const std::array<int, 3>> triangles_;
  const std::vector<int>& across_;
  std::vector<bool> seen_;
  OpenRings made_;
};

}  // namespace

MeshSides::MeshSides(std::size_t points, std::span<const std::array<int, 3>> triangles)
    : across(3 * triangles.size(), kOpen) {
  struct Side {
    std::uint64_t ends;
    int number;
    bool forwards;
  };
  std::vector<Side> all;
  all.reserve(across.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      if (a < 0 || index(a) >= points)
        throw InvalidInput("a triangle names the point " + std::to_string(a) + " of " +
                           std::to_string(points));
      const auto low = static_cast<std::uint64_t>(std::min(a, b));
      const auto high = static_cast<std::uint64_t>(std::max(a, b));
      all.push_back({(low << 32) | high, static_cast<int>(3 * t + k), a < b});
    }
  std::ranges::sort(all, {}, &Side::ends);
  for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
    while (to < all.size() && all[to].ends == all[from].ends) ++to;
    if (to == from + 1) continue;
    const bool fits = to == from + 2 && all[from].forwards != all[from + 1].forwards;
    for (std::size_t k = from; k < to; ++k) across[index(all[k].number)] = kWrong;
    if (!fits) continue;
    across[index(all[from].number)] = all[from + 1].number;
    across[index(all[from + 1].number)] = all[from].number;
  }
}

OpenRings open_rings(std::span<const std::array<int, 3>> triangles, const MeshSides& sides) {
  return RingWalk(triangles, sides).rings();
}

}  // namespace blossom
