// SPDX-License-Identifier: LGPL-2.1-or-later
// Flat faces inside of polygons, with points that are none.

#include <string>

#include <gtest/gtest.h>

#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/read_files.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::faces_of;
using testing::Folder;
using testing::replaced;

std::string hash(int number) { return "#" + std::to_string(number); }

std::string facet(int number, int a, int b, int c, const std::string& normal) {
  const std::string face = hash(number), bound = hash(number + 10), loop = hash(number + 20),
                    plane = hash(number + 30), place = hash(number + 40), axis = hash(number + 50);
  return face + "=FACE_SURFACE('',(" + bound + ")," + plane + ",.T.);\n" + bound +
         "=FACE_OUTER_BOUND(''," + loop + ",.T.);\n" + loop + "=POLY_LOOP('',(" + hash(a) + "," +
         hash(b) + "," + hash(c) + "));\n" + plane + "=PLANE(''," + place + ");\n" + place +
         "=AXIS2_PLACEMENT_3D(''," + hash(a) + "," + axis + ",$);\n" + axis + "=DIRECTION('',(" +
         normal + "));\n";
}

// The corner of a cube, cut off: #5 is the corner, #8 (0, 0, 1) in three of four faces.
std::string tetrahedron() {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
         "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\n"
         "DATA;\n#1=SHAPE_DEFINITION_REPRESENTATION(#301,#2);\n"
         "#2=FACETED_BREP_SHAPE_REPRESENTATION('',(#3),#300);\n#3=FACETED_BREP('',#4);\n"
         "#4=CLOSED_SHELL('',(#100,#101,#102,#103));\n#5=CARTESIAN_POINT('',(0.,0.,0.));\n"
         "#6=CARTESIAN_POINT('',(1.,0.,0.));\n#7=CARTESIAN_POINT('',(0.,1.,0.));\n"
         "#8=CARTESIAN_POINT('',(0.,0.,1.));\n" +
         facet(100, 5, 7, 6, "0.,0.,-1.") + facet(101, 5, 6, 8, "0.,-1.,0.") +
         facet(102, 5, 8, 7, "-1.,0.,0.") + facet(103, 6, 7, 8, "1.,1.,1.") +
         "#300=(GEOMETRIC_REPRESENTATION_CONTEXT(3)REPRESENTATION_CONTEXT('',''));\n"
         "#301=PRODUCT_DEFINITION_SHAPE('','',#302);\n"
         "#302=PRODUCT_DEFINITION('','',#303,#306);\n"
         "#303=PRODUCT_DEFINITION_FORMATION('','',#304);\n#304=PRODUCT('facets','','',(#305));\n"
         "#305=PRODUCT_CONTEXT('',#307,'mechanical');\n"
         "#306=PRODUCT_DEFINITION_CONTEXT('part definition',#307,'design');\n"
         "#307=APPLICATION_CONTEXT('');\nENDSEC;\nEND-ISO-10303-21;\n";
}

TEST(StepFacets, BoundASolid) {
  const Folder folder;
  testing::write_content(folder / "facets.step", tetrahedron());
  EXPECT_EQ(faces_of(folder / "facets.step"), 4);
}

TEST(StepFacets, AreLeftOutBesideACornerWithoutThreeCoordinates) {
  const Folder folder;
  for (const char* coordinates : {"(0.,1.)", "(1.)", "()"}) {
    testing::write_content(folder / "facets.step",
                           replaced(tetrahedron(), "(0.,0.,1.)", coordinates));
    EXPECT_EQ(faces_of(folder / "facets.step"), 1) << coordinates;
    EXPECT_EQ(read_model(folder / "facets.step", {.damaged = true}).face_count(), 1) << coordinates;
  }
  testing::write_content(folder / "facets.step", replaced(tetrahedron(), "(0.,0.,1.)", "(0.,1.)"));
  std::string said;
  const Model model = read_model(folder / "facets.step");
  for (const Loss& each : model.reading().losses) said += each.text() + "\n";
  EXPECT_NE(said.find("POLY_LOOP: corner 3 has no 3 coordinates"), std::string::npos) << said;
}

}  // namespace
}  // namespace blossom::occt
