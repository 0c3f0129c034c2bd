// SPDX-License-Identifier: GPL-3.0-or-later
// Watertight shapes are closed surfaces without self-intersections, by CGAL: meshed by Open
// CASCADE, and by samples that neighbours share.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/cgal/gpl/mesh_check.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "adapters/occt/watertight.h"
#include "core/forms/de_casteljau.h"

namespace blossom {
namespace {

class Mesh {
 public:
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;

  void add(int a, int b, int c) {
    if (a != b && b != c && c != a) triangles.push_back({a, b, c});
  }
};

// Nodes are one if their coordinates are equal bit for bit.
Mesh meshed(const TopoDS_Shape& shape, double deflection) {
  const BRepMesh_IncrementalMesh mesher(shape, deflection);
  EXPECT_TRUE(mesher.IsDone());
  Mesh mesh;
  std::map<std::array<double, 3>, int> known;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) own =
        BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
    if (own.IsNull()) {
      ADD_FAILURE() << "a face has no triangles";
      continue;
    }
    const auto node = [&](int i) {
      const gp_Pnt p = own->Node(i);
      const auto [found, is_new] =
          known.try_emplace({p.X(), p.Y(), p.Z()}, static_cast<int>(mesh.points.size()));
      if (is_new) mesh.points.push_back({p.X(), p.Y(), p.Z()});
      return found->second;
    };
    for (int k = 1; k <= own->NbTriangles(); ++k) {
      int a = 0, b = 0, c = 0;
      own->Triangle(k).Get(a, b, c);
      if (it.Current().Orientation() == TopAbs_REVERSED) std::swap(b, c);
      mesh.add(node(a), node(b), node(c));
    }
  }
  return mesh;
}

// Each side is sampled once, by its curve, and each piece inside.
class Sampler {
 public:
  Sampler(const occt::WatertightShape& shape, int parts) : made_(shape.pieces), parts_(parts) {
    mesh_.points = made_.vertices;
    for (const WatertightSide& side : made_.sides) {
      first_of_side_.push_back(static_cast<int>(mesh_.points.size()));
      for (int k = 1; k < parts_ && !side.curve.points.empty(); ++k)
        mesh_.points.push_back(point_at(side.curve, static_cast<double>(k) / parts_));
    }
    for (const WatertightPiece& piece : made_.pieces) {
      const auto face = shape.faces[static_cast<std::size_t>(piece.face)].front();
      reversed_ = face.Orientation() == TopAbs_REVERSED;
      if (const auto* triangle = std::get_if<BezierTriangle>(&piece.form))
        add(piece, *triangle);
      else
        add(piece, std::get<BezierPatch>(piece.form));
    }
  }

  const Mesh& mesh() const { return mesh_; }

 private:
  // Sample k of a side as the piece walks it.
  int on_side(const WatertightPiece& piece, std::size_t side, int k) const {
    const std::size_t next = (side + 1) % piece.vertices.size();
    if (k == 0) return piece.vertices[side];
    if (k == parts_) return piece.vertices[next];
    const auto number = static_cast<std::size_t>(piece.sides[side]);
    if (made_.sides[number].curve.points.empty()) return piece.vertices[side];
    return first_of_side_[number] + (piece.along[side] ? k : parts_ - k) - 1;
  }

  void add(int a, int b, int c) { reversed_ ? mesh_.add(a, c, b) : mesh_.add(a, b, c); }

  int inside(const Vec3& p) {
    mesh_.points.push_back(p);
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  void add(const WatertightPiece& piece, const BezierTriangle& triangle) {
    std::map<std::pair<int, int>, int> at;  // by the shares of a and b
    for (int i = 0; i <= parts_; ++i)
      for (int j = 0; i + j <= parts_; ++j) {
        const int k = parts_ - i - j;
        at[{i, j}] = k == 0   ? on_side(piece, 0, j)
                     : i == 0 ? on_side(piece, 1, k)
                     : j == 0 ? on_side(piece, 2, i)
                              : inside(point_at(triangle, static_cast<double>(i) / parts_,
                                                static_cast<double>(j) / parts_));
      }
    for (int i = 0; i < parts_; ++i)
      for (int j = 0; i + j < parts_; ++j) {
        add(at[{i, j}], at[{i + 1, j}], at[{i, j + 1}]);
        if (i + j + 1 < parts_) add(at[{i + 1, j}], at[{i + 1, j + 1}], at[{i, j + 1}]);
      }
  }

  void add(const WatertightPiece& piece, const BezierPatch& patch) {
    Grid<int> at(parts_ + 1, parts_ + 1);
    for (int i = 0; i <= parts_; ++i)
      for (int j = 0; j <= parts_; ++j)
        at(i, j) = j == 0        ? on_side(piece, 0, i)
                   : i == parts_ ? on_side(piece, 1, j)
                   : j == parts_ ? on_side(piece, 2, parts_ - i)
                   : i == 0      ? on_side(piece, 3, parts_ - j)
                                 : inside(point_at(patch, static_cast<double>(i) / parts_,
                                                   static_cast<double>(j) / parts_));
    for (int i = 0; i < parts_; ++i)
      for (int j = 0; j < parts_; ++j) {
        add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }

  const WatertightPieces& made_;
  int parts_;
  bool reversed_ = false;
  std::vector<int> first_of_side_;
  Mesh mesh_;
};

// Three nodes of Open CASCADE's mesh on one ray from the collapsed corner of a flat piece lie on a
// line, so there its mesh may have triangles of no area, turned over by rounding.
enum class Faces { Curved, Flat };

void expect_closed(const Mesh& mesh, double volume, double error, Faces faces = Faces::Curved) {
  const cgal::MeshCheck check = cgal::check_mesh(mesh.points, mesh.triangles);
  EXPECT_TRUE(check.manifold);
  EXPECT_TRUE(check.closed);
  if (faces == Faces::Curved) {
    EXPECT_EQ(check.self_intersections, 0);
    EXPECT_EQ(check.degenerate_triangles, 0);
  }
  EXPECT_NEAR(check.volume, volume, error * volume);
}

void expect_watertight(const TopoDS_Shape& a, const TopoDS_Shape& b, Faces faces) {
  const occt::SolidTrimResult fused =
      occt::trim_solids(occt::trim_tool(a), {occt::trim_tool(b)}, occt::SolidOperation::Fuse);
  ASSERT_EQ(fused.solids.size(), 1u);
  const occt::WatertightShape made = occt::watertight(fused.solids.front());
  ASSERT_TRUE(made.pieces.obstacle.empty()) << made.pieces.obstacle;

  {
    SCOPED_TRACE("meshed by Open CASCADE");
    expect_closed(meshed(made.shape, 1e-2), fused.volumes.back().fuse, 0.05, faces);
  }
  SCOPED_TRACE("meshed by samples");
  expect_closed(Sampler(made, 4).mesh(), fused.volumes.back().fuse, 0.01);
}

TEST(WatertightMesh, OfTwoSpheresIsClosed) {
  expect_watertight(BRepPrimAPI_MakeSphere(1), BRepPrimAPI_MakeSphere(gp_Pnt(0.7, 0.2, 0.3), 0.8),
                    Faces::Curved);
}

TEST(WatertightMesh, OfTwoBoxesIsClosed) {
  expect_watertight(BRepPrimAPI_MakeBox(2, 2, 2), BRepPrimAPI_MakeBox(gp_Pnt(1, 0.5, 0.7), 3, 1, 1),
                    Faces::Flat);
}

TEST(WatertightMesh, OfABoxAndACylinderIsClosed) {
  const gp_Ax2 axis(gp_Pnt(1, 1, 1), gp_Dir(0.2, 0.1, 1));
  expect_watertight(BRepPrimAPI_MakeBox(2, 2, 2), BRepPrimAPI_MakeCylinder(axis, 0.6, 3),
                    Faces::Flat);
}

// Its blends join their neighbours smoothly along edges of many short pieces: a facet of three
// points of such an edge may lie on the other side of it.
TEST(WatertightMesh, OfACrankArmDoesNotCrossItself) {
  const char* folder = std::getenv("BLOSSOM_TEST_DATA");
  if (!folder) GTEST_SKIP() << "set BLOSSOM_TEST_DATA";
  const occt::Model model = occt::read_model(std::string(folder) + "/models/crankarm.brep");
  const occt::WatertightShape made = occt::watertight(model.shape());
  ASSERT_EQ(made.pieces.obstacle, "");
  expect_closed(Sampler(made, 4).mesh(), 54074, 1e-3);
}

}  // namespace
}  // namespace blossom
