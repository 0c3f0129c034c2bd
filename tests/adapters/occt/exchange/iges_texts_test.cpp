// SPDX-License-Identifier: LGPL-2.1-or-later
// IGES files as other systems write them: without line ends, with more behind them, in units that
// are none, and with entities that Open CASCADE makes nothing of.

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::Folder;
using testing::write_content;

std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string left(std::string text, std::size_t width) {
  text.resize(width, ' ');
  return text;
}

/// Sections as lists of lines.
class IgesWriting {
 public:
  std::string unit = "2,2HMM";

  /// parameters   with the number of the type before them
  /// returns      how other entities name it
  int add(int type, const std::string& parameters) {
    const int number = static_cast<int>(directory_.size()) + 1;
    const int first = static_cast<int>(parameters_.size()) + 1;
    std::string rest = std::to_string(type) + "," + parameters + ";";
    for (; !rest.empty(); rest.erase(0, std::min<std::size_t>(64, rest.size())))
      parameters_.push_back(left(rest.substr(0, 64), 64) + right(std::to_string(number), 8));
    const std::string kind = right(std::to_string(type), 8);
    const int lines = static_cast<int>(parameters_.size()) - first + 1;
    const std::string zero = right("0", 8), blank(8, ' ');
    directory_.push_back(kind + right(std::to_string(first), 8) + zero + zero + zero + zero + zero +
                         zero + "00000000");
    directory_.push_back(kind + zero + zero + right(std::to_string(lines), 8) + zero + blank +
                         blank + blank + zero);
    return number;
  }

  /// A bilinear surface of 10 by 10.
  int add_surface() {
    return add(128,
               "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,10.,0.,0.,0.,10.,0.,"
               "10.,10.,5.,0.,1.,0.,1.");
  }

  /// end   behind each line
  std::string text(const std::string& end = "\n") const {
    std::string global = "1H,,1H;,4Hpart,4Hpart,3Hsys,1H1,32,38,6,308,15,4Hpart,1.," + unit +
                         ",1,0.01,15H20200101.120000,1.E-5,1000.,2Hme,3Horg,11,0;";
    std::vector<std::string> globals;
    for (; !global.empty(); global.erase(0, std::min<std::size_t>(72, global.size())))
      globals.push_back(left(global.substr(0, 72), 72));
    const std::array sections{std::vector<std::string>{left("A test", 72)}, globals, directory_,
                              parameters_};
    std::string all, last;
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const char letter = "SGDP"[k];
      for (std::size_t i = 0; i < sections[k].size(); ++i)
        all += sections[k][i] + letter + right(std::to_string(i + 1), 7) + end;
      last += letter + right(std::to_string(sections[k].size()), 7);
    }
    return all + left(last, 72) + "T      1" + end;
  }

 private:
  std::vector<std::string> directory_, parameters_;
};

Model read_text(const std::string& text) {
  const Folder folder;
  write_content(folder / "part.igs", text);
  return read_model(folder / "part.igs");
}

std::string refusal_of(const std::string& text) {
  try {
    read_text(text);
  } catch (const BadModel& error) {
    const std::string what = error.what();
    return what.substr(what.find(": ") + 2);
  }
  return "accepted";
}

IgesWriting sheet() {
  IgesWriting file;
  file.add_surface();
  return file;
}

TEST(IgesTexts, AreReadWithAnyEndsOfLines) {
  for (const char* end : {"\n", "\r\n", "\r", "", "   more\n", "\n\n"}) {
    const Model model = read_text(sheet().text(end));
    EXPECT_EQ(model.face_count(), 1) << end;
    EXPECT_TRUE(model.reading().losses.empty()) << end << model.reading().summary();
  }
}

TEST(IgesTexts, AreReadBehindBlankLines) {
  EXPECT_EQ(read_text("\n  \r\n" + sheet().text()).face_count(), 1);
}

TEST(IgesTexts, InCompressedFormAreRefusedAsSuch) {
  EXPECT_EQ(refusal_of(left("", 72) + "C      1\n" + sheet().text()),
            "is in the compressed form of IGES, which Open CASCADE does not read");
}

TEST(IgesTexts, TellUnitsThatAreNone) {
  for (const char* unit : {"3,2HXX", "99,"}) {
    IgesWriting file = sheet();
    file.unit = unit;
    const std::string text = file.text();
    const std::string said =
        refusal_of(text) == "accepted" ? read_text(text).reading().summary() : refusal_of(text);
    EXPECT_NE(said.find("the unit of lengths"), std::string::npos) << unit << ": " << said;
  }
  IgesWriting file = sheet();
  file.unit = "3,4HInch";
  EXPECT_TRUE(read_text(file.text()).reading().losses.empty());
}

TEST(IgesTexts, TellEntitiesOfWhichNothingIsMade) {
  const std::string block = "1.,2.,3.,0.,0.,0.,1.,0.,0.,0.,0.,1.";
  IgesWriting alone;
  alone.add(150, block);
  EXPECT_EQ(refusal_of(alone.text()),
            "holds no shape that can be used: Block (D1): Open CASCADE makes no shape of it");
  IgesWriting beside = sheet();
  beside.add(150, block);
  const Model model = read_text(beside.text());
  EXPECT_EQ(model.face_count(), 1);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
}

/// A plane with a square hole in a square.
/// bounded   whether the border of the hole has a curve
std::string plane_with_a_hole(bool bounded) {
  IgesWriting file;
  const auto link = [](int number) { return std::to_string(number); };
  const int plane = file.add(108, "0.,0.,1.,0.,0,0.,0.,0.,1.");
  const auto square = [&](const std::string& half) {
    const std::array corners{"-" + half + ",-" + half, half + ",-" + half, half + "," + half,
                             "-" + half + "," + half};
    std::string lines;
    for (std::size_t k = 0; k < 4; ++k)
      lines += "," + link(file.add(110, corners[k] + ",0.," + corners[(k + 1) % 4] + ",0."));
    return link(file.add(102, "4" + lines));
  };
  const auto border = [&](const std::string& curve) {
    return link(file.add(142, "0," + link(plane) + ",0," + curve + ",2"));
  };
  const std::string outer = border(square("10.")), inner = border(bounded ? square("2.") : "0");
  file.add(144, link(plane) + ",1,1," + outer + "," + inner);
  return file.text();
}

TEST(IgesTexts, TellBordersThatCannotBeMade) {
  EXPECT_EQ(read_text(plane_with_a_hole(true)).reading().summary(), "");
  const Model model = read_text(plane_with_a_hole(false));
  EXPECT_EQ(model.face_count(), 1);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
  EXPECT_NE(model.reading().summary().find("the face goes on where it should end"),
            std::string::npos)
      << model.reading().summary();
}

TEST(IgesTexts, TellFaultsInWords) {
  for (const char* fault :
       {"110,0.,0.,0.,1.,0.,0.,8.", "126,1,1,0,0,1,7,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1."}) {
    IgesWriting file = sheet();
    file.add(std::stoi(fault), fault + 4);
    const Model model = read_text(file.text());
    EXPECT_FALSE(model.reading().losses.empty()) << fault;
    for (const Loss& loss : model.reading().losses)
      for (const char* no_word : {"%d", "XSTEP", "Unknown message"})
        EXPECT_EQ(loss.text().find(no_word), std::string::npos) << loss.text();
  }
}

TEST(IgesTexts, MayHaveAnEndlessPlaneAlone) {
  IgesWriting file;
  file.add(108, "0.,0.,1.,0.,0,0.,0.,0.,1.");
  EXPECT_EQ(read_text(file.text()).face_count(), 1);
}

}  // namespace
}  // namespace blossom::occt
