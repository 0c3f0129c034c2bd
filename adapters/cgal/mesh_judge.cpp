// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/cgal/mesh_judge.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>

#include "core/base/errors.h"
#include "core/bounds/box_tree.h"
#include "core/math/index.h"

namespace blossom::cgal {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle = std::array<int, 3>;

constexpr std::size_t kAskAfter = 1 << 14;  // pairs of a thread

class Judge {
 public:
  Judge(std::span<const Vec3> points, std::span<const Triangle> triangles,
        const std::function<void()>& ask, const std::function<void(int, int)>& crossing)
      : points_(points), triangles_(triangles), ask_(ask), crossing_(crossing) {}

  MeshVerdict verdict() {
    static_cast<MeshFacts&>(found_) = mesh_facts(points_, triangles_, ask_);
    count_flat();
    count_crossings();
    return std::move(found_);
  }

 private:
  Kernel::Point_3 point(int i) const {
    const Vec3& p = points_[index(i)];
    return {p[0], p[1], p[2]};
  }
  Kernel::Triangle_3 triangle(const Triangle& t) const {
    return {point(t[0]), point(t[1]), point(t[2])};
  }

  void count_flat() {
    for (const Triangle& t : triangles_) {
      const bool flat = is_flat(t);
      found_.degenerate += flat;
      flat_.push_back(flat);
    }
  }

  bool is_flat(const Triangle& t) const {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
           CGAL::collinear(point(t[0]), point(t[1]), point(t[2]));
  }

  void count_crossings() {
    std::vector<Box> boxes;
    for (const Triangle& t : triangles_) {
      Box box;
      for (const int corner : t)
        box = joined(box, {points_[index(corner)], points_[index(corner)]});
      boxes.push_back(box);
    }
    BoxTree(boxes).for_each_pair([&](int i, int j) {
      // On each thread, as a count in common would go from one to the other with every pair.
      static thread_local std::size_t asked = 0;
      if (ask_ && ++asked % kAskAfter == 0) {
        const std::lock_guard guard(told_);
        ask_();
      }
      if (flat_[index(i)] || flat_[index(j)] ||
          !cross_beyond(triangles_[index(i)], triangles_[index(j)]))
        return;
      const std::lock_guard guard(told_);
      ++found_.crossings;
      found_.repeated += have_same_corners(triangles_[index(i)], triangles_[index(j)]);
      if (crossing_) crossing_(std::min(i, j), std::max(i, j));
      list({std::min(i, j), std::max(i, j)});
    });
    std::ranges::sort_heap(found_.crossing_pairs);
  }

  // A heap whose top is the last of those listed.
  void list(const std::array<int, 2>& pair) {
    std::vector<std::array<int, 2>>& listed = found_.crossing_pairs;
    if (listed.size() == kListedPairs) {
      if (listed.front() < pair) return;
      std::ranges::pop_heap(listed);
      listed.pop_back();
    }
    listed.push_back(pair);
    std::ranges::push_heap(listed);
  }

  // Of triangles with three different corners.
  static bool have_same_corners(const Triangle& a, const Triangle& b) {
    return std::ranges::all_of(a,
                               [&](int corner) { return std::ranges::find(b, corner) != b.end(); });
  }

  // Beyond the vertices that they share.
  bool cross_beyond(const Triangle& a, const Triangle& b) const {
    std::array<std::size_t, 3> in_a{}, in_b{};
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (a[i] == b[j] && shared < 3) {
          in_a[shared] = i;
          in_b[shared++] = j;
        }
    if (shared == 0) return CGAL::do_intersect(triangle(a), triangle(b));
    if (shared == 1) {
      const auto opposite = [&](const Triangle& t, std::size_t k) {
        return Kernel::Segment_3(point(t[(k + 1) % 3]), point(t[(k + 2) % 3]));
      };
      return CGAL::do_intersect(triangle(a), opposite(b, in_b[0])) ||
             CGAL::do_intersect(triangle(b), opposite(a, in_a[0]));
    }
    if (shared == 3) return true;
    // One lies on the other where they are in one plane and on one side of what they share.
    const auto p = point(a[in_a[0]]), q = point(a[in_a[1]]);
    const auto r = point(a[3 - in_a[0] - in_a[1]]), s = point(b[3 - in_b[0] - in_b[1]]);
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
  }

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  const std::function<void()>& ask_;
  const std::function<void(int, int)>& crossing_;
  std::vector<char> flat_;
  std::mutex told_;  // one crossing at a time
  MeshVerdict found_;
};

void check(std::span<const Vec3> points) {
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const double x : points[k].coordinates)
      if (!std::isfinite(x))
        throw InvalidInput("judge_mesh: point " + std::to_string(k) + " is not finite");
}

}  // namespace

MeshVerdict judge_mesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
                       const std::function<void()>& ask,
                       const std::function<void(int, int)>& crossing) {
  check(points);
  return Judge(points, triangles, ask, crossing).verdict();
}

}  // namespace blossom::cgal
