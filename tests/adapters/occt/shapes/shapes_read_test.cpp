// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that are no good: the message names the file, the place and the cause.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/shapes_files.h"
#include "tests/adapters/occt/surfaces_samples.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;
using testing::Folder;

/// What reading says, without the file's name, which must stand before it.
std::string refusal(const fs::path& file) {
  const std::string name = file.string() + ": ";
  try {
    read_model(file);
  } catch (const BadModel& error) {
    const std::string text = error.what();
    return text.starts_with(name) ? text.substr(name.size()) : "without the name: " + text;
  }
  return "accepted";
}

/// A small good file of a format, as text.
std::string sample(const std::string& ending) {
  const Folder folder;
  testing::write_machine(folder / "machine.step");
  write_model(read_model(folder / "machine.step"), folder / ("sample" + ending));
  return testing::content(folder / ("sample" + ending));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

class EveryFormat : public ::testing::TestWithParam<const char*> {
 protected:
  fs::path file() const { return folder_ / (std::string("part") + GetParam()); }
  Folder folder_;
};

TEST_P(EveryFormat, RefusesWhatIsNoFileOrEmptyOrSomethingElse) {
  EXPECT_EQ(refusal(file()), "no such file");
  testing::write_content(file(), "");
  EXPECT_EQ(refusal(file()), "is empty");
  testing::write_content(file(), " \n\n");
  EXPECT_EQ(refusal(file()), "is empty");
  testing::write_content(file(), "This is a letter.\nIt is no model.\n");
  EXPECT_EQ(refusal(file()).substr(0, 5), "is no");
  testing::write_content(file(), std::string(5000, '\0'));
  EXPECT_NE(refusal(file()), "accepted");
  fs::remove(file());
  fs::create_directory(file());
  EXPECT_EQ(refusal(file()), "is a folder");
}

TEST_P(EveryFormat, RefusesFilesThatAreCutOffAnywhere) {
  const std::string text = sample(GetParam());
  testing::write_content(file(), text);
  EXPECT_EQ(refusal(file()), "accepted");
  for (std::size_t k = 1; k < 40; ++k) {
    testing::write_content(file(), text.substr(0, text.size() * k / 40));
    EXPECT_NE(refusal(file()), "accepted") << k;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryFormat, ::testing::Values(".step", ".iges", ".brep"));

TEST(Reading, RefusesUnknownEndings) {
  EXPECT_EQ(refusal("part.obj"),
            "the ending '.obj' is not known; known are .step .stp .iges .igs .brep .brp");
  EXPECT_EQ(refusal("part").substr(0, 27), "the ending '' is not known;");
}

TEST(ReadingStep, SaysThatTheEndIsMissing) {
  const Folder folder;
  testing::write_content(folder / "cut.step",
                         replaced(sample(".step"), "END-ISO-10303-21", "END-ISO"));
  EXPECT_EQ(refusal(folder / "cut.step"), "is cut off: END-ISO-10303-21 is missing");
}

TEST(ReadingStep, NamesTheEntityThatIsNotThere) {
  const Folder folder;
  std::string text = sample(".step");
  const std::size_t line = text.find("\n#40 ") + 1;
  text.erase(line, text.find('\n', line) - line);
  testing::write_content(folder / "hole.step", text);
  EXPECT_EQ(refusal(folder / "hole.step"), "is damaged: it uses #40, which is not there");
}

TEST(ReadingStep, NamesTheEntityWhoseNumberIsNone) {
  const Folder folder;
  for (const char* number : {"NAN", "nan", "$", "'x'"}) {
    testing::write_content(folder / "nan.step",
                           replaced(sample(".step"), "CARTESIAN_POINT('',(0.000000000000000E+00,",
                                    std::string("CARTESIAN_POINT('',(") + number + ","));
    EXPECT_EQ(refusal(folder / "nan.step").substr(0, 5), "is da") << number;
    EXPECT_NE(refusal(folder / "nan.step").find("CartesianPoint"), std::string::npos) << number;
  }
}

/// A face on a rational B-spline surface, as STEP text on one line per entity.
std::string rational_step() {
  const Folder folder;
  testing::Random random(1);
  const auto surface = testing::random_spline_surface(random, true, false, false);
  surface->SetWeight(1, 1, 0.4375);
  Model model;
  model.add(BRepBuilderAPI_MakeFace(surface, 1e-7).Face(), "sheet");
  write_model(model, folder / "sheet.step");
  return testing::content(folder / "sheet.step");
}

TEST(ReadingStep, NamesTheSplineWhoseWeightOrKnotsAreNoGood) {
  const Folder folder;
  const std::string text = rational_step();
  for (const char* weight : {"0.", "-2.5"}) {
    testing::write_content(folder / "sheet.step", replaced(text, "0.437500000000000", weight));
    const std::string said = refusal(folder / "sheet.step");
    EXPECT_NE(said.find("a weight is " + std::to_string(std::stod(weight)) +
                        ", weights must be positive"),
              std::string::npos)
        << said;
  }
  const std::size_t knots = text.find("B_SPLINE_SURFACE_WITH_KNOTS((4,");
  ASSERT_NE(knots, std::string::npos);
  testing::write_content(folder / "sheet.step", std::string(text).replace(knots + 29, 1, "3"));
  EXPECT_NE(refusal(folder / "sheet.step").find("11 knots of degree 3 do not fit 8"),
            std::string::npos)
      << refusal(folder / "sheet.step");
}

TEST(ReadingStep, RefusesFilesWithoutAShape) {
  const Folder folder;
  testing::write_content(folder / "none.step",
                         "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                         "FILE_NAME('','',(''),(''),'','','');\n"
                         "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"
                         "#1 = CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n");
  EXPECT_EQ(refusal(folder / "none.step"), "holds no shape");
}

TEST(ReadingBrep, NamesTheFaceAndTheNumberThatIsNoGood) {
  const fs::path inputs = fs::path(BLOSSOM_TEST_FILES) / "inputs";
  EXPECT_EQ(refusal(inputs / "nan-pole-in-face-2.brep"),
            "face 2: control point (2, 2) is not finite");
  EXPECT_EQ(refusal(inputs / "infinite-plane-in-face-1.brep"),
            "face 1: a number of the surface is not finite");
  EXPECT_EQ(refusal(inputs / "zero-weight-in-face-2.brep"),
            "face 2: its surface cannot be read: weight (2, 1) is 0.000000, weights must be "
            "positive");
  EXPECT_EQ(refusal(inputs / "negative-weight-in-face-2.brep"),
            "face 2: its surface cannot be read: weight (2, 1) is -1.500000, weights must be "
            "positive");
}

TEST(ReadingBrep, NamesTheCurveThatOpenCascadeWouldLeaveOut) {
  const fs::path inputs = fs::path(BLOSSOM_TEST_FILES) / "inputs";
  EXPECT_EQ(refusal(inputs / "zero-weight-in-curve-6.brep"),
            "is damaged: the numbers of curve 6 in the table 'Curves' make no curve");
}

TEST(ReadingBrep, NamesTheEdgeWhoseNumbersAreNone) {
  const Folder folder;
  const std::string text = sample(".brep");
  testing::write_content(folder / "edge.brep", replaced(text, "\n1 0 0 0 ", "\n1 0 nan 0 "));
  EXPECT_EQ(refusal(folder / "edge.brep"), "edge 1: a number of the curve is not finite");
}

// The sample with another entry for the first line or plane of a table.
std::string with_entry(const std::string& table, const std::string& entry) {
  const std::string text = sample(".brep");
  const std::size_t first = text.find("\n1 ", text.find("\n" + table + " ") + 1) + 1;
  return std::string(text).replace(first, text.find('\n', first) - first, entry);
}

TEST(ReadingBrep, NamesTheEdgeWhoseCurveInAFaceHasNoNumbers) {
  const Folder folder;
  Model model;
  model.add(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), "box");
  write_model(model, folder / "box.brep");
  std::string text = testing::content(folder / "box.brep");
  const std::size_t first = text.find("\n1 ", text.find("\nCurve2ds ")) + 1;
  text.replace(first, text.find('\n', first) - first, "1 nan 0 1 0 ");
  testing::write_content(folder / "edge.brep", text);
  EXPECT_NE(refusal(folder / "edge.brep")
                .find(": a point of its curve in a face's parameters is not finite"),
            std::string::npos)
      << refusal(folder / "edge.brep");
}

TEST(ReadingBrep, NamesTheFaceWhoseRadiusIsZero) {
  const Folder folder;
  testing::write_content(folder / "ball.brep",
                         with_entry("Surfaces", "4 0 0 0 0 0 1 1 0 0 0 1 0 0 "));
  EXPECT_NE(refusal(folder / "ball.brep").find(": its radius is 0.0"), std::string::npos)
      << refusal(folder / "ball.brep");
}

TEST(ReadingBrep, NamesTheTableWithMoreEntriesThanTheFileHasLines) {
  const Folder folder;
  testing::write_content(folder / "many.brep",
                         replaced(sample(".brep"), "\nCurves ", "\nCurves 20000000"));
  EXPECT_EQ(refusal(folder / "many.brep"),
            "is damaged: it cannot have as many entries as its table 'Curves' says");
}

TEST(ReadingBrep, NamesTheFileThatAsksForTooManyPoints) {
  const Folder folder;
  testing::write_content(folder / "huge.brep",
                         with_entry("Surfaces", "9 0 0 0 0 1 1 2000000000 2000000000 2 2 0 0 0 "));
  EXPECT_NE(refusal(folder / "huge.brep").find("memory"), std::string::npos)
      << refusal(folder / "huge.brep");
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

TEST(ReadingIges, CountsTheLinesOfEachSection) {
  const Folder folder;
  std::string text = sample(".iges");
  const std::size_t line = text.find("P0000020\n");
  ASSERT_NE(line, std::string::npos);
  text.erase(line - 72, 81);
  testing::write_content(folder / "hole.iges", text);
  EXPECT_EQ(refusal(folder / "hole.iges").substr(0, 25), "is damaged: section P has");
}

TEST(FaceNumbers, AreOneToTheCountAndRefusedByName) {
  const Folder folder;
  testing::write_machine(folder / "machine.step");
  const Model model = read_model(folder / "machine.step");
  EXPECT_FALSE(model.face(18).IsNull());
  for (const int number : {0, 19, -1}) try {
      model.face(number);
      FAIL();
    } catch (const BadModel& error) {
      EXPECT_EQ(error.what(), (folder / "machine.step").string() + ": there is no face " +
                                  std::to_string(number) + ", faces are 1 to 18");
    }
}

}  // namespace
}  // namespace blossom::occt
