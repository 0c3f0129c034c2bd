// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/mesh_holes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/math/index.h"
#include "core/meshes/open_rings.h"
#include "core/regions/delaunay/constrained_delaunay.h"

namespace blossom {
namespace {

using Triangle = std::array<int, 3>;

// A ring is flat if it is no farther from a plane than this part of its size: what single
// precision and some digits of text leave of a plane.
constexpr double kFlatPart = 1e-5;
constexpr double kSamePlane = 1e-4;  // of the normals of two rings, whose planes count as one
// Points of a ring up to which all triangulations are compared: a second of work.
constexpr std::size_t kMaxCompared = 300;

Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); }

// Half of it is the area that a ring goes round.
Vec3 area_vector(std::span<const Vec3> points, const std::vector<int>& ring) {
  Vec3 sum;
  const Vec3& origin = points[index(ring[0])];
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
    sum += cross(points[index(ring[k])] - origin, points[index(ring[k + 1])] - origin);
  return sum;
}

// ---- flat rings

struct RingPlane {
  Vec3 point, normal;
  double size = 0;
};

std::optional<RingPlane> plane_of(std::span<const Vec3> points, const std::vector<int>& ring) {
  const Vec3 across = area_vector(points, ring);
  if (!(norm(across) > 0)) return {};
  RingPlane plane{points[index(ring[0])], unit(across)};
  for (const int k : ring)
    plane.size = std::max(plane.size, distance(points[index(k)], plane.point));
  for (const int k : ring)
    if (std::abs(dot(points[index(k)] - plane.point, plane.normal)) > kFlatPart * plane.size)
      return {};
  return plane;
}

bool is_one_plane(const RingPlane& a, const RingPlane& b) {
  const double size = std::max(a.size, b.size);
  return norm(cross(a.normal, b.normal)) < kSamePlane &&
         std::abs(dot(b.point - a.point, a.normal)) <= kFlatPart * size;
}

// What rings in one plane go round, each on its left; nothing if that is no region.
std::optional<std::vector<Triangle>> flat_triangles(std::span<const Vec3> points,
                                                    const std::vector<std::vector<int>>& rings,
                                                    const RingPlane& plane) {
  const Vec3 away = std::abs(plane.normal[0]) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 x = unit(cross(away, plane.normal)), y = cross(plane.normal, x);
  std::vector<int> numbers;
  std::vector<Vec2> places;
  for (const std::vector<int>& ring : rings)
    for (const int k : ring) {
      const Vec3 d = points[index(k)] - plane.point;
      numbers.push_back(k);
      places.push_back({dot(d, x), dot(d, y)});
    }
  try {
    ConstrainedDelaunay mesh(places);
    SideWindings windings;
    int first = 0;
    for (const std::vector<int>& ring : rings) {
      const int count = static_cast<int>(ring.size());
      for (int k = 0; k < count; ++k) {
        const int from = first + k, to = first + (k + 1) % count;
        std::pair<int, int> obstacle;
        if (!mesh.fix(from, to, obstacle)) return {};
        ++windings[{from, to}];
        --windings[{to, from}];
      }
      first += count;
    }
    if (!mesh.mark_region(windings)) return {};
    std::vector<Triangle> made;
    for (const ConstrainedDelaunay::Face& face : mesh.faces())
      if (face.inside)
        made.push_back({numbers[index(face.corner[0])], numbers[index(face.corner[1])],
                        numbers[index(face.corner[2])]});
    return made;
  } catch (const InvalidInput&) {
    return {};  // two points are equal
  }
}

// ---- other rings

struct Weight {
  double angle = 0, area = 0;

  friend bool operator<(const Weight& a, const Weight& b) {
    return a.angle != b.angle ? a.angle < b.angle : a.area < b.area;
  }
};

constexpr double kForbidden = 4;  // radians: more than any angle

class LeastAngles {
 public:
  // normals   of what is beyond each side, from a point to the next; 0 where nothing is known
  LeastAngles(std::span<const Vec3> points, const std::vector<int>& ring,
              const std::vector<Vec3>& normals, const std::set<std::pair<int, int>>& taken,
              const std::function<void()>& ask)
      : points_(points),
        ring_(ring),
        normals_(normals),
        taken_(taken),
        count_(ring.size()),
        weights_(count_ * count_),
        middles_(count_ * count_, 0) {
    for (std::size_t length = 2; length < count_; ++length) {
      if (ask) ask();
      for (std::size_t i = 0; i + length < count_; ++i) choose(i, i + length);
    }
  }

  std::vector<Triangle> triangles() const {
    std::vector<Triangle> made;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, count_ - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j < i + 2) continue;
      const std::size_t m = middles_[at(i, j)];
      made.push_back({ring_[i], ring_[m], ring_[j]});
      open.push_back({i, m});
      open.push_back({m, j});
    }
    return made;
  }

 private:
  std::size_t at(std::size_t i, std::size_t j) const { return i * count_ + j; }
  const Vec3& point(std::size_t i) const { return points_[index(ring_[i])]; }

  // Of what is beyond a side, as far as that is chosen.
  Vec3 beyond(std::size_t i, std::size_t j) const {
    if (j == i + 1) return normals_[i];
    return normal_of(point(i), point(middles_[at(i, j)]), point(j));
  }

  static double angle(const Vec3& a, const Vec3& b) {
    if (!(norm(a) > 0) || !(norm(b) > 0)) return 0;
    return std::atan2(norm(cross(a, b)), dot(a, b));
  }

  bool is_taken(std::size_t i, std::size_t j) const {
    if (j == i + 1 || (i == 0 && j == count_ - 1)) return false;
    return taken_.contains(std::minmax(ring_[i], ring_[j]));
  }

  void choose(std::size_t i, std::size_t j) {
    Weight least{kInfinity, 0};
    for (std::size_t m = i + 1; m < j; ++m) {
      const Weight &a = weights_[at(i, m)], &b = weights_[at(m, j)];
      const Vec3 normal = normal_of(point(i), point(m), point(j));
      const double area = norm(normal);
      Weight here{std::max(a.angle, b.angle), a.area + b.area + area};
      if (least < Weight{here.angle, 0}) continue;
      here.angle = std::max({here.angle, angle(normal, beyond(i, m)), angle(normal, beyond(m, j))});
      if (i == 0 && j == count_ - 1) here.angle = std::max(here.angle, angle(normal, normals_[j]));
      if (!(area > 0) || is_taken(i, j)) here.angle = std::max(here.angle, kForbidden);
      if (!(here < least)) continue;
      least = here;
      middles_[at(i, j)] = m;
    }
    weights_[at(i, j)] = least;
  }

  std::span<const Vec3> points_;
  const std::vector<int>& ring_;
  const std::vector<Vec3>& normals_;
  const std::set<std::pair<int, int>>& taken_;
  std::size_t count_;
  std::vector<Weight> weights_;
  std::vector<std::size_t> middles_;
};

// Cuts the sharpest corners off until few enough are left; the triangles that are cut.
std::vector<Triangle> cut_ears(std::span<const Vec3> points, std::vector<int>& ring,
                               std::vector<Vec3>& normals) {
  std::vector<Triangle> cut;
  const auto sharpness = [&](std::size_t k) {
    const std::size_t n = ring.size();
    const Vec3& at = points[index(ring[k])];
    const Vec3 a = points[index(ring[(k + n - 1) % n])] - at;
    const Vec3 b = points[index(ring[(k + 1) % n])] - at;
    const double turn = std::atan2(norm(cross(a, b)), dot(a, b));
    // A corner that the hole goes round from outside is no ear.
    return dot(cross(b, a), normals[k] + normals[(k + n - 1) % n]) < 0 ? turn + 4 : turn;
  };
  while (ring.size() > kMaxCompared) {
    std::size_t best = 0;
    double least = kInfinity;
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (const double turn = sharpness(k); turn < least) {
        least = turn;
        best = k;
      }
    const std::size_t n = ring.size(), before = (best + n - 1) % n, after = (best + 1) % n;
    const Triangle ear{ring[before], ring[best], ring[after]};
    cut.push_back(ear);
    normals[before] =
        unit(normal_of(points[index(ear[0])], points[index(ear[1])], points[index(ear[2])]));
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
    normals.erase(normals.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return cut;
}

class HoleFiller {
 public:
  HoleFiller(std::span<const Vec3> points, std::span<const Triangle> triangles,
             const std::function<void()>& ask)
      : points_(points), triangles_(triangles), ask_(ask) {}

  MeshHoles filled() {
    const MeshSides sides(points_.size(), triangles_);
    OpenRings open = open_rings(triangles_, sides);
    MeshHoles made;
    made.left_sides = open.left_sides;
    if (open.rings.empty()) return made;
    note_sides(open);
    for (std::size_t r = 0; r < open.rings.size(); ++r)
      planes_.push_back(plane_of(points_, open.rings[r].points));
    std::vector<bool> done(open.rings.size(), false);
    for (std::size_t r = 0; r < open.rings.size(); ++r) {
      if (ask_) ask_();
      if (!done[r] && planes_[r]) fill_plane(r, open, done, made);
      if (done[r]) continue;
      done[r] = true;
      made.holes.push_back({{open.rings[r].points}, bent_triangles(open.rings[r]), false});
    }
    return made;
  }

 private:
  // Sides between two points of rings: a new side there would be one too many.
  void note_sides(const OpenRings& open) {
    std::vector<bool> on_ring(points_.size(), false);
    for (const OpenRing& ring : open.rings)
      for (const int k : ring.points) on_ring[index(k)] = true;
    for (const Triangle& triangle : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = triangle[k], b = triangle[(k + 1) % 3];
        if (on_ring[index(a)] && on_ring[index(b)]) taken_.insert(std::minmax(a, b));
      }
  }

  // All rings in the plane of one together, else that one alone.
  void fill_plane(std::size_t first, const OpenRings& open, std::vector<bool>& done,
                  MeshHoles& made) {
    std::vector<std::size_t> places;
    std::size_t largest = first;
    for (std::size_t r = first; r < open.rings.size(); ++r)
      if (!done[r] && planes_[r] && is_one_plane(*planes_[first], *planes_[r])) {
        places.push_back(r);
        if (planes_[r]->size > planes_[largest]->size) largest = r;
      }
    for (const bool together : {true, false}) {
      if (!together) places = {first};
      MeshHole hole;
      hole.flat = true;
      for (const std::size_t r : places) hole.rings.push_back(open.rings[r].points);
      auto triangles = flat_triangles(points_, hole.rings, *planes_[together ? largest : first]);
      if (!triangles || adds_taken_side(*triangles, hole.rings)) continue;
      hole.triangles = std::move(*triangles);
      made.holes.push_back(std::move(hole));
      for (const std::size_t r : places) done[r] = true;
      return;
    }
  }

  bool adds_taken_side(const std::vector<Triangle>& triangles,
                       const std::vector<std::vector<int>>& rings) const {
    std::set<std::pair<int, int>> borders;
    for (const std::vector<int>& ring : rings)
      for (std::size_t k = 0; k < ring.size(); ++k)
        borders.insert(std::minmax(ring[k], ring[(k + 1) % ring.size()]));
    for (const Triangle& triangle : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::pair<int, int> side = std::minmax(triangle[k], triangle[(k + 1) % 3]);
        if (!borders.contains(side) && taken_.contains(side)) return true;
      }
    return false;
  }

  std::vector<Triangle> bent_triangles(const OpenRing& ring) const {
    std::vector<int> points = ring.points;
    std::vector<Vec3> normals;
    // A side of the ring from one point to the next is the one that the next one's triangle begins
    // there, backwards.
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Triangle& t = triangles_[index(ring.sides[(k + 1) % points.size()] / 3)];
      const Vec3 across =
          normal_of(points_[index(t[0])], points_[index(t[1])], points_[index(t[2])]);
      normals.push_back(norm(across) > 0 ? unit(across) : Vec3{});
    }
    std::vector<Triangle> made = cut_ears(points_, points, normals);
    const std::vector<Triangle> rest =
        LeastAngles(points_, points, normals, taken_, ask_).triangles();
    made.insert(made.end(), rest.begin(), rest.end());
    return made;
  }

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  const std::function<void()>& ask_;
  std::set<std::pair<int, int>> taken_;
  std::vector<std::optional<RingPlane>> planes_;
};

}  // namespace

MeshHoles fill_mesh_holes(std::span<const Vec3> points, std::span<const Triangle> triangles,
                          const std::function<void()>& ask) {
  return HoleFiller(points, triangles, ask).filled();
}

}  // namespace blossom
