// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom subdivide --whole`, as a user runs it.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

void set_knots(TColStd_Array1OfReal& knots, TColStd_Array1OfInteger& multiplicities, int degree) {
  for (int i = 1; i <= knots.Length(); ++i) {
    knots.SetValue(i, i - 1.0);
    multiplicities.SetValue(i, i == 1 || i == knots.Length() ? degree + 1 : 1);
  }
  multiplicities.SetValue(3, 2);  // a knot where curvatures jump
}

// Rational, of degree 3 x 2 over [0, 4] x [0, 3], with simple knots and a double one.
Handle(Geom_BSplineSurface) waves() {
  TColStd_Array1OfReal u(1, 5), v(1, 4);
  TColStd_Array1OfInteger in_u(1, 5), in_v(1, 4);
  set_knots(u, in_u, 3);
  set_knots(v, in_v, 2);
  TColgp_Array2OfPnt poles(1, 8, 1, 6);
  TColStd_Array2OfReal weights(1, 8, 1, 6);
  for (int i = 1; i <= 8; ++i)
    for (int j = 1; j <= 6; ++j) {
      poles.SetValue(i, j, gp_Pnt(i, j, std::sin(i + 2.0 * j)));
      weights.SetValue(i, j, 1 + 0.3 * std::cos(3.0 * i - j));
    }
  return new Geom_BSplineSurface(poles, weights, u, v, in_u, in_v, 3, 2);
}

class SubdivideWhole : public ::testing::Test {
 protected:
  void SetUp() override {
    surface_ = waves();
    testing::write({BRepBuilderAPI_MakeFace(surface_, 1e-7).Face()}, folder_ / "waves.brep");
    file_ = folder_ / "waves.brep";
  }

  json report(std::vector<std::string> words) {
    words.insert(words.end(), {"--json", "-"});
    const Finished run = blossom(words);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }

  testing::TestFolder folder_;
  Handle(Geom_BSplineSurface) surface_;
  std::string file_;
};

TEST_F(SubdivideWhole, KeepsKnotsAndMultiplicitiesWithinTheRectangle) {
  const json found = report({"subdivide", file_, "--whole", "--rectangle", "0.5", "3.5", "1", "3"});
  ASSERT_EQ(found["splines"].size(), 1u);
  const json& spline = found["splines"][0];
  EXPECT_EQ(spline["degree"], json({3, 2}));
  EXPECT_EQ(spline["u_knots"], json({0.5, 1.0, 2.0, 3.0, 3.5}));
  EXPECT_EQ(spline["u_multiplicities"], json({4, 1, 2, 1, 4}));
  EXPECT_EQ(spline["v_knots"], json({1.0, 2.0, 3.0}));
  EXPECT_EQ(spline["v_multiplicities"], json({3, 2, 3}));
  EXPECT_EQ(spline["poles"].size(), 8u);
}

TEST_F(SubdivideWhole, HasTheSamePointsAtTheSameParameters) {
  const std::string out = folder_ / "part.step";
  ASSERT_EQ(blossom({"subdivide", file_, "--whole", "--rectangle", "0.5", "3.5", "0.25", "2.75",
                     "-o", out})
                .code,
            0);
  const occt::Model model = occt::read_model(out);
  ASSERT_EQ(model.face_count(), 1);
  const auto part = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(model.face(1)));
  ASSERT_FALSE(part.IsNull());
  for (double u = 0.5; u <= 3.5; u += 0.125)
    for (double v = 0.25; v <= 2.75; v += 0.125)
      EXPECT_LT(part->Value(u, v).Distance(surface_->Value(u, v)), 1e-12) << u << " " << v;
}

TEST_F(SubdivideWhole, IsTheWholeSurfaceWithoutARectangle) {
  const json found = report({"subdivide", file_, "--whole"});
  const json& spline = found["splines"][0];
  ASSERT_EQ(spline["poles"].size(), 8u);
  for (int i = 1; i <= 8; ++i)
    for (int j = 1; j <= 6; ++j) {
      const json& pole =
          spline["poles"][static_cast<std::size_t>(i) - 1][static_cast<std::size_t>(j) - 1];
      EXPECT_LT(gp_Pnt(pole[0], pole[1], pole[2]).Distance(surface_->Pole(i, j)), 1e-12);
    }
}

TEST_F(SubdivideWhole, IsShownWithCurvesToo) {
  const std::string page = folder_ / "page.html";
  ASSERT_EQ(blossom({"subdivide", file_, "--whole", "--html", page}).code, 0);
  EXPECT_NE(testing::text_of(page).find("B-splines of waves.brep"), std::string::npos);
  ASSERT_EQ(blossom({"subdivide", file_, "--whole", "--interval", "1", "2", "--html", page}).code,
            0);
  EXPECT_NE(testing::text_of(page).find("\"name\":\"curve\""), std::string::npos);
}

TEST_F(SubdivideWhole, RefusesParametersOutOfRange) {
  const Finished run =
      blossom({"subdivide", file_, "--whole", "--rectangle", "0.5", "4.5", "1", "2"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("face 1: the rectangle's u [0.5, 4.5] leaves the parameters [0, 4]"),
            std::string::npos)
      << run.err;
}

TEST_F(SubdivideWhole, TakesCylindersAndEdges) {
  occt::Model model;
  model.add(BRepPrimAPI_MakeCylinder(2, 5).Shape(), "rod");
  const std::string rod = folder_ / "rod.step", out = folder_ / "bent.step";
  occt::write_model(model, rod);
  ASSERT_EQ(
      blossom({"subdivide", rod + "#1", "--whole", "--rectangle", "0.5", "4", "1", "2", "-o", out})
          .code,
      0);
  const occt::Model made = occt::read_model(out);
  const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(made.face(1)));
  ASSERT_FALSE(surface.IsNull());
  for (double u = 0.5; u <= 4; u += 0.25) {
    const gp_Pnt p = surface->Value(u, 1.5);
    EXPECT_NEAR(std::hypot(p.X(), p.Y()), 2, 1e-12);
    EXPECT_NEAR(p.Z(), 1.5, 1e-12);
  }
  const json edges = report({"subdivide", rod + "#edge:1", "--whole", "--interval", "1", "2"});
  ASSERT_EQ(edges["splines"].size(), 1u);
  EXPECT_EQ(edges["splines"][0]["edge"], 1);
}

}  // namespace
}  // namespace blossom
