// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes as bytes come back to the last bit, or are refused.

#include "adapters/occt/exact/exact_bytes.h"

#include <gtest/gtest.h>

#include <random>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Elips.hxx>

#include "adapters/occt/base/compounds.h"

namespace blossom::occt {
namespace {

// Directions whose lengths are not 1 to the last bit, as they come out of STEP.
class AnyDirections {
 public:
  gp_Dir direction() { return {number_(random_), number_(random_), number_(random_)}; }
  gp_Ax2 place() {
    const gp_Dir z = direction();
    gp_Dir x = direction();
    while (x.IsParallel(z, 0.1)) x = direction();
    return {gp_Pnt(number_(random_), number_(random_), number_(random_)), z, x};
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> number_{-1, 1};
};

// One of each kind of placement.
TopoDS_Shape odd_shapes(AnyDirections& any) {
  const TopoDS_Shape arc = BRepBuilderAPI_MakeEdge(gp_Elips(any.place(), 2, 1), 0, 1).Shape();
  return compound_of(std::vector<TopoDS_Shape>{
      BRepPrimAPI_MakeCylinder(any.place(), 1, 2).Shape(),
      BRepPrimAPI_MakeCone(any.place(), 1, 2, 3).Shape(),
      BRepPrimAPI_MakeTorus(any.place(), 3, 1).Shape(),
      BRepPrimAPI_MakeBox(any.place(), 1, 2, 3).Shape(),
      BRepPrimAPI_MakePrism(arc, gp_Vec(any.direction())).Shape(),
      BRepPrimAPI_MakeRevol(arc, gp_Ax1(gp_Pnt(0, 0, 9), any.direction()), 1.0).Shape()});
}

TEST(ExactBytes, ComesBackToTheLastBit) {
  AnyDirections any;
  for (int trial = 0; trial < 20; ++trial) {
    const TopoDS_Shape shape = odd_shapes(any);
    const std::optional<std::string> bytes = exact_bytes(shape);
    ASSERT_TRUE(bytes) << trial;
    const TopoDS_Shape again = shape_of_exact_bytes(*bytes);
    TopExp_Explorer a(shape, TopAbs_FACE), b(again, TopAbs_FACE);
    for (; a.More(); a.Next(), b.Next()) {
      ASSERT_TRUE(b.More());
      const BRepAdaptor_Surface first(TopoDS::Face(a.Current())), second(TopoDS::Face(b.Current()));
      for (const double t : {0.1, 0.7}) {
        const gp_Pnt p = first.Value(t, 1 - t), q = second.Value(t, 1 - t);
        EXPECT_TRUE(p.X() == q.X() && p.Y() == q.Y() && p.Z() == q.Z());
      }
    }
    EXPECT_FALSE(b.More());
    EXPECT_EQ(exact_bytes(again), bytes);
  }
}

// Places of places, one of them turned back, and a part that is used twice.
TEST(ExactBytes, PlacesOfInstancesComeBackToTheLastBit) {
  AnyDirections any;
  for (int trial = 0; trial < 20; ++trial) {
    gp_Trsf turn, move;
    turn.SetRotation(gp_Ax1(gp::Origin(), any.direction()), 0.1 + trial);
    move.SetTranslation(gp_Vec(any.direction()));
    const TopLoc_Location turned(turn), moved(move);
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
    const TopoDS_Shape inner =
        compound_of(std::vector<TopoDS_Shape>{box.Located(turned), box.Located(turned * moved)});
    const TopoDS_Shape shape = compound_of(std::vector<TopoDS_Shape>{
        inner.Located(moved * turned), inner.Located(turned.Inverted() * moved.Powered(3))});
    const std::optional<std::string> bytes = exact_bytes(shape);
    ASSERT_TRUE(bytes) << trial;
    const TopoDS_Shape again = shape_of_exact_bytes(*bytes);
    TopExp_Explorer a(shape, TopAbs_SOLID), b(again, TopAbs_SOLID);
    for (; a.More() && b.More(); a.Next(), b.Next())
      for (int row = 1; row <= 3; ++row)
        for (int column = 1; column <= 4; ++column)
          EXPECT_EQ(a.Current().Location().Transformation().Value(row, column),
                    b.Current().Location().Transformation().Value(row, column));
    EXPECT_EQ(a.More(), b.More());
  }
}

TEST(ExactBytes, DamagedBytesAreRefused) {
  const std::string bytes = *exact_bytes(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  for (const std::size_t size : {std::size_t{0}, std::size_t{4}, bytes.size() - 1})
    EXPECT_ANY_THROW(shape_of_exact_bytes(bytes.substr(0, size))) << size;
  EXPECT_ANY_THROW(shape_of_exact_bytes(bytes + "x"));
}

}  // namespace
}  // namespace blossom::occt
