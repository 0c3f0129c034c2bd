// SPDX-License-Identifier: LGPL-2.1-or-later
// Content of .stl, .ply, .obj and .off: as programs write it, as it comes back, and as it is
// damaged.

#include "plugin/meshes/formats/mesh_formats.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "plugin/meshes/mesh_files.h"

namespace blossom::meshes {
namespace {

FileMesh tetrahedron() {
  return {{{0, 0, 0}, {2, 0, 0}, {0, 2.1, 0}, {0.3, 0, 3}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

FileMesh grouped() {
  FileMesh mesh = tetrahedron();
  mesh.groups = {{"floor plate", 0, MeshColour{255, 0, 10}}, {"machine:1/Shaft/Face3", 1, {}}};
  return mesh;
}

double volume(const FileMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto p = [&](int k) { return mesh.points[static_cast<std::size_t>(k)]; };
    sum += dot(p(a), cross(p(b), p(c))) / 6;
  }
  return sum;
}

std::string refusal(FileMesh (*read)(std::string_view), const std::string& bytes) {
  try {
    read(bytes);
  } catch (const BadContent& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

void expect_equal(const FileMesh& a, const FileMesh& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

// ---- round trips

TEST(MeshFormats, GiveTheSameDoublesBack) {
  const FileMesh mesh = tetrahedron();
  expect_equal(read_ply(ply_content(mesh, false)), mesh);
  expect_equal(read_ply(ply_content(mesh, true)), mesh);
  expect_equal(read_obj(obj_text(mesh)), mesh);
  expect_equal(read_off(off_text(mesh)), mesh);
  EXPECT_DOUBLE_EQ(volume(read_stl(stl_text(mesh))), volume(mesh));
}

TEST(MeshFormats, KeepFloatsInBinaryStl) {
  FileMesh mesh = tetrahedron();
  for (Vec3& p : mesh.points)
    for (double& x : p.coordinates) x = static_cast<float>(x);
  EXPECT_NEAR(volume(read_stl(stl_bytes(mesh))), volume(mesh), 1e-12 * volume(mesh));
}

TEST(MeshFormats, KeepGroupsAndColours) {
  for (const FileMesh& read :
       {read_ply(ply_content(grouped(), false)), read_ply(ply_content(grouped(), true)),
        read_off(off_text(grouped()))})
    EXPECT_EQ(read.groups, grouped().groups);
}

TEST(MeshFormats, KeepGroupsWithoutColours) {
  FileMesh mesh = grouped();
  mesh.groups[0].colour.reset();
  EXPECT_EQ(read_ply(ply_content(mesh, false)).groups, mesh.groups);
  EXPECT_EQ(read_off(off_text(mesh)).groups, mesh.groups);
  mesh.groups[0].name = "floor_plate";  // names are words there
  EXPECT_EQ(read_obj(obj_text(mesh)).groups, mesh.groups);
  EXPECT_EQ(read_stl(stl_text(mesh)).groups, mesh.groups);
}

TEST(MeshFormats, TellWhatOfGroupsHasNoPlace) {
  using Words = std::vector<std::string>;
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const auto lost = [&](const char* ending, bool text) {
    const std::filesystem::path file =
        folder / ("blossom_lost_" + std::to_string(::getpid()) + ending);
    const Words told = write_mesh_file(grouped(), file, text, {}).lost;
    std::filesystem::remove(file);
    return told;
  };
  EXPECT_EQ(lost(".ply", false), Words{});
  EXPECT_EQ(lost(".off", false), Words{});
  EXPECT_EQ(lost(".obj", false), Words{"colours"});
  EXPECT_EQ(lost(".stl", true), Words{"colours"});
  EXPECT_EQ(lost(".stl", false), (Words{"names", "colours"}));
}

// ---- what other programs write

TEST(MeshFormats, RefuseCoordinatesWhoseVolumesAreNoNumbers) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("blossom_" + std::to_string(getpid()) + "_large.obj");
  for (const auto& [size, told] : {std::pair{"1e101", "beyond 1e+100"}, std::pair{"1e99", ""}}) {
    std::ofstream(file) << "v 0 0 0\nv " << size << " 0 0\nv 0 1 0\nf 1 2 3\n";
    std::string refused;
    try {
      read_mesh_file(file);
    } catch (const occt::BadModel& error) {
      refused = error.what();
    }
    EXPECT_EQ(refused.empty(), std::string(told).empty()) << refused;
    EXPECT_NE(refused.find(told), std::string::npos) << refused;
  }
  std::filesystem::remove(file);
}

TEST(TextStl, MayHaveAnyCaseBlanksAndLineEnds) {
  const std::string plain = stl_text(tetrahedron());
  std::string upper = plain;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const std::string& text :
       {replaced(plain, "\n", "\r\n"), replaced(plain, "\n", "\r"), "\n \n\t" + plain, upper,
        replaced(plain, "outer loop", "outer \t loop"), replaced(plain, "\n", " "),
        replaced(plain, "solid mesh", "solid " + std::string(5000, 'x')),
        replaced(plain, "solid mesh", "solid facet of a gem"), replaced(plain, "mesh", ""),
        replaced(plain, "vertex ", "vertex +")}) {
    const FileMesh read = read_stl(text);
    EXPECT_EQ(read.triangles.size(), 4u) << text.substr(0, 60);
    EXPECT_DOUBLE_EQ(volume(read), volume(tetrahedron())) << text.substr(0, 60);
  }
}

TEST(TextStl, MayHaveNormalsThatAreNone) {
  const std::string text = stl_text(tetrahedron());
  const std::size_t at = text.find("normal ") + 7;
  EXPECT_EQ(read_stl(text.substr(0, at) + "nan nan nan" + text.substr(text.find('\n', at)))
                .triangles.size(),
            4u);
}

TEST(TextStl, SaysInWhichLineItIsWrong) {
  const std::string text = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  EXPECT_EQ(refusal(read_stl, text + "vertex 1,5 1 0\n"), "line 6: '1,5' is no number");
  EXPECT_EQ(refusal(read_stl, text + "vertex nan 1 0\n"), "line 6: 'nan' is no finite number");
  EXPECT_EQ(refusal(read_stl, text + "endloop"), "line 6: the facet has 2 vertices");
  EXPECT_NE(refusal(read_stl, text).find("cut off"), std::string::npos);
  EXPECT_NE(refusal(read_stl, text + "vertex 0 1 0\nendloop\nendfacet\n").find("no endsolid"),
            std::string::npos);
}

TEST(BinaryStl, HasEachPlaceOnceHoweverManyThereAre) {
  constexpr int kSide = 60;
  FileMesh grid;
  for (int i = 0; i <= kSide; ++i)
    for (int j = 0; j <= kSide; ++j) grid.points.push_back({1.0 * i, 1.0 * j, 0.5 * (i ^ j)});
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const int a = i * (kSide + 1) + j, b = a + kSide + 1;
      grid.triangles.push_back({a, b, b + 1});
      grid.triangles.push_back({a, b + 1, a + 1});
    }
  const auto corners = [](const FileMesh& mesh) {
    std::vector<Vec3> all;
    for (const std::array<int, 3>& triangle : mesh.triangles)
      for (const int corner : triangle)
        all.push_back(mesh.points[static_cast<std::size_t>(corner)]);
    return all;
  };
  for (const std::string& bytes : {stl_bytes(grid), stl_text(grid)}) {
    const FileMesh read = read_stl(bytes);
    EXPECT_EQ(read.points.size(), grid.points.size());
    EXPECT_EQ(corners(read), corners(grid));
  }
}

TEST(BinaryStl, MayBeginWithSolidAndFacet) {
  std::string bytes = stl_bytes(tetrahedron());
  bytes.replace(0, 20, "solid facet normal 1");
  EXPECT_EQ(read_stl(bytes).triangles.size(), 4u);
}

TEST(BinaryStl, NotesWhatComesAfterItsFacets) {
  const FileMesh read = read_stl(stl_bytes(tetrahedron()) + "more");
  EXPECT_EQ(read.triangles.size(), 4u);
  EXPECT_EQ(read.notes, (std::vector<std::string>{
                            "4 bytes after the 4 facets that its header promises were not read"}));
}

TEST(BinaryStl, IsRefusedWithTheFacet) {
  FileMesh mesh = tetrahedron();
  mesh.points[2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(read_stl, stl_bytes(mesh)),
            "facet 1 has a coordinate that is no finite number");
}

TEST(BinaryStl, ThatPromisesTenGigabytesIsRefused) {
  std::string bytes = stl_bytes(tetrahedron());
  const std::uint32_t count = 200'000'000;
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  EXPECT_NE(refusal(read_stl, bytes).find("promises 200000000 facets, it has room for 4"),
            std::string::npos);
}

TEST(Stl, KeepsFacetsWithoutArea) {
  FileMesh mesh = tetrahedron();
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_EQ(read_stl(stl_bytes(mesh)).triangles.size(), 5u);
  EXPECT_EQ(read_stl(stl_text(mesh)).triangles.size(), 5u);
}

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, HasPolygonsTexturesNegativeNumbersAndContinuedLines) {
  const std::vector<std::array<int, 3>> two{{0, 1, 2}, {0, 2, 3}};
  for (const char* const face : {"f 1 2 3 4\n", "f 1/1 2/2 3/3 4/4\n", "f 1//1 2//1 3//1 4//1\n",
                                 "f -4 -3 -2 -1\n", "f 1 2 \\\n3 4\n", "f 1 2 3 4 # comment\n"})
    EXPECT_EQ(read_obj(std::string(kSquare) + face).triangles, two) << face;
}

TEST(Obj, HasPolygonsThatAreNotConvex) {
  const std::string dart = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\n";
  const std::vector<std::array<int, 3>> made = read_obj(dart + "f 1 2 3 4\n").triangles;
  ASSERT_EQ(made.size(), 2u);
  for (const std::array<int, 3>& triangle : made)
    EXPECT_TRUE(std::ranges::count(triangle, 1) == 1 && std::ranges::count(triangle, 3) == 1);
}

TEST(Obj, HasGroupsAndElseObjects) {
  const std::string square = kSquare;
  EXPECT_EQ(read_obj(square + "o all\ng a b\nf 1 2 3\ng c\nf 1 3 4\n").groups,
            (std::vector<MeshGroup>{{"a b", 0}, {"c", 1}}));
  EXPECT_EQ(read_obj(square + "o all\nf 1 2 3 4\n").groups, (std::vector<MeshGroup>{{"all", 0}}));
}

TEST(Obj, IsRefusedWithTheLine) {
  const std::string square = kSquare;
  EXPECT_EQ(refusal(read_obj, square + "f 1 2 9\n"),
            "line 5: a face names a vertex that is not there");
  EXPECT_EQ(refusal(read_obj, square + "f 0 1 2\n"),
            "line 5: a face names a vertex that is not there");
  EXPECT_EQ(refusal(read_obj, square + "f 1 2\n"), "line 5: a face has 2 corners");
  EXPECT_EQ(refusal(read_obj, square + "f 1 x 2\n"), "line 5: 'x' is no corner of a face");
}

constexpr const char* kOff = "4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Off, HasCommentsColoursAndHeadersOfManyKinds) {
  const std::string faces = "3 0 1 2\n3 0 2 3\n", rest = kOff + faces;
  for (const std::string& text :
       {"OFF\n" + rest, "OFF " + rest, rest, "off\n" + rest, "OFF\n# by hand\n\n" + rest,
        "OFF\n" + std::string(kOff) + "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5\n",
        "OFF\n" + std::string(kOff) + "3 0 1 2 7\n3 0 2 3 7\n",
        "OFF\n" + replaced(rest, "\n", "\r\n"),
        "COFF\n" + replaced(kOff, " 0\n", " 0 255 0 0 255\n") + faces})
    EXPECT_EQ(read_off(replaced(text, "2 0 255 0 0 255\n", "2 0\n")).triangles.size(), 2u) << text;
}

TEST(Off, IsReadInBothOrdersOfBytes) {
  for (const bool swap : {false, true}) {
    std::string bytes = "OFF BINARY\n";
    const auto add = [&](std::uint32_t word) {
      if (swap) word = __builtin_bswap32(word);
      bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
    };
    for (const std::uint32_t count : {3u, 1u, 0u}) add(count);
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
      add(std::bit_cast<std::uint32_t>(x));
    for (const std::uint32_t word : {3u, 0u, 1u, 2u}) add(word);
    EXPECT_EQ(read_off(bytes).triangles.size(), 1u);
    EXPECT_NE(refusal(read_off, bytes.substr(0, bytes.size() - 2)), "");
  }
}

TEST(Off, ThatPromisesMoreThanItHoldsIsRefused) {
  EXPECT_NE(refusal(read_off, "OFF\n2000000000 5 0\n").find("promises"), std::string::npos);
  EXPECT_NE(refusal(read_off, "OFF\n" + std::string(kOff) + "3 0 1 2\n").find("cut off"),
            std::string::npos);
}

constexpr const char* kPly =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
    "element face 1\nproperty list uchar int vertex_index\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nelement edge 1\nproperty int a\nend_header\n";

TEST(Ply, HasOtherElementsAndProperties) {
  const FileMesh read = read_ply("ply\nformat ascii 1.0\nobj_info x\n" + std::string(kPly) +
                                 "0 0 0 nan\n1 0 0 1\n0 1 0 1\n3 0 1 2 1 2 3\n7\n");
  EXPECT_EQ(read.triangles.size(), 1u);
  EXPECT_EQ(read.groups, (std::vector<MeshGroup>{{"", 0, MeshColour{1, 2, 3}}}));
}

TEST(Ply, IsReadInBothOrdersOfBytes) {
  for (const bool big : {false, true}) {
    std::string bytes =
        std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + kPly;
    const auto add = [&](std::uint32_t word) {
      if (big == (std::endian::native == std::endian::little)) word = __builtin_bswap32(word);
      bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
    };
    for (const float x : {0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f})
      add(std::bit_cast<std::uint32_t>(x));
    bytes += '\3';
    for (const std::uint32_t corner : {0u, 1u, 2u}) add(corner);
    bytes += "\1\2\3";
    add(0);
    EXPECT_EQ(read_ply(bytes).points[1], (Vec3{1, 0, 0}));
    EXPECT_EQ(refusal(read_ply, bytes.substr(0, bytes.size() - 8)),
              "ends in face 1: it is cut off");
  }
}

TEST(Ply, ThatPromisesMoreThanItHoldsIsRefused) {
  const std::string text = "ply\nformat ascii 1.0\n" + std::string(kPly);
  EXPECT_NE(refusal(read_ply, replaced(text, "vertex 3", "vertex 99999999999")).find("promises"),
            std::string::npos);
  EXPECT_NE(refusal(read_ply, text + "0 0 0 1\n1 0 0 1\n").find("ends in vertex 3"),
            std::string::npos);
  EXPECT_NE(refusal(read_ply, text + "0 0 nan 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 1 2 3\n7\n")
                .find("vertex 1 has a coordinate that is no finite number"),
            std::string::npos);
}

TEST(MeshFormats, RefuseWhatIsCutOff) {
  const FileMesh mesh = tetrahedron();
  using Reader = FileMesh (*)(std::string_view);
  const std::vector<std::pair<Reader, std::string>> files{{read_stl, stl_bytes(mesh)},
                                                          {read_stl, stl_text(mesh)},
                                                          {read_off, off_text(mesh)},
                                                          {read_ply, ply_content(mesh, true)},
                                                          {read_ply, ply_content(mesh, false)}};
  for (const auto& [read, whole] : files)
    for (const double part : {0.3, 0.6, 0.9})
      EXPECT_NE(refusal(read, whole.substr(0, static_cast<std::size_t>(
                                                  part * static_cast<double>(whole.size())))),
                "")
          << whole.substr(0, 20) << part;
}

}  // namespace
}  // namespace blossom::meshes
