// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/openmesh/meshes.h"

#include <algorithm>

#include "core/base/errors.h"
#include "core/forms/algebra/conversion.h"
#include "core/subdivision/tessellation.h"

namespace blossom::openmesh {
namespace {

// Sums before each span: where its first point is in the whole grid.
std::vector<int> starts(const std::vector<int>& counts) {
  std::vector<int> result{0};
  for (const int count : counts) result.push_back(result.back() + count);
  return result;
}

// Cells of each row and each column of patches: the finest that one of them needs.
struct SpanCells {
  std::vector<int> u, v;
};

SpanCells span_cells(const Grid<RationalBezierPatch>& patches, double tolerance) {
  SpanCells cells{std::vector<int>(static_cast<std::size_t>(patches.rows()), 1),
                  std::vector<int>(static_cast<std::size_t>(patches.columns()), 1)};
  for (int i = 0; i < patches.rows(); ++i)
    for (int j = 0; j < patches.columns(); ++j) {
      const CellCount needed = cells_for_tolerance(patches(i, j), tolerance);
      int& u = cells.u[static_cast<std::size_t>(i)];
      int& v = cells.v[static_cast<std::size_t>(j)];
      u = std::max(u, needed.u);
      v = std::max(v, needed.v);
    }
  return cells;
}

Grid<Vec3> points_of(const Grid<RationalBezierPatch>& patches, const SpanCells& cells) {
  const std::vector<int> first_u = starts(cells.u), first_v = starts(cells.v);
  Grid<Vec3> points(first_u.back() + 1, first_v.back() + 1);
  for (int i = 0; i < patches.rows(); ++i)
    for (int j = 0; j < patches.columns(); ++j) {
      const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
      const Grid<Vec3> part = points_on_grid(patches(i, j), {cells.u[k], cells.v[l]});
      for (int r = 0; r < part.rows(); ++r)
        for (int c = 0; c < part.columns(); ++c)
          points(first_u[k] + r, first_v[l] + c) = part(r, c);
    }
  return points;
}

void add_triangle(Mesh& mesh, int a, int b, int c) {
  const auto point = [&](int k) { return mesh.points[static_cast<std::size_t>(k)]; };
  const Vec3 ab = point(b) - point(a), ac = point(c) - point(a);
  if (norm(cross(ab, ac)) > 0) mesh.faces.push_back({a, b, c});
}

// Two triangles for each cell. In a closed direction the last row is the first.
Mesh triangulated(const Grid<Vec3>& points, bool closed_u, bool closed_v) {
  const int rows = points.rows() - (closed_u ? 1 : 0);
  const int columns = points.columns() - (closed_v ? 1 : 0);
  Mesh mesh;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) mesh.points.push_back(points(i, j));
  const auto index = [&](int i, int j) { return i % rows * columns + j % columns; };
  for (int i = 0; i + 1 < points.rows(); ++i)
    for (int j = 0; j + 1 < points.columns(); ++j) {
      add_triangle(mesh, index(i, j), index(i + 1, j), index(i, j + 1));
      add_triangle(mesh, index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
    }
  return mesh;
}

void add_net(Mesh& mesh, const RationalBezierPatch& patch) {
  const int first = static_cast<int>(mesh.points.size());
  const int rows = patch.points.rows(), columns = patch.points.columns();
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const Vec4& p = patch.points(i, j);
      mesh.points.push_back({p[0] / p[3], p[1] / p[3], p[2] / p[3]});
    }
  const auto index = [&](int i, int j) { return first + i * columns + j; };
  for (int i = 0; i + 1 < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j)
      mesh.faces.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
}

}  // namespace

Mesh tessellation(const BezierSurface& surface, double tolerance) {
  if (surface.patches.empty()) throw InvalidInput("tessellation: the surface has no patch");
  SpanCells cells = span_cells(surface.patches, tolerance);
  // Fewer than three cells round a closed direction would give two triangles the same corners.
  if (surface.closed_u) cells.u.front() = std::max(cells.u.front(), 3);
  if (surface.closed_v) cells.v.front() = std::max(cells.v.front(), 3);
  return triangulated(points_of(surface.patches, cells), surface.closed_u, surface.closed_v);
}

Mesh tessellation(const RationalBezierPatch& patch, double tolerance) {
  return triangulated(points_on_grid(patch, cells_for_tolerance(patch, tolerance)), false, false);
}

Mesh tessellation(const BezierPatch& patch, double tolerance) {
  return tessellation(homogeneous(patch), tolerance);
}

Mesh control_net(const BezierSurface& surface) {
  Mesh mesh;
  for (const RationalBezierPatch& patch : surface.patches.values()) add_net(mesh, patch);
  return mesh;
}

Mesh control_net(const RationalBezierPatch& patch) {
  Mesh mesh;
  add_net(mesh, patch);
  return mesh;
}

Mesh control_net(const BezierPatch& patch) { return control_net(homogeneous(patch)); }

}  // namespace blossom::openmesh
