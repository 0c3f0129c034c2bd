// SPDX-License-Identifier: LGPL-2.1-or-later
// Damaged and odd BREP files.

#include <filesystem>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BinTools.hxx>

#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/read_files.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;
using testing::faces_of;
using testing::Folder;
using testing::loss;
using testing::refusal;
using testing::replaced;
using testing::sample;

TEST(ReadingBrep, LeavesOutTheFaceWhoseNumbersAreNoGood) {
  const fs::path inputs = fs::path(BLOSSOM_TEST_FILES) / "inputs";
  EXPECT_EQ(loss(inputs / "nan-pole-in-face-2.brep"),
            "face (face 2): control point (2, 2) is not finite");
  EXPECT_EQ(faces_of(inputs / "nan-pole-in-face-2.brep"), 1);
  EXPECT_EQ(loss(inputs / "zero-weight-in-face-2.brep"),
            "face (face 2): its surface cannot be read: weight (2, 1) is 0.000000, weights must be "
            "positive");
  EXPECT_EQ(loss(inputs / "negative-weight-in-face-2.brep"),
            "face (face 2): its surface cannot be read: weight (2, 1) is -1.500000, weights must "
            "be positive");
}

TEST(ReadingBrep, LeavesOutAPlaneThatIsNowhere) {
  const fs::path inputs = fs::path(BLOSSOM_TEST_FILES) / "inputs";
  EXPECT_EQ(loss(inputs / "infinite-plane-in-face-1.brep"),
            "face (face 1): a number of the surface is not finite");
}

TEST(ReadingBrep, LeavesOutTheFaceOfACurveThatOpenCascadeDoesNotRead) {
  const fs::path inputs = fs::path(BLOSSOM_TEST_FILES) / "inputs";
  EXPECT_NE(
      loss(inputs / "zero-weight-in-curve-6.brep").find("the numbers of its curve make no curve"),
      std::string::npos)
      << loss(inputs / "zero-weight-in-curve-6.brep");
}

TEST(ReadingBrep, LeavesOutTheFacesOfAnEdgeWhoseNumbersAreNone) {
  const Folder folder;
  const std::string text = sample(".brep");
  testing::write_content(folder / "edge.brep", replaced(text, "\n1 0 0 0 ", "\n1 0 nan 0 "));
  EXPECT_EQ(faces_of(folder / "edge.brep"), 16);
  EXPECT_NE(loss(folder / "edge.brep").find("edge 1: a number of the curve is not finite"),
            std::string::npos)
      << loss(folder / "edge.brep");
}

TEST(ReadingBrep, LeavesOutTheFacesOfAnEdgeWhoseRangeRunsBackwards) {
  const Folder folder;
  Model model;
  model.add(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), "box");
  write_model(model, folder / "box.brep");
  // The line "1  curve location first last" of the first edge.
  testing::write_content(folder / "edge.brep", replaced(testing::content(folder / "box.brep"),
                                                        "\n1  1 0 0 1\n", "\n1  1 0 3 1\n"));
  EXPECT_EQ(faces_of(folder / "edge.brep"), 4);
  EXPECT_NE(loss(folder / "edge.brep").find("edge 1: its range runs backwards"), std::string::npos)
      << loss(folder / "edge.brep");
}

// The sample with another entry for the first line or plane of a table.
std::string with_entry(const std::string& table, const std::string& entry) {
  const std::string text = sample(".brep");
  const std::size_t first = text.find("\n1 ", text.find("\n" + table + " ") + 1) + 1;
  return std::string(text).replace(first, text.find('\n', first) - first, entry);
}

TEST(ReadingBrep, LeavesOutTheFacesOfAnEdgeWhoseCurveInAFaceHasNoNumbers) {
  const Folder folder;
  Model model;
  model.add(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), "box");
  write_model(model, folder / "box.brep");
  std::string text = testing::content(folder / "box.brep");
  const std::size_t first = text.find("\n1 ", text.find("\nCurve2ds ")) + 1;
  text.replace(first, text.find('\n', first) - first, "1 nan 0 1 0 ");
  testing::write_content(folder / "edge.brep", text);
  EXPECT_NE(loss(folder / "edge.brep")
                .find(": a point of its curve in a face's parameters is not finite"),
            std::string::npos)
      << loss(folder / "edge.brep");
  EXPECT_EQ(faces_of(folder / "edge.brep"), 4);
}

TEST(ReadingBrep, LeavesOutTheFaceWhoseRadiusIsZero) {
  const Folder folder;
  testing::write_content(folder / "ball.brep",
                         with_entry("Surfaces", "4 0 0 0 0 0 1 1 0 0 0 1 0 0 "));
  EXPECT_NE(loss(folder / "ball.brep").find(": its radius is 0.0"), std::string::npos)
      << loss(folder / "ball.brep");
}

TEST(ReadingBrep, NamesTheTableWithMoreEntriesThanTheFileHasLines) {
  const Folder folder;
  testing::write_content(folder / "many.brep",
                         replaced(sample(".brep"), "\nCurves ", "\nCurves 20000000"));
  EXPECT_EQ(refusal(folder / "many.brep"),
            "is damaged: it cannot have as many entries as its table 'Curves' says");
}

TEST(ReadingBrep, RefusesFilesWhoseParameterCurvesAreLost) {
  const Folder folder;
  testing::write_content(folder / "part.brep", replaced(sample(".brep"), "Curve2ds", "Curve2ts"));
  EXPECT_EQ(refusal(folder / "part.brep"), "is damaged: Not a Curve2d table");
}

TEST(ReadingBrep, SaysNothingOnStandardOutput) {
  const Folder folder;
  testing::write_content(folder / "part.brep", replaced(sample(".brep"), "Surfaces", "Surfices"));
  ::testing::internal::CaptureStdout();
  const std::string said = refusal(folder / "part.brep");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(said.substr(0, 17), "is damaged: Not a");
}

TEST(ReadingBrep, EndsWhenANumberCannotBeRead) {
  const Folder folder;
  const std::string text = sample(".brep");
  const std::size_t shapes = text.find("\nTShapes ");
  for (const char* other : {"x", "1e", "--1", "99999999"}) {
    const std::size_t place = text.find("\n1e-07\n", shapes);
    ASSERT_NE(place, std::string::npos);
    testing::write_content(folder / "part.brep",
                           std::string(text).replace(place + 1, 5, other).insert(shapes, "\n"));
    refusal(folder / "part.brep");
    testing::write_content(
        folder / "part.brep",
        replaced(text, "\nTriangulations 0", std::string("\nTriangulations ") + other));
    EXPECT_TRUE(refusal(folder / "part.brep").starts_with("is damaged")) << other;
  }
}

TEST(ReadingBrep, TakesTheBinaryForm) {
  const Folder folder;
  TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  std::ostringstream bytes;
  BinTools::Write(box, bytes);
  testing::write_content(folder / "box.brep", bytes.str());
  EXPECT_EQ(faces_of(folder / "box.brep"), 6);
  for (std::size_t k = 1; k < 20; ++k) {
    testing::write_content(folder / "box.brep", bytes.str().substr(0, bytes.str().size() * k / 20));
    EXPECT_NE(refusal(folder / "box.brep"), "accepted") << k;
  }
}

}  // namespace
}  // namespace blossom::occt
