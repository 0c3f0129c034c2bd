// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets of which others state what comes out.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/blending/continuity.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/mass.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/support/free_form_bodies.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

using nlohmann::json;
using testing::expect_sound;
using testing::told;

constexpr double kDegree = std::numbers::pi / 180;

// A primitive of Open CASCADE from its name and numbers; angles are in degrees.
TopoDS_Shape primitive(const std::string& name, const std::vector<double>& n) {
  const auto angle = [&](std::size_t i) { return n[i] * kDegree; };
  if (name == "box") return BRepPrimAPI_MakeBox(n[0], n[1], n[2]);
  if (name == "wedge" && n.size() == 4) return BRepPrimAPI_MakeWedge(n[0], n[1], n[2], n[3]);
  if (name == "wedge") return BRepPrimAPI_MakeWedge(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
  if (name == "cylinder" && n.size() == 2) return BRepPrimAPI_MakeCylinder(n[0], n[1]);
  if (name == "cylinder") return BRepPrimAPI_MakeCylinder(n[0], n[1], angle(2));
  if (name == "cone") return BRepPrimAPI_MakeCone(n[0], n[1], n[2], angle(3));
  if (name == "sphere" && n.size() == 3)
    return BRepPrimAPI_MakeSphere(n[0], angle(1), angle(2)).Shape();
  if (name == "sphere") return BRepPrimAPI_MakeSphere(n[0], angle(1), angle(2), angle(3)).Shape();
  if (name == "torus" && n.size() == 4)
    return BRepPrimAPI_MakeTorus(n[0], n[1], angle(2), angle(3)).Shape();
  if (name == "torus")
    return BRepPrimAPI_MakeTorus(n[0], n[1], angle(2), angle(3), angle(4)).Shape();
  ADD_FAILURE() << name;
  return {};
}

TopoDS_Shape made_of(const json& steps) {
  TopoDS_Shape shape;
  for (const json& step : steps) {
    const std::string name = step[0];
    gp_Trsf move;
    if (name == "scale") {
      move.SetScale(gp::Origin(), step[1]);
    } else if (name == "rotate") {
      const auto at = [&](const char* key, int i) { return step[1][key][i].get<double>(); };
      move.SetRotation(gp_Ax1({at("point", 0), at("point", 1), at("point", 2)},
                              {at("axis", 0), at("axis", 1), at("axis", 2)}),
                       step[1]["deg"].get<double>() * kDegree);
    } else {
      shape = primitive(name, std::vector<double>(step.begin() + 1, step.end()));
      continue;
    }
    shape = BRepBuilderAPI_Transform(shape, move).Shape();
  }
  return shape;
}

int edge_at(const TopoDS_Shape& shape, const Vec3& middle) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind != EdgeKind::Degenerate && distance(each.middle, middle) < 1e-5)
      return each.number;
  ADD_FAILURE() << "no edge there";
  return 0;
}

double area_of(const TopoDS_Shape& shape) {
  double sum = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    sum += area(TopoDS::Face(it.Current()));
  return sum;
}

// Six digits are stated, of which fitted blends spoil the last.
TEST(StatedFillets, OfPrimitivesHaveTheirAreas) {
  const char* data = blossom::testing::test_data();
  const std::filesystem::path file =
      std::filesystem::path(data != nullptr ? data : "") / "models/blend_cases.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such cases";
  std::ifstream in(file);
  const json cases = json::parse(in)["cases"];
  EXPECT_FALSE(cases.empty());
  for (const json& each : cases) {
    SCOPED_TRACE(each["id"].get<std::string>());
    const TopoDS_Shape shape = made_of(each["steps"]);
    std::vector<int> edges;
    FilletOptions options;
    for (const json& fillet : each["fillets"]) {
      const auto at = [&](int i) { return fillet["edge_midpoint"][i].get<double>(); };
      edges.push_back(edge_at(shape, {at(0), at(1), at(2)}));
      options.radius = fillet["radius"];
    }
    const FilletResult made = fillet(shape, edges, options);
    expect_sound(made);
    ASSERT_EQ(made.solids.size(), 1U) << told(made);
    const double stated = each["expect"]["area"];
    EXPECT_NEAR(area_of(made.solids.front().solid), stated, 2e-5 * stated);
  }
}

// Three of six upright edges of an angle, with half the width of its ends.
TEST(StatedFillets, OfAnAngleConsumeItsEnds) {
  const TopoDS_Shape angle =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 10, 10).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(5, 5, -1), 10, 10, 12).Shape());
  std::vector<int> upright;
  for (const EdgeFacts& each : edge_facts(angle))
    if (std::abs(each.middle[2] - 5) < 1e-9) upright.push_back(each.number);
  ASSERT_EQ(upright.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = i + 1; k < 6; ++k)
      for (std::size_t m = k + 1; m < 6; ++m)
        expect_sound(fillet(angle, {upright[i], upright[k], upright[m]}, {.radius = 2.5}));
}

gp_Pnt flat(double x, double y) { return {x, y, 0}; }

// A rounded triangle, both rims of which are rounded: from around it a ball takes an area of
// (1 - pi / 4) r^2, and as it turns once round less by that area's moment about the wall.
TEST(StatedFillets, OfBothRimsOfARoundedTriangle) {
  const auto arc = [](const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c) {
    return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, b, c).Value()).Edge();
  };
  const auto line = [](const gp_Pnt& a, const gp_Pnt& b) {
    return BRepBuilderAPI_MakeEdge(a, b).Edge();
  };
  const gp_Pnt a = flat(-27.598139, -7.0408573), b = flat(-19.555504, -22.983587),
               c = flat(12.125083, -22.983587), d = flat(19.878168, -6.6677585),
               e = flat(3.265825, 13.724955), f = flat(-12.529893, 13.351856);
  BRepBuilderAPI_MakeWire wire(arc(a, flat(-28.483755, -17.487625), b), line(b, c),
                               arc(c, flat(21.1572, -17.27554), d));
  wire.Add(line(d, e));
  wire.Add(arc(e, flat(-4.7233953, 17.406338), f));
  wire.Add(line(f, a));
  const TopoDS_Shape body = BRepPrimAPI_MakePrism(
      BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Face(), gp_Vec(0, 0, 111));
  std::vector<int> rims;
  double around = 0;
  for (const EdgeFacts& each : edge_facts(body)) {
    const bool top = std::abs(each.middle[2] - 111) < 1e-9;
    if (!top && std::abs(each.middle[2]) > 1e-9) continue;
    rims.push_back(each.number);
    if (top) around += each.length;
  }
  ASSERT_EQ(rims.size(), 12U);

  const FilletResult made = fillet(body, rims, {.radius = 10});

  expect_sound(made);
  ASSERT_EQ(made.solids.size(), 1U);
  const double pi = std::numbers::pi, section = (1 - pi / 4) * 100;
  const double moment = (5.0 / 6 - pi / 4) * 1000;
  EXPECT_NEAR(made.volume_before - made.solids.front().volume,
              2 * (around * section - 2 * pi * moment), 0.01);
}

// Between two free-form faces.
TEST(StatedFillets, OfFreeFormFacesAreTangentAndNear) {
  for (const double height : {2.0, -1.0}) {
    const TopoDS_Shape body = blossom::testing::free_form_body(height);
    const int edge = edge_at(body, {0.5, 0.5, blossom::testing::base_cubic(0.5, 0.5)});
    const FilletResult made = fillet(body, {edge}, {.radius = 0.1});
    expect_sound(made);
    ASSERT_EQ(made.solids.size(), 1U);
    EXPECT_NEAR(made.solids.front().volume, height > 0 ? 1.536326126 : 1.163673874, 1e-7);
    int contacts = 0;
    for (const EdgeContinuity& each : edge_continuity(made.solids.front().solid)) {
      if (!each.found || each.found->angle.value > 0.01) continue;
      ++contacts;
      EXPECT_LE(each.found->angle.value, 2e-7);
      EXPECT_LE(each.found->gap.value, 1e-8);
    }
    EXPECT_EQ(contacts, 2);
  }
}

}  // namespace
}  // namespace blossom::occt
