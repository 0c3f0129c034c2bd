// SPDX-License-Identifier: LGPL-2.1-or-later
// Assemblies against assemblies: parts are taken where they are placed, and reports name them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Trsf.hxx>
#include <nlohmann/json.hpp>

#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using nlohmann::json;
using testing::blossom;
using testing::Finished;

gp_Trsf moved(double x, double y, double z) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(x, y, z));
  return move;
}

gp_Trsf turned(double x, double y, double z) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0.5 * std::numbers::pi);
  return moved(x, y, z) * turn;
}

using Instance = std::pair<std::string, gp_Trsf>;

// A STEP file of instances of one part in an assembly, which is an instance itself. Open CASCADE
// does not write the name of an instance that is not moved.
void write_assembly(const std::filesystem::path& file, const TopoDS_Shape& part,
                    const std::vector<Instance>& instances, const Instance& outer) {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto named = [](const TDF_Label& label, const std::string& name) {
    TDataStd_Name::Set(label, name.c_str());
    return label;
  };
  const TDF_Label body = named(shapes->AddShape(part, false), "Body");
  const TDF_Label inner = named(shapes->NewShape(), "Inner");
  for (const auto& [name, place] : instances)
    named(shapes->AddComponent(inner, body, TopLoc_Location(place)), name);
  const TDF_Label whole = named(shapes->NewShape(), "Whole");
  named(shapes->AddComponent(whole, inner, TopLoc_Location(outer.second)), outer.first);
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  writer.Transfer(document, STEPControl_AsIs);
  writer.Write(file.c_str());
  XCAFApp_Application::GetApplication()->Close(document);
}

class Assemblies : public ::testing::Test {
 protected:
  // Boxes of size 2 about (0, 100, 0.25) and, turned, about (10, 100, 0).
  Assemblies() {
    write_assembly(folder / "rig.step", BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), 2, 2, 2).Shape(),
                   {{"near", moved(0, 0, 0.25)}, {"far", turned(10, 0, 0)}},
                   {"frame", moved(0, 100, 0)});
  }

  json report_of(std::vector<std::string> words) {
    words.insert(words.end(), {"--json", "-"});
    const Finished run = blossom(words);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }

  testing::TestFolder folder;
};

TEST_F(Assemblies, AreIntersectedWhereTheirPartsArePlaced) {
  // A ball of radius 1.2 in the middle of "far" meets its six sides in circles.
  write_assembly(folder / "ball.step", BRepPrimAPI_MakeSphere(1.2).Shape(),
                 {{"ball", turned(3, 0, 0)}}, {"arm", turned(10, 97, 0)});
  const json report = report_of({"intersect", folder / "ball.step", folder / "rig.step"});
  EXPECT_EQ(report["curves"].size(), 6u);
  for (const json& curve : report["curves"]) {
    EXPECT_NEAR(curve["length"], 2 * std::numbers::pi * std::sqrt(0.44), 1e-6);
    EXPECT_NEAR(curve["points"][0][0], 10, 1.2);
    EXPECT_NEAR(curve["points"][0][1], 100, 1.2);
  }
  EXPECT_EQ(report["parts_a"], (json{{"arm/ball", {1}}}));
  EXPECT_EQ(report["parts_b"], (json{{"frame/far", {7, 8, 9, 10, 11, 12}}}));
}

TEST_F(Assemblies, AreNamedWherePartsMeetAndWhereTheyAreNearest) {
  write_assembly(folder / "other.step", BRepPrimAPI_MakeBox(1, 1, 1).Shape(),
                 {{"left", moved(0, 0, 0.1)}, {"right", moved(300, 0, 0)}},
                 {"cart", moved(0.5, 99.5, 0.2)});
  const json report = report_of({"intersect", folder / "rig.step", folder / "other.step"});
  EXPECT_GT(report["curves"].size(), 0u);
  ASSERT_EQ(report["parts_a"].size(), 1u);
  EXPECT_TRUE(report["parts_a"].contains("frame/near"));
  ASSERT_EQ(report["parts_b"].size(), 1u);
  EXPECT_TRUE(report["parts_b"].contains("cart/left"));

  const json nearest =
      report_of({"query", "distance", folder / "rig.step#7-12", folder / "other.step"});
  EXPECT_NEAR(nearest["distance"][1], 9 - 1.5, 1e-9);
  EXPECT_EQ(nearest["nearest_a"]["part"], "frame/far");
  EXPECT_EQ(nearest["nearest_b"]["part"], "cart/left");
}

gp_Trsf askew(double x, double y, double z, double angle) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0.1, 0.2, 0.3), gp_Dir(1, 2, 3)), angle);
  return moved(x, y, z) * turn;
}

// The same instances as one flat compound.
void write_flat(const std::filesystem::path& file, const TopoDS_Shape& part,
                const std::vector<Instance>& instances, const Instance& outer) {
  const BRep_Builder builder;
  TopoDS_Compound flat;
  builder.MakeCompound(flat);
  for (const Instance& instance : instances)
    builder.Add(flat, part.Moved(outer.second * instance.second));
  BRepTools::Write(flat, file.c_str());
}

// Of each curve its length, in order.
std::vector<double> lengths_in(const json& report) {
  std::vector<double> lengths;
  for (const json& curve : report["curves"]) lengths.push_back(curve["length"]);
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

TEST_F(Assemblies, AnswerAsTheirPartsDoPlacedOneByOne) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(2, 0.7), rod = BRepPrimAPI_MakeCone(0.6, 0.3, 9);
  const std::vector<Instance> rings{{"one", askew(0, 0, 0, 0.4)}, {"two", askew(1.5, 0.4, 1, 1.7)}};
  const std::vector<Instance> rods{{"one", askew(-1, 0.5, -3, 0.9)},
                                   {"two", askew(2, -1, -2, -0.5)}};
  const Instance chain{"chain", askew(5, 6, 7, 0.8)}, rack{"rack", askew(5.5, 6.2, 6, 0.6)};
  write_assembly(folder / "chain.step", ring, rings, chain);
  write_assembly(folder / "rack.step", rod, rods, rack);
  write_flat(folder / "chain.brep", ring, rings, chain);
  write_flat(folder / "rack.brep", rod, rods, rack);
  const json nested = report_of({"intersect", folder / "chain.step", folder / "rack.step"});
  const json flat = report_of({"intersect", folder / "chain.brep", folder / "rack.brep"});
  EXPECT_EQ(nested["status"], flat["status"]);
  const std::vector<double> lengths = lengths_in(nested), wanted = lengths_in(flat);
  EXPECT_GE(wanted.size(), 4u);
  ASSERT_EQ(lengths.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(lengths[i], wanted[i], 1e-6);
  const json far = report_of({"query", "distance", folder / "chain.step", folder / "rig.step"});
  const json away = report_of({"query", "distance", folder / "chain.brep", folder / "rig.step"});
  EXPECT_NEAR(far["distance"][1], away["distance"][1], 1e-9);
}

}  // namespace
}  // namespace blossom
