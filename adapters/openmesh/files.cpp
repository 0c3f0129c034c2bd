// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes to files: OpenMesh writes the formats, into a file beside the target that takes its
// place when all is on the disk.

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultPolyMesh.hh>
#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "adapters/openmesh/digits.h"
#include "adapters/openmesh/meshes.h"
#include "adapters/openmesh/silence.h"

namespace blossom::openmesh {
namespace {

constexpr std::array<const char*, 4> kEndings{".obj", ".off", ".ply", ".stl"};

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& cause) {
  throw WriteFailure("cannot write " + file.string() + ": " + cause);
}

std::string ending(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::find(kEndings.begin(), kEndings.end(), text) == kEndings.end())
    fail(file, "the ending must be .obj, .off, .ply or .stl");
  return text;
}

std::vector<std::vector<int>> triangles(const std::vector<std::vector<int>>& faces) {
  std::vector<std::vector<int>> result;
  for (const std::vector<int>& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k) result.push_back({face[0], face[k - 1], face[k]});
  return result;
}

OpenMesh::PolyMesh to_openmesh(const Mesh& mesh, bool triangles_only,
                               const std::filesystem::path& file) {
  OpenMesh::PolyMesh result;
  std::vector<OpenMesh::VertexHandle> vertices;
  for (const Vec3& p : mesh.points)
    vertices.push_back(result.add_vertex(OpenMesh::Vec3d(p[0], p[1], p[2])));
  for (const std::vector<int>& face : triangles_only ? triangles(mesh.faces) : mesh.faces) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (const int k : face) corners.push_back(vertices.at(static_cast<std::size_t>(k)));
    if (!result.add_face(corners).is_valid())
      fail(file, "an edge would belong to more than two polygons");
  }
  return result;
}

}  // namespace

void write_mesh(const Mesh& mesh, const std::filesystem::path& file) {
  const std::string format = ending(file);
  const Silence silence;
  const OpenMesh::PolyMesh written = to_openmesh(mesh, format == ".stl", file);
  std::filesystem::path beside = file;
  beside += ".part";
  std::error_code error;
  {
    std::ofstream stream(beside, std::ios::binary);
    if (!stream) fail(file, "the folder is missing or not writable");
    const bool done = OpenMesh::IO::write_mesh(written, stream, format,
                                               OpenMesh::IO::Options::Default, kAllDigits);
    stream.close();
    if (!done || !stream) {
      std::filesystem::remove(beside, error);
      fail(file, "not everything could be written");
    }
  }
  std::filesystem::rename(beside, file, error);
  if (error) {
    const std::string cause = error.message();
    std::filesystem::remove(beside, error);
    fail(file, cause);
  }
}

}  // namespace blossom::openmesh
