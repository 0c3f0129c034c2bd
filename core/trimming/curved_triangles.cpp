// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/trimming/curved_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "core/blossom/triangle_composition.h"
#include "core/forms/degree.h"

namespace blossom {
namespace {

constexpr int kMostRounds = 16;  // of halving; chords come nearer to arcs by 4 each time

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The region of one patch while its arcs are being divided.
class Region {
 public:
  Region(BorderArcs& borders, std::vector<int>& arcs, const std::vector<BorderSide>& sides,
         int patch_u, int patch_v)
      : borders_(borders),
        arcs_(arcs),
        sides_(sides),
        corner_{static_cast<double>(patch_u), static_cast<double>(patch_v)},
        scale_(borders.metric(patch_u, patch_v)) {}

  CurvedTriangles triangles() {
    for (int round = 0; round < kMostRounds; ++round) {
      CurvedTriangles made;
      const std::set<int> to_halve = attempt(made);
      if (to_halve.empty()) return made;
      bool halved = false;
      for (const int arc : to_halve)
        if (const int second = borders_.halve(arc); second >= 0) {
          arcs_.push_back(second);
          halved = true;
        }
      if (!halved) break;
    }
    return {{}, "its borders meet or touch where the doubles cannot tell their sides"};
  }

 private:
  const RegionArc& arc(int number) const { return borders_.arcs()[index(number)]; }
  bool is_curved(int number) const { return arc(number).curve.degree() > 1; }

  // The triangles, or the arcs to halve first.
  std::set<int> attempt(CurvedTriangles& made) const {
    std::vector<BorderSide> sides;
    std::map<std::pair<int, int>, int> arc_between;
    for (const int number : arcs_) {
      sides.push_back({arc(number).from, arc(number).to});
      arc_between[{arc(number).from, arc(number).to}] = number;
    }
    sides.insert(sides.end(), sides_.begin(), sides_.end());
    std::set<int> to_halve = between_two_points(sides);
    if (!to_halve.empty()) return to_halve;
    const Triangulation flat = triangulate(scaled_points(), sides);
    for (const int side : flat.conflicts)
      if (index(side) < arcs_.size()) to_halve.insert(arcs_[index(side)]);
    if (!flat.consistent) to_halve.insert(arcs_.begin(), arcs_.end());
    // Halves of a straight arc that is the very trim lie where it does; there may be 2^16 of them.
    if (std::ranges::any_of(to_halve, [&](int number) { return is_curved(number); }))
      std::erase_if(to_halve, [&](int number) { return !is_curved(number); });
    else
      std::erase_if(to_halve, [&](int number) { return arc(number).exact; });
    if (!flat.conflicts.empty() || !flat.consistent) {
      if (to_halve.empty()) made.obstacle = "its borders cross each other";
      return to_halve;
    }
    for (const std::array<int, 3>& corners : flat.triangles) {
      CurvedTriangle triangle = curved(corners, arc_between);
      if (!keeps_its_turn(triangle.map))
        for (const int number : triangle.arcs)
          if (number >= 0 && is_curved(number)) to_halve.insert(number);
      made.triangles.push_back(std::move(triangle));
    }
    return to_halve;
  }

  // Curved arcs whose chord another side runs back along: nothing would be left between them.
  std::set<int> between_two_points(const std::vector<BorderSide>& sides) const {
    std::set<std::pair<int, int>> ends;
    for (const BorderSide& side : sides) ends.insert({side.from, side.to});
    std::set<int> result;
    for (const int number : arcs_)
      if (is_curved(number) && ends.contains({arc(number).to, arc(number).from}))
        result.insert(number);
    return result;
  }

  std::vector<Vec2> scaled_points() const {
    std::vector<Vec2> points = borders_.vertices();
    for (Vec2& p : points) p = {p[0] * scale_[0], p[1] * scale_[1]};
    return points;
  }

  CurvedTriangle curved(const std::array<int, 3>& corners,
                        const std::map<std::pair<int, int>, int>& arc_between) const {
    CurvedTriangle triangle{corners, {-1, -1, -1}, {1, {}}};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = arc_between.find({corners[k], corners[(k + 1) % 3]});
      if (found == arc_between.end()) continue;
      triangle.arcs[k] = found->second;
      triangle.map.degree = std::max(triangle.map.degree, arc(found->second).curve.degree());
    }
    BezierTriangle& map = triangle.map;
    const int q = map.degree;
    std::array<Vec2, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = borders_.vertices()[index(corners[k])] - corner_;
    for (int nu = 0; nu <= q; ++nu)
      for (int mu = 0; nu + mu <= q; ++mu) {
        const Vec2 p = (1.0 / q) * (nu * at[0] + mu * at[1] + (q - nu - mu) * at[2]);
        map.points.push_back({p[0], p[1], 1});
      }
    for (std::size_t k = 0; k < 3; ++k)
      if (triangle.arcs[k] >= 0)
        set_side(map, static_cast<int>(k), static_cast<int>((k + 1) % 3),
                 elevated(arc(triangle.arcs[k]).curve, q));
    for (int k = 0; k < 3; ++k)  // the vertices as they are, without a rounding
      map(k == 0 ? q : 0, k == 1 ? q : 0) = {at[index(k)][0], at[index(k)][1], 1};
    return triangle;
  }

  // The corners of straight triangles go round counter-clockwise exactly.
  static bool keeps_its_turn(const BezierTriangle& map) {
    if (map.degree == 1) return true;
    const BezierTriangleOf<double> turning = turning_form(map);
    return std::ranges::all_of(turning.points, [](double x) { return x >= -kTurningError; });
  }

  BorderArcs& borders_;
  std::vector<int>& arcs_;
  const std::vector<BorderSide>& sides_;
  Vec2 corner_;
  Vec2 scale_;
};

}  // namespace

CurvedTriangles curved_triangles(BorderArcs& borders, std::vector<int>& arcs,
                                 const std::vector<BorderSide>& sides, int patch_u, int patch_v) {
  return Region(borders, arcs, sides, patch_u, patch_v).triangles();
}

}  // namespace blossom
