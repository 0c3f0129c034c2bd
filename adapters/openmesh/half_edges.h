// SPDX-License-Identifier: LGPL-2.1-or-later
// The facets of a model as half-edges of the caller's own kind of OpenMesh.
//
//   OpenMesh::TriMesh mesh;
//   const auto added = blossom::openmesh::add_facets(mesh, tessellation.facets,
//   tessellation.reversed); mesh.property(added.face_number, face);  mesh.normal(halfedge);
//   mesh.texcoord2D(halfedge);

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <OpenMesh/Core/Utils/Property.hh>

#include "core/tessellation/shape_facets.h"

namespace blossom::openmesh {

struct AddedFacets {
  OpenMesh::FPropHandleT<int> face_number;  ///< of the model's face, from 0 on; "face_number"
  std::size_t triangles = 0;
  /// Of these, with vertices of their own: half-edges are of manifolds alone, where at most two
  /// triangles share a side and those round a vertex are one fan.
  std::size_t apart = 0;
};

/// Adds points and triangles; of each corner the surface's unit normal and parameters, as the
/// half-edge that ends there has them, and of each triangle its face.
///
/// Mesh       an OpenMesh::TriMesh_ArrayKernelT; what is in it already stays
/// reversed   of each face of the model: its outside is against S_u x S_v, so its facets and
///            normals are turned
template <class Mesh>
AddedFacets add_facets(Mesh& mesh, const ShapeFacets& facets, const std::vector<bool>& reversed) {
  AddedFacets added;
  mesh.request_halfedge_normals();
  mesh.request_halfedge_texcoords2D();
  if (!mesh.get_property_handle(added.face_number, "face_number"))
    mesh.add_property(added.face_number, "face_number");
  const auto vector = [](const Vec3& v) {
    using Scalar = typename Mesh::Scalar;
    return typename Mesh::Point(static_cast<Scalar>(v[0]), static_cast<Scalar>(v[1]),
                                static_cast<Scalar>(v[2]));
  };
  std::vector<OpenMesh::VertexHandle> vertices;
  for (const Vec3& point : facets.points) vertices.push_back(mesh.add_vertex(vector(point)));
  for (std::size_t f = 0; f < facets.faces.size(); ++f) {
    const MeshedFace& face = facets.faces[f];
    const auto vertex = [&](int corner) {
      return vertices[static_cast<std::size_t>(face.vertices[static_cast<std::size_t>(corner)])];
    };
    for (std::array<int, 3> corners : face.triangles) {
      if (reversed[f]) std::swap(corners[1], corners[2]);
      const auto& [a, b, c] = corners;
      auto triangle = mesh.add_face(vertex(a), vertex(b), vertex(c));
      ++added.triangles;
      if (!triangle.is_valid()) {
        const auto own = [&](int corner) {
          const typename Mesh::Point point = mesh.point(vertex(corner));  // adding moves the points
          return mesh.add_vertex(point);
        };
        triangle = mesh.add_face(own(a), own(b), own(c));
        ++added.apart;
      }
      mesh.property(added.face_number, triangle) = static_cast<int>(f);
      // The first half-edge of a face is not always that to its second vertex.
      auto side = mesh.halfedge_handle(triangle);
      const auto first = mesh.point(vertex(a));
      for (int k = 0; k < 3 && mesh.point(mesh.to_vertex_handle(side)) != first; ++k)
        side = mesh.next_halfedge_handle(side);
      for (const int corner : corners) {
        const auto at = static_cast<std::size_t>(corner);
        const Vec3 normal = (reversed[f] ? -1.0 : 1.0) * face.normals[at];
        using Normal = typename Mesh::Normal;
        using Part = typename Normal::value_type;
        mesh.set_normal(side, Normal(static_cast<Part>(normal[0]), static_cast<Part>(normal[1]),
                                     static_cast<Part>(normal[2])));
        using TexCoord = typename Mesh::TexCoord2D;
        using Coord = typename TexCoord::value_type;
        mesh.set_texcoord2D(
            side, TexCoord(static_cast<Coord>(face.uv[at][0]), static_cast<Coord>(face.uv[at][1])));
        side = mesh.next_halfedge_handle(side);
      }
    }
  }
  return added;
}

}  // namespace blossom::openmesh
