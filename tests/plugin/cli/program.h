// SPDX-License-Identifier: LGPL-2.1-or-later
// Running the built program `blossom`, and faces with known intersections to run it on.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

namespace blossom::testing {

/// A folder of the running test, emptied at the start and removed in the end.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

  /// Names of everything in it, sorted.
  std::vector<std::string> listing() const;

 private:
  std::filesystem::path folder_;
};

struct Finished {
  int code = 0;  ///< exit code; 128 + signal if a signal ended it
  std::string out;
  std::string err;
};

/// Runs the program and waits.
/// before    a shell command that runs it, for example "timeout 5"
/// out       where stdout goes, instead of into the result
Finished blossom(const std::vector<std::string>& arguments, const std::string& before = {},
                 const std::string& out = {});

std::string text_of(const std::filesystem::path& file);

void write_text(const std::filesystem::path& file, const std::string& text);

/// z = x^2 + y^2 over [-1, 1]^2 as a Bezier surface; x = 2 u - 1, y = 2 v - 1.
TopoDS_Face bowl();

/// The square [-1.5, 1.5]^2 at height z as a bilinear Bezier surface; x = 3 u - 1.5, likewise y.
TopoDS_Face lid(double z);

/// Half a cylinder of radius 1 round the z axis, from z = 0 to 0.8125, as a rational Bezier
/// surface.
TopoDS_Face half_pipe();

/// The square [0, 2]^2 at z = 0 as a B-spline surface of 2 x 2 spans; x = u, y = v.
TopoDS_Face four_spans();

/// Of what is asked of triangles; tests of that are skipped where the program is built without it.
#ifdef BLOSSOM_WITH_CGAL
inline constexpr bool kHasCgal = true;
#else
inline constexpr bool kHasCgal = false;
#endif
inline constexpr const char* kNoCgal = "the program is built without CGAL";

/// Writes faces as parts of a model, named "part 1", "part 2", ...
void write(const std::vector<TopoDS_Face>& faces, const std::filesystem::path& file);

}  // namespace blossom::testing
