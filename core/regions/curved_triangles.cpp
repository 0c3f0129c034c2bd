// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/curved_triangles.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "core/blossom/triangle_composition.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/evaluation.h"
#include "core/math/index.h"
#include "core/regions/delaunay/plane_predicates.h"
#include "core/regions/sliver_triangles.h"

namespace blossom {
namespace {

constexpr int kMaxChordRounds = 16;  // of halving; chords come nearer to arcs by 4 each time
constexpr double kFlat = -0.5;       // cosine of an angle beyond which a triangle is flat
constexpr double kInLine = -0.999;   // likewise, beyond which its corners are in one line
constexpr double kBetter = 0.01;     // gain of cosines that is worth a flip
constexpr double kLessFlat = 4;      // likewise, of distances of cosines from -1
constexpr double kLine = 1e-15;      // as near to -1 are cosines for rounding alone
constexpr double kTriangleLoweringPart = 0.1;  // of the tolerance, for lower degrees
constexpr double kHigh = 1e3;  // of tolerances of borders: heights that need not be raised
constexpr int kMaxFlips = 64;  // rounds of flips, each of which may call for another

using Corners = std::array<int, 3>;
using ArcBetween = std::map<std::pair<int, int>, int>;  // arcs by their ends

// Flips sides of ears, triangles between two arcs, that are nearly flat in space: all of a facet at
// the tip lies on the border then, which may bend away from the face and into the next one. Of
// other triangles those whose corners are in one line, as between a ruling of a cone and its tip:
// all such facets would fall together.
class FlatEars {
 public:
  /// points     of the vertices in the chart
  /// in_space   the point of a vertex
  FlatEars(std::vector<Corners>& triangles, const std::vector<Vec2>& points,
           std::function<Vec3(int)> in_space, const ArcBetween& arcs)
      : triangles_(triangles), points_(points), in_space_(std::move(in_space)), arcs_(arcs) {
    for (std::size_t i = 0; i < triangles_.size(); ++i) note(i);
  }

  void flip_all() {
    bool flipped = true;
    for (int round = 0; flipped && round < kMaxFlips; ++round) {
      flipped = false;
      for (std::size_t i = 0; i < triangles_.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) flipped = flip(i, k) || flipped;
    }
  }

 private:
  void note(std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k) beside_[{triangles_[i][k], triangles_[i][(k + 1) % 3]}] = i;
  }

  bool turns_left(int a, int b, int c) const {
    return orientation(points_[index(a)], points_[index(b)], points_[index(c)]) > 0;
  }

  static double cosine(const Vec3& a, const Vec3& b) {
    const double size = norm(a) * norm(b);
    return size > 0 ? dot(a, b) / size : 1;
  }

  // Of the widest angle.
  double least_cosine(int a, int b, int c) const {
    const Vec3 p = in_space_(a), q = in_space_(b), r = in_space_(c);
    return std::min({cosine(q - p, r - p), cosine(r - q, p - q), cosine(p - r, q - r)});
  }

  bool is_arc(int from, int to) const { return arcs_.contains({from, to}); }

  // Whether the triangle lies between two arcs that meet at b.
  bool is_ear(int a, int b, int c) const { return is_arc(a, b) && is_arc(b, c); }

  // Whether it lies behind one, so that the ear has no other triangle to be flipped with.
  bool is_behind_ear(int from, int to) const {
    const auto found = beside_.find({to, from});
    if (found == beside_.end()) return false;
    const Corners& ear = triangles_[found->second];
    const int tip = ear[0] + ear[1] + ear[2] - from - to;
    return is_ear(from, tip, to);
  }

  // The side opposite to corner k of triangle i.
  bool flip(std::size_t i, std::size_t k) {
    const int a = triangles_[i][(k + 2) % 3], b = triangles_[i][k], c = triangles_[i][(k + 1) % 3];
    const auto behind = beside_.find({a, c});
    if (behind == beside_.end() || arcs_.contains({a, c}) || arcs_.contains({c, a})) return false;
    const bool at_ear = is_ear(a, b, c) || is_behind_ear(a, b) || is_behind_ear(b, c);
    const std::size_t j = behind->second;
    const Corners& other = triangles_[j];
    const int d = other[0] + other[1] + other[2] - a - c;
    const double now = std::min(least_cosine(a, b, c), least_cosine(a, c, d));
    if (now >= (at_ear ? kFlat : kInLine) || !turns_left(a, b, d) || !turns_left(b, c, d))
      return false;
    const double then = std::min(least_cosine(a, b, d), least_cosine(b, c, d));
    if (then < now + kBetter && 1 + then < kLessFlat * std::max(1 + now, kLine)) return false;
    beside_.erase({a, c});
    beside_.erase({c, a});
    triangles_[i] = {a, b, d};
    triangles_[j] = {b, c, d};
    note(i);
    note(j);
    return true;
  }

  std::vector<Corners>& triangles_;
  const std::vector<Vec2>& points_;
  std::function<Vec3(int)> in_space_;
  const ArcBetween& arcs_;
  std::map<std::pair<int, int>, std::size_t> beside_;  // triangles by their directed sides
};

// The region of one patch while its arcs are being divided.
class Region {
 public:
  Region(BorderArcs& borders, std::vector<int>& arcs, const std::vector<BorderSide>& sides,
         int patch_u, int patch_v, TriangleLowering& lowering)
      : borders_(borders),
        arcs_(arcs),
        sides_(sides),
        lowering_(lowering),
        patch_{patch_u, patch_v},
        corner_{static_cast<double>(patch_u), static_cast<double>(patch_v)},
        scale_(borders.metric(patch_u, patch_v)) {}

  CurvedTriangles triangles() {
    const std::size_t most = arcs_.size() + BorderArcs::kMaxArcs;
    std::string obstacle;
    for (int round = 0; round < kMaxChordRounds && arcs_.size() <= most; ++round) {
      CurvedTriangles made;
      std::set<int> to_halve = attempt(made);
      const bool is_covered = to_halve.empty();
      if (is_covered && !borders_.has_common_borders()) to_halve = lower(made);
      if (to_halve.empty()) return made;
      obstacle = is_covered ? "its triangles leave the surface by more than the tolerance"
                            : "its borders meet or touch where the doubles cannot tell their sides";
      bool halved = false;
      for (const int arc : to_halve)
        if (const int second = borders_.halve(arc); second >= 0) {
          arcs_.push_back(second);
          halved = true;
        }
      if (!halved) break;
    }
    return {{}, obstacle};
  }

 private:
  const RegionArc& arc(int number) const { return borders_.arcs()[index(number)]; }
  bool is_curved(int number) const { return arc(number).curve.degree() > 1; }

  // The triangles, or the arcs to halve first.
  std::set<int> attempt(CurvedTriangles& made) const {
    std::vector<BorderSide> sides;
    ArcBetween arc_between;
    for (const int number : arcs_) {
      sides.push_back({arc(number).from, arc(number).to});
      arc_between[{arc(number).from, arc(number).to}] = number;
    }
    sides.insert(sides.end(), sides_.begin(), sides_.end());
    std::set<int> to_halve = between_two_points(sides);
    if (!to_halve.empty()) return to_halve;
    std::vector<Vec2> points = scaled_points();
    Triangulation flat = triangulate(points, sides);
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
    if (borders_.has_common_borders()) {
      const auto in_space = [this](int vertex) { return borders_.point_in(patch_, vertex); };
      FlatEars(flat.triangles, points, in_space, arc_between).flip_all();
    }
    for (const Corners& corners : flat.triangles) {
      CurvedTriangle triangle = curved(corners, arc_between, points);
      if (!keeps_its_turn(triangle.map))
        for (const int number : triangle.arcs)
          if (number >= 0 && is_curved(number)) to_halve.insert(number);
      made.triangles.push_back(std::move(triangle));
    }
    if (to_halve.empty() && borders_.has_common_borders())
      raise(made, std::move(flat.triangles), std::move(points), arc_between);
    return to_halve;
  }

  // Makes low triangles at borders higher, where these will be moved.
  void raise(CurvedTriangles& made, std::vector<Corners> triangles, std::vector<Vec2> points,
             const ArcBetween& arc_between) const {
    const std::size_t given = points.size();
    TriangleChart chart{std::move(points), {}, {}, {}};
    chart.jet = [this](const Vec2& at) {
      const Vec2 local = unscaled(at) - corner_;
      PatchJet jet = jet_at(borders_.patch(patch_), local[0], local[1], 1);
      jet.u = (1 / scale_[0]) * jet.u;
      jet.v = (1 / scale_[1]) * jet.v;
      return jet;
    };
    chart.least_height = [this, &arc_between](int from, int to) {
      const auto found = arc_between.find({from, to});
      if (found == arc_between.end()) return 0.0;
      const int border = arc(found->second).border;
      return borders_.takes_cells(border) ? 0 : kHigh * borders_.tolerance_of(border);
    };
    chart.is_valid = [&](const Corners& corners) {
      return keeps_its_turn(curved(corners, arc_between, chart.points).map);
    };
    if (!raise_sliver_triangles(triangles, chart)) return;
    std::vector<int> names;
    for (std::size_t k = given; k < chart.points.size(); ++k)
      names.push_back(borders_.vertex_at(unscaled(chart.points[k])));
    made.triangles.clear();
    for (const Corners& corners : triangles) {
      made.triangles.push_back(curved(corners, arc_between, chart.points));
      for (int& vertex : made.triangles.back().vertices)
        if (index(vertex) >= given) vertex = names[index(vertex) - given];
    }
  }

  // What the errors of its arcs leave of the tolerance to a triangle; nothing if all are exact.
  double left_of_tolerance(const CurvedTriangle& triangle) const {
    double error = 0;
    bool exact = true;
    for (const int number : triangle.arcs) {
      if (number < 0) continue;
      // Beyond the tolerance are arcs at gaps of the trims alone, for which only the fit counts.
      const bool at_gap = arc(number).error > borders_.options().tolerance;
      error = std::max(error, at_gap ? arc(number).fit_error : arc(number).error);
      exact = exact && arc(number).exact;
    }
    return exact ? 0 : borders_.options().tolerance - error;
  }

  RationalBezierTriangle over(const CurvedTriangle& triangle) const {
    RationalBezierTriangle whole = composition(borders_.patch(patch_), triangle.map);
    const auto has_weight = [](const Vec3& p) { return p[2] != 1; };
    if (!borders_.is_rational() && std::ranges::none_of(triangle.map.points, has_weight))
      for (Vec4& p : whole.points) p[3] = 1;
    return whole;
  }

  // Lowers what is above the highest degree, and what is fitted as far as the arcs leave tolerance;
  // returns the arcs to halve for that.
  std::set<int> lower(CurvedTriangles& made) const {
    const RegionOptions& options = borders_.options();
    const RationalBezierPatch& patch = borders_.patch(patch_);
    const int straight = patch.degree_u() + patch.degree_v();
    std::set<int> to_halve;
    for (CurvedTriangle& triangle : made.triangles) {
      const bool has_to_be = triangle.map.degree * straight > options.highest_degree;
      double within = kTriangleLoweringPart * options.tolerance;
      if (!has_to_be) within = std::min(within, left_of_tolerance(triangle));
      if (!has_to_be && (within <= 0 || triangle.map.degree == 1)) continue;
      auto lower = lowering_(over(triangle), straight, options.highest_degree, within);
      if (lower.form.degree < triangle.map.degree * straight) triangle.lowered = std::move(lower);
      if (!triangle.lowered || triangle.lowered->error <= options.tolerance) continue;
      for (const int number : triangle.arcs)
        if (number >= 0 && is_curved(number)) to_halve.insert(number);
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

  Vec2 unscaled(const Vec2& p) const { return {p[0] / scale_[0], p[1] / scale_[1]}; }

  CurvedTriangle curved(const Corners& corners, const ArcBetween& arc_between,
                        const std::vector<Vec2>& points) const {
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
    for (std::size_t k = 0; k < 3; ++k) at[k] = unscaled(points[index(corners[k])]) - corner_;
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
  TriangleLowering& lowering_;
  std::array<int, 2> patch_;
  Vec2 corner_;
  Vec2 scale_;
};

}  // namespace

CurvedTriangles curved_triangles(BorderArcs& borders, std::vector<int>& arcs,
                                 const std::vector<BorderSide>& sides, int patch_u, int patch_v,
                                 TriangleLowering& lowering) {
  return Region(borders, arcs, sides, patch_u, patch_v, lowering).triangles();
}

}  // namespace blossom
