// SPDX-License-Identifier: LGPL-2.1-or-later
// Whatever is wrong with its inputs and outputs, the program says so in one message, answers with
// the right exit code, and leaves nothing half done.

#include <gtest/gtest.h>

#include <algorithm>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using testing::blossom;
using testing::Finished;

class BadInput : public ::testing::Test {
 protected:
  BadInput() {
    testing::write({testing::bowl()}, folder / "bowl.brep");
    testing::write({testing::lid(0.25)}, folder / "lid.step");
  }

  // Intersects bowl.brep with the file, and expects to be told why it cannot be.
  void expect_refused(const std::string& file, const std::string& why) {
    const std::vector<std::string> before = folder.listing();
    const Finished run = blossom({"intersect", folder / "bowl.brep", folder / file, "-o",
                                  folder / "out.step", "--json", folder / "out.json"});
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(why), std::string::npos) << run.err;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
    EXPECT_EQ(folder.listing(), before);
  }

  void write_text(const std::string& file, const std::string& text) {
    testing::write_text(folder / file, text);
  }

  testing::TestFolder folder;
};

TEST_F(BadInput, MissingFileIsNamed) { expect_refused("nowhere.step", "no such file"); }

TEST_F(BadInput, OutputsHaveNames) {
  const Finished run = blossom({"convert", folder / "bowl.brep", "-o", ""});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("--output takes the name of a file, not an empty one"), std::string::npos)
      << run.err;
}

TEST_F(BadInput, AFileThatGrowsTooLargeIsNoCrash) {
  const Finished run =
      blossom({"convert", folder / "bowl.brep", "-o", folder / "out.step"}, "ulimit -f 1;");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("out.step: cannot be written: File too large"), std::string::npos)
      << run.err;
}

TEST_F(BadInput, FolderIsNoModel) {
  std::filesystem::create_directory(folder / "folder.step");
  expect_refused("folder.step", "folder");
}

TEST_F(BadInput, EmptyFileIsNoModel) {
  write_text("empty.step", "");
  expect_refused("empty.step", "empty");
  write_text("empty.brep", "");
  expect_refused("empty.brep", "empty");
}

TEST_F(BadInput, CutOffStepIsRefused) {
  const std::string whole = testing::text_of(folder / "lid.step");
  write_text("cut.step", whole.substr(0, whole.size() / 3));
  expect_refused("cut.step", "cut off");
}

TEST_F(BadInput, CutOffBrepIsRefused) {
  const std::string whole = testing::text_of(folder / "bowl.brep");
  write_text("cut.brep", whole.substr(0, whole.size() / 2));
  expect_refused("cut.brep", "cut");
}

TEST_F(BadInput, TextIsNoModel) {
  write_text("letter.step", "Dear shipyard, please find the hull enclosed.\n");
  expect_refused("letter.step", "");
}

TEST_F(BadInput, UnknownEndingIsRefusedUnlessTheContentIsKnown) {
  write_text("letter.doc", "Dear shipyard, please find the hull enclosed.\n");
  expect_refused("letter.doc", "'.doc' is not known");
  write_text("lid.doc", testing::text_of(folder / "lid.step"));
  EXPECT_EQ(blossom({"info", folder / "lid.doc"}).code, 0);
}

// A rational face of one span, with the numbers 7.125 as a coordinate and 0.625 as a weight.
TopoDS_Face marked_face() {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  TColStd_Array2OfReal weights(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j) {
      poles(i, j) = gp_Pnt(i, j, i == 2 && j == 2 ? 7.125 : 0);
      weights(i, j) = i == 2 && j == 2 ? 0.625 : 1;
    }
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger counts(1, 2);
  counts.Init(3);
  return BRepBuilderAPI_MakeFace(
             new Geom_BSplineSurface(poles, weights, knots, knots, counts, counts, 2, 2), 1e-7)
      .Face();
}

class BadNumbers : public BadInput {
 protected:
  // The marked face with `from` written as `to`.
  void write_changed(const std::string& file, const std::string& from, const std::string& to) {
    testing::write({marked_face()}, folder / "marked.brep");
    std::string text = testing::text_of(folder / "marked.brep");
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos);
    text.replace(place, from.size(), to);
    write_text(file, text);
  }
};

TEST_F(BadNumbers, UnchangedAreAccepted) {
  write_changed("good.brep", "7.125", "7.125");
  EXPECT_EQ(blossom({"info", folder / "good.brep"}).code, 0);
}

TEST_F(BadNumbers, PoleThatIsNoNumberIsRefused) {
  write_changed("nan.brep", "7.125", "nan");
  expect_refused("nan.brep", "");
}

TEST_F(BadNumbers, InfinitePoleIsRefused) {
  write_changed("inf.brep", "7.125", "inf");
  expect_refused("inf.brep", "");
}

TEST_F(BadNumbers, ZeroWeightIsRefused) {
  write_changed("zero.brep", "0.625", "0");
  expect_refused("zero.brep", "");
}

TEST_F(BadNumbers, NegativeWeightIsRefused) {
  write_changed("negative.brep", "0.625", "-0.625");
  expect_refused("negative.brep", "");
}

TEST_F(BadInput, FaceThatDoesNotExistIsNamed) {
  const Finished run =
      blossom({"intersect", folder / "bowl.brep", (folder / "lid.step").string() + "#1,2"});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("lid.step: there is no face 2"), std::string::npos) << run.err;
}

class BadOutput : public BadInput {
 protected:
  void expect_failure(const std::vector<std::string>& options, int code) {
    const std::vector<std::string> before = folder.listing();
    std::vector<std::string> all = {"intersect", folder / "bowl.brep", folder / "lid.step"};
    all.insert(all.end(), options.begin(), options.end());
    const Finished run = blossom(all);
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(options.back()), std::string::npos) << run.err;
    EXPECT_EQ(folder.listing(), before);
  }
};

TEST_F(BadOutput, FolderThatIsNotThere) {
  expect_failure({"-o", folder / "no folder/out.step"}, 1);
  expect_failure({"--json", folder / "no folder/out.json"}, 1);
  expect_failure({"--picture", folder / "no folder/out.png"}, 1);
}

TEST_F(BadOutput, FolderThatCannotBeWritten) {
  // Not even root may create files there.
  expect_failure({"--json", "/proc/blossom.json"}, 1);
  expect_failure({"-o", "/proc/blossom.step"}, 1);
  expect_failure({"--picture", "/proc/blossom.png"}, 1);
}

TEST_F(BadOutput, FolderInThePlaceOfTheFile) {
  std::filesystem::create_directory(folder / "out.step");
  expect_failure({"-o", folder / "out.step"}, 1);
}

TEST_F(BadOutput, EndingThatIsNoFormat) { expect_failure({"-o", folder / "out.docx"}, 2); }

TEST_F(BadOutput, FailureKeepsWhatWasThere) {
  write_text("out.json", "old");
  testing::write({testing::lid(0.25)}, folder / "out.step");
  const std::string old = testing::text_of(folder / "out.step");
  expect_failure(
      {"-o", folder / "out.step", "--json", folder / "out.json", "--picture", "/proc/blossom.png"},
      1);
  EXPECT_EQ(testing::text_of(folder / "out.json"), "old");
  EXPECT_TRUE(testing::text_of(folder / "out.step") == old);
}

// Also through another spelling, a link, and with faces chosen.
TEST_F(BadOutput, NeverReplacesAnInput) {
  const std::string bowl = folder / "bowl.brep", lid = folder / "lid.step";
  const std::string old_bowl = testing::text_of(bowl), old_lid = testing::text_of(lid);
  const std::string dotted = folder / "./lid.step", link = folder / "link.brep";
  std::filesystem::create_symlink(bowl, link);
  const std::vector<std::vector<std::string>> calls = {
      {"intersect", bowl, lid, "-o", bowl},
      {"intersect", bowl, lid, "--json", lid},
      {"trim", bowl, lid, "--keep", "all", "-o", dotted},
      {"trim", bowl, lid, "--solid", "cut", "-o", bowl},
      {"blend", "strip", bowl + "#1", lid, "-o", bowl},
      {"self-intersect", lid, "--picture", lid},
      {"query", "plane", bowl, "--point", "0,0,0", "--normal", "0,0,1", "-o", bowl},
      {"subdivide", bowl + "#1", "--levels", "1", "-o", link},
      {"convert", lid, "-o", lid},
      {"check", bowl, "--json", bowl},
      {"info", bowl, "--json", bowl}};
  for (const std::vector<std::string>& call : calls) {
    const Finished run = blossom(call);
    EXPECT_EQ(run.code, 2) << call.front();
    EXPECT_NE(run.err.find("is an input"), std::string::npos) << call.front() << ": " << run.err;
    EXPECT_TRUE(testing::text_of(bowl) == old_bowl) << call.front();
    EXPECT_TRUE(testing::text_of(lid) == old_lid) << call.front();
  }
}

TEST_F(BadOutput, FullDiskIsAFailure) {
  const Finished run = blossom(
      {"intersect", folder / "bowl.brep", folder / "lid.step", "--json", "-"}, "", "/dev/full");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("stdout"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace blossom
