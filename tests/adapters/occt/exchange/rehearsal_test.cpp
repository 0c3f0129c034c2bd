// SPDX-License-Identifier: LGPL-2.1-or-later
// Reading in a child process: what ends the child tells of the file only what it can, and what it
// has read comes over as it is.

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exact/exact_bytes.h"
#include "adapters/occt/exchange/model_bytes.h"
#include "adapters/occt/face_colours.h"
#include "adapters/occt/reading.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/read_files.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using Deed = std::function<void(std::string_view step)>;

class Rehearsing : public ::testing::Test {
 protected:
  Rehearsing() : file_(folder_ / "part.step") {
    testing::write_content(file_, testing::sample(".step"));
  }

  /// A sound file, read while the child does something at each step.
  Model with(const Deed& deed) const {
    return read_model_in_child(
        file_, {.damaged = true, .step = [&deed](const char* step) { deed(step); }});
  }

  testing::Folder folder_;
  std::filesystem::path file_;
};

TEST_F(Rehearsing, LeavesOutTheNamesIfTheseCrash) {
  const Model model = with([](std::string_view step) {
    if (step.starts_with(kReadingNames)) std::abort();
  });
  EXPECT_EQ(model.reading().grade(), ReadingGrade::AttributesLost);
  EXPECT_EQ(model.face_count(), 18);
}

TEST_F(Rehearsing, RefusesWhatCrashes) {
  try {
    with([](std::string_view) { std::abort(); });
    ADD_FAILURE() << "accepted";
  } catch (const BadModel& error) {
    EXPECT_NE(std::string(error.what()).find("Open CASCADE crashes while"), std::string::npos);
  }
}

TEST_F(Rehearsing, GoesOnWhenATerminalInterruptsTheProgram) {
  const Model model = with([](std::string_view) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::raise(signal);
  });
  EXPECT_EQ(model.reading().grade(), ReadingGrade::Whole);
}

TEST_F(Rehearsing, EndsByWhatInterruptsTheProgram) {
  struct Interrupted {};
  EXPECT_THROW(read_model_in_child(file_, {.step = [](const char*) { std::abort(); }},
                                   [] { throw Interrupted(); }),
               Interrupted);
}

TEST_F(Rehearsing, TellsTheFaultsThatTheChildFinds) {
  try {
    with([](std::string_view) { throw BadModel("it is wrong there"); });
    ADD_FAILURE() << "accepted";
  } catch (const BadModel& error) {
    EXPECT_TRUE(std::string_view(error.what()).ends_with("part.step: it is wrong there"));
  }
}

void lack_memory() { throw std::bad_alloc(); }

TEST_F(Rehearsing, TellsWantOfMemory) {
  EXPECT_THROW(with([](std::string_view) { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_THROW(with([](std::string_view) { std::raise(SIGKILL); }), std::bad_alloc);
  EXPECT_THROW(with([](std::string_view) noexcept { lack_memory(); }), std::bad_alloc);
}

/// As one does that waits for a lock whose owner is a thread of the program.
TEST_F(Rehearsing, DoesNotWaitForAChildThatIsStuck) {
  const Model model = with([](std::string_view) { pause(); });
  EXPECT_EQ(model.reading().grade(), ReadingGrade::Whole);
}

using Tree = std::vector<std::pair<std::string, std::vector<int>>>;

void add_to(Tree& tree, const std::vector<AssemblyNode>& nodes) {
  for (const AssemblyNode& node : nodes) {
    tree.emplace_back(node.path + " of " + node.product, node.faces);
    add_to(tree, node.parts);
  }
}

Tree tree_of(const Model& model) {
  Tree tree;
  add_to(tree, model.assembly());
  return tree;
}

/// What a model says, with its shape to the last bit.
std::string told(const Model& model) {
  std::ostringstream out;
  out << model.file() << model.file_unit() << to_string(model.reading().grade());
  for (const Loss& loss : model.reading().losses) out << loss.text();
  for (const std::string& name : model.face_names()) out << name << ';';
  for (const std::string& path : model.part_paths()) out << path << ';';
  for (int face = 1; face <= model.face_count(); ++face) out << model.part_name(face) << ';';
  for (const std::optional<FaceColour>& colour : face_colours(model))
    for (const double value : colour.value_or(FaceColour{-1, -1, -1})) out << value << ' ';
  for (const auto& [name, faces] : tree_of(model)) {
    out << name;
    for (const int face : faces) out << ' ' << face;
  }
  return out.str() + exact_bytes(model.shape()).value_or("?");
}

/// Names, colours, layers, sizes and dimensions in the file that a model makes. Its lines come in
/// the order in which Open CASCADE's maps of shapes have them, by addresses.
std::string written(const Model& model, const std::filesystem::path& file) {
  write_model(model, file);
  return testing::story(file);
}

/// Colours, layers, dimensions, assemblies and styles of single instances are all in what is
/// written. That the child did hand it over shows in the steps, which are told there alone.
class HandedOver : public ::testing::TestWithParam<void (*)(const std::filesystem::path&)> {};

TEST_P(HandedOver, IsWhatIsReadHere) {
  const testing::Folder folder;
  const std::filesystem::path file = folder / "model.step";
  GetParam()(file);
  const Model here = read_model(file);
  int steps = 0;
  const Model there = read_model_in_child(file, {.step = [&steps](const char*) { ++steps; }});
  EXPECT_EQ(told(there), told(here));
  EXPECT_EQ(steps, 0);
  EXPECT_TRUE(ModelBytes::of(there));
  EXPECT_EQ(written(there, folder / "there.step"), written(here, folder / "here.step"));
}

/// Without documents.
TEST(HandedOver, IsABrepFileAsWell) {
  const testing::Folder folder;
  const std::filesystem::path file = folder / "model.brep";
  testing::write_content(file, testing::sample(".brep"));
  EXPECT_EQ(told(read_model_in_child(file)), told(read_model(file)));
}

/// Faces can be changed afterwards, and what is said of others stays.
TEST(HandedOver, CanBeChanged) {
  const testing::Folder folder;
  const std::filesystem::path file = folder / "model.step";
  testing::write_works(file);
  Model here = read_model(file), there = read_model_in_child(file);
  for (Model* model : {&here, &there}) model->replace_faces({{1, {}}});
  EXPECT_EQ(told(there), told(here));
  EXPECT_EQ(told(there.copy()), told(here.copy()));
}

INSTANTIATE_TEST_SUITE_P(
    Files, HandedOver,
    ::testing::Values([](const std::filesystem::path& file) { testing::write_machine(file); },
                      &testing::write_roots, &testing::write_gauge, &testing::write_pairs,
                      [](const std::filesystem::path& file) {
                        testing::write_works(file, "INCH");
                      }));

}  // namespace
}  // namespace blossom::occt
