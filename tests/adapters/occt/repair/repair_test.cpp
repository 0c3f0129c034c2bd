// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/support/loose_shapes.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

using Numbers = std::vector<int>;
using testing::cylinder_with_loose_image;
using testing::cylinder_with_wide_rim;
using testing::image_of;
using testing::rims_of;
using testing::side_of;

// Faces 1 to 3 have a loose image, 4 to 6 a rim that is too wide, 7 to 12 are a sound box.
TopoDS_Shape patients() {
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, cylinder_with_loose_image(0.01));
  builder.Add(all, cylinder_with_wide_rim(1e-5));
  builder.Add(all, BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  return BRepBuilderAPI_Copy(all).Shape();
}

// All that repairs may change of a face: tolerances, and points of images.
std::vector<double> state_of(const TopoDS_Face& face) {
  std::vector<double> state;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    state.push_back(BRep_Tool::Tolerance(edge));
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) image = BRep_Tool::CurveOnSurface(edge, face, first, last);
    for (int i = 0; !image.IsNull() && i <= 7; ++i) {
      const gp_Pnt2d at = image->Value(first + i * (last - first) / 7);
      state.insert(state.end(), {at.X(), at.Y()});
    }
  }
  for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
    state.push_back(BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
  return state;
}

std::vector<std::vector<double>> states_of(const TopoDS_Shape& shape) {
  std::vector<std::vector<double>> states;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) states.push_back(state_of(TopoDS::Face(faces(i))));
  return states;
}

std::vector<std::vector<double>> repaired_at_once(const TopoDS_Shape& shape) {
  Repairer(shape, StatedTolerances::Raised).repair_all({});
  return states_of(shape);
}

TEST(Repairs, TellWhatTheyChangedByNumber) {
  const Repairs made = Repairer(patients(), StatedTolerances::Raised).repair_all({});
  ASSERT_EQ(made.remade.size(), 1U);
  EXPECT_EQ(made.remade.front().face, 1);
  EXPECT_NEAR(made.largest_gap(), 0.01, 1e-9);
  ASSERT_EQ(made.edges.size(), 1U);
  EXPECT_EQ(made.vertices.size(), 1U);
  EXPECT_NEAR(made.largest_tolerance(), 1.1e-5, 1e-9);
  EXPECT_TRUE(made.missing.empty());
}

TEST(Repairs, OfAFaceAreThoseOfAllWhicheverComesFirst) {
  const auto at_once = repaired_at_once(patients());
  Numbers order(at_once.size());
  std::iota(order.begin(), order.end(), 1);
  for (std::size_t turn = 0; turn < order.size(); ++turn) {
    std::rotate(order.begin(), order.begin() + 1, order.end());
    for (const bool backwards : {false, true}) {
      Numbers one_by_one = order;
      if (backwards) std::reverse(one_by_one.begin(), one_by_one.end());
      const TopoDS_Shape shape = patients();
      Repairer repairer(shape, StatedTolerances::Raised);
      for (const int number : one_by_one) {
        repairer.repair({number}, {});
        const auto now = static_cast<std::size_t>(number) - 1;
        EXPECT_EQ(states_of(shape)[now], at_once[now]) << "face " << number;
      }
      EXPECT_EQ(states_of(shape), at_once) << "from face " << one_by_one.front();
    }
  }
}

TEST(Repairs, LeaveFacesAloneThatAreNotAskedFor) {
  const TopoDS_Shape shape = patients();
  const auto given = states_of(shape);
  Repairer repairer(shape, StatedTolerances::Raised);
  EXPECT_TRUE(repairer.repair({7, 12}, {}).empty());
  EXPECT_EQ(states_of(shape), given);
  EXPECT_FALSE(repairer.repair({4}, {}).empty());
  for (const std::size_t other : {0U, 1U, 2U}) EXPECT_EQ(states_of(shape)[other], given[other]);
}

TEST(Repairs, AreMadeOnce) {
  Repairer repairer(patients(), StatedTolerances::Raised);
  EXPECT_FALSE(repairer.repair({1, 4}, {}).empty());
  EXPECT_TRUE(repairer.repair({1, 4}, {}).empty());
  EXPECT_TRUE(repairer.repair_all({}).empty());
}

TEST(Repairs, RaiseNoTolerancesThatAFileStates) {
  const Repairs made = Repairer(patients(), StatedTolerances::Kept).repair_all({});
  EXPECT_TRUE(made.edges.empty() && made.vertices.empty());
  EXPECT_EQ(made.remade.size(), 1U);
}

TEST(Repairs, AddImagesThatAreMissing) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  const TopoDS_Face side = side_of(cylinder);
  const TopoDS_Edge rim = rims_of(cylinder).front();
  BRep_Builder().UpdateEdge(rim, Handle(Geom2d_Curve)(), side, 1e-7);
  ASSERT_TRUE(image_of(rim, side).IsNull());
  const Repairs made = Repairer(cylinder, StatedTolerances::Kept).repair({2}, {});
  ASSERT_EQ(made.missing.size(), 1U);
  EXPECT_EQ(made.missing.front().face, 1);
  EXPECT_TRUE(made.missing.front().added);
  EXPECT_FALSE(image_of(rim, side).IsNull());
}

TEST(Repairs, EndWhenTheyAreToldTo) {
  const TopoDS_Shape shape = patients();
  Repairer repairer(shape, StatedTolerances::Raised);
  int asked = 0;
  const auto stop = [&] {
    if (++asked == 3) throw std::runtime_error("stop");
  };
  EXPECT_THROW(repairer.repair_all(stop), std::runtime_error);
  EXPECT_EQ(asked, 3);
  repairer.repair_all({});
  EXPECT_EQ(states_of(shape), repaired_at_once(patients()));
}

TEST(Repairs, OfAModelWaitUntilTheyAreAskedFor) {
  Model model;
  const TopoDS_Shape cylinder = cylinder_with_loose_image(0.01);
  model.add(cylinder, "part");
  EXPECT_GT(BRep_Tool::Tolerance(rims_of(cylinder).front()), 0.01);
  EXPECT_THROW(model.repair(Numbers{4}), BadModel);
  EXPECT_EQ(model.repair(Numbers{2}).remade.size(), 1U);  // its neighbour's, whose rim is its own
  EXPECT_LE(BRep_Tool::Tolerance(rims_of(cylinder).front()), 1e-6);
}

// A model of 190 faces, nearly all of which hang together by loose edges.
TEST(Repairs, OfAModelFromAFileAreThoseOfAllInReverseOrder) {
  const char* const folder = blossom::testing::test_data();
  if (folder == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  for (const char* const name : {"/models/nist_ctc_02.stp", "/models/boxed_sphere.step"}) {
    Model at_once = read_model(std::string(folder) + name);
    at_once.repair();
    Model one_by_one = read_model(std::string(folder) + name);
    for (int number = one_by_one.face_count(); number > 0; --number)
      one_by_one.repair(Numbers{number});
    EXPECT_EQ(states_of(one_by_one.shape()), states_of(at_once.shape())) << name;
  }
}

}  // namespace
}  // namespace blossom::occt
