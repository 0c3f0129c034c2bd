// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/plugin/cli/program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "adapters/occt/shapes.h"

namespace blossom::testing {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

TopoDS_Face face_on(const Handle(Geom_Surface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

}  // namespace

TestFolder::TestFolder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::ranges::replace(name, '/', '_');
  // Runs beside each other have folders of their own.
  std::string pattern = ::testing::TempDir() + "/blossom_" + name + "_XXXXXX";
  folder_ = ::mkdtemp(pattern.data());
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::vector<std::string> TestFolder::listing() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

Finished blossom(const std::vector<std::string>& arguments, const std::string& before,
                 const std::string& out) {
  const std::string stem = std::to_string(::getpid());
  const std::filesystem::path temporary = ::testing::TempDir();
  const std::filesystem::path out_file = temporary / ("blossom_out_" + stem);
  const std::filesystem::path err_file = temporary / ("blossom_err_" + stem);

  std::string command = before + " " + quoted(BLOSSOM_PROGRAM);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " >" + quoted(out.empty() ? out_file.string() : out);
  command += " 2>" + quoted(err_file.string()) + " </dev/null";
  const int status = std::system(command.c_str());

  Finished finished;
  finished.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (out.empty()) finished.out = text_of(out_file);
  finished.err = text_of(err_file);
  std::filesystem::remove(out_file);
  std::filesystem::remove(err_file);
  return finished;
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

TopoDS_Face bowl() {
  // x^2 over [-1, 1] has the Bezier values 1, -1, 1.
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      poles(i + 1, j + 1) = gp_Pnt(i - 1, j - 1, (i == 1 ? -1 : 1) + (j == 1 ? -1 : 1));
  return face_on(new Geom_BezierSurface(poles));
}

TopoDS_Face lid(double z) {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(3 * i - 1.5, 3 * j - 1.5, z);
  return face_on(new Geom_BezierSurface(poles));
}

TopoDS_Face half_pipe() {
  // A half circle of degree 3: weights 1, 1/3, 1/3, 1.
  constexpr double kHeight = 0.8125;
  TColgp_Array2OfPnt poles(1, 4, 1, 2);
  TColStd_Array2OfReal weights(1, 4, 1, 2);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) {
      const bool inner = i == 1 || i == 2;
      poles.SetValue(i + 1, j + 1, gp_Pnt(i < 2 ? 1 : -1, inner ? 2 : 0, j * kHeight));
      weights.SetValue(i + 1, j + 1, inner ? 1.0 / 3 : 1);
    }
  return face_on(new Geom_BezierSurface(poles, weights));
}

TopoDS_Face four_spans() {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) poles(i + 1, j + 1) = gp_Pnt(i, j, 0);
  TColStd_Array1OfReal knots(1, 3);
  for (int i = 0; i < 3; ++i) knots(i + 1) = i;
  TColStd_Array1OfInteger counts(1, 3);
  counts.Init(1);
  counts(1) = counts(3) = 2;
  return face_on(new Geom_BSplineSurface(poles, knots, knots, counts, counts, 1, 1));
}

void write(const std::vector<TopoDS_Face>& faces, const std::filesystem::path& file) {
  occt::quiet_messages();
  occt::Model model;
  int number = 0;
  for (const TopoDS_Face& face : faces) model.add(face, "part " + std::to_string(++number));
  occt::write_model(model, file);
}

}  // namespace blossom::testing
