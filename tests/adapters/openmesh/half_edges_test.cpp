// SPDX-License-Identifier: LGPL-2.1-or-later
// Facets of a model as half-edges, with what their corners have.

#include "adapters/openmesh/half_edges.h"

#include <gtest/gtest.h>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace blossom {
namespace {

// Two faces of a square each, which share a side and stand at a right angle; the second is turned.
ShapeFacets corner() {
  ShapeFacets facets;
  facets.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}};
  const Vec3 up{0, 0, 1}, back{0, 1, 0};
  MeshedFace floor{{0, 1, 2, 3}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {up, up, up, up}, {}};
  floor.triangles = {{0, 1, 2}, {0, 2, 3}};
  MeshedFace wall{{0, 1, 5, 4}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {-back, -back, -back, -back}, {}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  facets.faces = {floor, wall};
  return facets;
}

struct Doubles : OpenMesh::DefaultTraitsDouble {};
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<Doubles>;

TEST(HalfEdges, HaveNormalsParametersAndFacesOfTheirCorners) {
  DoubleMesh mesh;
  const openmesh::AddedFacets added = openmesh::add_facets(mesh, corner(), {false, true});
  EXPECT_EQ(mesh.n_vertices(), 6u);
  EXPECT_EQ(mesh.n_faces(), 4u);
  EXPECT_EQ(added.triangles, 4u);
  EXPECT_EQ(added.apart, 0u);
  for (const auto face : mesh.faces()) {
    const bool wall = mesh.property(added.face_number, face) == 1;
    for (const auto side : mesh.fh_range(face)) {
      const auto& point = mesh.point(mesh.to_vertex_handle(side));
      const double scale = wall ? 2 : 1;
      EXPECT_EQ(mesh.texcoord2D(side)[0], static_cast<float>(scale * point[0]));
      EXPECT_EQ(mesh.texcoord2D(side)[1], static_cast<float>(scale * (wall ? point[2] : point[1])));
      EXPECT_EQ(mesh.normal(side),
                wall ? DoubleMesh::Normal(0, 1, 0) : DoubleMesh::Normal(0, 0, 1));
    }
  }
}

TEST(HalfEdges, GetVerticesOfTheirOwnWhereMoreThanTwoShareASide) {
  ShapeFacets facets = corner();
  facets.points.push_back({0, -1, -1});
  MeshedFace fin{{0, 1, 6}, std::vector<Vec2>(3), std::vector<Vec3>(3), {}};
  fin.triangles = {{0, 1, 2}};
  facets.faces.push_back(fin);
  OpenMesh::TriMesh mesh;
  const auto added = openmesh::add_facets(mesh, facets, {false, true, false});
  EXPECT_EQ(added.apart, 1u);
  EXPECT_EQ(mesh.n_faces(), 5u);
  EXPECT_EQ(mesh.n_vertices(), 10u);
}

}  // namespace
}  // namespace blossom
