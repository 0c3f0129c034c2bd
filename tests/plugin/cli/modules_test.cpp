// SPDX-License-Identifier: LGPL-2.1-or-later
// What the program loads, and when.

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/plugin/cli/program.h"

namespace blossom::testing {
namespace {

namespace fs = std::filesystem;

std::string output_of(const std::string& command) {
  std::string text;
  FILE* const pipe = popen(command.c_str(), "r");
  char piece[4096];
  while (pipe != nullptr && std::fgets(piece, sizeof(piece), pipe) != nullptr) text += piece;
  if (pipe != nullptr) pclose(pipe);
  return text;
}

class TheProgram : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(modules())) GTEST_SKIP() << "it was built without modules";
    write({bowl()}, model("step"));
    write({bowl()}, model("brep"));
    fs::copy_file(BLOSSOM_PROGRAM, folder_ / "blossom");
  }

  static fs::path modules() { return fs::path(BLOSSOM_PROGRAM).parent_path() / "modules"; }

  static std::string libraries_of(const fs::path& file) {
    return output_of("ldd " + file.string());
  }

  fs::path model(const std::string& ending) const { return folder_ / ("bowl." + ending); }

  /// What a copy of the program says that has no modules beside it.
  std::string alone(const std::string& arguments) const {
    return output_of((folder_ / "blossom").string() + " " + arguments + " 2>&1; echo code $?");
  }

  TestFolder folder_;
};

TEST_F(TheProgram, LoadsNoLibraryOfFileFormatsAtItsStart) {
  const std::string libraries = libraries_of(BLOSSOM_PROGRAM);
  EXPECT_NE(libraries.find("libTKBRep"), std::string::npos);
  for (const char* name :
       {"libTKSTEP", "libTKIGES", "libTKXCAF", "libTKService", "libX11", "lib3MF", "libcrypto"})
    EXPECT_EQ(libraries.find(name), std::string::npos) << name;
}

TEST_F(TheProgram, LoadsNoLibraryOfPicturesToReadStep) {
  const std::string libraries = libraries_of(modules() / "blossom_step.so");
  EXPECT_NE(libraries.find("libTKSTEP"), std::string::npos);
  for (const char* name : {"libTKIGES", "libTKXCAF", "libTKService", "libX11"})
    EXPECT_EQ(libraries.find(name), std::string::npos) << name;
}

TEST_F(TheProgram, ReadsBrepWithoutModules) {
  const std::string said = alone("info " + model("brep").string());
  EXPECT_NE(said.find("1 face"), std::string::npos) << said;
  EXPECT_NE(said.find("code 0"), std::string::npos) << said;
}

TEST_F(TheProgram, SaysWhichModuleIsMissing) {
  const std::string step = alone("info " + model("step").string());
  EXPECT_NE(step.find("STEP files cannot be loaded: "), std::string::npos) << step;
  EXPECT_NE(step.find("blossom_step.so"), std::string::npos) << step;
  EXPECT_NE(step.find("code 1"), std::string::npos) << step;
  const std::string written =
      alone("convert " + model("brep").string() + " -o " + (folder_ / "out.step").string());
  EXPECT_NE(written.find("blossom_documents.so"), std::string::npos) << written;
  EXPECT_NE(written.find("code 1"), std::string::npos) << written;
  EXPECT_FALSE(fs::exists(folder_ / "out.step"));
  if (!fs::exists(modules() / "blossom_three_mf.so")) return;
  const std::string triangles =
      alone("convert " + model("brep").string() + " -o " + (folder_ / "out.3mf").string());
  EXPECT_NE(triangles.find("blossom_three_mf.so"), std::string::npos) << triangles;
  EXPECT_NE(triangles.find("code 1"), std::string::npos) << triangles;
}

// By what the loader of glibc tells of the batch's own process. Jobs are copies of it, which close
// that file.
TEST_F(TheProgram, LoadsALibraryOnceForAllJobsOfABatch) {
  fs::copy(modules(), folder_ / "modules");
  std::string jobs;
  for (const char* id : {"1", "2", "3"})
    jobs += R"({"id": ")" + std::string(id) + R"(", "arguments": ["info", "bowl.step"]})" + "\n";
  write_text(folder_ / "jobs.jsonl", jobs);
  const std::string said =
      output_of("LD_DEBUG=files LD_DEBUG_OUTPUT=" + (folder_ / "ld").string() + " " +
                (folder_ / "blossom").string() + " batch " + (folder_ / "jobs.jsonl").string() +
                " -o " + (folder_ / "out.jsonl").string() + " 2>&1");
  EXPECT_NE(said.find("3 jobs: 3 done"), std::string::npos) << said;
  const std::string loads = output_of("cat " + (folder_ / "ld").string() +
                                      ".* | grep -c 'blossom_step.so.*dynamically loaded by'");
  EXPECT_EQ(loads, "1\n");
}

TEST_F(TheProgram, GoesOnWithABatchWhileItIsInstalledAnew) {
  constexpr int kJobs = 30;
  fs::copy(modules(), folder_ / "modules");
  std::string jobs;
  for (int i = 0; i < kJobs; ++i)
    jobs += R"({"id": ")" + std::to_string(i) + R"(", "arguments": ["info", "bowl.step"]})" + "\n";
  write_text(folder_ / "jobs.jsonl", jobs);
  std::atomic<bool> over{false};
  std::thread installing([&] {
    while (!over && text_of(folder_ / "out.jsonl").empty())
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    fs::remove_all(folder_ / "modules");
  });
  const std::string said = alone("batch " + (folder_ / "jobs.jsonl").string() + " -o " +
                                 (folder_ / "out.jsonl").string());
  over = true;
  installing.join();
  EXPECT_NE(said.find("30 jobs: 30 done"), std::string::npos) << said;
}

TEST_F(TheProgram, RefusesAModuleOfAnotherBuild) {
  fs::create_directory(folder_ / "modules");
  std::ofstream(folder_ / "modules/other.cpp")
      << "extern \"C\" const void* blossom_module(const char*) { return nullptr; }\n";
  output_of("c++ -shared -fPIC -o " + (folder_ / "modules/blossom_step.so").string() + " " +
            (folder_ / "modules/other.cpp").string());
  if (!fs::exists(folder_ / "modules/blossom_step.so")) GTEST_SKIP() << "there is no compiler";
  const std::string said = alone("info " + model("step").string());
  EXPECT_NE(said.find("belongs to another version"), std::string::npos) << said;
}

}  // namespace
}  // namespace blossom::testing
