// SPDX-License-Identifier: LGPL-2.1-or-later
// BREP files, text and binary, that say they have more than they are long.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Poly_Polygon3D.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>

#include "adapters/occt/base/errors.h"
#include "tests/adapters/occt/exchange/read_files.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;
using testing::faces_of;
using testing::Folder;
using testing::refusal;

Handle(Geom_BezierSurface) rational_surface() {
  TColgp_Array2OfPnt poles(1, 3, 1, 4);
  TColStd_Array2OfReal weights(1, 3, 1, 4);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 4; ++j) {
      poles(i, j) = gp_Pnt(i, j, i == 2 ? 1 : 0);
      weights(i, j) = j == 2 ? 2 : 1;
    }
  return new Geom_BezierSurface(poles, weights);
}

Handle(Geom_BezierCurve) curve_beside_axis() {
  TColgp_Array1OfPnt poles(1, 3);
  for (int i = 1; i <= 3; ++i) poles(i) = gp_Pnt(i == 2 ? 3 : 2, 0, i);
  return new Geom_BezierCurve(poles);
}

Handle(Geom_Surface) trimmed_surface(const Handle(Geom_Surface) & surface) {
  return new Geom_RectangularTrimmedSurface(surface, 0.3, 0.7, 0.0, 1.0);
}

std::vector<Handle(Geom_Surface)> surfaces() {
  const gp_Ax3 axes;
  const Handle(Geom_BezierCurve) curve = curve_beside_axis();
  const Handle(Geom_TrimmedCurve) trimmed =
      new Geom_TrimmedCurve(GeomConvert::CurveToBSplineCurve(curve), 0.2, 0.8);
  const Handle(Geom_BezierSurface) bezier = rational_surface();
  const Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(bezier);
  std::vector<Handle(Geom_Surface)> all;
  all.push_back(bezier);
  all.push_back(spline);
  all.push_back(trimmed_surface(new Geom_ConicalSurface(axes, 0.5, 2)));
  all.push_back(trimmed_surface(new Geom_SurfaceOfLinearExtrusion(curve, gp::DY())));
  all.push_back(trimmed_surface(new Geom_SurfaceOfLinearExtrusion(trimmed, gp::DY())));
  all.emplace_back(new Geom_SphericalSurface(axes, 2));
  all.emplace_back(new Geom_ToroidalSurface(axes, 3, 1));
  all.emplace_back(new Geom_SurfaceOfRevolution(curve, gp::OZ()));
  all.emplace_back(new Geom_OffsetSurface(spline, 0.1));
  return all;
}

std::vector<Handle(Geom2d_Curve)> planar_curves() {
  const gp_Ax22d axes;
  TColgp_Array1OfPnt2d poles(1, 2);
  poles(2) = gp_Pnt2d(1, 1);
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(2);
  const Handle(Geom2d_BezierCurve) bezier = new Geom2d_BezierCurve(poles);
  std::vector<Handle(Geom2d_Curve)> all;
  all.push_back(bezier);
  all.emplace_back(new Geom2d_Circle(axes, 2));
  all.emplace_back(new Geom2d_Ellipse(axes, 3, 2));
  all.emplace_back(new Geom2d_Parabola(axes, 2));
  all.emplace_back(new Geom2d_Hyperbola(axes, 3, 2));
  all.emplace_back(new Geom2d_BSplineCurve(poles, knots, multiplicities, 1));
  all.emplace_back(new Geom2d_OffsetCurve(bezier, 0.1));
  all.emplace_back(new Geom2d_TrimmedCurve(bezier, 0.0, 1.0));
  return all;
}

std::vector<TopoDS_Edge> edges() {
  const gp_Ax2 axes;
  const Handle(Geom_BezierCurve) curve = curve_beside_axis();
  std::vector<Handle(Geom_Curve)> curves;
  curves.push_back(curve);
  curves.emplace_back(new Geom_Ellipse(axes, 3, 2));
  curves.emplace_back(new Geom_Parabola(axes, 2));
  curves.emplace_back(new Geom_Hyperbola(axes, 3, 2));
  curves.emplace_back(new Geom_OffsetCurve(curve, 0.1, gp::DY()));
  std::vector<TopoDS_Edge> all;
  for (const Handle(Geom_Curve) & each : curves)
    all.push_back(BRepBuilderAPI_MakeEdge(each, 0, 1).Edge());
  TColgp_Array1OfPnt nodes(1, 2);
  nodes(2) = gp_Pnt(1, 0, 0);
  BRep_Builder().UpdateEdge(all.front(), new Poly_Polygon3D(nodes));
  for (const Handle(Geom2d_Curve) & each : planar_curves())
    all.push_back(BRepBuilderAPI_MakeEdge(each, new Geom_Plane(gp::XOY()), 0, 1).Edge());
  return all;
}

// All kinds of entries that BREP has, with triangles, and one face at another place.
TopoDS_Compound all_kinds() {
  TopoDS_Compound whole;
  BRep_Builder().MakeCompound(whole);
  for (const Handle(Geom_Surface) & each : surfaces())
    BRep_Builder().Add(whole, BRepBuilderAPI_MakeFace(each, 1e-6).Shape());
  for (const TopoDS_Edge& edge : edges()) BRep_Builder().Add(whole, edge);
  TopoDS_Shape pipe = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  BRepMesh_IncrementalMesh(pipe, 0.1);
  gp_Trsf away;
  away.SetTranslation(gp_Vec(5, 0, 0));
  BRep_Builder().Add(whole, pipe);
  BRep_Builder().Add(whole, pipe.Moved(TopLoc_Location(away).Powered(2)));
  return whole;
}

constexpr int kFaces = 9 + 6;

struct Form {
  bool binary;
  int version;
  bool normals = false;
};
constexpr Form kForms[] = {{false, 1}, {false, 2}, {false, 3, true}, {true, 1},
                           {true, 2},  {true, 3},  {true, 4, true}};

std::string written(const TopoDS_Shape& shape, const Form& form) {
  std::ostringstream out;
  if (form.binary)
    BinTools::Write(shape, out, true, form.normals,
                    static_cast<BinTools_FormatVersion>(form.version));
  else
    BRepTools::Write(shape, out, true, form.normals,
                     static_cast<TopTools_FormatVersion>(form.version));
  return out.str();
}

// Words of a text; in binary `k` is a kind or flag, `d` a degree, `i` an integer, `r` a real
// number.
struct Word {
  char type;
  long value = 0;

  void append_to(std::string& bytes, bool binary) const {
    if (!binary) {
      bytes += std::to_string(value) + ' ';
      return;
    }
    const auto put = [&bytes](const auto number) {
      bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
    };
    if (type == 'k') put(static_cast<char>(value));
    if (type == 'd') put(static_cast<std::uint16_t>(value));
    if (type == 'i') put(static_cast<std::int32_t>(value));
    if (type == 'r') put(static_cast<double>(value));
  }
};

constexpr std::string_view kTables[] = {
    "Locations", "Curve2ds",       "Curves", "Polygon3D", "PolygonOnTriangulations",
    "Surfaces",  "Triangulations", "TShapes"};

// Where the tables begin: some names end with others.
std::vector<std::size_t> headings(const std::string& content) {
  std::vector<std::size_t> all;
  for (const std::string_view name : kTables)
    all.push_back(content.find(std::string(name) + " ", all.empty() ? 0 : all.back()));
  return all;
}

// The content with a further entry at the end of a table.
std::string with_last(std::string content, std::size_t table, const std::vector<Word>& entry,
                      bool binary) {
  const std::vector<std::size_t> all = headings(content);
  const std::size_t count_at = all[table] + kTables[table].size() + 1;
  const std::size_t digits = content.find('\n', count_at) - count_at;
  const int count = std::stoi(content.substr(count_at, digits));
  std::string bytes;
  for (const Word& word : entry) word.append_to(bytes, binary);
  const bool shapes_follow = kTables[table + 1] == "TShapes";  // behind an empty line
  content.insert(all[table + 1] - (shapes_follow ? 1 : 0), bytes);
  return content.replace(count_at, digits, std::to_string(count + 1));
}

constexpr long kMany = 2147483647;

struct Case {
  std::string_view table;
  std::vector<Word> entry;
  std::string what;
};

std::vector<Word> operator+(std::vector<Word> first, const std::vector<Word>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<Case> cases() {
  const Word zero{'r'}, no{'k'};
  const auto spline = [&](long poles, long knots) {
    return std::vector<Word>{{'k', 7}, no, no, {'d', 3}, {'i', poles}, {'i', knots}};
  };
  const auto grid = [&](long rows, long columns, long knots_u, long knots_v) {
    return std::vector<Word>{{'k', 9},
                             no,
                             no,
                             no,
                             no,
                             {'d', 1},
                             {'d', 1},
                             {'i', rows},
                             {'i', columns},
                             {'i', knots_u},
                             {'i', knots_v}};
  };
  const std::vector<Word> bezier = {{'k', 6}, no, {'d', 65000}};
  const std::vector<Word> trimmed = {{'k', 8}, zero, zero};
  const std::string poles = "65001 control points", many = "2147483647 ";
  return {
      {"Curve2ds", bezier, poles},
      {"Curve2ds", spline(kMany, 2), many + "control points"},
      {"Curve2ds", spline(2, kMany), many + "knots"},
      {"Curve2ds", spline(-5, 2), "-5 control points"},
      {"Curve2ds", trimmed + spline(2, -1), "-1 knots"},
      {"Curve2ds", std::vector<Word>{{'k', 9}, zero} + bezier, poles},
      {"Curves", bezier, poles},
      {"Curves", spline(kMany, 2), many + "control points"},
      {"Curves", spline(2, kMany), many + "knots"},
      {"Curves", trimmed + trimmed + spline(-5, 2), "-5 control points"},
      {"Curves", std::vector<Word>{{'k', 9}, zero, zero, zero, zero} + bezier, poles},
      {"Polygon3D", {{'i', kMany}, no, zero}, many + "nodes"},
      {"PolygonOnTriangulations", {{'i', kMany}}, many + "nodes"},
      {"Surfaces", {{'k', 8}, no, {'k', 1}, {'d', 65000}, {'d', 1}}, "65001 x 2 control points"},
      {"Surfaces", grid(kMany, 4, 2, 2), many + "x 4 control points"},
      {"Surfaces", grid(4, kMany, 2, 2), "4 x 2147483647 control points"},
      {"Surfaces", grid(kMany, kMany, 2, 2), many + "x 2147483647 control points"},
      {"Surfaces", grid(65536, 65536, 2, 2), "65536 x 65536 control points"},
      {"Surfaces", grid(400, 400, 2, 2), "400 x 400 control points"},
      {"Surfaces", grid(2, 2, kMany, 2), many + "knots"},
      {"Surfaces", grid(2, 2, 2, -1), "-1 knots"},
      {"Surfaces", std::vector<Word>{{'k', 6}, zero, zero, zero} + spline(kMany, 2),
       many + "control points"},
      {"Surfaces", std::vector<Word>{{'k', 7}, zero, zero, zero, zero, zero, zero} + bezier, poles},
      {"Surfaces",
       std::vector<Word>{{'k', 11}, zero, {'k', 10}, zero, zero, zero, zero} + grid(2, kMany, 2, 2),
       "2 x 2147483647 control points"},
      {"Triangulations", {{'i', kMany}, {'i', 1}, no, zero, zero}, many + "nodes"},
      {"Triangulations", {{'i', 3}, {'i', kMany}, no, zero, zero}, many + "triangles"},
  };
}

std::size_t table_of(const Case& one) {
  return static_cast<std::size_t>(std::ranges::find(kTables, one.table) - std::begin(kTables));
}

TEST(BrepCounts, AreRefusedWhereTheFileIsTooShortForThem) {
  const Folder folder;
  const fs::path file = folder / "part.brep";
  const TopoDS_Compound shape = all_kinds();
  for (const Form& form : kForms) {
    const std::string content = written(shape, form);
    for (const Case& each : cases()) {
      testing::write_content(file, with_last(content, table_of(each), each.entry, form.binary));
      const std::string said = refusal(file);
      EXPECT_TRUE(said.ends_with(" of its table '" + std::string(each.table) +
                                 "' cannot have the " + each.what + " that it says"))
          << (form.binary ? "binary " : "text ") << form.version << ", " << each.what << ": "
          << said;
    }
  }
}

TEST(BrepCounts, OfSoundFilesAreTaken) {
  const Folder folder;
  const fs::path file = folder / "part.brep";
  const TopoDS_Compound shape = all_kinds();
  for (const Form& form : kForms) {
    testing::write_content(file, written(shape, form));
    EXPECT_EQ(faces_of(file), kFaces) << (form.binary ? "binary " : "text ") << form.version;
  }
}

TEST(BrepCounts, OfTablesAreRefusedInBinaryFilesToo) {
  const Folder folder;
  const fs::path file = folder / "part.brep";
  const std::string content = written(all_kinds(), {true, 3});
  for (std::size_t i = 0; i < std::size(kTables); ++i) {
    std::string damaged = content;
    damaged.insert(headings(content)[i] + kTables[i].size() + 1, "2000000");
    testing::write_content(file, damaged);
    EXPECT_EQ(refusal(file), "is damaged: it cannot have as many entries as its table '" +
                                 std::string(kTables[i]) + "' says");
  }
}

}  // namespace
}  // namespace blossom::occt
