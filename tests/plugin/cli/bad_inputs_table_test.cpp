// SPDX-License-Identifier: LGPL-2.1-or-later
// Every line of tests/data/cli/bad_inputs.txt: a command line that cannot be done, the exit code
// and the message that it gets, or the beginning of it. Nothing is printed on stdout but the
// summary of what is refused, nothing is written, nothing hangs.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zlib.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shell.hxx>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using testing::blossom;
using testing::Finished;

struct Line {
  int number = 0;  // in the file
  int code = 0;
  std::vector<std::string> arguments;
  std::string message;  // the first line on stderr, without "blossom: "
  bool whole = true;    // or only the beginning

  bool is_message(const std::string& told) const {
    return whole ? told == message : told.starts_with(message);
  }
};

// "2 | intersect bowl.brep | intersect needs two models; the second is missing".
Line parsed(int number, const std::string& text) {
  const std::size_t first = text.find(" | "), last = text.find(" | ", first + 2);
  Line line{number, std::stoi(text.substr(0, first)), {}, text.substr(last + 3)};
  if (line.message.ends_with("...")) {
    line.whole = false;
    line.message.erase(line.message.size() - 3);
  }
  std::istringstream words(text.substr(first + 2, last - first - 2));
  for (std::string word; words >> word;) line.arguments.push_back(word);
  return line;
}

// The lines by sections, which empty lines divide.
std::vector<std::vector<Line>> table() {
  std::ifstream in(BLOSSOM_TEST_FILES "/cli/bad_inputs.txt");
  std::vector<std::vector<Line>> sections(1);
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    if (text.empty()) sections.emplace_back();
    if (!text.empty() && text[0] != '#') sections.back().push_back(parsed(number, text));
  }
  return sections;
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// The table of a BREP text said to have 2147483647 entries.
std::string with_count(std::string text, const std::string& table) {
  const std::size_t start = text.find("\n" + table + " ") + table.size() + 2;
  return text.replace(start, text.find('\n', start) - start, "2147483647");
}

std::string with_first_surface(std::string text, const std::string& surface) {
  const std::size_t heading = text.find("\nSurfaces ") + 1;
  return text.insert(text.find('\n', heading) + 1, surface);
}

constexpr int kSections = 13;  // the first is the file's comment

class BadInputsTable : public ::testing::TestWithParam<int> {
 protected:
  BadInputsTable() {
    write_models();
    write_texts();
    write_laws();
    std::filesystem::create_directory(folder / "folder.step");
    for (const char* name : {"pipe.step", "pipe.json"}) ::mkfifo((folder / name).c_str(), 0600);
    std::filesystem::create_symlink("bowl.brep", folder / "link_to_bowl.brep");
    std::filesystem::create_symlink("a.json", folder / "b_is_a.png");
    std::filesystem::create_symlink("target.step", folder / "dangling.json");
    testing::write_text(folder / "a.json", "{}");
    std::filesystem::create_hard_link(folder / "a.json", folder / "hard_a.png");
  }

  void write_models() {
    testing::write({testing::bowl()}, folder / "bowl.brep");
    testing::write({testing::lid(0.25)}, folder / "lid.step");
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    write(box, "box.step");
    write(BRepPrimAPI_MakeBox(gp_Pnt(9, 9, 9), gp_Pnt(10, 10, 10)).Shape(), "far.step");
    TopoDS_Shell shell;
    BRep_Builder().MakeShell(shell);
    TopExp_Explorer it(box, TopAbs_FACE);
    for (int i = 0; i < 5; ++i, it.Next()) BRep_Builder().Add(shell, it.Current());
    write(shell, "open.brep");
    write(BRepPrimAPI_MakeCylinder(1, 3).Shape(), "pin.step");
    write(box.Reversed(), "inverted.brep");
    write(three_leaves(), "leaves.brep");
  }

  // Three faces at one edge, all of it and all of them.
  static TopoDS_Shape three_leaves() {
    BRepBuilderAPI_Sewing sewing(1e-6, true, true, true, true);
    for (const gp_Pnt& out : {gp_Pnt(1, 0, 0), gp_Pnt(0, 1, 0), gp_Pnt(-1, -1, 0)})
      sewing.Add(BRepBuilderAPI_MakeFace(
          BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 1),
                                     out.Translated(gp_Vec(0, 0, 1)), out, true)
              .Wire()));
    sewing.Perform();
    return sewing.SewedShape();
  }

  void write_texts() {
    const std::string step = testing::text_of(folder / "lid.step");
    const std::string brep = testing::text_of(folder / "bowl.brep");
    const std::string letter = "Dear shipyard, please find the hull enclosed.\n";
    const std::string net = R"({"schema": "blossom.net/1", "nets": [{"kind": "patch", )";
    const std::vector<std::pair<const char*, std::string>> files = {
        {"empty.step", ""},
        {"empty.brep", ""},
        {"empty.igs", ""},
        {"empty.json", ""},
        {"letter.step", letter},
        {"letter.brep", letter},
        {"letter.igs", letter},
        {"jobs.jsonl", R"({"id": "a", "arguments": ["info", "bowl.brep"]})"},
        {"nojson.jsonl", "info bowl.brep\n"},
        {"list.jsonl", "[1]\n"},
        {"noid.jsonl", R"({"arguments": ["info"]})"},
        {"number.jsonl", R"({"id": 1, "arguments": ["info"]})"},
        {"longid.jsonl", R"({"id": ")" + std::string(1001, 'x') + R"(", "arguments": ["info"]})"},
        {"noarguments.jsonl", R"({"id": "a", "arguments": []})"},
        {"command.jsonl", R"({"id": "a", "arguments": "info bowl.brep"})"},
        {"nulls.jsonl", R"({"id": "a", "arguments": ["info", null]})"},
        {"zero.jsonl", R"({"id": "a", "arguments": ["info", "a\u0000b"]})"},
        {"member.jsonl", R"({"id": "a", "arguments": ["info"], "shell": true})"},
        {"twice.jsonl",
         "\n{\"id\": \"a\", \"arguments\": [\"info\"]}\n"
         "{\"id\": \"a\", \"arguments\": [\"check\"]}\n"},
        {"nested.jsonl", R"({"id": "a", "arguments": ["batch", "jobs.jsonl"]})"},
        {"deep.jsonl", std::string(100'000, '[')},
        {"long.jsonl", R"({"id": "a", "arguments": [")" + std::string(1 << 20, 'x') + R"("]})"},
        {"many.jsonl", R"({"id": "a", "arguments": ["info")" + repeated(R"(,"x")", 10'000) + "]}"},
        {"nest.jsonl", R"({"id": "a", "arguments": [)" + std::string(100'000, '[') +
                           std::string(100'000, ']') + "]}"},
        {"nest.json", R"({"schema": "blossom.net/1", "nets": )" + std::string(100'000, '[') +
                          std::string(100'000, ']') + "}"},
        {"degree.json", net + R"("degree": [26, 1], "points": []}]})"},
        {"huge.json", net + R"("degree": [1e300, 1], "points": []}]})"},
        {"deep.step", step.substr(0, step.find("DATA;") + 6) + "#1=POINT(" +
                          std::string(200'000, '(') + std::string(200'000, ')') +
                          ");\nENDSEC;\nEND-ISO-10303-21;\n"},
        {"loop.step", step.substr(0, step.find("DATA;") + 6) +
                          "#1=SHAPE_REPRESENTATION('',(#2),#1);\n#2=MAPPED_ITEM('',#3,#2);\n"
                          "#3=REPRESENTATION_MAP(#2,#1);\nENDSEC;\nEND-ISO-10303-21;\n"},
        {"many.brep", with_count(brep, "Surfaces")},
        {"shapes.brep", with_count(brep, "TShapes")},
        {"rows.brep", with_first_surface(brep, "9 0 0 0 0 1 1 2147483647 4 2 2 ")},
        {"noresult.jsonl", "{\"id\": \"a\"}\n"},
        {"cut.step", step.substr(0, step.size() / 3)},
        {"cut.brep", brep.substr(0, brep.size() / 2)},
        {"letter.doc", letter},
        {"broken.json", "{\"schema\": "},
        {"other.json", R"({"schema": "geo/1"})"},
        {"nonets.json", R"({"schema": "blossom.net/1", "nets": []})"},
        {"nan.json", net + R"("degree": [1, 1], "points": [[[0, 0, 0], [0, 1, NaN]]]}]})"},
        {"short.json", net + R"("degree": [1, 1], "points": [[[0, 0, 0], [0, 1, 0]]]}]})"}};
    for (const auto& [name, text] : files) testing::write_text(folder / name, text);
    write_bomb();
    ASSERT_EQ(blossom({"convert", folder / "bowl.brep", "-o", folder / "nets.json", "-q"}).code, 0);
  }

  void write_laws() {
    const std::vector<std::pair<const char*, const char*>> laws = {
        {"one.law.json", R"({"law": "linear", "radii": [0.1]})"},
        {"kind.law.json", R"({"law": "steep", "radii": [0.1, 0.2]})"},
        {"word.law.json", R"({"law": "linear", "radii": [0.1, "two"]})"},
        {"negative.law.json", R"({"law": "linear", "radii": [0.1, -0.2]})"},
        {"half.law.json", R"({"law": "table", "at": [0, 0.5], "radii": [0.1, 0.2]})"},
        {"back.law.json",
         R"({"law": "table", "at": [0, 0.7, 0.3, 1], "radii": [0.1, 0.2, 0.2, 0.1]})"},
        {"short.law.json", R"({"law": "table", "at": [0, 1], "radii": [0.1, 0.2, 0.3]})"},
        {"dip.law.json",
         R"({"law": "table", "at": [0, 0.1, 0.9, 1], "radii": [0.9, 0.01, 0.01, 0.9]})"},
        {"cut.law.json", R"({"law": "linear", "radii": [0.1, 0.2)"},
        {"good.law.json", R"({"law": "linear", "radii": [0.1, 0.2]})"}};
    for (const auto& [name, text] : laws) testing::write_text(folder / name, text);
  }

  // A thousandth of what it unpacks to.
  void write_bomb() {
    const gzFile out = gzopen((folder / "bomb.step.gz").c_str(), "wb9");
    const std::string blank(1 << 20, ' ');
    for (int i = 0; i < 64; ++i) gzwrite(out, blank.data(), static_cast<unsigned>(blank.size()));
    gzclose(out);
  }

  void write(const TopoDS_Shape& shape, const std::string& file) {
    occt::quiet_messages();
    occt::Model model;
    model.add(shape, "part");
    occt::write_model(model, folder / file);
  }

  testing::TestFolder folder;
};

TEST(BadInputs, AreManyInEverySectionOfTheTable) {
  const std::vector<std::vector<Line>> sections = table();
  ASSERT_EQ(sections.size(), std::size_t{kSections});
  std::size_t count = 0;
  for (const std::vector<Line>& lines : sections) count += lines.size();
  EXPECT_GE(count, 120u);
}

TEST_P(BadInputsTable, GetTheirCodeAndMessageAndLeaveNothingBehind) {
  const std::vector<Line> lines = table().at(static_cast<std::size_t>(GetParam()));
  const std::vector<std::string> before = folder.listing();
  const std::string there = "cd '" + (folder / "").string() + "' && timeout 30";
  for (const Line& line : lines) {
    SCOPED_TRACE("bad_inputs.txt:" + std::to_string(line.number));
    const Finished run = blossom(line.arguments, there);
    EXPECT_EQ(run.code, line.code) << run.out << run.err;
    // What was well asked for and cannot be made has a summary, which says so.
    EXPECT_TRUE(run.out.empty() ||
                (run.code == 1 && run.out.find(", refused, ") != std::string::npos))
        << run.out;
    const std::string told = run.err.substr(0, run.err.find('\n'));
    EXPECT_TRUE(told.starts_with("blossom: ") && line.is_message(told.substr(9))) << told;
    EXPECT_EQ(run.err.find("Standard_"), std::string::npos) << run.err;
    EXPECT_EQ(folder.listing(), before);
  }
}

INSTANTIATE_TEST_SUITE_P(Sections, BadInputsTable, ::testing::Range(1, kSections));

}  // namespace
}  // namespace blossom
