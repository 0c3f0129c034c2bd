// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts in other STEP files: those beside the model are read, and no name leads anywhere else.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::content;
using testing::Folder;
using testing::write_content;

constexpr int kFacesOfBox = 6, kFacesOfBall = 1;

// An assembly of a box and a ball, each in a file of its own: part_SOLID.stp, part_SOLID_1.stp.
void write_apart(const std::filesystem::path& file) {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(10, 10, 10).Shape());
  builder.Add(both, BRepPrimAPI_MakeSphere(gp_Pnt(30, 0, 0), 4).Shape());
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->AddShape(both, true);
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", "MM");
  STEPCAFControl_Writer writer;
  writer.Transfer(document, STEPControl_AsIs, "part_");
  writer.Write(file.c_str());
  XCAFApp_Application::GetApplication()->Close(document);
}

class StepInOtherFiles : public ::testing::Test {
 protected:
  void SetUp() override { write_apart(folder / "main.stp"); }

  // The box is said to be somewhere else.
  std::filesystem::path with_box_in(const std::string& name) const {
    std::string text = content(folder / "main.stp");
    const std::string before = "part_SOLID.stp";
    for (std::size_t i = 0; (i = text.find(before, i)) != std::string::npos; i += name.size())
      text.replace(i, before.size(), name);
    write_content(folder / "changed.stp", text);
    return folder / "changed.stp";
  }

  // Only the ball is there, and it is said why.
  void expect_ball(const std::filesystem::path& file, const std::string& cause) const {
    const Model model = read_model(file);
    EXPECT_EQ(model.face_count(), kFacesOfBall);
    EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
    ASSERT_FALSE(model.reading().losses.empty());
    EXPECT_EQ(model.reading().losses.front().what, "part");
    EXPECT_EQ(model.reading().losses.front().cause, cause);
  }

  const Folder folder;
};

TEST_F(StepInOtherFiles, PartsBesideTheModelAreRead) {
  const Model model = read_model(folder / "main.stp");
  EXPECT_EQ(model.face_count(), kFacesOfBox + kFacesOfBall);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::Whole);
}

TEST_F(StepInOtherFiles, NoNameLeadsOutOfTheFolder) {
  const Folder outside;
  std::filesystem::copy(folder / "part_SOLID.stp", outside / "box.stp");
  const std::string cause = "its file would be outside of the model's folder";
  expect_ball(with_box_in(outside / "box.stp"), cause);
  expect_ball(with_box_in("../" + outside.path().filename().string() + "/box.stp"), cause);
}

TEST_F(StepInOtherFiles, WhatIsNoFileIsNotOpened) {
  ASSERT_EQ(mkfifo((folder / "pipe.stp").c_str(), 0600), 0);  // who opens it waits for ever
  expect_ball(with_box_in("pipe.stp"), "what it names is no regular file");
  expect_ball(with_box_in("none.stp"), "its file is not beside the model");
}

TEST_F(StepInOtherFiles, NamesInNamedFilesAreFollowed) {
  const Model model = read_model(with_box_in("main.stp"));  // which has both
  EXPECT_EQ(model.face_count(), kFacesOfBox + 2 * kFacesOfBall);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::Whole) << model.reading().summary();
}

TEST_F(StepInOtherFiles, FilesThatNameEachOtherInACircleAreTold) {
  expect_ball(with_box_in("changed.stp"),
              "its file has it in itself: files name each other in a circle");
  const std::filesystem::path changed = with_box_in("main.stp");
  std::string text = content(folder / "main.stp");
  const std::string before = "part_SOLID.stp";
  for (std::size_t i = 0; (i = text.find(before, i)) != std::string::npos;)
    text.replace(i, before.size(), "changed.stp");
  write_content(folder / "main.stp", text);
  const Model model = read_model(changed);
  EXPECT_EQ(model.face_count(), 2 * kFacesOfBall);  // of both files
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
}

// As CAD systems do that run elsewhere.
TEST_F(StepInOtherFiles, FoldersAndCapitalsInNamesDoNotMatter) {
  for (const char* name : {"C:\\work\\part_SOLID.stp", "../parts/part_SOLID.stp", "PART_solid.STP"})
    EXPECT_EQ(read_model(with_box_in(name)).face_count(), kFacesOfBox + kFacesOfBall) << name;
}

TEST_F(StepInOtherFiles, OfNamesThatDifferInCapitalsAloneNoneIsTaken) {
  std::filesystem::copy(folder / "part_SOLID.stp", folder / "PART_SOLID.stp");
  expect_ball(with_box_in("part_Solid.stp"), "its file is not beside the model");
}

TEST_F(StepInOtherFiles, WhatIsLostInAFileIsTold) {
  std::string text = content(folder / "part_SOLID.stp");
  const std::size_t plane = text.find("PLANE(");
  ASSERT_NE(plane, std::string::npos);
  text.replace(plane, 5, "PLAIN");
  write_content(folder / "part_SOLID.stp", text);
  const Model model = read_model(folder / "main.stp");
  EXPECT_EQ(model.face_count(), kFacesOfBox - 1 + kFacesOfBall);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
  EXPECT_NE(model.reading().losses.front().text().find("part_SOLID.stp"), std::string::npos)
      << model.reading().losses.front().text();
}

TEST_F(StepInOtherFiles, InstancesReferToWhatTheFileHas) {
  const std::vector<AssemblyNode> all = read_model(with_box_in("main.stp")).assembly();
  ASSERT_EQ(all.size(), 1u);
  ASSERT_EQ(all[0].parts.size(), 2u);
  EXPECT_EQ(all[0].parts[0].parts.size(), 2u);
  EXPECT_EQ(all[0].parts[1].faces.size(), 1u);
}

TEST_F(StepInOtherFiles, AreWrittenWithTheModel) {
  const Model model = read_model(with_box_in("main.stp"));
  write_model(model, folder / "whole.step");
  const Folder alone;
  std::filesystem::copy(folder / "whole.step", alone / "whole.step");
  const Model again = read_model(alone / "whole.step");
  EXPECT_EQ(again.face_count(), model.face_count());
  EXPECT_EQ(again.part_paths(), model.part_paths());
  EXPECT_EQ(again.reading().grade(), ReadingGrade::Whole) << again.reading().summary();
}

TEST_F(StepInOtherFiles, WhatEndsAChildIsLeftOut) {
  const Model model =
      read_model_in_child(folder / "main.stp", {.step = [](const char* step) {
                            if (std::string(step).find("part_SOLID.stp") != std::string::npos)
                              std::abort();
                          }});
  EXPECT_EQ(model.face_count(), kFacesOfBall);
  EXPECT_EQ(model.reading().losses.front().text(),
            "part (part_SOLID.stp): its file cannot be read: Open CASCADE crashes, or never ends");
}

// As some CAD systems name the file that they exported.
TEST_F(StepInOtherFiles, ANameBesideAShapeIsWhereItCameFrom) {
  Model box;
  box.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "Box");
  write_model(box, folder / "plain.step");
  std::string text = testing::content(folder / "plain.step");
  const std::string product = "PRODUCT_DEFINITION('design','',";
  const std::size_t start = text.find(product);
  ASSERT_NE(start, std::string::npos) << text;
  text.insert(text.find(')', start + product.size()), ",(#90001)");
  text.insert(start + std::string("PRODUCT_DEFINITION").size(), "_WITH_ASSOCIATED_DOCUMENTS");
  text.insert(text.rfind("ENDSEC"),
              "#90001=DOCUMENT('None','Main:box:::0','',#90002);\n"
              "#90002=DOCUMENT_TYPE('cad_filename');\n");
  write_content(folder / "named.step", text);

  const Model model = read_model(folder / "named.step");

  EXPECT_EQ(model.face_count(), 6);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::Whole) << model.reading().summary();
}

TEST_F(StepInOtherFiles, FilesThatCannotBeReadAreTold) {
  write_content(folder / "words.stp", "no model\n");
  expect_ball(with_box_in("words.stp"), "its file is no STEP file");
}

TEST_F(StepInOtherFiles, AModelOfWhichNoPartIsThereIsRefused) {
  const Folder alone;
  std::filesystem::copy(folder / "main.stp", alone / "main.stp");
  EXPECT_THROW(read_model(alone / "main.stp"), BadModel);
}

}  // namespace
}  // namespace blossom::occt
