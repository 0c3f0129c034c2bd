// SPDX-License-Identifier: LGPL-2.1-or-later
// Who wants no looks gets the same shapes and names, with or without a document.

#include "adapters/occt/exchange/plain_parts.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/exchange/contents.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;
using testing::Folder;

Model without_looks(const fs::path& file) { return read_model(file, {.looks = false}); }

bool has_document(const Model& model) { return contents_of(model).document != nullptr; }

/// A tree of names with the numbers of faces in it, in one line.
std::string told(const std::vector<AssemblyNode>& nodes) {
  std::string text;
  for (const AssemblyNode& node : nodes) {
    text += "(" + node.name + "|" + node.product + "|" + node.path + "|";
    text += std::to_string(node.solids.size()) + "|";
    for (const int face : node.faces) text += " " + std::to_string(face);
    text += told(node.parts) + ")";
  }
  return text;
}

void expect_same_names(const fs::path& file) {
  const Model whole = read_model(file), quick = without_looks(file);
  ASSERT_EQ(quick.face_count(), whole.face_count()) << file;
  EXPECT_EQ(quick.face_names(), whole.face_names()) << file;
  EXPECT_EQ(quick.part_paths(), whole.part_paths()) << file;
  EXPECT_EQ(told(quick.assembly()), told(whole.assembly())) << file;
  EXPECT_EQ(quick.part_name(1), whole.part_name(1)) << file;
  EXPECT_EQ(quick.file_unit(), whole.file_unit()) << file;
}

TopoDS_Shape box(double x) { return BRepPrimAPI_MakeBox(gp_Pnt(x, 0, 0), 1, 2, 3).Shape(); }

/// One part of two boxes.
TopoDS_Shape two_boxes() {
  TopoDS_Compound whole;
  const BRep_Builder builder;
  builder.MakeCompound(whole);
  builder.Add(whole, box(0));
  builder.Add(whole, box(5));
  return whole;
}

using Write = void (*)(const fs::path&);

constexpr std::array<Write, 5> kFiles{
    [](const fs::path& file) { testing::write_machine(file, "INCH"); }, testing::write_roots,
    testing::write_gauge, testing::write_pairs,
    [](const fs::path& file) { testing::write_works(file); }};

TEST(ReadingWithoutLooks, GivesTheNamesOfPartsFacesAndInstances) {
  const Folder folder;
  for (const Write write : kFiles) {
    write(folder / "model.step");
    expect_same_names(folder / "model.step");
  }
}

TEST(ReadingWithoutLooks, MakesADocumentOfAssembliesOnly) {
  const Folder folder;
  testing::write_gauge(folder / "gauge.step");
  EXPECT_FALSE(has_document(without_looks(folder / "gauge.step")));
  EXPECT_TRUE(has_document(read_model(folder / "gauge.step")));
  testing::write_pairs(folder / "pairs.step");
  EXPECT_TRUE(has_document(without_looks(folder / "pairs.step")));
}

TEST(ReadingWithoutLooks, NamesPartsOfSeveralSolidsAndSeveralParts) {
  const Folder folder;
  Model made;
  made.add(two_boxes(), "Pair", {1, 0, 0});
  made.add(box(10), "Größe");
  write_model(made, folder / "boxes.step");
  expect_same_names(folder / "boxes.step");
  const Model read = without_looks(folder / "boxes.step");
  EXPECT_FALSE(has_document(read));
  EXPECT_EQ(read.part_paths().front(), "Pair");
  EXPECT_EQ(read.part_paths().back(), "Größe");
}

TEST(ReadingWithoutLooks, TakesANameWithoutAnyLetterOfASCII) {
  const Folder folder;
  Model made;
  made.add(box(0), "\xE9\xBD\xBF\xE8\xBD\xAE");  // a gear
  write_model(made, folder / "gear.step");
  expect_same_names(folder / "gear.step");
  EXPECT_EQ(without_looks(folder / "gear.step").part_name(1), "\xE9\xBD\xBF\xE8\xBD\xAE");
}

TEST(ReadingWithoutLooks, KeepsTheNamesWhenItIsWrittenAfterAll) {
  const Folder folder;
  testing::write_gauge(folder / "gauge.step");
  const Model read = without_looks(folder / "gauge.step");
  const std::vector<std::string> names = read.face_names();
  write_model(read, folder / "again.step");
  EXPECT_TRUE(has_document(read));
  EXPECT_EQ(read.face_names(), names);
  EXPECT_EQ(read_model(folder / "again.step").face_names(), names);
}

TEST(ReadingWithoutLooks, SaysTheSameOfRealFiles) {
  const char* const data = std::getenv("BLOSSOM_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "BLOSSOM_TEST_DATA is not set";
  for (const char* name : {"nacelle.stp", "nist_ctc_02.stp", "s1_mainbody_back.stp"})
    expect_same_names(fs::path(data) / "models" / name);
}

TEST(PlainParts, ATwiceNamedFaceHasTheNameThatWasGivenLast) {
  const TopoDS_Shape solid = box(0);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  const PlainParts parts{{solid, "Box", {{solid, "Solid"}, {faces(2), "Top"}}}};
  const std::vector<std::string> wanted{"Solid", "Top", "Solid", "Solid", "Solid", "Solid"};
  EXPECT_EQ(face_names(parts, faces), wanted);
  EXPECT_EQ(part_paths(parts, faces), std::vector<std::string>(6, "Box"));
  EXPECT_EQ(part_name(parts, TopoDS::Face(faces(2))), "Box");
}

TEST(PlainParts, SeveralMakeOneCompoundAndNoneMakeNothing) {
  EXPECT_TRUE(whole_of({}).IsNull());
  const TopoDS_Shape one = box(0), other = box(5);
  EXPECT_TRUE(whole_of({{one}}).IsSame(one));
  const TopoDS_Shape both = whole_of({{one}, {other}});
  EXPECT_EQ(both.ShapeType(), TopAbs_COMPOUND);
  EXPECT_EQ(both.NbChildren(), 2);
}

}  // namespace
}  // namespace blossom::occt
