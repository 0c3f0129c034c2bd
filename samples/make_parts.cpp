// SPDX-License-Identifier: LGPL-2.1-or-later
// Makes the STEP files that samples/run.sh and the README's lines work on, named and coloured:
// hull.step with the skin of a boat, cutters.step with its deck and the tunnel of a bow thruster,
// fuselage.step and wings.step of an aircraft, and two solids, block.step and drill.step.
//
// usage: make_parts FOLDER

#include <exception>
#include <filesystem>
#include <iostream>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "adapters/occt/shapes.h"
#include "samples/aircraft_parts.h"
#include "samples/hull_parts.h"

namespace {

TopoDS_Face face_on(const Handle(Geom_BSplineSurface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

void make_parts(const std::filesystem::path& folder) {
  namespace samples = blossom::samples;
  std::filesystem::create_directories(folder);

  blossom::occt::Model hull;
  hull.add(face_on(samples::hull_skin()), "Hull", {0.36, 0.56, 0.78});
  blossom::occt::write_model(hull, folder / "hull.step");

  blossom::occt::Model cutters;
  cutters.add(face_on(samples::deck()), "Deck", {0.93, 0.69, 0.33});
  cutters.add(face_on(samples::thruster_tunnel()), "Thruster tunnel", {0.55, 0.75, 0.45});
  blossom::occt::write_model(cutters, folder / "cutters.step");

  blossom::occt::Model fuselage, wings;
  fuselage.add(samples::fuselage(), "Fuselage", {0.36, 0.56, 0.78});
  blossom::occt::write_model(fuselage, folder / "fuselage.step");
  for (const int side : {1, -1})
    wings.add(samples::wing(side), side > 0 ? "Starboard wing" : "Port wing", {0.93, 0.69, 0.33});
  blossom::occt::write_model(wings, folder / "wings.step");

  blossom::occt::Model block;
  block.add(BRepPrimAPI_MakeBox(60, 40, 20).Shape(), "Block", {0.36, 0.56, 0.78});
  blossom::occt::write_model(block, folder / "block.step");

  blossom::occt::Model drill;
  const gp_Ax2 axis(gp_Pnt(25, 20, -10), gp::DZ());
  drill.add(BRepPrimAPI_MakeCylinder(axis, 8, 40).Shape(), "Drill", {0.93, 0.69, 0.33});
  blossom::occt::write_model(drill, folder / "drill.step");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_parts FOLDER\n";
    return 2;
  }
  blossom::occt::quiet_messages();
  try {
    make_parts(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "make_parts: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
