// SPDX-License-Identifier: LGPL-2.1-or-later
// Damaged and odd STEP files.

#include <algorithm>
#include <cctype>
#include <string>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>

#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/convert/surfaces_samples.h"
#include "tests/adapters/occt/exchange/read_files.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::faces_of;
using testing::Folder;
using testing::loss;
using testing::refusal;
using testing::replaced;
using testing::sample;
using testing::wide;

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

/// The sample with other text for the first `from` behind `start`, read with damaged faces made as
/// far as they can be.
Model read_damaged(const std::string& start, const std::string& from, const std::string& to) {
  const Folder folder;
  std::string text = sample(".step");
  const std::size_t entity = text.find(start), place = text.find(from, entity);
  EXPECT_NE(entity, std::string::npos) << start;
  EXPECT_NE(place, std::string::npos) << from;
  testing::write_content(folder / "damaged.step", text.replace(place, from.size(), to));
  return read_model(folder / "damaged.step", {.damaged = true});
}

bool tells(const Model& model, const std::string& words) {
  return std::ranges::any_of(model.reading().losses, [&](const Loss& loss) {
    return loss.of_shape && loss.text().find(words) != std::string::npos;
  });
}

/// The field behind the name of the first entity of a kind.
std::string first_field(const std::string& kind) {
  const std::string text = sample(".step");
  const std::size_t place = text.find('#', text.find(kind));
  return text.substr(place, text.find_first_of(",)", place) - place);
}

TEST(ReadingStep, MakesFacesOfWhatIsLeftWhenAsked) {
  const Model model = read_damaged("ORIENTED_EDGE(", first_field("ORIENTED_EDGE("), "$");
  EXPECT_EQ(model.face_count(), 18);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
  EXPECT_TRUE(tells(model, "edge_element is missing; it is made of what is left"));
}

TEST(ReadingStep, LeavesOutDamagedFacesThatWouldTakeOthersAlong) {
  const Model model = read_damaged("EDGE_CURVE(", first_field("EDGE_CURVE("), "$");
  EXPECT_EQ(model.face_count(), 16);
  EXPECT_TRUE(tells(model, "2 faces"));
  EXPECT_FALSE(tells(model, "made of what is left"));
}

TEST(ReadingStep, MakesEdgesWithoutCurvesWhoseNumbersAreNone) {
  const std::string text = sample(".step");
  const std::size_t end = text.find(");", text.find("VECTOR(")), length = text.rfind(',', end);
  const Model model = read_damaged("VECTOR(", text.substr(length, end - length), ",$");
  EXPECT_EQ(model.face_count(), 18);
  EXPECT_TRUE(tells(model, "VECTOR: magnitude is no number; it is made of what is left"));
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
}

TEST(ReadingStep, LeavesOutFacesOnSurfacesWhoseNumbersAreNone) {
  const std::string text = sample(".step"), direction = "DIRECTION('',(";
  const std::size_t place = text.find(direction, text.find("PLANE("));
  const std::string first = text.substr(place, text.find(',', place + direction.size()) - place);
  const Model model = read_damaged("PLANE(", first, direction + "$");
  EXPECT_EQ(model.face_count(), 17);
  EXPECT_TRUE(tells(model, "direction_ratios is no number"));
  EXPECT_FALSE(tells(model, "made of what is left"));
}

TEST(ReadingStep, TakesEntitiesWithTooManyFieldsForEmpty) {
  const Model model = read_damaged("ADVANCED_FACE(", ");", ",$);");
  EXPECT_EQ(model.face_count(), 17);
  EXPECT_TRUE(tells(model, "it does not have 4 parameters"));
}

TEST(ReadingStep, LeavesOutFacesAtPlacesThatAreEndless) {
  const std::string corner = first_field("VERTEX_POINT(");
  const std::string text = sample(".step");
  const std::size_t open = text.find("(", text.find("(", text.find("\n" + corner + " =")) + 1);
  const std::string first = text.substr(open, text.find(',', open) - open);
  const Model model = read_damaged("\n" + corner + " =", first, "(1.E+308");
  EXPECT_EQ(model.face_count(), 15);
  EXPECT_TRUE(tells(model, "CARTESIAN_POINT: a coordinate is not finite"));
}

TEST(ReadingStep, UsesCurvesInSpaceWhereThoseInFacesAreNone) {
  const std::string curve = first_field("DEFINITIONAL_REPRESENTATION(");
  const Model model = read_damaged("DEFINITIONAL_REPRESENTATION(", curve, first_field("LINE("));
  EXPECT_EQ(model.face_count(), 18);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::AttributesLost);
}

TEST(ReadingStep, OutlivesShapesThatAreOfNothing) {
  const std::string of = first_field("SHAPE_DEFINITION_REPRESENTATION(");
  const Model model = read_damaged("SHAPE_DEFINITION_REPRESENTATION(", of, "$");
  EXPECT_EQ(model.face_count(), 18);
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
  testing::write_content(folder / "sheet.step", replaced(text, "0.437500000000000", "2.5E16"));
  EXPECT_NE(refusal(folder / "sheet.step").find("the lightest point is lost in roundings"),
            std::string::npos)
      << refusal(folder / "sheet.step");
  const std::size_t knots = text.find("B_SPLINE_SURFACE_WITH_KNOTS((4,");
  ASSERT_NE(knots, std::string::npos);
  testing::write_content(folder / "sheet.step", std::string(text).replace(knots + 29, 1, "3"));
  EXPECT_NE(refusal(folder / "sheet.step").find("11 knots of degree 3 do not fit 8"),
            std::string::npos)
      << refusal(folder / "sheet.step");
}

TEST(ReadingStep, TakesComplexEntitiesWithAPartOfTheWrongLength) {
  const Folder folder;
  testing::write_content(folder / "sheet.step", replaced(rational_step(), "REPRESENTATION_ITEM('')",
                                                         "REPRESENTATION_ITEM()"));
  EXPECT_NE(refusal(folder / "sheet.step").find("it has no fields"), std::string::npos);
  std::string text = rational_step();
  const std::size_t item = text.find("REPRESENTATION_ITEM('')", text.find("BOUNDED_SURFACE("));
  testing::write_content(folder / "sheet.step", text.replace(item, 23, "REPRESENTATION_ITEM()"));
  EXPECT_EQ(faces_of(folder / "sheet.step"), 1);
  EXPECT_EQ(read_model(folder / "sheet.step").reading().grade(), ReadingGrade::AttributesLost);
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

}  // namespace
}  // namespace blossom::occt
