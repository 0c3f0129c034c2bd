// SPDX-License-Identifier: LGPL-2.1-or-later
// Assemblies through STEP files: what is not cut stays as it is, pieces take over what they can.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::Folder;
using testing::story;

// The lines of the story of the untouched assembly, as far as tests need them.
const std::string kMachine1 =
    "  machine:1 of Machine 0.000..40.000 0.000..30.000 0.000..30.000 valid\n"
    "    plate:1 of Plate #0000FF 0.000..40.000 0.000..30.000 0.000..10.000 valid\n"
    "      * Top #FF0000\n"
    "    bolt:1 of Bolt #FFFF00 5.000..13.000 5.000..13.000 10.000..30.000 valid\n"
    "      * Head\n"
    "    bolt:2 #0000FF of Bolt #FFFF00 25.000..33.000 5.000..13.000 10.000..30.000 valid\n"
    "      * Head\n";
const std::string kMachine2 =
    "  machine:2 of Machine -30.000..0.000 100.000..140.000 0.000..30.000 valid\n"
    "    > machine:2/bolt:1 #FF00FF\n";
const std::string kPlate =
    "    plate:1 of Plate #0000FF 0.000..40.000 0.000..30.000 0.000..10.000 valid\n"
    "      * Top #FF0000\n";
const std::string kBolt1 =
    "    bolt:1 of Bolt #FFFF00 5.000..13.000 5.000..13.000 10.000..30.000 valid\n"
    "      * Head\n";
const std::string kBolt2 =
    "    bolt:2 #0000FF of Bolt #FFFF00 25.000..33.000 5.000..13.000 10.000..30.000 valid\n"
    "      * Head\n";
const std::string kBolt9 =
    "  bolt:9 of Bolt #FFFF00 200.000..208.000 0.000..8.000 0.000..20.000 valid\n"
    "    * Head\n";
const std::string kWorks = "Works -30.000..208.000 0.000..140.000 0.000..30.000 valid\n";

Model works(const Folder& folder, const char* unit = "MM") {
  testing::write_works(folder / "works.step", unit);
  return read_model(folder / "works.step");
}

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high) {
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

Model saw(const TopoDS_Shape& shape) {
  Model model;
  model.add(shape, "Saw", {0, 1, 0});
  return model;
}

/// Combines solids, puts them into the part and tells the story of the file.
std::string combined(Model& part, const Model& tool, SolidOperation operation,
                     const Folder& folder) {
  const SolidTrimResult made =
      trim_solids(trim_tool(part.shape()), {trim_tool(tool.shape())}, operation);
  EXPECT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  std::vector<CombinedSolid> solids;
  for (const TopoDS_Solid& solid : made.solids) {
    solids.push_back({solid, {}});
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(solid, TopAbs_FACE, faces);
    for (const SolidFace& face : made.faces)
      if (faces.Contains(face.face))
        solids.back().faces.push_back({face.face, face.tool < 0 ? &part : &tool, face.from + 1});
  }
  part.replace_solids(solids);
  write_model(part, folder / "out.step");
  return story(folder / "out.step");
}

class Works : public ::testing::TestWithParam<const char*> {};

TEST_P(Works, StaysAsItIs) {
  const Folder folder;
  const Model model = works(folder, GetParam());
  EXPECT_EQ(model.face_count(), 42);
  write_model(model, folder / "out.step");
  const std::string told = story(folder / "out.step");
  EXPECT_EQ(told, story(folder / "works.step"));
  EXPECT_EQ(told.substr(told.find('\n') + 1),
            kWorks + kMachine1 + kMachine2 + kPlate + kBolt1 + kBolt2 + kBolt9 +
                "layer plates: Plate\nlayer bolts: Bolt\nlayer tops: Top\n");
}

INSTANTIATE_TEST_SUITE_P(All, Works, ::testing::Values("MM", "INCH", "M"));

// The plate of machine:2 falls in two; everything else, machine:1 too, is as it was.
TEST(WorksSolids, CutOnePlateWhereItIs) {
  const Folder folder;
  Model part = works(folder, "INCH");
  const Model tool = saw(box({-40, 115, -5}, {10, 120, 40}));
  EXPECT_EQ(
      combined(part, tool, SolidOperation::Cut, folder),
      "in INCH\n" + kWorks + kMachine1 + kMachine2 +
          "    plate:1.1 of Plate.1 #0000FF 0.000..15.000 0.000..30.000 0.000..10.000 valid\n"
          "      * - #00FF00\n"
          "      * Top.1 #FF0000\n" +
          kBolt1 + kBolt2 +
          "    plate:1.2 of Plate.2 #0000FF 20.000..40.000 0.000..30.000 0.000..10.000 valid\n"
          "      * - #00FF00\n"
          "      * Top.2 #FF0000\n" +
          kBolt9 +
          "layer plates: Plate Plate.1 Plate.2\n"
          "layer bolts: Bolt\n"
          "layer tops: Top Top.1 Top.2\n");
  EXPECT_EQ(part.face_count(), 48);
}

// The violet bolt of machine:2 falls in two, and both are violet; the other bolts are not.
TEST(WorksSolids, GiveInstanceColoursToAllPieces) {
  const Folder folder;
  Model part = works(folder);
  const Model tool = saw(box({-20, 104, 20}, {-1, 114, 22}));
  EXPECT_EQ(combined(part, tool, SolidOperation::Cut, folder),
            "in millimetre\n" + kWorks + kMachine1 +
                "  machine:2 of Machine -30.000..0.000 100.000..140.000 0.000..30.000 valid\n"
                "    > machine:2/bolt:1.1 #FF00FF\n"
                "    > machine:2/bolt:1.2 #FF00FF\n" +
                kPlate +
                "    bolt:1.1 of Bolt.1 #FFFF00 5.000..13.000 5.000..13.000 22.000..30.000 valid\n"
                "      * - #00FF00\n"
                "      * Head\n" +
                kBolt2 +
                "    bolt:1.2 of Bolt.2 #FFFF00 5.000..13.000 5.000..13.000 10.000..20.000 valid\n"
                "      * - #00FF00\n" +
                kBolt9 +
                "layer plates: Plate\n"
                "layer bolts: Bolt Bolt.1 Bolt.2\n"
                "layer tops: Top\n");
}

TEST(WorksSolids, TakeOutPartsWithTheirColoursWhenNothingIsLeft) {
  const Folder folder;
  Model part = works(folder);
  const Model tool = saw(box({-20, 104, 9}, {-1, 114, 40}));
  const std::string told = combined(part, tool, SolidOperation::Cut, folder);
  EXPECT_EQ(told.find(kMachine1), ("in millimetre\n" + kWorks).size());
  const std::string second = told.substr(told.find("  machine:2"));
  EXPECT_EQ(second.find('>'), std::string::npos) << told;
  EXPECT_EQ(second.find("bolt:1"), std::string::npos) << told;
  EXPECT_NE(second.find(kBolt2 + kBolt9), std::string::npos) << told;
}

TEST(WorksSolids, TakeOutAssembliesThatAreEmpty) {
  const Folder folder;
  Model part = works(folder);
  const Model tool = saw(box({190, -5, 10}, {210, 20, 40}));
  EXPECT_EQ(combined(part, tool, SolidOperation::Common, folder),
            "in millimetre\n"
            "Works 200.000..208.000 0.000..8.000 10.000..20.000 valid\n"
            "  bolt:9 of Bolt #FFFF00 200.000..208.000 0.000..8.000 10.000..20.000 valid\n"
            "    * - #00FF00\n"
            "    * Head\n"
            "layer bolts: Bolt\n");
}

TEST(WorksSolids, SplitSideBySide) {
  const Folder folder;
  Model part = works(folder);
  const Model tool = saw(box({190, -5, 10}, {210, 20, 40}));
  EXPECT_EQ(combined(part, tool, SolidOperation::Split, folder),
            "in millimetre\n" + kWorks + kMachine1 + kMachine2 + kPlate + kBolt1 + kBolt2 +
                "  bolt:9.1 of Bolt.1 #FFFF00 200.000..208.000 0.000..8.000 0.000..10.000 valid\n"
                "    * - #00FF00\n"
                "  bolt:9.2 of Bolt.2 #FFFF00 200.000..208.000 0.000..8.000 10.000..20.000 valid\n"
                "    * - #00FF00\n"
                "    * Head\n"
                "layer plates: Plate\n"
                "layer bolts: Bolt Bolt.1 Bolt.2\n"
                "layer tops: Top\n");
}

TEST(WorksSolids, FuseIntoThePartThatTheToolMeets) {
  const Folder folder;
  Model part = works(folder);
  const Model tool = saw(box({190, -5, 10}, {210, 20, 40}));
  const std::string told = combined(part, tool, SolidOperation::Fuse, folder);
  EXPECT_NE(told.find(kMachine1 + kMachine2 + kPlate + kBolt1 + kBolt2 +
                      "  bolt:9 of Bolt #FFFF00 190.000..210.000 -5.000..20.000 0.000..40.000 "
                      "valid\n    * - #00FF00\n"),
            std::string::npos)
      << told;
}

// Both sides of the cut are green, though they are one face of the tool.
TEST(Solids, OfASplitPartHaveTheirOwnLooks) {
  const Folder folder;
  Model part;
  part.add(box({0, 0, 0}, {10, 10, 10}), "Block", {1, 0, 0});
  const Model tool = saw(box({5, -5, -5}, {20, 20, 20}));
  EXPECT_EQ(combined(part, tool, SolidOperation::Split, folder),
            "in millimetre\n"
            "Block.1 #FF0000 0.000..5.000 0.000..10.000 0.000..10.000 valid\n"
            "  * - #00FF00\n"
            "Block.2 #FF0000 5.000..10.000 0.000..10.000 0.000..10.000 valid\n"
            "  * - #00FF00\n");
}

// Two bodies of one part, one of which falls in two, and a loose edge beside them.
TEST(Solids, StayInOnePartWithOthers) {
  const Folder folder;
  TopoDS_Compound two;
  const BRep_Builder builder;
  builder.MakeCompound(two);
  builder.Add(two, box({0, 0, 0}, {10, 10, 10}));
  builder.Add(two, box({20, 0, 0}, {30, 10, 10}));
  builder.Add(two, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 20), gp_Pnt(5, 0, 20)).Edge());
  Model part;
  part.add(two, "Pair");
  const Model tool = saw(box({4, -5, -5}, {6, 20, 20}));
  EXPECT_EQ(combined(part, tool, SolidOperation::Cut, folder),
            "in millimetre\n"
            "Pair 0.000..30.000 0.000..10.000 0.000..20.000 valid\n"
            "  * - #00FF00\n"
            "  * - #00FF00\n");
  int solids = 0, edges = 0;
  for (TopoDS_Iterator it(part.shape()); it.More(); it.Next())
    ++(it.Value().ShapeType() == TopAbs_SOLID ? solids : edges);
  EXPECT_EQ(solids, 3);
  EXPECT_EQ(edges, 1);
}

TEST(Solids, RefuseFacesThatAreNotThere) {
  Model part;
  part.add(box({0, 0, 0}, {1, 1, 1}), "Block");
  const TopoDS_Solid solid = TopoDS::Solid(part.shape());
  EXPECT_THROW(part.replace_solids({{solid, {}}}), BadModel);
  EXPECT_THROW(part.replace_solids({{solid, {{part.face(1), &part, 7}}}}), BadModel);
  EXPECT_EQ(part.face_count(), 6);
}

// A face of one bolt only, named where it is used: that bolt becomes a part of its own and stays
// violet.
TEST(WorksFaces, CutOneInstanceAndKeepItsColour) {
  const Folder folder;
  Model part = works(folder);
  part.replace_faces({{30, {}}});
  write_model(part, folder / "out.step");
  EXPECT_EQ(story(folder / "out.step"),
            "in millimetre\n" + kWorks + kMachine1 + kMachine2 + kPlate +
                "    bolt:1 of Bolt #FFFF00 5.000..13.000 5.000..13.000 10.000..30.000 valid\n" +
                kBolt2 + kBolt9 +
                "layer plates: Plate\n"
                "layer bolts: Bolt Bolt\n"
                "layer tops: Top\n");
}

}  // namespace
}  // namespace blossom::occt
