// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/openmesh/meshes.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultPolyMesh.hh>

#include <cmath>
#include <fstream>
#include <string>

#include "core/base/errors.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::random_patch;
using testing::seeded;

constexpr double kTolerance = 0.01;
constexpr double kSingle = 0x1p-22;  // coordinates in the files are floats

// A quarter of a cylinder of radius 1 from z = 0 to 1, turned by `angle`.
RationalBezierPatch quarter(double angle) {
  const double c = std::cos(angle), s = std::sin(angle), w = std::sqrt(0.5);
  const Vec3 arc[] = {{1, 0, 1}, {1, 1, w}, {0, 1, 1}};
  RationalBezierPatch patch{Grid<Vec4>(3, 2)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) {
      const auto& [x, y, weight] = arc[i].coordinates;
      patch.points(i, j) = {weight * (c * x - s * y), weight * (s * x + c * y), weight * j, weight};
    }
  return patch;
}

BezierSurface cylinder() {
  BezierSurface surface;
  surface.patches = Grid<RationalBezierPatch>(4, 1);
  const double quarter_turn = std::acos(0.0);
  for (int i = 0; i <= 4; ++i) surface.u_knots.push_back(i * quarter_turn);
  for (int i = 0; i < 4; ++i) surface.patches(i, 0) = quarter(i * quarter_turn);
  surface.v_knots = {0, 1};
  surface.u_law = ParameterLaw::Angle;
  surface.rational = true;
  surface.closed_u = true;
  return surface;
}

// The graph z = u^2 - u v of degrees 2 and 1.
BezierPatch graph() {
  BezierPatch patch{Grid<Vec3>(3, 2)};
  const double z[3][2] = {{0, 0}, {0, -0.5}, {1, 0}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) patch.points(i, j) = {i / 2.0, 1.0 * j, z[i][j]};
  return patch;
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& name)
      : path_(std::filesystem::path(::testing::TempDir()) /
              ("blossom_" + std::to_string(::getpid()) + "_" + name)) {}
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

OpenMesh::PolyMesh read(const std::filesystem::path& file) {
  OpenMesh::PolyMesh mesh;
  EXPECT_TRUE(OpenMesh::IO::read_mesh(mesh, file.string())) << file;
  return mesh;
}

// Corners, middles of edges and centre of a face.
std::vector<Vec3> samples(const OpenMesh::PolyMesh& mesh, OpenMesh::SmartFaceHandle face) {
  std::vector<Vec3> corners;
  Vec3 sum{};
  for (const auto vertex : face.vertices()) {
    const auto p = mesh.point(vertex);
    corners.push_back({p[0], p[1], p[2]});
    sum += corners.back();
  }
  std::vector<Vec3> result = corners;
  for (std::size_t k = 0; k < corners.size(); ++k)
    result.push_back((corners[k] + corners[(k + 1) % corners.size()]) * 0.5);
  result.push_back(sum * (1 / static_cast<double>(corners.size())));
  return result;
}

class MeshFile : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshFile, OfAGraphStaysWithinTheToleranceOfIt) {
  const TemporaryFile file(std::string("graph") + GetParam());
  openmesh::write_mesh(openmesh::tessellation(graph(), kTolerance), file.path());

  const OpenMesh::PolyMesh mesh = read(file.path());

  EXPECT_GT(mesh.n_faces(), 8u);
  for (const auto face : mesh.faces())
    for (const Vec3& p : samples(mesh, face))
      EXPECT_LE(std::abs(p[2] - (p[0] * p[0] - p[0] * p[1])), kTolerance + kSingle);
}

TEST_P(MeshFile, OfACylinderStaysWithinTheToleranceOfIt) {
  const TemporaryFile file(std::string("cylinder") + GetParam());
  openmesh::write_mesh(openmesh::tessellation(cylinder(), kTolerance), file.path());

  const OpenMesh::PolyMesh mesh = read(file.path());

  double highest = 0;
  for (const auto face : mesh.faces())
    for (const Vec3& p : samples(mesh, face)) {
      EXPECT_LE(std::abs(std::hypot(p[0], p[1]) - 1), kTolerance + kSingle);
      highest = std::max(highest, p[2]);
    }
  EXPECT_EQ(highest, 1);
}

TEST_P(MeshFile, KeepsTheFacesAndTheDigitsOfSinglePrecision) {
  auto random = seeded(1);
  const BezierPatch patch = random_patch(random, 3, 2);
  const openmesh::Mesh net = openmesh::control_net(patch);
  const TemporaryFile file(std::string("net") + GetParam());
  openmesh::write_mesh(net, file.path());

  const OpenMesh::PolyMesh mesh = read(file.path());

  const bool triangles = std::string(GetParam()) == ".stl";
  ASSERT_EQ(mesh.n_vertices(), 12u);
  EXPECT_EQ(mesh.n_faces(), triangles ? 12u : 6u);
  for (const Vec3& p : net.points) {
    double nearest = 1;
    for (const auto vertex : mesh.vertices()) {
      const auto q = mesh.point(vertex);
      nearest = std::min(nearest, max_norm(p - Vec3{q[0], q[1], q[2]}));
    }
    EXPECT_LE(nearest, triangles ? 1e-9 + 0x1p-25 : 0x1p-25);  // .stl has ten digits
  }
}

INSTANTIATE_TEST_SUITE_P(Endings, MeshFile, ::testing::Values(".obj", ".off", ".ply", ".stl"));

TEST(Tessellation, JoinsPatchesAndTheSeamOfACylinder) {
  const TemporaryFile file("joined.off");
  openmesh::write_mesh(openmesh::tessellation(cylinder(), kTolerance), file.path());

  const OpenMesh::PolyMesh mesh = read(file.path());

  // A band: Euler characteristic 0, and its border edges are those of the two circles.
  EXPECT_EQ(static_cast<int>(mesh.n_vertices() + mesh.n_faces()), static_cast<int>(mesh.n_edges()));
  int border = 0, on_circles = 0;
  for (const auto edge : mesh.edges()) border += edge.is_boundary() ? 1 : 0;
  for (const auto vertex : mesh.vertices())
    on_circles += mesh.point(vertex)[2] == 0 || mesh.point(vertex)[2] == 1 ? 1 : 0;
  EXPECT_EQ(border, on_circles);
}

TEST(Tessellation, IsOrientedByTheNormalOfTheSurface) {
  const openmesh::Mesh mesh = openmesh::tessellation(graph(), kTolerance);

  EXPECT_GT(mesh.faces.size(), 1u);
  for (const auto& face : mesh.faces) {
    const auto point = [&](std::size_t k) {
      return mesh.points[static_cast<std::size_t>(face[k])];
    };
    EXPECT_GT(cross(point(1) - point(0), point(2) - point(0))[2], 0);
  }
}

TEST(Tessellation, LeavesOutTrianglesOfNoArea) {
  BezierPatch triangle{Grid<Vec3>(2, 2)};  // one side is a point
  triangle.points(0, 1) = {1, 0, 0};
  triangle.points(1, 0) = triangle.points(1, 1) = {0, 1, 0};

  const openmesh::Mesh mesh = openmesh::tessellation(triangle, 10.0);

  EXPECT_EQ(mesh.faces.size(), 1u);
}

TEST(ControlNet, OfASurfaceHasTheNetOfEachPatch) {
  const openmesh::Mesh net = openmesh::control_net(cylinder());

  EXPECT_EQ(net.points.size(), 24u);
  EXPECT_EQ(net.faces.size(), 8u);
  for (const auto& face : net.faces) EXPECT_EQ(face.size(), 4u);
  EXPECT_NEAR(distance(net.points[2], {1, 1, 0}), 0, 1e-15);
}

TEST(MeshFile, RefusesAFolderThatIsNotThere) {
  const std::filesystem::path file = "no_such_folder/mesh.obj";
  try {
    openmesh::write_mesh(openmesh::control_net(graph()), file);
    FAIL() << "wrote into a folder that is not there";
  } catch (const openmesh::WriteFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find(file.string()), std::string::npos);
  }
}

TEST(MeshFile, RefusesEndingsItDoesNotKnow) {
  EXPECT_THROW(openmesh::write_mesh(openmesh::control_net(graph()), "mesh.stp"),
               openmesh::WriteFailure);
  EXPECT_FALSE(std::filesystem::exists("mesh.stp"));
}

TEST(MeshFile, LeavesTheOldFileWhenItRefuses) {
  const TemporaryFile file("kept.obj");
  std::ofstream(file.path()) << "kept";
  const openmesh::Mesh fin{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
                           {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};

  EXPECT_THROW(openmesh::write_mesh(fin, file.path()), openmesh::WriteFailure);

  std::string content;
  std::ifstream(file.path()) >> content;
  EXPECT_EQ(content, "kept");
}

TEST(Tessellation, RefusesASurfaceWithoutPatches) {
  EXPECT_THROW(openmesh::tessellation(BezierSurface{}, kTolerance), InvalidInput);
  EXPECT_THROW(openmesh::tessellation(graph(), -1), InvalidInput);
}

}  // namespace
}  // namespace blossom
