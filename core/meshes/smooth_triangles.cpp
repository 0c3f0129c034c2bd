// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/smooth_triangles.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "core/base/disjoint_sets.h"
#include "core/base/errors.h"
#include "core/math/index.h"
#include "core/meshes/open_rings.h"

namespace blossom {
namespace {

using Corners = std::array<Vec3, 3>;

constexpr double kEqualNormals = 1e-9;       // radians: roundings of averages
constexpr int kPlaces = 7;                   // of a side at which normals are compared
constexpr std::size_t kAskTriangles = 1024;  // triangles

Corners corners_of(std::span<const Vec3> points, const std::array<int, 3>& triangle) {
  return {points[index(triangle[0])], points[index(triangle[1])], points[index(triangle[2])]};
}

Vec3 normal_of(const Corners& p) { return unit(cross(p[1] - p[0], p[2] - p[0])); }

// ---- patches

// To the next control point of a cubic from one end of a chord: in the plane of the normal, so long
// that arcs of circles come out as near as cubics can be.
Vec3 tangent(const Vec3& chord, const Vec3& normal) {
  const Vec3 along = chord - dot(chord, normal) * normal;
  const double length = norm(chord);
  return length > 0 ? 2 * length / (3 * (1 + norm(along) / length)) * unit(along) : Vec3{};
}

// A side as a cubic, and once more of degree 4.
struct SideCurve {
  std::array<Vec3, 4> cubic;
  std::array<Vec3, 5> quartic;
  Vec3 g0, g1;  // across it, in the tangent planes of its ends

  SideCurve(const Vec3& a, const Vec3& n_a, const Vec3& b, const Vec3& n_b) {
    cubic = {a, a + tangent(b - a, n_a), b - tangent(b - a, n_b), b};
    quartic[0] = a;
    for (std::size_t k = 1; k < 4; ++k) {
      const double part = static_cast<double>(k) / 4;
      quartic[k] = part * cubic[k - 1] + (1 - part) * cubic[k];
    }
    quartic[4] = b;
    g0 = unit(cross(n_a, cubic[1] - cubic[0]));
    g1 = unit(cross(n_b, cubic[3] - cubic[2]));
  }
};

// What t has of two vectors that are at right angles: k g + h c.
struct Split {
  double k = 0, h = 0;

  Split(const Vec3& t, const Vec3& g, const Vec3& c) {
    k = dot(t, g);
    h = dot(c, c) > 0 ? dot(t, c) / dot(c, c) : 0;
  }
};

// The second row of control points along a side, between its ends; see the formula for D.
void add_inner_row(const SideCurve& side, std::array<Vec3, 4>& row) {
  const std::array<Vec3, 5>& e = side.quartic;
  std::array<Vec3, 3> c;  // of C'
  for (std::size_t k = 0; k < 3; ++k) c[k] = 3.0 * (side.cubic[k + 1] - side.cubic[k]);
  const auto across = [&](std::size_t k) { return 4.0 * (row[k] - 0.5 * (e[k] + e[k + 1])); };
  const Split from(across(0), side.g0, c[0]), to(across(3), side.g1, c[2]);
  const Vec3 middle = 0.5 * (from.k * side.g1 + to.k * side.g0);
  const Vec3 first =
      (1.0 / 3) * (from.k * side.g0 + 2.0 * middle + to.h * c[0] + 2 * from.h * c[1]);
  const Vec3 second = (1.0 / 3) * (2.0 * middle + to.k * side.g1 + 2 * to.h * c[1] + from.h * c[2]);
  row[1] = 0.25 * first + 0.5 * (e[1] + e[2]);
  row[2] = 0.25 * second + 0.5 * (e[2] + e[3]);
}

// Rows of the three patches from their sides to the middle, and what they have in common.
class SplitTriangle {
 public:
  SplitTriangle(const Corners& p, const Corners& n)
      : sides_{SideCurve(p[0], n[0], p[1], n[1]), SideCurve(p[1], n[1], p[2], n[2]),
               SideCurve(p[2], n[2], p[0], n[0])} {
    for (std::size_t i = 0; i < 3; ++i)
      ways_[i][0] = (1.0 / 3) * (p[i] + side(i).quartic[1] + side(i + 2).quartic[3]);
    for (std::size_t i = 0; i < 3; ++i) {
      rows_[i][0] = ways_[i][0];
      rows_[i][3] = way(i + 1)[0];
      add_inner_row(side(i), rows_[i]);
    }
    for (std::size_t i = 0; i < 3; ++i)
      ways_[i][1] = (1.0 / 3) * (ways_[i][0] + rows_[i][1] + rows_[(i + 2) % 3][2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<Vec3, 4>& r = rows_[i];
      centres_[i] = 0.5 * (ways_[i][1] + way(i + 1)[1]) - 0.25 * (r[0] - r[1] - r[2] + r[3]);
    }
    for (std::size_t i = 0; i < 3; ++i)
      ways_[i][2] = (1.0 / 3) * (ways_[i][1] + centres_[i] + centres_[(i + 2) % 3]);
    middle_ = (1.0 / 3) * (ways_[0][2] + ways_[1][2] + ways_[2][2]);
  }

  BezierTriangle patch(std::size_t i) const {
    BezierTriangle made{4, std::vector<Vec3>(BezierTriangle::count(4))};
    const auto row = [&](int across, std::initializer_list<Vec3> points) {
      int mu = 0;
      for (const Vec3& p : points) {
        made(4 - across - mu, mu) = p;
        ++mu;
      }
    };
    const std::array<Vec3, 5>& e = side(i).quartic;
    const std::array<Vec3, 4>& r = rows_[i];
    row(0, {e[0], e[1], e[2], e[3], e[4]});
    row(1, {r[0], r[1], r[2], r[3]});
    row(2, {ways_[i][1], centres_[i], way(i + 1)[1]});
    row(3, {ways_[i][2], way(i + 1)[2]});
    row(4, {middle_});
    return made;
  }

 private:
  const SideCurve& side(std::size_t i) const { return sides_[i % 3]; }
  const std::array<Vec3, 3>& way(std::size_t i) const { return ways_[i % 3]; }

  std::array<SideCurve, 3> sides_;
  std::array<std::array<Vec3, 3>, 3> ways_;  // from a corner to the middle, without both
  std::array<std::array<Vec3, 4>, 3> rows_;  // the second ones
  std::array<Vec3, 3> centres_;              // of the third ones
  Vec3 middle_;
};

// Of a patch at a place of its side from corner to corner.
Vec3 normal_at_side(const BezierTriangle& patch, double u) {
  std::array<Vec3, 4> along, across;
  for (int k = 0; k < 4; ++k) {
    along[index(k)] = patch(3 - k, k + 1) - patch(4 - k, k);
    across[index(k)] = patch(3 - k, k) - patch(4 - k, k);
  }
  for (std::size_t left = 3; left > 0; --left)
    for (std::size_t k = 0; k < left; ++k) {
      along[k] = (1 - u) * along[k] + u * along[k + 1];
      across[k] = (1 - u) * across[k] + u * across[k + 1];
    }
  return cross(along[0], across[0]);
}

double largest_angle_of(const BezierTriangle& a, const BezierTriangle& b) {
  double most = 0;
  for (int k = 1; k <= kPlaces; ++k) {
    const double u = static_cast<double>(k) / (kPlaces + 1);
    most = std::max(most, angle_between(normal_at_side(a, u), normal_at_side(b, 1 - u)));
  }
  return most;
}

void measure_sides(const MeshSides& sides, std::span<const CornerNormals> normals,
                   SmoothMesh& made) {
  for (std::size_t s = 0; s < sides.across.size(); ++s) {
    const int other = sides.across[s], side = static_cast<int>(s);
    if (other < side) continue;
    const int k = side % 3, l = other % 3;
    const auto of = [&](int which, int corner) {
      return normals[index(which / 3)][index(corner % 3)];
    };
    const bool equal = angle_between(of(side, k), of(other, l + 1)) <= kEqualNormals &&
                       angle_between(of(side, k + 1), of(other, l)) <= kEqualNormals;
    if (!equal) {
      ++made.sharp_sides;
      continue;
    }
    ++made.smooth_sides;
    made.largest_angle =
        std::max(made.largest_angle, largest_angle_of(made.patches[s], made.patches[index(other)]));
  }
}

}  // namespace

std::vector<CornerNormals> corner_normals(std::span<const Vec3> points,
                                          std::span<const std::array<int, 3>> triangles,
                                          double crease, const std::function<void()>& ask) {
  const auto step = [&ask](std::size_t t) {
    if (ask && t % kAskTriangles == 0) ask();
  };
  const MeshSides sides(points.size(), triangles);
  std::vector<Vec3> flat;
  flat.reserve(triangles.size());
  for (const std::array<int, 3>& t : triangles) {
    step(flat.size());
    flat.push_back(normal_of(corners_of(points, t)));
  }
  DisjointSets corners(3 * triangles.size());  // corners at one point that have one normal
  for (std::size_t s = 0; s < sides.across.size(); ++s) {
    if (s % 3 == 0) step(s / 3);
    const int other = sides.across[s], side = static_cast<int>(s);
    if (other < side || angle_between(flat[s / 3], flat[index(other / 3)]) >= crease) continue;
    // Where a side begins, and where it ends, which the other triangle has the other way.
    const auto begin = [](int of) { return index(of); };
    const auto end = [](int of) { return index(of % 3 == 2 ? of - 2 : of + 1); };
    corners.join(begin(side), end(other));
    corners.join(end(side), begin(other));
  }
  std::vector<Vec3> sums(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    step(t);
    const Corners p = corners_of(points, triangles[t]);
    for (std::size_t k = 0; k < 3; ++k)
      sums[corners.find(3 * t + k)] +=
          angle_between(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]) * flat[t];
  }
  std::vector<CornerNormals> normals(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) normals[t][k] = unit(sums[corners.find(3 * t + k)]);
  return normals;
}

SmoothMesh smooth_mesh(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles,
                       std::span<const CornerNormals> normals, const std::function<void()>& ask) {
  if (normals.size() != triangles.size())
    throw InvalidInput("smooth_mesh: " + std::to_string(triangles.size()) + " triangles have " +
                       std::to_string(normals.size()) + " triples of normals");
  const MeshSides sides(points.size(), triangles);
  SmoothMesh made;
  made.patches.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (ask && t % kAskTriangles == 0) ask();
    const Corners p = corners_of(points, triangles[t]);
    Corners n = normals[t];
    for (Vec3& normal : n) normal = dot(normal, normal) > 0 ? unit(normal) : normal_of(p);
    const SplitTriangle split(p, n);
    for (std::size_t i = 0; i < 3; ++i) made.patches.push_back(split.patch(i));
  }
  measure_sides(sides, normals, made);
  return made;
}

}  // namespace blossom
