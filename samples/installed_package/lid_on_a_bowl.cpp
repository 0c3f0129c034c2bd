// SPDX-License-Identifier: LGPL-2.1-or-later
// The bowl z = x^2 + y^2 over [-1, 1]^2 and a lid at z = 1/4 meet in a circle of radius 1/2.
// Finds it from C++, and checks that it is that circle.

#include <cmath>
#include <iostream>
#include <numbers>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "adapters/occt/intersection.h"

namespace {

TopoDS_Face bowl() {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      poles(i + 1, j + 1) = gp_Pnt(i - 1, j - 1, (i == 1 ? -1 : 1) + (j == 1 ? -1 : 1));
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face();
}

TopoDS_Face lid() {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(2 * i - 1, 2 * j - 1, 0.25);
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Face();
}

}  // namespace

int main() {
  const auto answer = blossom::occt::intersect({bowl()}, {lid()});
  std::cout << "status: " << blossom::to_string(answer.status) << '\n';
  if (answer.status != blossom::Status::Complete || answer.pairs.size() != 1) return 1;

  for (const auto& curve : answer.pairs[0].found.curves)
    std::cout << (curve.closed ? "closed" : "open") << " curve of length " << curve.length << '\n';
  const auto& curves = answer.pairs[0].found.curves;
  const bool right = curves.size() == 1 && curves[0].closed &&
                     std::abs(curves[0].length - std::numbers::pi) < 1e-6;
  return right ? 0 : 1;
}
