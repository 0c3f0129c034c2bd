// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/cgal/mesh_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "adapters/cgal/mesh_chains.h"
#include "core/base/errors.h"
#include "core/bounds/box_tree.h"
#include "core/math/index.h"

namespace blossom::cgal {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_rational;
using ExactVec = std::array<Exact, 3>;
using Triangle = std::array<int, 3>;

constexpr std::size_t kAskEvery = 1 << 12;  // pairs, or triangles

Kernel::Point_3 kernel_point(const Vec3& p) { return {p[0], p[1], p[2]}; }
ExactVec exact(const Vec3& p) { return {Exact(p[0]), Exact(p[1]), Exact(p[2])}; }
ExactVec operator-(const ExactVec& a, const ExactVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Exact dot_of(const ExactVec& a, const ExactVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
ExactVec cross_of(const ExactVec& a, const ExactVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Of a vector's product with the motion (e, e^2, e^3).
int sign_along_motion(const ExactVec& v) {
  for (const Exact& x : v)
    if (const int sign = CGAL::sign(x); sign != 0) return sign;
  return 0;
}

// p + t (q - p) where the distances of p and q from a plane, of different signs, say t.
Vec3 point_between(const ExactVec& p, const ExactVec& q, const Exact& of_p, const Exact& of_q) {
  const Exact t = of_p / (of_p - of_q);
  Vec3 made;
  for (std::size_t k = 0; k < 3; ++k)
    made.coordinates[k] = CGAL::to_double(Exact(p[k] + t * (q[k] - p[k])));
  return made;
}

void check(const MeshView& mesh) {
  for (const Vec3& p : mesh.points)
    for (const double x : p.coordinates)
      if (!std::isfinite(x)) throw InvalidInput("a mesh has a point that is not finite");
  for (const Triangle& t : mesh.triangles)
    for (const int corner : t)
      if (corner < 0 || index(corner) >= mesh.points.size())
        throw InvalidInput("a mesh has a triangle with corner " + std::to_string(corner) +
                           ", but there are " + std::to_string(mesh.points.size()) + " points");
}

// A mesh whose equal points are one, with numbered sides and without flat triangles.
struct JoinedMesh {
  explicit JoinedMesh(const MeshView& mesh) : points(mesh.points) {
    check(mesh);
    std::vector<int> order(points.size()), same(points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto coordinates = [&](int i) { return points[index(i)].coordinates; };
    std::ranges::sort(order, {}, coordinates);
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool repeats = k > 0 && coordinates(order[k]) == coordinates(order[k - 1]);
      same[index(order[k])] = repeats ? same[index(order[k - 1])] : order[k];
    }
    for (const Triangle& t : mesh.triangles) {
      const Triangle joined{same[index(t[0])], same[index(t[1])], same[index(t[2])]};
      const auto corner = [&](std::size_t k) { return kernel_point(points[index(joined[k])]); };
      if (!CGAL::collinear(corner(0), corner(1), corner(2))) triangles.push_back(joined);
    }
    flat = mesh.triangles.size() - triangles.size();
    number_sides();
  }

  const Vec3& corner(int triangle, std::size_t k) const {
    return points[index(triangles[index(triangle)][k])];
  }
  double largest_coordinate() const {
    double largest = 0;
    for (const Vec3& p : points) largest = std::max(largest, max_norm(p));
    return largest;
  }
  std::vector<Box> boxes() const {
    std::vector<Box> made;
    for (const Triangle& t : triangles) {
      Box box;
      for (const int k : t) box = joined(box, {points[index(k)], points[index(k)]});
      made.push_back(box);
    }
    return made;
  }

  std::span<const Vec3> points;
  std::vector<Triangle> triangles{};
  std::vector<std::array<int, 2>> sides{};     // of points, the lower first
  std::vector<std::array<int, 3>> sides_of{};  // of triangles: from each corner to the next
  std::size_t flat = 0;

 private:
  void number_sides() {
    const auto side_of = [&](const Triangle& t, std::size_t k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      return std::array{low, high};
    };
    for (const Triangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) sides.push_back(side_of(t, k));
    std::ranges::sort(sides);
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    for (const Triangle& t : triangles) {
      std::array<int, 3>& own = sides_of.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        own[k] = static_cast<int>(std::ranges::lower_bound(sides, side_of(t, k)) - sides.begin());
    }
  }
};

// Two meshes, the second moved by `way` times the motion.
class Meeting {
 public:
  Meeting(const JoinedMesh& a, const JoinedMesh& b, int way, const std::function<void()>& ask)
      : a_(a), b_(b), way_(way), ask_(ask) {}

  /// Whether a decision was taken by the motion.
  bool was_moved() const { return moved_; }

  MeshMeeting found(const BoxTree& tree_a, const BoxTree& tree_b) {
    MeshMeeting made;
    std::size_t asked = 0;
    tree_a.for_each_meeting(tree_b, [&](int i, int j) {
      if (ask_ && ++asked % kAskEvery == 0) ask_();
      add_pair(i, j, made);
    });
    const MeshNodes nodes = numbered(pieces_);
    std::vector<Vec3> places;
    for (const NodeKey& key : nodes.keys) {
      if (ask_ && ++asked % kAskEvery == 0) ask_();
      places.push_back(key[0] == 0 ? place(a_, b_, key) : place(b_, a_, key));
    }
    chain(nodes, places, made);
    return made;
  }

 private:
  // On which side of a triangle's plane a corner of the other mesh is.
  int side(const JoinedMesh& of, int triangle, const Vec3& p, int way) {
    const Vec3 &a = of.corner(triangle, 0), &b = of.corner(triangle, 1),
               &c = of.corner(triangle, 2);
    const int sign =
        CGAL::orientation(kernel_point(a), kernel_point(b), kernel_point(c), kernel_point(p));
    if (sign != 0) return sign;
    moved_ = true;
    ++zeros_;
    return way * sign_along_motion(cross_of(exact(b) - exact(a), exact(c) - exact(a)));
  }

  // Which way the line from p to q goes round the one from a to b, which is moved.
  int turn(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, int way) {
    const int sign =
        CGAL::orientation(kernel_point(p), kernel_point(q), kernel_point(a), kernel_point(b));
    if (sign != 0) return sign;
    moved_ = true;
    return way * sign_along_motion(cross_of(exact(q) - exact(p), exact(a) - exact(b)));
  }

  // The sides of a triangle that go through one of the other mesh.
  void add_crossings(const JoinedMesh& of, int i, const std::array<int, 3>& ends,
                     const JoinedMesh& through, int j, int kind, std::vector<NodeKey>& crossings) {
    const int way = kind == 0 ? way_ : -way_;
    for (std::size_t k = 0; k < 3; ++k) {
      if (ends[k] == ends[(k + 1) % 3]) continue;
      const Vec3 &p = of.corner(i, k), &q = of.corner(i, (k + 1) % 3);
      std::array<int, 3> turns{};
      for (std::size_t m = 0; m < 3; ++m)
        turns[m] = turn(p, q, through.corner(j, m), through.corner(j, (m + 1) % 3), way);
      if (turns[0] == turns[1] && turns[1] == turns[2])
        crossings.push_back({kind, of.sides_of[index(i)][k], j});
    }
  }

  void add_pair(int i, int j, MeshMeeting& made) {
    std::array<int, 3> of_a{}, of_b{};
    zeros_ = 0;
    for (std::size_t k = 0; k < 3; ++k) of_a[k] = side(b_, j, a_.corner(i, k), -way_);
    if (zeros_ == 3 && overlap(i, j)) ++made.in_plane;
    if (of_a[0] == of_a[1] && of_a[1] == of_a[2]) return;
    for (std::size_t k = 0; k < 3; ++k) of_b[k] = side(a_, i, b_.corner(j, k), way_);
    if (of_b[0] == of_b[1] && of_b[1] == of_b[2]) return;
    std::vector<NodeKey>& crossings = crossings_;
    crossings.clear();
    add_crossings(a_, i, of_a, b_, j, 0, crossings);
    add_crossings(b_, j, of_b, a_, i, 1, crossings);
    if (crossings.size() == 2) pieces_.push_back({crossings[0], crossings[1]});
  }

  // Whether triangles in one plane have an area in common: no side has the other one beyond it.
  bool overlap(int i, int j) const {
    return !has_beyond_a_side(a_, i, b_, j) && !has_beyond_a_side(b_, j, a_, i);
  }

  static bool has_beyond_a_side(const JoinedMesh& of, int i, const JoinedMesh& other, int j) {
    const auto corner = [](const JoinedMesh& mesh, int t, std::size_t k) {
      return kernel_point(mesh.corner(t, k % 3));
    };
    for (std::size_t k = 0; k < 3; ++k) {
      bool beyond = true;
      for (std::size_t m = 0; m < 3; ++m)
        beyond = beyond && CGAL::coplanar_orientation(corner(of, i, k), corner(of, i, k + 1),
                                                      corner(of, i, k + 2),
                                                      corner(other, j, m)) != CGAL::POSITIVE;
      if (beyond) return true;
    }
    return false;
  }

  Vec3 place(const JoinedMesh& of, const JoinedMesh& through, const NodeKey& key) const {
    const auto& ends = of.sides[index(key[1])];
    const ExactVec p = exact(of.points[index(ends[0])]), q = exact(of.points[index(ends[1])]);
    const ExactVec a = exact(through.corner(key[2], 0));
    const ExactVec normal =
        cross_of(exact(through.corner(key[2], 1)) - a, exact(through.corner(key[2], 2)) - a);
    return point_between(p, q, dot_of(normal, p - a), dot_of(normal, q - a));
  }

  const JoinedMesh &a_, &b_;
  const int way_;
  const std::function<void()>& ask_;
  bool moved_ = false;
  int zeros_ = 0;  // of the pair's corners in a plane
  std::vector<NodeKey> crossings_;
  std::vector<MeshPiece> pieces_;
};

// A mesh and a plane that is moved by `way` along its normal.
class PlaneMeeting {
 public:
  PlaneMeeting(const JoinedMesh& mesh, const Vec3& point, const Vec3& normal)
      : mesh_(mesh), point_(exact(point)), normal_(exact(normal)) {
    std::vector<char> used(mesh.points.size());
    for (const Triangle& t : mesh.triangles)
      for (const int corner : t) used[index(corner)] = true;
    heights_.resize(mesh.points.size());
    for (std::size_t k = 0; k < heights_.size(); ++k)
      if (used[k]) heights_[k] = height(mesh.points[k], point, normal);
  }

  bool touches() const {
    return std::ranges::any_of(mesh_.triangles, [&](const Triangle& t) {
      return std::ranges::any_of(t, [&](int corner) { return heights_[index(corner)] == 0; });
    });
  }

  MeshMeeting found(int way, const std::function<void()>& ask) const {
    MeshMeeting made;
    std::vector<MeshPiece> pieces;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (ask && t % kAskEvery == 0) ask();
      add_triangle(t, way, pieces, made);
    }
    const MeshNodes nodes = numbered(pieces);
    std::vector<Vec3> places;
    for (const NodeKey& key : nodes.keys) {
      const auto& ends = mesh_.sides[index(key[0])];
      const ExactVec p = exact(mesh_.points[index(ends[0])]),
                     q = exact(mesh_.points[index(ends[1])]);
      places.push_back(
          point_between(p, q, dot_of(normal_, p - point_), dot_of(normal_, q - point_)));
    }
    chain(nodes, places, made);
    return made;
  }

 private:
  void add_triangle(std::size_t t, int way, std::vector<MeshPiece>& pieces,
                    MeshMeeting& made) const {
    std::array<int, 3> signs{};
    for (std::size_t k = 0; k < 3; ++k) signs[k] = heights_[index(mesh_.triangles[t][k])];
    made.in_plane += signs == std::array{0, 0, 0};
    for (int& sign : signs) sign = sign == 0 ? -way : sign;
    std::vector<NodeKey> ends;
    for (std::size_t k = 0; k < 3; ++k)
      if (signs[k] != signs[(k + 1) % 3]) ends.push_back({mesh_.sides_of[t][k], 0, 0});
    if (ends.size() == 2) pieces.push_back({ends[0], ends[1]});
  }

  // The sign of the height over the plane.
  int height(const Vec3& p, const Vec3& point, const Vec3& normal) const {
    const double value = dot(normal, p - point);
    constexpr double kRounding = 0x1p-49;  // of three products, their factors and their sum
    double most = 0;
    for (int k = 0; k < 3; ++k) most += std::abs(normal[k]) * (std::abs(p[k]) + std::abs(point[k]));
    if (std::abs(value) > kRounding * most) return value > 0 ? 1 : -1;
    return CGAL::sign(dot_of(normal_, exact(p) - point_));
  }

  const JoinedMesh& mesh_;
  ExactVec point_, normal_;
  std::vector<int> heights_;
};

// Points of the answer are rounded from exact ones, to a unit in the last place or two.
double rounding_of(double largest) { return 0x1p-51 * largest; }

void compare(const MeshMeeting& other, MeshMeeting& made) {
  made.touching = made.in_plane > 0 || !have_equal_curves(made, other);
  made.points.insert(made.points.end(), other.points.begin(), other.points.end());
  std::ranges::sort(made.points, {}, &Vec3::coordinates);
  made.points.erase(std::unique(made.points.begin(), made.points.end()), made.points.end());
  // A corner through which a curve goes is no point of its own.
  std::vector<Vec3> on_curves;
  for (const MeshCurve& curve : made.curves)
    on_curves.insert(on_curves.end(), curve.points.begin(), curve.points.end());
  std::ranges::sort(on_curves, {}, &Vec3::coordinates);
  std::erase_if(made.points, [&](const Vec3& p) {
    return std::ranges::binary_search(on_curves, p.coordinates, {}, &Vec3::coordinates);
  });
}

}  // namespace

MeshMeeting intersect_meshes(const MeshView& a, const MeshView& b,
                             const std::function<void()>& ask) {
  const JoinedMesh first(a), second(b);
  const BoxTree tree_a(first.boxes()), tree_b(second.boxes());
  Meeting there(first, second, 1, ask);
  MeshMeeting made = there.found(tree_a, tree_b);
  if (there.was_moved()) compare(Meeting(first, second, -1, ask).found(tree_a, tree_b), made);
  made.rounding = rounding_of(std::max(first.largest_coordinate(), second.largest_coordinate()));
  made.flat = first.flat + second.flat;
  return made;
}

MeshMeeting section_of_mesh(const MeshView& mesh, const Vec3& point, const Vec3& normal,
                            const std::function<void()>& ask) {
  for (const Vec3& v : {point, normal})
    for (const double x : v.coordinates)
      if (!std::isfinite(x)) throw InvalidInput("the plane is not finite");
  if (max_norm(normal) == 0) throw InvalidInput("the plane's normal is zero");
  const JoinedMesh joined(mesh);
  const PlaneMeeting meeting(joined, point, normal);
  MeshMeeting made = meeting.found(1, ask);
  if (meeting.touches()) compare(meeting.found(-1, ask), made);
  made.rounding = rounding_of(joined.largest_coordinate());
  made.flat = joined.flat;
  return made;
}

}  // namespace blossom::cgal
