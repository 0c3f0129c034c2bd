// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/mesh_facts.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/errors.h"
#include "core/math/index.h"

namespace blossom {
namespace {

constexpr std::size_t kAskAfter = 1 << 16;  // steps: less than a millisecond

// Counts steps of a long work.
class Asking {
 public:
  explicit Asking(const std::function<void()>& ask) : ask_(ask) {}

  void step() {
    if (ask_ && ++steps_ % kAskAfter == 0) ask_();
  }

 private:
  const std::function<void()>& ask_;
  std::size_t steps_ = 0;
};

// A side, its lower point first, and the triangle that has it.
struct SideUse {
  int low, high, triangle;
  bool forward;
};

// Sorted, first by their lower points, of which each has few sides: that needs no comparisons.
std::vector<SideUse> side_uses(std::size_t points, std::span<const std::array<int, 3>> triangles,
                               Asking& asking) {
  const auto for_uses = [&](const auto& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      asking.step();
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
        if (a < 0 || index(a) >= points)
          throw InvalidInput("triangle " + std::to_string(t) + " has corner " + std::to_string(a) +
                             ", but there are " + std::to_string(points) + " points");
        if (a != b) visit(SideUse{std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
      }
    }
  };
  std::vector<std::size_t> ends(points + 1);  // of the uses of each point and those before it
  for_uses([&](const SideUse& use) { ++ends[index(use.low) + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<SideUse> uses(ends.back());
  for_uses([&](const SideUse& use) { uses[ends[index(use.low)]++] = use; });
  std::size_t first = 0;
  for (std::size_t p = 0; p < points; first = ends[p++])
    // The projection is what a sort calls all the time.
    std::ranges::sort(std::span(uses).subspan(first, ends[p] - first), {}, [&](const SideUse& use) {
      asking.step();
      return std::pair{use.high, use.triangle};
    });
  return uses;
}

// Calls `visit` with the uses of each side, and what is faulty of it.
void for_sides(std::span<const SideUse> uses, Asking& asking, const auto& visit) {
  for (std::size_t first = 0, end = 0; first < uses.size(); first = end) {
    asking.step();
    std::size_t forward = 0;
    for (end = first; end < uses.size() && uses[end].low == uses[first].low &&
                      uses[end].high == uses[first].high;
         ++end)
      forward += uses[end].forward;
    const std::size_t count = end - first;
    visit(uses.subspan(first, count), FaultySide{{uses[first].low, uses[first].high},
                                                 count % 2 == 1,
                                                 count > 2,
                                                 count % 2 == 0 && 2 * forward != count});
  }
}

void add_sides(std::size_t points, std::span<const std::array<int, 3>> triangles, Asking& asking,
               MeshFacts& facts) {
  const std::vector<SideUse> uses = side_uses(points, triangles, asking);
  DisjointSets parts(triangles.size());
  for_sides(uses, asking, [&](std::span<const SideUse> of_side, const FaultySide& side) {
    for (const SideUse& use : of_side)
      parts.join(index(use.triangle), index(of_side.front().triangle));
    facts.open_sides += side.open;
    facts.crowded_sides += side.crowded;
    facts.turned_sides += side.turned;
  });
  for (std::size_t t = 0; t < triangles.size(); ++t) facts.parts += parts.find(t) == t;
}

}  // namespace

MeshFacts mesh_facts(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles,
                     const std::function<void()>& ask) {
  MeshFacts facts;
  Asking asking(ask);
  add_sides(points.size(), triangles, asking, facts);
  // Far from the origin the volumes of its cones cancel.
  const Vec3 apex = points.empty() ? Vec3{} : points.front();
  for (const std::array<int, 3>& t : triangles) {
    asking.step();
    const Vec3 a = points[index(t[0])] - apex, b = points[index(t[1])] - apex,
               c = points[index(t[2])] - apex;
    facts.area += 0.5 * norm(cross(b - a, c - a));
    facts.volume += dot(a, cross(b, c)) / 6;
  }
  if (!facts.closed()) facts.volume = 0;
  return facts;
}

std::vector<FaultySide> faulty_sides(std::size_t points,
                                     std::span<const std::array<int, 3>> triangles,
                                     const std::function<void()>& ask) {
  Asking asking(ask);
  const std::vector<SideUse> uses = side_uses(points, triangles, asking);
  std::vector<FaultySide> faulty;
  for_sides(uses, asking, [&](std::span<const SideUse>, const FaultySide& side) {
    if (side.open || side.crowded || side.turned) faulty.push_back(side);
  });
  return faulty;
}

}  // namespace blossom
