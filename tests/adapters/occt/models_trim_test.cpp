// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimming naturally bounded free-form faces of real models, by a plane and by a turned copy.
//
// Needs models in the folder that the environment variable BLOSSOM_TEST_DATA names.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/trim.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

constexpr int kFacesPerModel = 3;
constexpr double kTurn = 23 * 3.14159265358979323846 / 180;
constexpr double kSeconds = 1;

std::vector<std::filesystem::path> model_files() {
  const char* folder = blossom::testing::test_data();
  std::vector<std::filesystem::path> files;
  if (folder == nullptr) return files;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(folder) + "/models")) {
    const std::string ending = entry.path().extension();
    if (ending == ".brep" || ending == ".step" || ending == ".stp" || ending == ".iges")
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The middle of a naturally bounded free-form face and its frame there.
struct Middle {
  gp_Pnt point;
  gp_Vec du, dv;
  double size = 0;
};

std::optional<Middle> middle_of(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const GeomAbs_SurfaceType type = GeomAdaptor_Surface(surface).GetType();
  if (type != GeomAbs_BSplineSurface && type != GeomAbs_BezierSurface) return std::nullopt;
  const FaceTrims trims = face_trims(face);
  if (!trims.natural) return std::nullopt;
  const auto parameter = [&](int k, double t) {
    return at({trims.box.low[k], trims.box.high[k]}, t) / trims.scale[k];
  };
  Middle middle;
  surface->D1(parameter(0, 0.5), parameter(1, 0.5), middle.point, middle.du, middle.dv);
  for (const double u : {0.0, 1.0})
    for (const double v : {0.0, 1.0})
      middle.size = std::max(
          middle.size, middle.point.Distance(surface->Value(parameter(0, u), parameter(1, v))));
  if (middle.du.Crossed(middle.dv).Magnitude() < 1e-9) return std::nullopt;
  return middle;
}

struct Counts {
  int runs = 0, divided = 0, invalid = 0, lost = 0, unfinished = 0, refused = 0;
};

void run(const std::string& name, int number, const TopoDS_Face& face, const TopoDS_Face& tool,
         const char* kind, Counts& counts) {
  ++counts.runs;
  TrimOptions options;
  options.intersection.time_limit = kSeconds;
  const auto start = std::chrono::steady_clock::now();
  TrimResult result;
  try {
    result = trim({{number, face, true}}, {trim_tool(tool)}, options);
  } catch (const BadModel& error) {
    ++counts.refused;
    std::printf("%-24s %4d %-6s refused: %s\n", name.c_str(), number, kind, error.what());
    return;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  double sum = 0;
  bool valid = true;
  for (const TrimPiece& piece : result.pieces) {
    sum += piece.area;
    valid = valid && BRepCheck_Analyzer(piece.shape).IsValid();
  }
  const double whole = result.areas.at(number);
  const double error = std::abs(sum - whole) / whole;
  if (result.pieces.size() > 1) ++counts.divided;
  if (result.status == Status::Stopped) ++counts.unfinished;
  const bool was_valid = BRepCheck_Analyzer(face).IsValid();
  if (!valid && was_valid) ++counts.invalid;
  if (error > 1e-9) ++counts.lost;
  std::printf("%-24s %4d %-6s %-9s %3zu pieces %-7s area error %8.1e %7.3f s%s%s\n", name.c_str(),
              number, kind, to_string(result.status), result.pieces.size(),
              valid ? "valid" : "INVALID", error, took.count(), result.notes.empty() ? "" : "  ",
              result.notes.empty() ? "" : result.notes.front().c_str());
  // What is not divided has its reason.
  EXPECT_TRUE(result.pieces.size() > 1 || !result.notes.empty() ||
              result.status != Status::Complete)
      << name << " face " << number << " by " << kind;
  EXPECT_TRUE(valid || !was_valid) << name << " face " << number << " by " << kind;
  EXPECT_LE(error, 1e-9) << name << " face " << number << " by " << kind;
}

void run_model(const std::filesystem::path& file, Counts& counts) {
  const Model model = testing::repaired_model(file);
  int found = 0;
  for (int number = 1; number <= model.face_count() && found < kFacesPerModel; ++number) {
    const TopoDS_Face face = model.face(number);
    const std::optional<Middle> middle = middle_of(face);
    if (!middle) continue;
    ++found;
    const gp_Pln plane(middle->point, gp_Dir(middle->du));
    const double size = 3 * middle->size;
    run(file.filename(), number, face, BRepBuilderAPI_MakeFace(plane, -size, size, -size, size),
        "plane", counts);
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(middle->point, gp_Dir(middle->du)), kTurn);
    run(file.filename(), number, face, TopoDS::Face(face.Moved(TopLoc_Location(turn))), "copy",
        counts);
  }
}

TEST(TrimOfModels, IsValidAndKeepsTheArea) {
  const std::vector<std::filesystem::path> files = model_files();
  if (files.empty()) GTEST_SKIP() << blossom::testing::kNoTestData;
  quiet_messages();
  Counts counts;
  for (const std::filesystem::path& file : files) run_model(file, counts);
  std::printf("%d runs: %d divided, %d invalid, %d with area lost, %d stopped, %d refused\n",
              counts.runs, counts.divided, counts.invalid, counts.lost, counts.unfinished,
              counts.refused);
  EXPECT_GT(counts.divided, counts.runs / 2);
}

}  // namespace
}  // namespace blossom::occt
