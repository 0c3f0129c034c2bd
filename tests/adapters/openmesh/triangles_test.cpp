// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles to files and back, and files that are no meshes.

#include "adapters/openmesh/triangles.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace blossom {
namespace {

using openmesh::BadMesh;
using openmesh::Encoding;
using openmesh::TriangleSoup;

// Coordinates are floats already.
TriangleSoup tetrahedron() {
  return {{{0, 0, 0}, {2, 0, 0}, {0, 2.5, 0}, {0.25, 0, 3}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

double volume(const TriangleSoup& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto p = [&](int k) { return mesh.points[static_cast<std::size_t>(k)]; };
    sum += dot(p(a), cross(p(b), p(c))) / 6;
  }
  return sum;
}

class MeshFiles : public ::testing::Test {
 protected:
  ~MeshFiles() override { std::filesystem::remove(path_); }

  const std::filesystem::path& written(const std::string& bytes, const std::string& ending) {
    std::filesystem::remove(path_);
    path_ = std::filesystem::path(::testing::TempDir()) /
            ("blossom_" + std::to_string(::getpid()) + "_mesh" + ending);
    std::ofstream(path_, std::ios::binary) << bytes;
    return path_;
  }

  std::string refusal(const std::string& bytes, const std::string& ending) {
    try {
      openmesh::read_triangles(written(bytes, ending));
    } catch (const BadMesh& error) {
      return std::string(error.what()).substr(path_.string().size());
    }
    return "";
  }

 private:
  std::filesystem::path path_;
};

TEST_F(MeshFiles, KeepTrianglesAndVolumeInEveryFormat) {
  for (const char* ending : {".stl", ".ply", ".obj", ".off"})
    for (const Encoding encoding : {Encoding::Binary, Encoding::Text}) {
      const openmesh::MeshBytes made = openmesh::mesh_bytes(tetrahedron(), ending, encoding);
      EXPECT_EQ(made.rounding, 0) << ending;
      EXPECT_EQ(made.apart, 0) << ending;
      const TriangleSoup read = openmesh::read_triangles(written(made.bytes, ending));
      EXPECT_EQ(read.points.size(), 4u) << ending;
      EXPECT_EQ(read.triangles.size(), 4u) << ending;
      EXPECT_NEAR(volume(read), volume(tetrahedron()), 1e-12 * volume(tetrahedron())) << ending;
    }
}

TEST_F(MeshFiles, TellHowFarSinglePrecisionMovesPoints) {
  TriangleSoup mesh = tetrahedron();
  mesh.points[1][0] = 1000.1;
  const double off = std::abs(static_cast<double>(1000.1f) - 1000.1);
  EXPECT_DOUBLE_EQ(openmesh::mesh_bytes(mesh, ".stl", Encoding::Binary).rounding, off);
}

TEST_F(MeshFiles, KeepEveryTriangleWhereMoreThanTwoShareASide) {
  TriangleSoup mesh = tetrahedron();
  mesh.points.push_back({-1, -1, 1});
  mesh.triangles.push_back({0, 3, 4});
  for (const char* ending : {".stl", ".ply", ".obj", ".off"}) {
    const openmesh::MeshBytes made = openmesh::mesh_bytes(mesh, ending, Encoding::Binary);
    EXPECT_EQ(made.apart, 1);
    EXPECT_EQ(openmesh::read_triangles(written(made.bytes, ending)).triangles.size(), 5u);
  }
}

TEST_F(MeshFiles, ReadNonManifoldsAsTheyAre) {
  const TriangleSoup read = openmesh::read_triangles(written(
      "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 1 4\n", ".off"));
  EXPECT_EQ(read.triangles.size(), 3u);
  EXPECT_EQ(read.points.size(), 5u);
}

TEST_F(MeshFiles, ReadPolygonsAsFans) {
  const TriangleSoup read =
      openmesh::read_triangles(written("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", ".obj"));
  EXPECT_EQ(read.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

// A header of STL that promises 10 GB of facets.
std::string large_header() {
  std::string bytes(84, ' ');
  const std::uint32_t count = 200'000'000;
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  return bytes + std::string(100, '\0');
}

TEST_F(MeshFiles, RefuseWhatTheyCannotHold) {
  EXPECT_NE(refusal(large_header(), ".stl").find("promises 200000000 facets, it has room for 2"),
            std::string::npos);
  EXPECT_NE(refusal("", ".stl"), "");
  EXPECT_NE(refusal("too short", ".stl"), "");
  EXPECT_NE(refusal("OFF\n2000000000 5 0\n", ".off").find("promises"), std::string::npos);
  EXPECT_NE(refusal("ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\n"
                    "property float y\nproperty float z\nelement face 1\n"
                    "property list uchar int vertex_indices\nend_header\n",
                    ".ply")
                .find("promises"),
            std::string::npos);
  EXPECT_NE(refusal("v 0 0 0\n", ".obj").find("no triangle"), std::string::npos);
  EXPECT_NE(refusal("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ".obj"), "");
}

TEST_F(MeshFiles, RefuseFilesThatAreCutOff) {
  for (const char* ending : {".stl", ".ply", ".off"})
    for (const Encoding encoding : {Encoding::Binary, Encoding::Text}) {
      const std::string whole = openmesh::mesh_bytes(tetrahedron(), ending, encoding).bytes;
      for (const double part : {0.3, 0.6, 0.9})
        EXPECT_NE(
            refusal(
                whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))),
                ending),
            "")
            << ending << " " << part;
    }
}

}  // namespace
}  // namespace blossom
