// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces on closed surfaces in STEP files of others: the side that the file says.

#include "adapters/occt/exchange/step/step_sides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <regex>
#include <string>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/adapters/occt/polar_bodies.h"

namespace blossom::occt {
namespace {

using testing::area_of;
using testing::bored;
using testing::content;
using testing::polar_bodies;
using testing::PolarBody;
using testing::write_content;

/// As Open CASCADE writes it, which leaves poles and seams to the reader.
void write_plainly(const TopoDS_Shape& shape, const std::filesystem::path& file) {
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  writer.Write(file.c_str());
}

double volume_of(const TopoDS_Shape& shape) {
  double sum = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    sum += cone_volume(TopoDS::Face(it.Current()), {});
  return sum;
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  int found = 0;
  for (TopExp_Explorer it(shape, kind); it.More(); it.Next()) ++found;
  return found;
}

void expect_as(const Model& back, const TopoDS_Shape& shape, const std::string& what) {
  EXPECT_TRUE(back.reading().losses.empty()) << what;
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid()) << what;
  EXPECT_EQ(count_of(back.shape(), TopAbs_SOLID), count_of(shape, TopAbs_SOLID)) << what;
  const double area = area_of(shape), volume = volume_of(shape);
  EXPECT_NEAR(area_of(back.shape()), area, 1e-5 * area) << what;
  EXPECT_NEAR(volume_of(back.shape()), volume, 1e-5 * std::abs(volume)) << what;
}

TopoDS_Shape bored_through(const TopoDS_Shape& body, double angle) {
  return bored(bored(body, angle, 0.3), angle + 3.1, -0.3);
}

TopoDS_Shape ring() {
  const gp_Ax2 axis(gp_Pnt(10, 0, 0), gp_Dir(0.3, 0, 1));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(10, 4).Shape(),
                         BRepPrimAPI_MakeCylinder(axis, 1, 20).Shape())
      .Shape();
}

// Holes on the seam, which they interrupt, and beside it; one hole, and two.
TEST(StepSides, AreThoseOfTheFile) {
  const testing::Folder folder;
  for (const PolarBody& body : polar_bodies())
    for (const double angle : {0.1, 2.0})
      for (const bool through : {false, true}) {
        const TopoDS_Shape shape =
            through ? bored_through(body.shape, angle) : bored(body.shape, angle, 0.3);
        write_plainly(shape, folder / "part.step");
        expect_as(read_model(folder / "part.step"), shape,
                  body.name + (" at " + std::to_string(angle)) + (through ? ", through" : ""));
      }
}

// As other systems write them: the hole's border is the face's only one.
TEST(StepSides, AreThoseOfTheFileWithoutLoopsAtPoles) {
  const testing::Folder folder;
  for (const PolarBody& body : polar_bodies()) {
    const TopoDS_Shape shape = bored(body.shape, 2, 0.3);
    write_plainly(shape, folder / "part.step");
    const std::string text = content(folder / "part.step");
    std::smatch loop, bound;
    ASSERT_TRUE(std::regex_search(text, loop, std::regex("(#[0-9]+) = VERTEX_LOOP"))) << body.name;
    ASSERT_TRUE(std::regex_search(
        text, bound, std::regex("(#[0-9]+) = FACE_BOUND\\('',\\s*" + loop[1].str() + ",")));
    const std::string left =
        std::regex_replace(text, std::regex("\\(" + bound[1].str() + ","), "(");
    ASSERT_NE(left, text);
    write_content(folder / "part.step", left);
    expect_as(read_model(folder / "part.step"), shape, body.name);
  }
}

TEST(StepSides, OfARingWithAHoleAreThoseOfTheFile) {
  const testing::Folder folder;
  write_plainly(ring(), folder / "ring.step");
  expect_as(read_model(folder / "ring.step"), ring(), "ring");
}

// Where borders of planes run the wrong way, too, those of balls are not believed.
TEST(StepSides, AreNotBelievedOfFilesWithBordersTurned) {
  const testing::Folder folder;
  const gp_Ax2 axis(gp::Origin(), gp_Dir(0.4, 0.8, 0.3));
  const TopoDS_Shape shape = BRepAlgoAPI_Common(BRepPrimAPI_MakeSphere(10).Shape(),
                                                BRepPrimAPI_MakeCylinder(axis, 2, 25).Shape())
                                 .Shape();
  write_plainly(shape, folder / "pin.step");
  expect_as(read_model(folder / "pin.step"), shape, "as written");
  std::string text = content(folder / "pin.step");
  text = std::regex_replace(text, std::regex("(FACE_BOUND\\('',\\s*#[0-9]+,\\s*)\\.T\\."), "$1.X.");
  text = std::regex_replace(text, std::regex("(FACE_BOUND\\('',\\s*#[0-9]+,\\s*)\\.F\\."), "$1.T.");
  text = std::regex_replace(text, std::regex("\\.X\\."), ".F.");
  ASSERT_NE(text, content(folder / "pin.step"));
  write_content(folder / "pin.step", text);
  expect_as(read_model(folder / "pin.step"), shape, "turned");
}

}  // namespace
}  // namespace blossom::occt
