// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces from pole to pole with holes: halves that readers of STEP understand.

#include "adapters/occt/repair/polar_faces.h"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/adapters/occt/polar_bodies.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::area_of;
using testing::bored;
using testing::polar_bodies;
using testing::PolarBody;

using testing::kPi;

// Holes on the seam, which they interrupt, beside it, and on both sides.
TEST(PolarFaces, AreCutIntoValidHalvesThatMakeThemUp) {
  for (const PolarBody& body : polar_bodies())
    for (const double angle : {0.0, 2.0, 6.0}) {
      const TopoDS_Shape shape = bored(body.shape, angle, 0.3);
      const auto halves = polar_faces(shape);
      ASSERT_EQ(halves.size(), 1U) << body.name << " at " << angle;
      const auto& [number, pieces] = *halves.begin();
      ASSERT_EQ(pieces.size(), 2U);
      double sum = 0;
      for (const TopoDS_Face& piece : pieces) {
        EXPECT_TRUE(BRepCheck_Analyzer(piece).IsValid());
        EXPECT_TRUE(polar_halves(piece).empty());
        sum += area(piece);
      }
      TopTools_IndexedMapOfShape faces;
      TopExp::MapShapes(shape, TopAbs_FACE, faces);
      const double whole = area(TopoDS::Face(faces(number)));
      EXPECT_NEAR(sum, whole, 1e-9 * whole) << body.name << " at " << angle;
    }
}

TEST(PolarFaces, LeaveOtherFacesAlone) {
  for (const PolarBody& body : polar_bodies())
    EXPECT_TRUE(polar_faces(body.shape).empty()) << body.name;
  EXPECT_TRUE(polar_faces(bored(BRepPrimAPI_MakeSphere(10, 0, kPi / 2).Shape(), 0, 0.4)).empty());
  EXPECT_TRUE(polar_faces(bored(BRepPrimAPI_MakeCone(10, 0, 20).Shape(), 0, 0.1)).empty());
}

// Without halves, Open CASCADE's reader gives the piece that was cut out for 8 of these 12.
TEST(PolarFaces, ComeBackFromStepAsTheyWere) {
  const testing::Folder folder;
  for (const PolarBody& body : polar_bodies())
    for (const double angle : {0.0, 2.0, 6.0}) {
      const TopoDS_Shape shape = bored(body.shape, angle, 0.3);
      Model model;
      model.add(shape, "part");
      write_model(model, folder / "part.step");
      const Model back = read_model(folder / "part.step");
      EXPECT_TRUE(back.reading().losses.empty());
      EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid());
      EXPECT_NEAR(area_of(back.shape()), area_of(shape), 1e-6 * area_of(shape))
          << body.name << " at " << angle;
      EXPECT_EQ(model.face_count(), 3) << "the model that was written has changed";
    }
}

}  // namespace
}  // namespace blossom::occt
