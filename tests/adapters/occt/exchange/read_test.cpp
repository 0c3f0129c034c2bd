// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that are no good: the message names the file, the place and the cause; and files of which
// something is whole: that is read, and the rest is listed.

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BinTools.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/convert/surfaces_samples.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

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

/// The first loss of a file that is read in parts.
std::string loss(const fs::path& file) {
  const Model model = read_model(file);
  return model.reading().losses.empty() ? "nothing is lost" : model.reading().losses.front().text();
}

int faces_of(const fs::path& file) { return read_model(file).face_count(); }

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

/// Solids of IGES whose faces are cut off may end the process, which the command line survives:
/// ReadingCutFiles.AreReadInPartsOrRefusedInWords in tests/plugin/cli.
class FormatThatCanBeCut : public EveryFormat {};

TEST_P(FormatThatCanBeCut, GivesWhatIsWholeOfFilesThatAreCutOffAnywhere) {
  const std::string text = sample(GetParam());
  testing::write_content(file(), text);
  const int all = faces_of(file());
  EXPECT_EQ(read_model(file()).reading().grade(), ReadingGrade::Whole);
  int read = 0;
  for (std::size_t k = 1; k < 40; ++k) {
    testing::write_content(file(), text.substr(0, text.size() * k / 40));
    try {
      const Model model = read_model(file());
      EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost) << k;
      EXPECT_LE(model.face_count(), all) << k;
      ++read;
    } catch (const BadModel&) {
      EXPECT_LT(k, 39U);
    }
  }
  EXPECT_GT(read, 0);
}

TEST_P(EveryFormat, IsFoundByTheContentWhateverTheEnding) {
  testing::write_content(folder_ / "part.dat", sample(GetParam()));
  EXPECT_EQ(faces_of(folder_ / "part.dat"), 18);
  testing::write_content(folder_ / "part.igs", sample(GetParam()));
  EXPECT_EQ(faces_of(folder_ / "part.igs"), 18);
}

TEST_P(EveryFormat, HasLineEndsOfAnySystem) {
  std::string mac = sample(GetParam()), windows;
  for (const char c : mac) windows += c == '\n' ? "\r\n" : std::string(1, c);
  std::ranges::replace(mac, '\n', '\r');
  testing::write_content(file(), mac);
  EXPECT_EQ(faces_of(file()), 18);
  testing::write_content(file(), windows);
  EXPECT_EQ(faces_of(file()), 18);
}

/// Text in UTF-16 or UTF-32: so many bytes a letter, the least first or last.
std::string wide(const std::string& text, std::size_t bytes, bool least_first, bool mark) {
  std::string made;
  const auto put = [&](unsigned code) {
    for (std::size_t i = 0; i < bytes; ++i)
      made += static_cast<char>(code >> 8 * (least_first ? i : bytes - 1 - i) & 0xFFU);
  };
  if (mark) put(0xFEFF);
  for (const char c : text) put(static_cast<unsigned char>(c));
  return made;
}

TEST_P(EveryFormat, MayHaveWideLetters) {
  for (const std::size_t bytes : {2, 4})
    for (const bool least_first : {true, false})
      for (const bool mark : {true, false}) {
        testing::write_content(file(), wide(sample(GetParam()), bytes, least_first, mark));
        EXPECT_EQ(faces_of(file()), 18) << bytes << least_first << mark;
      }
}

TEST_P(EveryFormat, ReadsWithoutNamesWhenTheyAreNotWanted) {
  testing::write_content(file(), sample(GetParam()));
  std::vector<std::string> steps;
  const Model model = read_model(
      file(), {.names = false, .step = [&](const char* step) { steps.push_back(step); }});
  EXPECT_EQ(model.face_count(), 18);
  EXPECT_TRUE(model.face_names().front().empty());
  ASSERT_FALSE(steps.empty());
  for (const std::string& step : steps) {
    EXPECT_TRUE(step.ends_with(" of " + file().string())) << step;
    EXPECT_EQ(step.find("names"), std::string::npos) << step;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryFormat, ::testing::Values(".step", ".iges", ".brep"));
INSTANTIATE_TEST_SUITE_P(All, FormatThatCanBeCut, ::testing::Values(".step", ".brep"));

TEST(Reading, RefusesWhatIsOfNoFormatAndHasAnUnknownEnding) {
  const Folder folder;
  EXPECT_EQ(refusal(folder / "part.obj"), "no such file");
  testing::write_content(folder / "part.obj", "v 0 0 0\n");
  EXPECT_EQ(refusal(folder / "part.obj"),
            "is no STEP, IGES or BREP file by its content, and the ending '.obj' is not known");
}

TEST(Reading, RefusesPipesAndDevicesWithoutWaiting) {
  const Folder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.step").c_str(), 0600), 0);
  EXPECT_EQ(refusal(folder / "pipe.step"), "is no regular file");
  EXPECT_EQ(refusal("/dev/zero"), "is no regular file");
}

TEST(Reading, RefusesFilesThatAreLargerThanTheMemory) {
  const Folder folder;
  testing::write_content(folder / "huge.step", "ISO-10303-21;");
  fs::resize_file(folder / "huge.step", std::uintmax_t{1} << 42U);  // a hole takes no room
  EXPECT_EQ(refusal(folder / "huge.step"), "is larger than the memory of this machine");
}

TEST(ReadingStep, TakesAFileWhoseLastLineIsMissing) {
  const Folder folder;
  testing::write_content(folder / "cut.step", replaced(sample(".step"), "END-ISO-10303-21;", ""));
  EXPECT_EQ(loss(folder / "cut.step"), "the file's last line: END-ISO-10303-21 is missing");
  EXPECT_EQ(read_model(folder / "cut.step").reading().grade(), ReadingGrade::AttributesLost);
  EXPECT_EQ(faces_of(folder / "cut.step"), 18);
}

TEST(ReadingStep, TakesOddBeginningsAndSmallLetters) {
  const Folder folder;
  const std::string text = sample(".step");
  std::string small = text;
  bool quoted = false;
  for (char& c : small) {
    quoted = quoted != (c == '\'');
    if (!quoted) c = static_cast<char>(std::tolower(c));
  }
  const std::string odd[] = {"\xef\xbb\xbf" + text, "/* ISO-10303-21; by hand */\n\n" + text, small,
                             text + std::string(100, '\0')};
  for (const std::string& content : odd) {
    testing::write_content(folder / "odd.step", content);
    EXPECT_EQ(faces_of(folder / "odd.step"), 18) << content.substr(0, 40);
    EXPECT_EQ(read_model(folder / "odd.step").reading().grade(), ReadingGrade::Whole);
    EXPECT_EQ(read_model(folder / "odd.step").part_name(1), "Base plate");
  }
}

TEST(ReadingStep, TakesWideLettersForThoseTheyAre) {
  const Folder folder;
  std::string text = sample(".step");
  while (text.find("Base plate") != std::string::npos)
    text = replaced(text, "Base plate", "Pl\xE4tte @@");
  text = wide(text, 2, true, true);
  for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@'))
    text.replace(at, 4, "\x3D\xD8\x29\xDD");  // one letter in two halves
  testing::write_content(folder / "named.step", text);
  EXPECT_EQ(read_model(folder / "named.step").part_name(1), "Pl\xC3\xA4tte \xF0\x9F\x94\xA9");
}

TEST(ReadingStep, TellsNumbersOfSeveralEntities) {
  const Folder folder;
  const std::string point = "#99999=CARTESIAN_POINT('',(1.,2.,3.));\n";
  const std::string other = "#99999=CARTESIAN_POINT('',(9.,2.,3.));\n";
  const auto with = [&](const std::string& more) {
    testing::write_content(folder / "again.step",
                           replaced(sample(".step"), "DATA;\n", "DATA;\n" + more));
  };
  with(point + point);
  EXPECT_EQ(read_model(folder / "again.step").reading().grade(), ReadingGrade::Whole);
  with(point + other);
  EXPECT_EQ(loss(folder / "again.step"),
            "entity number (#99999): several entities have it, and the first is taken");
  EXPECT_EQ(faces_of(folder / "again.step"), 18);
}

/// Reads the sample with each entity of a kind damaged in its first field behind the name, which
/// ends with a mark.
void expect_outlived(const std::string& kind, char mark) {
  const Folder folder;
  const std::string text = sample(".step"), start = kind + "('',";
  int wholes = 0;
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
    const std::size_t place = at + start.size();
    std::string damaged = text;
    damaged.replace(place, text.find(mark, place) - place, mark == ';' ? "$)" : "$");
    testing::write_content(folder / "damaged.step", damaged);
    const Model model = read_model(folder / "damaged.step");
    EXPECT_LE(model.face_count(), 18);
    if (model.face_count() == 18)
      ++wholes;
    else
      EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost) << kind << at;
    EXPECT_NE(model.reading().grade(), ReadingGrade::Whole) << kind << at;
  }
  EXPECT_GT(wholes, 0);
}

TEST(ReadingStep, OutlivesPlacementsWithoutALocationOrADirection) {
  expect_outlived("AXIS2_PLACEMENT_3D", ',');
  expect_outlived("DIRECTION", ';');
}

TEST(ReadingStep, UsesCurvesInSpaceWhereThoseInFacesAreAnEmptyList) {
  const Folder folder;
  std::string text = sample(".step");
  const std::size_t begin = text.find("SURFACE_CURVE("), list = text.find(",(#", begin) + 1;
  text.replace(list, text.find(')', list) + 1 - list, "()");
  testing::write_content(folder / "empty.step", text);
  EXPECT_EQ(faces_of(folder / "empty.step"), 18);
  EXPECT_EQ(read_model(folder / "empty.step").reading().grade(), ReadingGrade::AttributesLost);
}

TEST(ReadingStep, TakesNamesAsOtherProgramsWriteThem) {
  const Folder folder;
  const auto name_of_first = [&](const std::string& written) {
    std::string text = sample(".step");
    while (text.find("Base plate") != std::string::npos)
      text = replaced(text, "Base plate", written);
    testing::write_content(folder / "named.step", text);
    const Model model = read_model(folder / "named.step");
    EXPECT_EQ(model.reading().grade(), ReadingGrade::Whole) << written;
    return model.part_name(1);
  };
  EXPECT_EQ(name_of_first("\xE6\x97\xA5\xE6\x9C\xAC"), "\xE6\x97\xA5\xE6\x9C\xAC");
  EXPECT_EQ(name_of_first("gear \xF0\x9F\x94\xA9"), "gear \xF0\x9F\x94\xA9");  // beyond 16 bits
  EXPECT_EQ(name_of_first("W\xE4lzlager"), "W\xC3\xA4lzlager");                // Latin-1
  EXPECT_EQ(name_of_first("\xED\xA0\x80"), "\xC3\xAD\xC2\xA0\xC2\x80");        // half a pair
  EXPECT_EQ(name_of_first("red\x1B[31m"), "red [31m");
}

/// The number of an entity, "#40", that has `text` in it.
std::string entity_with(const std::string& step, const std::string& text) {
  const std::size_t place = step.find(text);
  EXPECT_NE(place, std::string::npos) << text;
  const std::size_t start = step.rfind("\n#", place) + 1;
  return step.substr(start, step.find_first_of(" =", start) - start);
}

TEST(ReadingStep, LeavesOutTheFacesOfAnEntityThatIsNotThere) {
  const Folder folder;
  std::string text = sample(".step");
  const std::string edge = entity_with(text, "EDGE_CURVE(");
  const std::size_t line = text.find("\n" + edge + " ") + 1;
  text.erase(line, text.find('\n', line) - line);
  testing::write_content(folder / "hole.step", text);
  const Model model = read_model(folder / "hole.step");
  EXPECT_EQ(model.face_count(), 16);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
  EXPECT_NE(loss(folder / "hole.step").find("edge_element is of another kind"), std::string::npos)
      << loss(folder / "hole.step");
  EXPECT_NE(loss(folder / "hole.step").find("product 'Base plate'"), std::string::npos)
      << loss(folder / "hole.step");
}

TEST(ReadingStep, LeavesOutTheFacesOfAPointThatIsNone) {
  const Folder folder;
  const std::string text = sample(".step");
  const std::string corner = entity_with(text, "VERTEX_POINT(");
  const std::size_t use = text.find('#', text.find("VERTEX_POINT("));
  const std::string point = text.substr(use, text.find(')', use) - use);
  const std::size_t place = text.find("\n" + point + " ");
  const std::size_t open = text.find("(", text.find("CARTESIAN_POINT", place) + 16);
  for (const char* number : {"NAN", "nan", "$", "'x'"}) {
    testing::write_content(
        folder / "nan.step",
        std::string(text).replace(open + 1, text.find(',', open) - open - 1, number));
    const Model model = read_model(folder / "nan.step");
    EXPECT_EQ(model.face_count(), 15) << number;  // three faces meet in a corner
    EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost) << number;
  }
  testing::write_content(folder / "flat.step",
                         std::string(text).erase(open + 1, text.find(',', open) - open));
  EXPECT_NE(loss(folder / "flat.step").find("its point has 2 coordinates instead of 3"),
            std::string::npos);
  EXPECT_EQ(faces_of(folder / "flat.step"), 15);
}

TEST(ReadingStep, KeepsFacesWhoseColoursAreDamaged) {
  const Folder folder;
  const std::string text = sample(".step");
  const std::size_t style = text.find("STYLED_ITEM(");
  const std::size_t reference = text.find("(#", style);
  testing::write_content(folder / "style.step", std::string(text).replace(reference, 2, "(#99999"));
  const Model model = read_model(folder / "style.step");
  EXPECT_EQ(model.face_count(), 18);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::AttributesLost);
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

TEST(ReadingStep, RefusesTheOnlyFaceWhenWeightsOrKnotsAreNoGood) {
  const Folder folder;
  const std::string text = rational_step();
  for (const char* weight : {"0.", "-2.5"}) {
    testing::write_content(folder / "sheet.step", replaced(text, "0.437500000000000", weight));
    const std::string said = refusal(folder / "sheet.step");
    EXPECT_NE(said.find("a weight is " + std::to_string(std::stod(weight)) +
                        ", weights must be positive"),
              std::string::npos)
        << said;
    EXPECT_TRUE(said.starts_with("holds no shape that can be used")) << said;
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
  testing::write_content(folder / "none.step",
                         replaced(testing::content(folder / "none.step"),
                                  "#1 = CARTESIAN_POINT('',(0.,0.,0.));\n", ""));
  EXPECT_EQ(refusal(folder / "none.step"), "has a header, but nothing in it");
}

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

TEST(ReadingIges, TakesAByteOrderMark) {
  const Folder folder;
  testing::write_content(folder / "marked.iges", "\xef\xbb\xbf" + sample(".iges"));
  EXPECT_EQ(faces_of(folder / "marked.iges"), 18);
}

TEST(ReadingIges, CountsTheLinesOfEachSection) {
  const Folder folder;
  std::string text = sample(".iges");
  const std::size_t line = text.find("P0000020\n");
  ASSERT_NE(line, std::string::npos);
  text.erase(line - 72, 81);
  testing::write_content(folder / "hole.iges", text);
  EXPECT_EQ(loss(folder / "hole.iges").substr(0, 19), "lines of section P:");
  EXPECT_EQ(read_model(folder / "hole.iges").reading().grade(), ReadingGrade::ShapesLost);
}

TEST(ReadingIges, TakesAFileWhoseGlobalSectionIsCountedWrong) {
  const Folder folder;
  const std::string text = sample(".iges");
  const std::size_t count = text.find('G', text.rfind("\nS") + 1);
  testing::write_content(folder / "odd.iges", std::string(text).replace(count + 7, 1, "9"));
  EXPECT_EQ(faces_of(folder / "odd.iges"), 18);
  EXPECT_EQ(read_model(folder / "odd.iges").reading().grade(), ReadingGrade::AttributesLost);
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
