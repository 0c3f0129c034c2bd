// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/base/errors.h"
#include "core/bounds/box_tree.h"
#include "core/math/index.h"

namespace blossom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kAskEvery = 1024;  // facets

using Corners = std::array<Vec3, 3>;

double squared_gap(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  const Vec3 off = p - (a + t * d);
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

struct Facet {
  Corners corner;
  std::array<OtherMesh::Nearest, 3> near;
  int triangle = 0;
  double upper = 0;  // squared

  bool operator<(const Facet& other) const { return upper < other.upper; }
};

class Search {
 public:
  Search(const OtherMesh& other, double accuracy) : other_(other), accuracy_(accuracy) {}

  void add(const Corners& corner, const std::array<OtherMesh::Nearest, 3>& near, int triangle) {
    Facet facet{corner, near, triangle, kInfinity};
    for (std::size_t k = 0; k < 3; ++k) take(facet, corner[k], near[k]);
    if (is_open(facet)) {
      // Where meshes coincide a corner is as near to each facet round it, the middle to one alone.
      const Vec3 middle = (1.0 / 3) * (corner[0] + corner[1] + corner[2]);
      take(facet, middle, other_.nearest(middle, near[0].triangle));
    }
    if (is_open(facet))
      open_.push(facet);
    else
      settled_ = std::max(settled_, facet.upper);
  }

  FarthestPoint found(const std::function<bool()>& ask) {
    for (int count = 1; !open_.empty() && is_open(open_.top()); ++count) {
      if (ask && count % kAskEvery == 0 && !ask()) break;
      const Facet facet = open_.top();
      open_.pop();
      divide(facet);
    }
    const double left = open_.empty() ? 0 : open_.top().upper;
    found_.lower = std::sqrt(lower_);
    found_.upper = std::sqrt(std::max({settled_, left, lower_}));
    return found_;
  }

 private:
  // A place of the facet with what is nearest to it.
  void take(Facet& facet, const Vec3& place, const OtherMesh::Nearest& near) {
    const Corners there = other_.corners(near.triangle);
    double most = 0;
    for (const Vec3& p : facet.corner) most = std::max(most, squared_gap(p, there));
    facet.upper = std::min(facet.upper, most);
    if (near.square <= lower_ && found_.triangle >= 0) return;
    lower_ = near.square;
    found_.point = place;
    found_.triangle = facet.triangle;
  }

  bool is_open(const Facet& facet) const {
    const double upper = std::sqrt(facet.upper);
    return upper > accuracy_ && upper > std::sqrt(lower_) + accuracy_;
  }

  void divide(const Facet& facet) {
    Corners middle;
    std::array<OtherMesh::Nearest, 3> near;
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] = 0.5 * (facet.corner[(k + 1) % 3] + facet.corner[(k + 2) % 3]);
      near[k] = other_.nearest(middle[k], facet.near[(k + 1) % 3].triangle);
    }
    add(middle, near, facet.triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      add({facet.corner[k], middle[b], middle[a]}, {facet.near[k], near[b], near[a]},
          facet.triangle);
    }
  }

  const OtherMesh& other_;
  double accuracy_;
  double lower_ = 0, settled_ = 0;  // squared
  std::priority_queue<Facet> open_;
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
                             double accuracy, const std::function<bool()>& ask) {
  check(points, triangles);
  check(other_points, others);
  if (others.empty()) throw InvalidInput("farthest_point: the other mesh has no triangle");
  if (!(accuracy > 0)) throw InvalidInput("farthest_point: the accuracy must be positive");
  const OtherMesh other(other_points, others);
  std::vector<OtherMesh::Nearest> near(points.size());
  std::vector<char> known(points.size(), 0);
  Search search(other, accuracy);
  int guess = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Corners corner;
    std::array<OtherMesh::Nearest, 3> of_corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t point = index(triangles[t][k]);
      if (!known[point]) near[point] = other.nearest(points[point], guess);
      known[point] = 1;
      guess = near[point].triangle;
      corner[k] = points[point];
      of_corner[k] = near[point];
    }
    search.add(corner, of_corner, static_cast<int>(t));
  }
  return search.found(ask);
}

}  // namespace blossom
