// SPDX-License-Identifier: LGPL-2.1-or-later
// What all commands of the program have in common: how much they say, help, and exit codes.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plugin/cli/arguments/values.h"
#include "plugin/cli/output/verbosity.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using testing::blossom;
using testing::Finished;

class Verbose : public ::testing::Test {
 protected:
  // What a note and a detail print at this level.
  static std::string told_at(cli::Verbosity level) {
    cli::set_verbosity(level);
    ::testing::internal::CaptureStderr();
    cli::note("2 edges were repaired");
    cli::detail("edge 7: its tolerance is 1e-3");
    cli::set_verbosity(cli::Verbosity::Normal);
    return ::testing::internal::GetCapturedStderr();
  }
};

TEST_F(Verbose, NotesAreSilencedByQuietAndDetailsNeedVerbose) {
  EXPECT_EQ(told_at(cli::Verbosity::Quiet), "");
  EXPECT_EQ(told_at(cli::Verbosity::Normal), "blossom: 2 edges were repaired\n");
  EXPECT_EQ(told_at(cli::Verbosity::Verbose),
            "blossom: 2 edges were repaired\nblossom: edge 7: its tolerance is 1e-3\n");
}

TEST(Values, NumbersAreWrittenAsPeopleWriteThem) {
  EXPECT_EQ(cli::number_text(1e-9), "1e-9");
  EXPECT_EQ(cli::number_text(1e22), "1e22");
  EXPECT_EQ(cli::number_text(0.25), "0.25");
  EXPECT_EQ(cli::number_text(300), "300");
  EXPECT_EQ(cli::number_text(cli::rounded(2.0 / 3)), "0.666667");
}

TEST(Values, TheNearestWordIsWithinAFewLetters) {
  const std::vector<std::string> words = {"json", "tolerance", "help"};
  EXPECT_EQ(cli::nearest_word("jsno", words), "json");
  EXPECT_EQ(cli::nearest_word("tolernce", words), "tolerance");
  EXPECT_EQ(cli::nearest_word("Zahnrad", {"Welle", "Zahnrad 40 mm", "Lager"}), "Zahnrad 40 mm");
  EXPECT_EQ(cli::nearest_word("keep", words), "");
}

TEST(Help, OfACommandIsThatOfItsOption) {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{}, {"intersect"}, {"query", "ray"}}) {
    std::vector<std::string> asked = {"help"}, option = command;
    asked.insert(asked.end(), command.begin(), command.end());
    option.emplace_back("--help");
    const Finished help = blossom(asked);
    EXPECT_EQ(help.code, 0) << help.err;
    EXPECT_NE(help.out, "");
    EXPECT_EQ(help.out, blossom(option).out);
  }
}

TEST(Summary, NamesPartsAndCountsOverlaps) {
  const testing::TestFolder folder;
  testing::write({testing::lid(0.25)}, folder / "a.step");
  testing::write({testing::half_pipe(), testing::lid(0.25)}, folder / "b.step");
  const Finished run = blossom({"intersect", folder / "a.step", (folder / "b.step").string() + "#2",
                                "--fail-on", "findings"});
  EXPECT_EQ(run.code, 5) << run.err;
  EXPECT_NE(run.out.find(", 1 overlap of about 9 mm², "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  part 1 x part 2, face 1 x face 2: overlap of about 9 mm² near "
                         "(0, 0, 0.25), 4.24264 across, gap 0 to "),
            std::string::npos)
      << run.out;
  EXPECT_EQ(run.out.find("coinciding"), std::string::npos) << "told twice: " << run.out;
}

TEST(Summary, TellsAPointOfContactOnceAndRoundings) {
  const testing::TestFolder folder;
  testing::write({testing::bowl()}, folder / "bowl.brep");
  testing::write({testing::lid(0)}, folder / "lid.brep");
  const Finished run = blossom({"intersect", folder / "bowl.brep", folder / "lid.brep"});
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.out.find(": touching in a point near (0, 0, 0), "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find(": point near"), std::string::npos) << run.out;
}

TEST(Values, SecondsHaveThreeDigits) {
  EXPECT_EQ(cli::seconds_text(0.0123456), "0.0123 s");
  EXPECT_EQ(cli::seconds_text(12.3456), "12.3 s");
  EXPECT_EQ(cli::seconds_text(0), "0 s");
}

TEST(Usage, TellsWhereACommandIsThatIsNotHere) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> rows{
      {{"query", "clash", "a.step"}, "there is 'blossom clash': "},
      {{"fillet", "a.step"}, "there is 'blossom blend fillet': "},
      {{"query", "section", "a.step"}, "there is 'blossom query plane': the section of"},
      {{"mesh", "a.step"}, "there is 'blossom convert': "},
      {{"fuse", "a.step"}, "there is 'blossom trim': "},
      {{"cut", "a.step"}, "there is 'blossom trim': "},
      {{"union", "a.step"}, "there is 'blossom trim': "},
      {{"solid", "a.step"}, "there is 'blossom trim': "},
      {{"melt", "a.step"}, "there are info, check, "},
      {{"query", "nearest", "a.step", "--point", "0,0,0"}, "no command 'query nearest'; there is"},
  };
  for (const auto& [words, hint] : rows) {
    const Finished run = blossom(words);
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find(hint), std::string::npos) << run.err;
  }
}

TEST(Usage, TellsWhatIsNeededBesideAnOptionThatIsNotThere) {
  const Finished run = blossom({"query", "point", "a.step", "--point", "1,2,3"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("has no option '--point'; it needs --at X,Y,Z\n"), std::string::npos)
      << run.err;
}

TEST(EveryCommand, IsSilentWithQuietAndTakesVerbose) {
  const testing::TestFolder folder;
  testing::write({testing::bowl()}, folder / "bowl.brep");
  testing::write({testing::lid(0.25)}, folder / "lid.brep");
  const std::string a = folder / "bowl.brep", b = folder / "lid.brep";
  const std::vector<std::vector<std::string>> calls = {
      {"info", a},
      {"check", a},
      {"intersect", a, b},
      {"self-intersect", a},
      {"trim", a, b, "--keep", "all"},
      {"subdivide", a, "--levels", "1"},
      {"convert", a, "-o", folder / "out.brep"},
      {"query", "ray", a, "--from", "0,0,5", "--direction", "0,0,-1"},
      {"query", "plane", a, "--point", "0,0,0.5", "--normal", "0,0,1"},
      {"query", "distance", a, b},
      {"query", "does-intersect", a, b},
      {"query", "point", a, "--at", "0,0,5"}};
  for (std::vector<std::string> call : calls) {
    const std::string command = call[0] + " " + call[1];
    call.push_back("-q");
    const Finished quiet = blossom(call);
    EXPECT_EQ(quiet.code, 0) << command << ": " << quiet.err;
    EXPECT_EQ(quiet.out + quiet.err, "") << command;
    call.back() = "-v";
    const Finished verbose = blossom(call);
    EXPECT_EQ(verbose.code, 0) << command << ": " << verbose.err;
    EXPECT_NE(verbose.out, "") << command;
    call.push_back("-q");
    EXPECT_EQ(blossom(call).code, 2) << command;
  }
}

TEST(Usage, OptionsThatWouldDoNothingAreRefused) {
  const testing::TestFolder folder;
  const std::string pot = folder / "pot.brep", mesh = folder / "a.off", out = folder / "b.";
  testing::write({testing::bowl()}, pot);
  testing::write_text(mesh, "OFF\n3 1 0\n0 0 0\n2 0 0\n0 2 0\n3 0 1 2\n");
  const std::vector<std::vector<std::string>> cases{
      {"convert", pot, "-o", out + "step", "--deviation", "1"},
      {"convert", pot, "-o", out + "step", "--angle", "20"},
      {"convert", pot, "-o", out + "step", "--text"},
      {"convert", pot, "-o", out + "step", "--crease", "40"},
      {"convert", pot, "-o", out + "step", "--tolerance", "1"},
      {"convert", pot, "-o", out + "obj", "--text"},
      {"convert", pot, "-o", out + "stl", "--crease", "40"},
      {"convert", pot, "-o", out + "stl", "--tolerance", "1"},
      {"convert", mesh, "-o", out + "ply", "--deviation", "1"},
      {"check", pot, "--view", "top"},
      {"check", pot, "--size", "200x200"},
      {"check", mesh, "--deep"},
      {"intersect", mesh, mesh, "--joined"},
      {"intersect", mesh, mesh, "--tolerance", "1"},
      {"query", "plane", mesh, "--point", "0,0,0", "--normal", "0,0,1", "--budget", "9"}};
  for (const std::vector<std::string>& words : cases) {
    const testing::Finished run = testing::blossom(words);
    EXPECT_EQ(run.code, 2) << words[0] << " " << words.back();
    EXPECT_NE(run.err.find(" does nothing here: "), std::string::npos) << run.err;
  }
}

TEST(Usage, NamesWhatIsMeant) {
  const testing::TestFolder folder;
  const std::string pot = folder / "pot.brep", law = folder / "law.json";
  testing::write({testing::bowl()}, pot);
  testing::write_text(law, "[]");
  const auto told = [](const std::vector<std::string>& words) {
    return testing::blossom(words).err;
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(told({"batch", "--each", pot, pot, "-o", folder / "r.jsonl", "--", "info", "{}"}),
      "quotes: --each '*.step'");
  has(told({"check", pot, pot, "--picture", folder / "p.png"}), "--picture is for one file");
  has(told({"trim", pot, pot, "--keep", "inside"}), pot + " is none");
  has(told({"trim", pot, pot, "--solid", "union"}), "did you mean 'fuse'?");
  has(told({"blend", "fillet", pot, "--edges", "1", "--law", law}), law);
  const std::string none = folder / "none.step";
  const std::string lines = testing::blossom({"info", pot, none}).out;
  has(lines, none + ": ");
  EXPECT_EQ(lines.find(none, lines.find(none) + 1), std::string::npos) << lines;
}

}  // namespace
}  // namespace blossom
