// SPDX-License-Identifier: LGPL-2.1-or-later
// Questions to a model: how far two shapes are apart, and what a plane cuts out of one.
//
// usage: 04_query_a_model
//
// Prints the answers, and ends with 1 if one is not what geometry says.

#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/distance.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/plane_section.h"

namespace {

using namespace blossom;

bool near(double found, double expected, double within) {
  return std::abs(found - expected) <= within;
}

// A ball of radius 2 beside a pin of radius 1: 7 - 2 - 1 = 4 are between them.
bool ask_distance() {
  const occt::MeasuredShape ball(BRepPrimAPI_MakeSphere(gp_Pnt(7, 0, 5), 2).Shape());
  const occt::MeasuredShape pin(BRepPrimAPI_MakeCylinder(1, 10).Shape());
  const occt::ShapeDistance found = occt::least_distance(ball, pin);
  std::printf("distance: at least %.9f, at most %.9f\n", found.lower, found.upper);
  std::printf("  from (%.3f, %.3f, %.3f) to (%.3f, %.3f, %.3f)\n", found.a.point[0],
              found.a.point[1], found.a.point[2], found.b.point[0], found.b.point[1],
              found.b.point[2]);
  return found.lower <= 4 && 4 <= found.upper + 1e-6 && near(found.upper, 4, 1e-6);
}

// A slanted plane cuts an ellipse out of the pin; a level one a circle.
bool ask_section() {
  const auto faces = occt::faces_of(BRepPrimAPI_MakeCylinder(1, 10).Shape());
  const occt::PlaneSection level = occt::plane_section(faces, {{0, 0, 5}, {0, 0, 1}});
  std::printf("section: %s, %zu wires\n", to_string(level.status), level.wires.size());
  for (const occt::SectionWire& wire : level.wires)
    std::printf("  %s, length %.9f\n", wire.closed ? "closed" : "open", wire.length);
  return level.status == Status::Complete && level.wires.size() == 1 &&
         level.wires.front().closed && near(level.wires.front().length, 2 * std::numbers::pi, 1e-6);
}

}  // namespace

int main() try {
  const bool right = ask_distance() && ask_section();
  return right ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
