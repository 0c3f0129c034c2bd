// SPDX-License-Identifier: LGPL-2.1-or-later
// Trims in a plane, made by hand: polygons and circles.

#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/unbounded.h"
#include "core/plane/planar_curves.h"
#include "core/topology/face_trims.h"

namespace blossom::testing {

/// The plane z = 0, without end, by its coordinates.
inline SurfaceChart plane_chart() {
  return {[](const Vec2& uv) {
            return SurfaceJet{{uv[0], uv[1], 0}, {1, 0, 0}, {0, 1, 0}};
          },
          {{-kInfinity, -kInfinity}, {kInfinity, kInfinity}},
          {},
          {1, 1}};
}

/// Loops whose edges, and vertices, are numbered in the order in which they come.
struct FlatLoops {
  std::vector<FaceVertex> vertices;
  std::vector<std::vector<Coedge>> loops;
  int edges = 0;

  int add_vertex(const Vec2& at, double tolerance = kOnWire) {
    vertices.push_back({{at[0], at[1], 0}, tolerance});
    return static_cast<int>(vertices.size()) - 1;
  }

  Coedge coedge(PlanarCurve curve, int start, int end) {
    Coedge made;
    made.edge = edges++;
    made.curve = std::move(curve);
    made.tolerance = kOnWire;
    made.start = start;
    made.end = end;
    return made;
  }

  /// gap   by so much edges stop short of the second corner
  void add_polygon(const std::vector<Vec2>& corners, double gap = 0) {
    const int first = static_cast<int>(vertices.size()), count = static_cast<int>(corners.size());
    for (const Vec2& corner : corners) add_vertex(corner, std::max(kOnWire, 1.1 * gap));
    std::vector<Coedge>& loop = loops.emplace_back();
    for (int i = 0; i < count; ++i) {
      const int next = (i + 1) % count;
      Vec2 from = corners[static_cast<std::size_t>(i)],
           to = corners[static_cast<std::size_t>(next)];
      const double length = distance(from, to);
      const Vec2 along = (1 / length) * (to - from);
      if (i == 1) from += gap * along;
      if (i == 0) to -= gap * along;
      loop.push_back(coedge(planar_line(from, to, {0, length}), first + i, first + next));
    }
  }
};

/// Arcs of a circle, quarter by quarter.
/// turn    1 from (1, 0) to (0, 1), -1 the other way round
/// start   the angle where they begin, radians
inline PlanarCurve quarters_of_circle(const Vec2& centre, double radius, int turn, int count,
                                      double start = 0) {
  const double w = std::sqrt(0.5);
  PlanarCurve circle;
  Vec2 x{radius * std::cos(start), radius * std::sin(start)};
  Vec2 y = turn * Vec2{-x[1], x[0]};
  for (int i = 0; i < count; ++i) {
    const auto point = [&](const Vec2& out, double weight) {
      return Vec3{(centre + out)[0] * weight, (centre + out)[1] * weight, weight};
    };
    circle.spans.push_back({{{point(x, 1), point(x + y, w), point(y, 1)}}, {i * 1.0, i + 1.0}});
    x = std::exchange(y, -1.0 * x);
  }
  return circle;
}

inline FaceTrims trims_of(FlatLoops loops) {
  return blossom::trims_of(plane_chart(), std::move(loops.vertices), std::move(loops.loops))
      .value();
}

inline const std::vector<Vec2> kSquare4{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

/// [0, 4]^2 without the disc of radius 1 round its middle.
inline FaceTrims square_without_disc() {
  FlatLoops loops;
  loops.add_polygon(kSquare4);
  const int vertex = loops.add_vertex({3, 2});
  loops.loops.push_back({loops.coedge(quarters_of_circle({2, 2}, 1, -1, 4), vertex, vertex)});
  return trims_of(std::move(loops));
}

/// Of radius 1, above the x-axis.
inline FaceTrims half_disc() {
  FlatLoops loops;
  const int left = loops.add_vertex({-1, 0}), right = loops.add_vertex({1, 0});
  loops.loops.push_back({loops.coedge(planar_line({-1, 0}, {1, 0}, {-1, 1}), left, right),
                         loops.coedge(quarters_of_circle({0, 0}, 1, 1, 2), right, left)});
  return trims_of(std::move(loops));
}

}  // namespace blossom::testing
