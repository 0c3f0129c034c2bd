// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/sliver_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "core/math/index.h"
#include "core/regions/delaunay/plane_predicates.h"

namespace blossom {
namespace {

// Cosine of an angle beyond which a triangle is less than half as high as its shorter side there is
// long: others gain little.
constexpr double kWide = -0.87;
constexpr int kMaxRounds = 8;    // over all triangles, as those that are new may be low, too
constexpr int kMaxHalvings = 4;  // of the way to a new vertex: near ones may be better, or valid
constexpr double kInside = 0.5;  // of the way to what lies across, where that is near
constexpr double kSame = 1e-9;   // of a triangle's sides: nearer corners are one point in space
constexpr std::size_t kNoTriangle = static_cast<std::size_t>(-1);

using Corners = std::array<int, 3>;

// The same triangle from its corner k on.
Corners turned(const Corners& t, std::size_t k) { return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]}; }

// A triangle between three points in space, or its image by derivatives.
struct Spatial {
  Vec3 ab, bc;

  double height() const {
    const double longest = std::max({norm(ab), norm(bc), norm(ab + bc)});
    return longest > 0 ? norm(cross(ab, bc)) / longest : 0;
  }

  // Of the angle at b.
  double cosine() const {
    const double size = norm(ab) * norm(bc);
    return size > 0 ? -dot(ab, bc) / size : 1;
  }
};

class Raiser {
 public:
  Raiser(std::vector<Corners>& triangles, TriangleChart& chart)
      : triangles_(triangles), chart_(chart) {
    for (std::size_t i = 0; i < triangles_.size(); ++i) note(i);
  }

  // Whether any were.
  bool raise_all() {
    bool raised = true, any = false;
    for (int round = 0; raised && round < kMaxRounds; ++round) {
      raised = false;
      for (std::size_t i = 0; i < triangles_.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
          raised = (is_low(i, k) && (flip(i, k) || add_vertex(i, k))) || raised;
      any = any || raised;
    }
    return any;
  }

 private:
  // ---- triangles

  const Vec2& point(int vertex) const { return chart_.points[index(vertex)]; }

  void note(std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k) beside_[{triangles_[i][k], triangles_[i][(k + 1) % 3]}] = i;
  }

  // The triangle on the left of a side, if there is one.
  std::size_t on_left(int a, int b) const {
    const auto found = beside_.find({a, b});
    return found == beside_.end() ? kNoTriangle : found->second;
  }

  int apex(std::size_t i, int a, int b) const {
    const Corners& t = triangles_[i];
    return t[0] == a ? t[2] : t[0] == b ? t[1] : t[0];
  }

  Vec2 middle(const Corners& t) const {
    return (1.0 / 3) * (point(t[0]) + point(t[1]) + point(t[2]));
  }

  static Vec3 in_space(const PatchJet& jet, const Vec2& way) {
    return way[0] * jet.u + way[1] * jet.v;
  }

  // As the derivatives in its middle make it, and straight between its corners: the same where two
  // of these are one point in space.
  std::array<Spatial, 2> spatial(const Corners& t) const {
    const PatchJet jet = chart_.jet(middle(t));
    const Spatial by_jet{in_space(jet, point(t[1]) - point(t[0])),
                         in_space(jet, point(t[2]) - point(t[1]))};
    const Vec3 a = chart_.jet(point(t[0])).point, b = chart_.jet(point(t[1])).point,
               c = chart_.jet(point(t[2])).point;
    const double same = kSame * std::max(norm(by_jet.ab), norm(by_jet.bc));
    const bool has_pole = std::min({distance(a, b), distance(b, c), distance(c, a)}) <= same;
    return {by_jet, has_pole ? by_jet : Spatial{b - a, c - b}};
  }

  double height(const Corners& t) const {
    const auto [by_jet, straight] = spatial(t);
    return std::min(by_jet.height(), straight.height());
  }

  bool is_valid(const Corners& t) const {
    return orientation(point(t[0]), point(t[1]), point(t[2])) > 0 && chart_.is_valid(t);
  }

  // Whether a triangle is lower than a border beside corner k wants, as its angle there is wide.
  bool is_low(std::size_t i, std::size_t k) const {
    const auto [b, c, a] = turned(triangles_[i], k);
    const double least = std::max(chart_.least_height(a, b), chart_.least_height(b, c));
    if (!(least > 0)) return false;
    const auto [by_jet, straight] = spatial({a, b, c});
    return std::min(by_jet.cosine(), straight.cosine()) < kWide &&
           std::min(by_jet.height(), straight.height()) < least;
  }

  // In the place of others, which cover the same part of the region; what there are more come last.
  void replace(const std::vector<std::size_t>& places, const std::vector<Corners>& by) {
    for (const std::size_t i : places)
      for (std::size_t k = 0; k < 3; ++k)
        beside_.erase({triangles_[i][k], triangles_[i][(k + 1) % 3]});
    for (std::size_t n = 0; n < by.size(); ++n) {
      if (n >= places.size()) triangles_.emplace_back();
      const std::size_t i = n < places.size() ? places[n] : triangles_.size() - 1;
      triangles_[i] = by[n];
      note(i);
    }
  }

  // Of the side opposite to corner k of triangle i, if that is worth it.
  bool flip(std::size_t i, std::size_t k) {
    const auto [b, c, a] = turned(triangles_[i], k);
    const std::size_t j = on_left(a, c);
    if (j == kNoTriangle) return false;
    const int d = apex(j, a, c);
    const Corners one{a, b, d}, other{b, c, d};
    const double now = std::min(height(triangles_[i]), height(triangles_[j]));
    if (!is_valid(one) || !is_valid(other) ||
        !(std::min(height(one), height(other)) > kRaised * now))
      return false;
    replace({i, j}, {one, other});
    return true;
  }

  // ---- vertices inside

  // The triangle that a point lies in, seen straight on from corner k of triangle i; none if it
  // lies outside of the region, with the part of the way to it that is inside.
  struct Place {
    std::size_t triangle = kNoTriangle;
    double inside = 1;
  };

  Place place_of(const Vec2& wanted, std::size_t i, std::size_t k) const {
    auto [b, right, left] = turned(triangles_[i], k);
    while (orientation(point(right), point(left), wanted) < 0) {
      const std::size_t next = on_left(left, right);
      if (next == kNoTriangle)
        return {kNoTriangle, part_before(point(b), wanted, point(right), point(left))};
      const int far = apex(next, left, right);
      (orientation(point(b), wanted, point(far)) > 0 ? left : right) = far;
      i = next;
    }
    return {i, 1};
  }

  // The part of a way from the left of a line to its right that lies before the line.
  static double part_before(const Vec2& start, const Vec2& end, const Vec2& a, const Vec2& b) {
    const auto off = [&](const Vec2& p) {
      return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    };
    const double from = off(start), to = off(end);
    return from > to ? std::clamp(from / (from - to), 0.0, 1.0) : 0;
  }

  // The way from corner k of triangle i at a right angle to the side opposite to it, as far as its
  // sides there are long in the geometric mean, or half as far as the border across.
  Vec2 way_inside(std::size_t i, std::size_t k) const {
    const auto [b, c, a] = turned(triangles_[i], k);
    const PatchJet jet = chart_.jet(middle(triangles_[i]));
    const Vec3 across = in_space(jet, point(c) - point(a));
    const Vec2 left{-dot(jet.v, across), dot(jet.u, across)};
    const double far = std::sqrt(norm(in_space(jet, point(a) - point(b))) *
                                 norm(in_space(jet, point(c) - point(b))));
    const double size = norm(in_space(jet, left));
    if (!(size > 0)) return {0, 0};
    const Vec2 way = (far / size) * left;
    const Place place = place_of(point(b) + way, i, k);
    return place.triangle == kNoTriangle ? kInside * place.inside * way : way;
  }

  // The best of some vertices on the way from corner k of triangle i, if it raises that.
  bool add_vertex(std::size_t i, std::size_t k) {
    const auto [b, c, a] = turned(triangles_[i], k);
    if (on_left(a, c) == kNoTriangle) return false;
    Vec2 way = way_inside(i, k), best_way;
    Star best;
    for (int halving = 0; halving <= kMaxHalvings; ++halving, way = 0.5 * way) {
      const Place place = place_of(point(b) + way, i, k);
      if (place.triangle == kNoTriangle) continue;
      chart_.points.push_back(point(b) + way);
      Star star = star_in(place.triangle);
      chart_.points.pop_back();
      if (std::ranges::find(star.places, i) == star.places.end() || star.height <= best.height)
        continue;
      best = std::move(star);
      best_way = way;
    }
    if (best.places.empty() || !(best.height > kRaised * best.before)) return false;
    chart_.points.push_back(point(b) + best_way);
    replace(best.places, best.made);
    return true;
  }

  // What is to be at a new vertex.
  struct Star {
    std::vector<std::size_t> places;  // of triangles that it takes the place of
    std::vector<Corners> made;
    double before = 0;  // height of the lowest one
    double height = 0;  // likewise of those made; 0 if one of them is not valid
  };

  // Of the last point: in the place of the triangle that it lies in, and of those behind as long as
  // those at the vertex get higher by that.
  Star star_in(std::size_t inside) const {
    const int vertex = static_cast<int>(chart_.points.size()) - 1;
    Star star{{inside}, {}, height(triangles_[inside]), 0};
    std::vector<Corners> open;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b, c] = turned(triangles_[inside], k);
      open.push_back({a, b, vertex});
    }
    while (!open.empty()) {
      const Corners at = open.back();
      open.pop_back();
      const std::size_t behind = on_left(at[1], at[0]);
      if (behind != kNoTriangle) {
        const int far = apex(behind, at[1], at[0]);
        const Corners one{at[0], far, vertex}, other{far, at[1], vertex};
        const double was = height(triangles_[behind]);
        if (is_valid(one) && is_valid(other) &&
            std::min(height(one), height(other)) > std::min(was, height(at))) {
          star.places.push_back(behind);
          star.before = std::min(star.before, was);
          open.insert(open.end(), {one, other});
          continue;
        }
      }
      star.made.push_back(at);
    }
    const bool all_valid =
        std::ranges::all_of(star.made, [this](const Corners& t) { return is_valid(t); });
    if (!all_valid) return star;
    star.height = height(star.made.front());
    for (const Corners& t : star.made) star.height = std::min(star.height, height(t));
    return star;
  }

  std::vector<Corners>& triangles_;
  TriangleChart& chart_;
  std::map<std::pair<int, int>, std::size_t> beside_;  // triangles by their directed sides
};

}  // namespace

bool raise_sliver_triangles(std::vector<std::array<int, 3>>& triangles, TriangleChart& chart) {
  return Raiser(triangles, chart).raise_all();
}

}  // namespace blossom
