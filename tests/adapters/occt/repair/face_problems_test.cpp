// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with faces: in words, for many as for one, and without checks that are left out.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/soundness.h"

namespace blossom::occt {
namespace {

using Problems = std::vector<std::string>;

const CheckRunner kDirectly = [](const std::string&, const std::function<void()>& work) {
  work();
  return true;
};

// A bow tie in the plane z = 0.
TopoDS_Face crossed() {
  BRepBuilderAPI_MakePolygon wire(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(0, 1, 0),
                                  gp_Pnt(1, 1.5, 0), true);
  return BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire()).Face();
}

// A cylinder one of whose rims is looser than it says.
TopoDS_Face loose() {
  const TopoDS_Face face = BRepPrimAPI_MakeCylinder(1, 2).Face();
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    double from = 0, to = 0;
    const auto line =
        Handle(Geom2d_Line)::DownCast(BRep_Tool::CurveOnSurface(edge, face, from, to));
    if (line.IsNull() || line->Direction().Y() != 0 || line->Location().Y() != 2) continue;
    BRep_Builder().UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(0, 1.99), gp_Dir2d(1, 0)), face, 1e-7);
  }
  return face;
}

std::vector<TopoDS_Face> many() {
  std::vector<TopoDS_Face> faces;
  for (int i = 0; i < 20; ++i) {
    for (TopExp_Explorer it(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), TopAbs_FACE); it.More();
         it.Next())
      faces.push_back(TopoDS::Face(it.Current()));
    faces.push_back(i % 3 == 0 ? crossed() : loose());
  }
  return faces;
}

std::vector<int> numbers_of(const std::vector<TopoDS_Face>& faces) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < faces.size(); ++i) numbers.push_back(static_cast<int>(i) + 1);
  return numbers;
}

TEST(FaceProblems, AreWords) {
  EXPECT_EQ(face_problems(crossed()).front(), "a wire meets itself");
  EXPECT_TRUE(face_fault(crossed()).starts_with("a wire meets itself"));
  const std::string fault = face_fault(loose());
  EXPECT_NE(fault.find("an edge has curves in space and on the face that are apart"),
            std::string::npos)
      << fault;
  EXPECT_EQ(face_fault(BRepPrimAPI_MakeCylinder(1, 2).Face()), "");
}

// Half a disc whose straight edge has a direction that no vector can be made of, as files may.
TopoDS_Face of_wild_numbers() {
  const gp_Circ round(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 4);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(round, 0, M_PI).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(-4, 0, 0), gp_Pnt(4, 0, 0)).Edge());
  std::ostringstream out;
  BRepTools::Write(BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire()).Face(), out);
  std::string text = out.str();
  const std::string line = "\n1 -4 0 0 1 0 0";
  EXPECT_NE(text.find(line), std::string::npos);
  text.replace(text.find(line), line.size(), "\n1 -4 0 0 1e300 0 0");
  std::istringstream in(text);
  TopoDS_Shape shape;
  BRepTools::Read(shape, in, BRep_Builder());
  return TopoDS::Face(shape);
}

TEST(FaceProblems, OfNumbersThatNoCheckCanTakeAreProblemsOfTheFace) {
  const TopoDS_Face face = of_wild_numbers();
  EXPECT_NE(face_fault(face), "");
  const std::vector<TopoDS_Face> faces(20, face);
  const auto found = face_problems(faces, numbers_of(faces), kDirectly);
  for (const Problems& problems : found) EXPECT_FALSE(problems.empty());
}

TEST(FaceProblems, OfManyFacesAreThoseOfEach) {
  const std::vector<TopoDS_Face> faces = many();
  const auto found = face_problems(faces, numbers_of(faces), kDirectly);
  ASSERT_EQ(found.size(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) EXPECT_EQ(found[i], face_problems(faces[i])) << i;
}

TEST(FaceProblems, LeaveOutNoMoreThanTheChecksThatFail) {
  const std::vector<TopoDS_Face> faces = many();
  const std::set<std::string> failing = {"checking faces", "checking face 3"};
  const auto found =
      face_problems(faces, numbers_of(faces), [&](const std::string& what, const auto& work) {
        if (failing.contains(what)) return false;
        work();
        return true;
      });
  for (std::size_t i = 0; i < faces.size(); ++i)
    EXPECT_EQ(found[i], i == 2 ? Problems{kUnchecked} : face_problems(faces[i])) << i;
}

TEST(FaceProblems, AreTheSameInEveryCheckOfAShape) {
  const TopoDS_Face face = crossed();
  const Soundness left_out = soundness(face, [](const std::string&, const auto&) { return false; });
  ASSERT_EQ(left_out.faces.front().problems.size(), 1U);
  EXPECT_EQ(left_out.faces.front().problems.front().what, kUnchecked);
  EXPECT_EQ(soundness(face).faces.front().problems.front().what, "a wire meets itself");
}

}  // namespace
}  // namespace blossom::occt
