// SPDX-License-Identifier: LGPL-2.1-or-later
// Assemblies of other systems through read_model, a cut and write_model: what is told of them with
// Open CASCADE alone, before and after. Takes all STEP files of the folder BLOSSOM_ASSEMBLIES.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/support/models.h"

namespace blossom::occt {
namespace {

using testing::Folder;
using testing::story;

using Lines = std::vector<std::string>;  // sorted

Lines lines_of(const std::filesystem::path& file) {
  std::istringstream text(story(file));
  Lines lines;
  for (std::string line; std::getline(text, line);) {
    // The unit's name is in small letters or large ones.
    if (line.starts_with("in "))
      for (char& letter : line) letter = static_cast<char>(std::tolower(letter));
    // Open CASCADE gives a name to parts without one, and drops labels that say nothing.
    if (line.find(" of - ") == std::string::npos && !line.ends_with(" * -")) lines.push_back(line);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

Lines missing(const Lines& before, const Lines& after) {
  Lines lost;
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                      std::back_inserter(lost));
  return lost;
}

long count(const Lines& lines, const std::string& word) {
  return std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(word) != std::string::npos;
  });
}

std::vector<std::filesystem::path> step_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    for (const char* const ending : {".stp", ".step", ".STP", ".STEP"})
      if (entry.path().extension() == ending) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// The first face is taken out, which opens its solid: the lines of the face, the solid, the part,
// its layer, and those of the assemblies round it, which say their sizes, may change; no other one.
TEST(ForeignAssemblies, StayAsTheyAreButForWhatIsCut) {
  const char* const folder = std::getenv("BLOSSOM_ASSEMBLIES");
  if (!folder) GTEST_SKIP() << "set BLOSSOM_ASSEMBLIES";
  std::printf(
      "| file | labels | instances | coloured | layers | dimensions | changed | by a cut |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|\n");
  const std::vector<std::filesystem::path> files = step_files(folder);
  ASSERT_FALSE(files.empty()) << folder;
  for (const std::filesystem::path& file : files) {
    const Folder own;
    const Lines before = lines_of(file);
    Model model = testing::repaired_model(file);
    write_model(model, own / "copy.step");
    const Lines copied = missing(before, lines_of(own / "copy.step"));
    const std::string path = model.part_paths().front();
    const int faces = model.face_count();
    model.replace_faces({{1, {}}});
    ASSERT_EQ(model.face_count(), faces - 1) << file;
    write_model(model, own / "cut.step");
    const Lines cut = missing(before, lines_of(own / "cut.step"));
    std::printf("| %s | %zu | %ld | %ld | %ld | %ld | %zu | %zu |\n", file.filename().c_str(),
                before.size(), count(before, " of "), count(before, " #"), count(before, "layer "),
                count(before, "dimension "), copied.size(), cut.size());
    EXPECT_TRUE(copied.empty()) << file << ": " << copied.front();
    const auto round = static_cast<std::size_t>(std::count(path.begin(), path.end(), '/')) + 5;
    EXPECT_LE(cut.size(), round) << file << ": " << cut.front() << " ... " << cut.back();
  }
}

}  // namespace
}  // namespace blossom::occt
