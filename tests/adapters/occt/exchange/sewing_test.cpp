// SPDX-License-Identifier: LGPL-2.1-or-later
// Models of loose faces: sewn, they have the numbers, names and looks that they had.

#include <gtest/gtest.h>

#include <filesystem>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/face_colours.h"
#include "adapters/occt/shapes.h"
#include "tests/support/endless_edges.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

TopoDS_Shape plate() {
  const gp_Ax2 axis(gp_Pnt(10, 10, -1), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 20, 3).Shape(),
                         BRepPrimAPI_MakeCylinder(axis, 4, 5).Shape())
      .Shape();
}

std::vector<TopoDS_Shape> loose(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape());
  return faces;
}

int solids_in(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  return solids.Extent();
}

std::vector<Vec3> points_of(const Model& model) {
  std::vector<Vec3> points;
  for (int number = 1; number <= model.face_count(); ++number) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(model.face(number), properties);
    const gp_Pnt point = properties.CentreOfMass();
    points.push_back({point.X(), point.Y(), point.Z()});
  }
  return points;
}

class SewingOfFiles : public ::testing::Test {
 protected:
  SewingOfFiles() { quiet_messages(); }
  ~SewingOfFiles() override { std::filesystem::remove(file_); }

  Model iges_of(const TopoDS_Shape& shape, int mode) {
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", mode);
    writer.AddShape(shape);
    writer.ComputeModel();
    EXPECT_TRUE(writer.Write(file_.c_str()));
    return read_model(file_);
  }

  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() /
      ("sewing_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
       ".igs");
};

TEST_F(SewingOfFiles, MakesTheSolidsOfIgesInBothModes) {
  for (const int mode : {0, 1}) {
    Model model = iges_of(plate(), mode);
    const std::vector<Vec3> before = points_of(model);
    const Sewing told = model.sew();
    EXPECT_EQ(told.sewn(), mode == 0 ? 7 : 0);
    EXPECT_FALSE(told.renumbered);
    EXPECT_EQ(solids_in(model.shape()), 1);
    EXPECT_NEAR(testing::volume(model.shape()), testing::volume(plate()), 1e-3);
    const std::vector<Vec3> after = points_of(model);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i)
      EXPECT_LT(distance(after[i], before[i]), 1e-6) << "face " << i + 1;
  }
}

// IGES has conics of revolution as approximations, which swing about each other.
TEST_F(SewingOfFiles, MakesRoundSolidsToo) {
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeCone(10, 0, 20).Shape(), BRepPrimAPI_MakeCone(10, 4, 20).Shape(),
        BRepPrimAPI_MakeCylinder(10.05, 100).Shape(), BRepPrimAPI_MakeSphere(10).Shape(),
        BRepPrimAPI_MakeTorus(20, 5).Shape()}) {
    Model model = iges_of(shape, 0);
    EXPECT_EQ(model.sew().solids.size(), 1U);
    EXPECT_NEAR(testing::volume(model.shape()), testing::volume(shape),
                1e-4 * testing::volume(shape));
  }
}

TEST(Sewing, OfSingleFacesKeepsTheirNamesAndColours) {
  Model model;
  int number = 0;
  for (const TopoDS_Shape& face : loose(plate())) {
    const double red = ++number == 3 ? 1 : 0;
    model.add(face, "F" + std::to_string(number),
              number == 2 ? std::vector<double>{} : std::vector<double>{red, 0.5, 0});
  }
  const std::vector<std::string> names = model.face_names();
  const auto colours = face_colours(model);

  const Sewing told = model.sew();

  ASSERT_EQ(told.solids, std::vector<int>{7});
  EXPECT_EQ(model.face_names(), names);
  ASSERT_EQ(model.assembly().size(), 1U);
  EXPECT_EQ(model.assembly().front().solids, std::vector<int>{1});
  const auto now = face_colours(model);
  ASSERT_EQ(now.size(), colours.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    ASSERT_EQ(now[i].has_value(), colours[i].has_value()) << i;
    for (std::size_t k = 0; now[i] && k < 3; ++k) EXPECT_NEAR((*now[i])[k], (*colours[i])[k], 1e-6);
  }
}

TEST(Sewing, LeavesWhatDoesNotClose) {
  std::vector<TopoDS_Shape> faces = loose(plate());
  const std::vector<TopoDS_Shape> box =
      loose(BRepPrimAPI_MakeBox(gp_Pnt(50, 0, 0), 1, 1, 1).Shape());
  faces.insert(faces.end(), box.begin(), box.end() - 1);
  Model model;
  model.add(compound_of(faces), "both");
  const Sewing told = model.sew();
  EXPECT_EQ(told.loose, 12);
  EXPECT_EQ(told.solids, std::vector<int>{7});
  EXPECT_EQ(told.open_edges, 4);
  EXPECT_EQ(model.face_count(), 12);
  EXPECT_EQ(solids_in(model.shape()), 1);
}

TEST(Sewing, TellsWhatOpenCascadeFailsOnAndLeavesItLoose) {
  std::vector<TopoDS_Shape> faces = loose(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  faces.front() = testing::without_vertices(faces.front());
  Model model;
  model.add(compound_of(faces), "damaged");
  model.add(compound_of(loose(plate())), "sound");
  for (int i = 0; i < 2; ++i) {
    const Sewing told = model.sew();
    EXPECT_NE(told.failed.find("sewing loose faces: "), std::string::npos) << told.failed;
    EXPECT_EQ(told.loose, 13);
    EXPECT_EQ(told.solids, std::vector<int>{7});
    EXPECT_EQ(told.open_edges, 0);
    EXPECT_EQ(solids_in(model.shape()), 1);
  }
}

TEST(Sewing, TellsThatFacesOfSolidsWhichTakeTurnsAreRenumbered) {
  const std::vector<TopoDS_Shape> a = loose(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  const std::vector<TopoDS_Shape> b = loose(BRepPrimAPI_MakeBox(gp_Pnt(9, 0, 0), 1, 1, 1).Shape());
  std::vector<TopoDS_Shape> faces;
  for (std::size_t i = 0; i < a.size(); ++i) faces.insert(faces.end(), {a[i], b[i]});
  Model model;
  model.add(compound_of(faces), "both");
  const Sewing told = model.sew();
  EXPECT_EQ(told.solids, (std::vector<int>{6, 6}));
  EXPECT_TRUE(told.renumbered);
}

TEST(Sewing, LeavesSolidsAndSheetsAsTheyAre) {
  Model model;
  model.add(BRepPrimAPI_MakeSphere(1).Shape(), "ball");
  model.add(loose(plate()).front(), "sheet");
  const TopoDS_Shape before = model.shape();
  const Sewing told = model.sew();
  EXPECT_EQ(told.loose, 1);
  EXPECT_TRUE(told.solids.empty());
  EXPECT_EQ(told.open_edges, 0);
  EXPECT_TRUE(model.shape().IsSame(before));
}

TopoDS_Shape first_in(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  return TopExp_Explorer(shape, kind).Current();
}

TEST(Sewing, OfWhatIsOpenLeavesClosedShellsAndFacesThatCloseAlone) {
  for (const TopoDS_Shape& sheet :
       {first_in(plate(), TopAbs_SHELL), first_in(BRepPrimAPI_MakeSphere(1).Shape(), TopAbs_SHELL),
        first_in(BRepPrimAPI_MakeTorus(3, 1).Shape(), TopAbs_FACE)}) {
    Model model;
    model.add(sheet, "sheet");
    EXPECT_EQ(model.sew({}, {}, Sewable::Open).loose, 0);
    EXPECT_EQ(solids_in(model.shape()), 0);
    EXPECT_EQ(model.sew({}, {}, Sewable::All).solids.size(), 1U);
    EXPECT_EQ(solids_in(model.shape()), 1);
  }
}

TEST(Sewing, OfWhatIsOpenSewsFacesThatCloseTogether) {
  Model model;
  for (const TopoDS_Shape& face : loose(plate())) model.add(face, "plate");
  EXPECT_EQ(model.sew({}, {}, Sewable::Open).solids.size(), 1U);
}

// Left out beside a solid, the sheet would be no part of the answer.
TEST(Sewing, OfWhatIsOpenSewsClosedShellsBesideSolids) {
  const gp_Ax2 aside(gp_Pnt(100, 0, 0), gp_Dir(0, 0, 1));
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(aside, 1).Shape();
  Model beside;
  beside.add(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), "block");
  beside.add(first_in(ball, TopAbs_SHELL), "ball");
  EXPECT_EQ(beside.sew({}, {}, Sewable::Open).solids.size(), 1U);
  EXPECT_EQ(solids_in(beside.shape()), 2);
  Model made;
  for (const TopoDS_Shape& face : loose(plate())) made.add(face, "plate");
  made.add(first_in(ball, TopAbs_SHELL), "ball");
  EXPECT_EQ(made.sew({}, {}, Sewable::Open).solids.size(), 2U);
  EXPECT_EQ(solids_in(made.shape()), 2);
}

}  // namespace
}  // namespace blossom::occt
