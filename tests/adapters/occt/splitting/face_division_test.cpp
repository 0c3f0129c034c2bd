// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/face_division.h"

#include <gtest/gtest.h>

#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gp_Pln.hxx>

#include "tests/adapters/occt/trim_cases.h"

namespace blossom::occt {
namespace {

using namespace testing;

struct Faces {
  std::vector<FaceDivision> all;
  EdgeSplits splits{1e-7};
  DivisionJob job{splits, 1e-7};

  Faces() {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(BRepPrimAPI_MakeBox(2, 2, 2).Shape(), TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) all.emplace_back(TopoDS::Face(faces(i)));
  }

  // Each step for all faces before the next.
  void divide() {
    for (FaceDivision& face : all)
      if (!face.cuts().empty()) face.begin(job);
    for (FaceDivision& face : all) face.settle();
    for (FaceDivision& face : all) face.finish(job);
  }
};

int edges_of(const TopoDS_Face& face) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(face, TopAbs_EDGE, edges);
  return edges.Extent();
}

TEST(FaceDivision, NothingDividesWhatHasNoCuts) {
  Faces faces;
  faces.divide();
  EXPECT_EQ(faces.all.size(), 6u);
  for (const FaceDivision& face : faces.all) {
    ASSERT_EQ(face.split().pieces.size(), 1u);
    EXPECT_TRUE(face.split().pieces[0].face.IsSame(face.face()));
    EXPECT_EQ(face.splitter(), nullptr);
  }
}

// A cut through one face of a box splits an edge of each of two neighbours, which stay one piece.
TEST(FaceDivision, ACutSplitsTheEdgesOfNeighboursToo) {
  Faces faces;
  FaceDivision& first = faces.all[0];
  const double a = 0.5;
  double from[2], to[2];
  BRepTools::UVBounds(first.face(), from[0], to[0], from[1], to[1]);
  const double u = from[0] + a * (to[0] - from[0]);
  first.add_cut(line_cut(first.face(), {u, from[1]}, {u, to[1]}), {});
  faces.divide();
  EXPECT_EQ(first.split().pieces.size(), 2u);
  int with_five_edges = 0;
  for (std::size_t i = 1; i < faces.all.size(); ++i) {
    ASSERT_EQ(faces.all[i].split().pieces.size(), 1u);
    with_five_edges += edges_of(faces.all[i].split().pieces[0].face) == 5;
  }
  EXPECT_EQ(with_five_edges, 2);
}

TEST(FaceDivision, LeavesAFaceWholeWhateverWasToDivideIt) {
  Faces faces;
  FaceDivision& first = faces.all[0];
  first.add_cut(line_cut(first.face(), {1, 0}, {1, 2}), {});
  first.begin(faces.job);
  first.leave_whole();
  ASSERT_EQ(first.split().pieces.size(), 1u);
  EXPECT_TRUE(first.split().pieces[0].face.IsSame(first.face()));
}

TEST(FaceDivision, CutsBothFacesOfAPairAlongTheirCurve) {
  Faces faces;
  const TopoDS_Face tool =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(1, 1, 1), gp_Dir(1, 2, 3)), -5, 5, -5, 5);
  const ShapeIntersection found = intersect({faces.all[0].face()}, {tool});
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  const FaceCut a = cut_of_a(found.pairs[0], 0), b = cut_of_b(found.pairs[0], 0);
  const Interval domain = a.curve.domain();
  for (const double part : {0.1, 0.6}) {
    const double t = at(domain, part);
    const Vec3 p = point_at(a.curve, t);
    const Vec2 x = point_at(a.chart, t), y = point_at(b.chart, t);
    const gp_Pnt on_a = BRep_Tool::Surface(faces.all[0].face())->Value(x[0], x[1]);
    const gp_Pnt on_b = BRep_Tool::Surface(tool)->Value(y[0], y[1]);
    EXPECT_LE(on_a.Distance(gp_Pnt(p[0], p[1], p[2])), 1e-7);
    EXPECT_LE(on_b.Distance(gp_Pnt(p[0], p[1], p[2])), 1e-7);
  }
}

}  // namespace
}  // namespace blossom::occt
