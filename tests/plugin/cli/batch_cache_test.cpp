// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom batch --cache`: models that were read are kept for other jobs, which changes no result.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

namespace fs = std::filesystem;
using testing::blossom;
using testing::Finished;

// An assembly of two rods in an odd direction.
void write_rods(const fs::path& file, double length) {
  const gp_Ax2 place(gp_Pnt(0.1, 0.2, 0.3), gp_Dir(0.3, 0.5, 0.7), gp_Dir(1, 0.1, -0.5));
  occt::Model model;
  model.add_assembly({{"long", BRepPrimAPI_MakeCylinder(place, 1, length).Shape()},
                      {"short", BRepPrimAPI_MakeCylinder(place, 2, length / 2).Shape()}},
                     "rods");
  occt::write_model(model, file);
}

// Without what differs from run to run.
std::string comparable(nlohmann::json result) {
  result.erase("run");
  if (result.contains("report"))
    for (const char* name : {"seconds", "seconds_first"}) result["report"].erase(name);
  return result.dump();
}

class BatchCache : public ::testing::Test {
 protected:
  BatchCache() {
    write_rods(folder / "rods.step", 5);
    testing::write({testing::bowl()}, folder / "bowl.brep");
    testing::write({testing::bowl(), testing::lid(0.25)}, folder / "both.iges");
    add({"info", "rods.step", "--json", "-", "--log", "rods.log"});
    add({"check", "rods.step", "--json", "-", "--log", "rods.log"});
    add({"clash", "rods.step", "--json", "-", "--log", "rods.log"});
    add({"intersect", "rods.step#short/Face1", "both.iges#2", "--json", "-", "--log", "rods.log"});
    add({"query", "point", "bowl.brep", "--at", "0,0,1", "--json", "-"});
    add({"info", "nowhere.step"});
  }

  void add(const nlohmann::json& arguments) {
    lines += nlohmann::json{{"id", std::to_string(++jobs)}, {"arguments", arguments}}.dump() + "\n";
  }

  // The results, sorted by their jobs.
  std::vector<std::string> run(const std::vector<std::string>& options) {
    testing::write_text(folder / "jobs.jsonl", lines);
    for (const char* name : {"results.jsonl", "rods.log"}) fs::remove(folder / name);  // added to
    std::vector<std::string> words{"batch", folder / "jobs.jsonl", "-o", folder / "results.jsonl",
                                   "-q"};
    words.insert(words.end(), options.begin(), options.end());
    const Finished finished = blossom(words);
    EXPECT_EQ(finished.err, "");
    std::vector<std::string> results(static_cast<std::size_t>(jobs));
    std::istringstream in(testing::text_of(folder / "results.jsonl"));
    for (std::string line; std::getline(in, line);) {
      const nlohmann::json result = nlohmann::json::parse(line);
      const std::string id = result["id"];
      results.at(std::stoul(id) - 1) = comparable(result);
    }
    return results;
  }

  std::vector<fs::path> kept() const {
    std::vector<fs::path> files;
    for (const auto& each : fs::directory_iterator(cache))
      if (each.path().extension() == ".model") files.push_back(each.path());
    return files;
  }

  testing::TestFolder folder;
  const fs::path cache = folder / "cache";
  std::string lines;
  int jobs = 0;
};

// Which of the jobs of one file reads it is by chance.
TEST_F(BatchCache, ChangesNoResult) {
  const std::vector<std::string> without = run({});
  EXPECT_EQ(run({"--cache", cache}), without);
  EXPECT_NE(testing::text_of(folder / "rods.log").find("transferring"), std::string::npos);
  EXPECT_EQ(kept().size(), 3u);
  EXPECT_EQ(run({"--cache", cache}), without);
  EXPECT_EQ(testing::text_of(folder / "rods.log").find("transferring"), std::string::npos);
}

TEST_F(BatchCache, ChangesNoResultOfLooseFacesThatBecomeASolid) {
  std::vector<TopoDS_Face> faces;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(BRepBuilderAPI_Copy(it.Current()).Shape()));
  testing::write(faces, folder / "loose.iges");
  lines.clear();
  jobs = 0;
  add({"query", "mass", "loose.iges", "--json", "-"});
  add({"query", "mass", "loose.iges#solid:1", "--json", "-"});
  const std::vector<std::string> without = run({});
  EXPECT_NE(without.front().find("\"solids\":1"), std::string::npos) << without.front();
  EXPECT_EQ(run({"--cache", cache}), without);
  EXPECT_EQ(run({"--cache", cache}), without);
}

TEST_F(BatchCache, JobsAtTheSameTimeShareIt) {
  for (int i = 0; i < 12; ++i) add({"info", "rods.step", "--json", "-"});
  const std::vector<std::string> without = run({});
  EXPECT_EQ(run({"--cache", cache, "-j", "8"}), without);
  EXPECT_EQ(run({"--cache", cache, "-j", "8"}), without);
  EXPECT_EQ(kept().size(), 3u);
}

TEST_F(BatchCache, KnowsAFileByItsContent) {
  run({"--cache", cache});
  write_rods(folder / "rods.step", 7);
  const std::vector<std::string> without = run({});
  EXPECT_EQ(run({"--cache", cache}), without);
  EXPECT_EQ(kept().size(), 4u);
}

TEST_F(BatchCache, DoesWithoutWhatIsDamaged) {
  const std::vector<std::string> without = run({"--cache", cache});
  std::vector<std::uintmax_t> sizes;
  for (const fs::path& file : kept()) {
    std::string text = testing::text_of(file);
    text[text.size() / 2] ^= 1;
    testing::write_text(file, text);
  }
  EXPECT_EQ(run({"--cache", cache}), without);
  for (const fs::path& file : kept()) testing::write_text(file, "half of");
  EXPECT_EQ(run({"--cache", cache}), without);
  for (const fs::path& file : kept()) EXPECT_GT(fs::file_size(file), 1000u);
}

TEST_F(BatchCache, ModelsThatAreWrittenComeFromTheirFiles) {
  lines.clear();
  jobs = 0;
  add({"convert", "rods.step", "-o", "rods.brep"});
  add({"query", "plane", "rods.step", "--point", "0,0,1", "--normal", "0,0,1", "-o", "cut.step",
       "--json", "-"});
  const std::vector<std::string> without = run({});
  EXPECT_EQ(run({"--cache", cache}), without);
  EXPECT_EQ(kept().size(), 0u);
}

TEST_F(BatchCache, ForgetsWhatWasNotUsedForLongest) {
  fs::create_directory(cache);
  const fs::path old = cache / "old.model", recent = cache / "recent.model";
  for (const fs::path& file : {old, recent}) {
    testing::write_text(file, "x");
    fs::resize_file(file, 3'000'000'000);  // with a hole in it
  }
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1));
  run({"--cache", cache});
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(recent));
  EXPECT_EQ(kept().size(), 4u);
}

TEST_F(BatchCache, SaysWhereItCannotBe) {
  testing::write_text(folder / "jobs.jsonl", lines);
  const Finished run = blossom({"batch", folder / "jobs.jsonl", "-o", folder / "results.jsonl",
                                "--cache", folder / "bowl.brep"});
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("bowl.brep: models cannot be kept there: "), std::string::npos) << run.err;
}

}  // namespace
}  // namespace blossom
