// SPDX-License-Identifier: LGPL-2.1-or-later
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "adapters/openmesh/digits.h"
#include "adapters/openmesh/silence.h"
#include "adapters/openmesh/triangles.h"

namespace blossom::openmesh {
namespace {

double rounding_of(const std::vector<Vec3>& points) {
  double most = 0;
  for (const Vec3& p : points) {
    Vec3 off;
    for (int k = 0; k < 3; ++k) off[k] = static_cast<double>(static_cast<float>(p[k])) - p[k];
    most = std::max(most, norm(off));
  }
  return most;
}

OpenMesh::TriMesh half_edges(const TriangleSoup& soup, int& apart) {
  OpenMesh::TriMesh mesh;
  mesh.reserve(soup.points.size(), soup.triangles.size() * 3 / 2, soup.triangles.size());
  std::vector<OpenMesh::VertexHandle> vertices;
  const auto point = [&](int k) {
    const Vec3& p = soup.points[static_cast<std::size_t>(k)];
    return OpenMesh::TriMesh::Point(static_cast<float>(p[0]), static_cast<float>(p[1]),
                                    static_cast<float>(p[2]));
  };
  for (std::size_t k = 0; k < soup.points.size(); ++k)
    vertices.push_back(mesh.add_vertex(point(static_cast<int>(k))));
  for (const auto& [a, b, c] : soup.triangles) {
    const auto vertex = [&](int k) { return vertices[static_cast<std::size_t>(k)]; };
    if (mesh.add_face(vertex(a), vertex(b), vertex(c)).is_valid()) continue;
    ++apart;
    mesh.add_face(mesh.add_vertex(point(a)), mesh.add_vertex(point(b)), mesh.add_vertex(point(c)));
  }
  return mesh;
}

}  // namespace

bool is_mesh_ending(const std::string& ending) {
  return ending == ".stl" || ending == ".ply" || ending == ".obj" || ending == ".off";
}

MeshBytes mesh_bytes(const TriangleSoup& soup, const std::string& ending, Encoding encoding) {
  if (!is_mesh_ending(ending))
    throw std::invalid_argument("no mesh format has the ending " + ending);
  const Silence silence;
  MeshBytes result;
  result.rounding = rounding_of(soup.points);
  OpenMesh::TriMesh mesh = half_edges(soup, result.apart);
  OpenMesh::IO::Options options = OpenMesh::IO::Options::Default;
  if (encoding == Encoding::Binary && ending != ".obj") options += OpenMesh::IO::Options::Binary;
  if (ending == ".stl") {
    mesh.request_face_normals();
    mesh.update_face_normals();
    options += OpenMesh::IO::Options::FaceNormal;
  }
  std::ostringstream stream;
  if (!OpenMesh::IO::write_mesh(mesh, stream, ending, options, kAllDigits))
    throw std::runtime_error("OpenMesh cannot write the mesh as " + ending);
  result.bytes = std::move(stream).str();
  return result;
}

}  // namespace blossom::openmesh
