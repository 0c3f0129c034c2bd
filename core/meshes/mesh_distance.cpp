// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"
#include "core/math/index.h"
#include "core/math/segment.h"

namespace blossom {
namespace {

constexpr int kAskEvery = 1024;  // pieces
// Of the accuracy: what is beyond a triangle by no more needs no other triangle for its bound.
constexpr double kNarrow = 0.1;

using Corners = std::array<Vec3, 3>;

double squared_gap(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 off = way_from_segment(p, a, b);
  return dot(off, off);
}

double squared_gap(const Vec3& p, const Corners& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double square = dot(n, n);
  bool over = square > 0;
  for (std::size_t k = 0; k < 3 && over; ++k)
    over = dot(n, cross(t[(k + 1) % 3] - t[k], p - t[k])) >= 0;
  const double height = dot(n, p - t[0]);
  if (over) return height * height / square;
  return std::min(
      {squared_gap(p, t[0], t[1]), squared_gap(p, t[1], t[2]), squared_gap(p, t[2], t[0])});
}

// Convex but for rounding, so a plane may cross more than two sides of a narrow one: n corners
// become 3 n / 2 at most, a triangle's 4, 6 and 9 by three planes.
constexpr std::size_t kMaxCorners = 9;

struct Polygon {
  std::array<Vec3, kMaxCorners> corner;
  std::size_t count = 0;

  void push(const Vec3& p) { corner[count++] = p; }
};

// Takes away what is behind a plane, and returns it. Nothing is gone if no corner is farther behind
// than `least`; all of it if none is farther before.
Polygon divided(Polygon& of, const Vec3& origin, const Vec3& inwards, double least) {
  std::array<double, kMaxCorners> at{};
  double most_before = 0, most_behind = 0;
  for (std::size_t k = 0; k < of.count; ++k) {
    at[k] = dot(inwards, of.corner[k] - origin);
    most_before = std::max(most_before, at[k]);
    most_behind = std::max(most_behind, -at[k]);
  }
  const double narrow = least * norm(inwards);
  if (most_behind <= narrow) return {};
  if (most_before <= narrow) return std::exchange(of, {});
  Polygon before, behind;
  for (std::size_t k = 0; k < of.count; ++k) {
    const std::size_t next = k + 1 == of.count ? 0 : k + 1;
    const Vec3 &p = of.corner[k], &q = of.corner[next];
    (at[k] >= 0 ? before : behind).push(p);
    if ((at[k] >= 0) == (at[next] >= 0)) continue;
    const Vec3 between = p + (at[k] / (at[k] - at[next])) * (q - p);
    before.push(between);
    behind.push(between);
  }
  of = before;
  return behind;
}

class OtherMesh {
 public:
  OtherMesh(std::span<const Vec3> points, IndexTriangles triangles)
      : points_(points), triangles_(triangles), tree_(boxes()) {}

  struct Nearest {
    double square = kInfinity;
    int triangle = 0;
  };

  // guess   a triangle that may be near
  Nearest nearest(const Vec3& p, int guess) const {
    Nearest best{squared_gap(p, corners(guess)), guess};
    tree_.for_each_near(p, best.square, [&](int t) {
      const double square = squared_gap(p, corners(t));
      if (square < best.square) best = {square, t};
      return best.square;
    });
    return best;
  }

  Corners corners(int t) const {
    const auto& [a, b, c] = triangles_[index(t)];
    return {points_[index(a)], points_[index(b)], points_[index(c)]};
  }

 private:
  std::vector<Box> boxes() const {
    std::vector<Box> result;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
      Box box;
      for (const Vec3& p : corners(t)) box = joined(box, {p, p});
      result.push_back(box);
    }
    return result;
  }

  std::span<const Vec3> points_;
  IndexTriangles triangles_;
  BoxTree tree_;
};

// A part of a facet, and a triangle of the other mesh that bounds it.
struct Piece {
  Corners corner;
  double upper = kInfinity;  // squared: the farthest corner's distance from `near`
  int farthest = 0;          // corner
  int near = -1;             // triangle of the other mesh
  int triangle = 0;          // that it is a part of

  bool operator<(const Piece& other) const { return upper < other.upper; }
};

// The triangles of a convex polygon.
template <class Visit>
void for_each_triangle(const Polygon& polygon, Visit visit) {
  for (std::size_t k = 2; k < polygon.count; ++k)
    visit(Corners{polygon.corner[0], polygon.corner[k - 1], polygon.corner[k]});
}

class Search {
 public:
  Search(const OtherMesh& other, const WantedBounds& wanted)
      : other_(other), wanted_(wanted), settled_below_(std::max(wanted.accuracy, wanted.enough)) {}

  // near   triangles of the other mesh that may bound it
  template <std::size_t Count>
  void add(const Corners& corner, const std::array<int, Count>& near, int triangle) {
    Piece piece{corner};
    piece.triangle = triangle;
    for (const int other : near) bound(piece, other);
    if (is_open(piece))
      open_.push(piece);
    else
      settled_ = std::max(settled_, piece.upper);
  }

  // A place of a facet with what is nearest to it.
  void take(const Vec3& place, const OtherMesh::Nearest& near, int triangle) {
    if (near.square <= lower_ && found_.triangle >= 0) return;
    lower_ = near.square;
    found_.point = place;
    found_.triangle = triangle;
  }

  FarthestPoint found(const std::function<bool()>& ask) {
    for (int count = 1;
         !open_.empty() && is_open(open_.top()) && std::sqrt(lower_) <= wanted_.too_far; ++count) {
      if (ask && count % kAskEvery == 0 && !ask()) break;
      const Piece piece = open_.top();
      open_.pop();
      divide(piece);
    }
    const double left = open_.empty() ? 0 : open_.top().upper;
    found_.lower = std::sqrt(lower_);
    found_.upper = std::sqrt(std::max({settled_, left, lower_}));
    return found_;
  }

 private:
  void bound(Piece& piece, int other) {
    const Corners there = other_.corners(other);
    double most = 0;
    int farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double square = squared_gap(piece.corner[k], there);
      if (square <= most) continue;
      most = square;
      farthest = static_cast<int>(k);
    }
    if (most >= piece.upper) return;
    piece.upper = most;
    piece.farthest = farthest;
    piece.near = other;
  }

  bool is_open(const Piece& piece) const {
    const double upper = std::sqrt(piece.upper);
    return upper > settled_below_ && upper > std::sqrt(lower_) + wanted_.accuracy;
  }

  int asked(const Vec3& place, int guess, int triangle) {
    const OtherMesh::Nearest near = other_.nearest(place, guess);
    take(place, near, triangle);
    return near.triangle;
  }

  // What is over the triangle nearest to its middle is bounded by that one's plane; if all is, or
  // nothing, by the one nearest to the corner whose distance is the bound.
  void divide(const Piece& piece) {
    const auto& [a, b, c] = piece.corner;
    const int of_middle = asked((1.0 / 3) * (a + b + c), piece.near, piece.triangle);
    if (cut(piece, of_middle, {of_middle, piece.near})) return;
    const int of_corner = asked(piece.corner[index(piece.farthest)], piece.near, piece.triangle);
    if (cut(piece, of_corner, {of_middle, of_corner})) return;
    halve(piece, of_middle, of_corner);
  }

  // By the planes through the sides of a triangle, across it. False if it is all on one side.
  bool cut(const Piece& piece, int over, const std::array<int, 2>& near) {
    const Corners there = other_.corners(over);
    const Vec3 n = cross(there[1] - there[0], there[2] - there[0]);
    if (!(dot(n, n) > 0)) return false;
    Polygon left{{piece.corner[0], piece.corner[1], piece.corner[2]}, 3};
    std::array<Polygon, 3> beside;
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& from = there[k];
      const Vec3 inwards = cross(n, there[(k + 1) % 3] - from);
      beside[k] = divided(left, from, inwards, kNarrow * wanted_.accuracy);
      any = any || beside[k].count > 0;
    }
    if (!any || left.count == 0) return false;
    const auto add_part = [&](const Corners& part) { add(part, near, piece.triangle); };
    for_each_triangle(left, add_part);
    for (const Polygon& part : beside) for_each_triangle(part, add_part);
    return true;
  }

  void halve(const Piece& piece, int of_middle, int of_corner) {
    const std::array<int, 3> near{of_middle, of_corner, piece.near};
    std::size_t k = 0;
    for (const std::size_t other : {1u, 2u})
      if (side_of(piece, other) > side_of(piece, k)) k = other;
    const Vec3 &a = piece.corner[k], &b = piece.corner[(k + 1) % 3], &c = piece.corner[(k + 2) % 3];
    const Vec3 middle = 0.5 * (a + b);
    add({a, middle, c}, near, piece.triangle);
    add({middle, b, c}, near, piece.triangle);
  }

  static double side_of(const Piece& piece, std::size_t k) {
    const Vec3 d = piece.corner[(k + 1) % 3] - piece.corner[k];
    return dot(d, d);
  }

  const OtherMesh& other_;
  WantedBounds wanted_;
  double settled_below_;
  double lower_ = 0, settled_ = 0;  // squared
  std::priority_queue<Piece> open_;
  FarthestPoint found_;
};

void check(std::span<const Vec3> points, IndexTriangles triangles) {
  for (const auto& triangle : triangles)
    for (const int corner : triangle)
      if (corner < 0 || index(corner) >= points.size())
        throw InvalidInput("farthest_point: there is no point " + std::to_string(corner));
}

}  // namespace

FarthestPoint farthest_point(std::span<const Vec3> points, IndexTriangles triangles,
                             std::span<const Vec3> other_points, IndexTriangles others,
                             const WantedBounds& wanted, const std::function<bool()>& ask) {
  check(points, triangles);
  check(other_points, others);
  if (others.empty()) throw InvalidInput("farthest_point: the other mesh has no triangle");
  if (!(wanted.accuracy > 0)) throw InvalidInput("farthest_point: the accuracy must be positive");
  const OtherMesh other(other_points, others);
  std::vector<OtherMesh::Nearest> near(points.size());
  std::vector<char> known(points.size(), 0);
  Search search(other, wanted);
  int guess = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Corners corner;
    std::array<int, 3> of_corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t point = index(triangles[t][k]);
      corner[k] = points[point];
      if (!known[point]) {
        near[point] = other.nearest(corner[k], guess);
        search.take(corner[k], near[point], static_cast<int>(t));
      }
      known[point] = 1;
      of_corner[k] = guess = near[point].triangle;
    }
    search.add(corner, of_corner, static_cast<int>(t));
  }
  return search.found(ask);
}

}  // namespace blossom
