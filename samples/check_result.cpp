// SPDX-License-Identifier: LGPL-2.1-or-later
// Opens what samples/boat.sh, or with "aircraft" samples/aircraft.sh, has written with Open CASCADE
// alone, and checks it: validity, number of faces and holes, names, areas and volumes.
//
// usage: check_result FOLDER [aircraft]

#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include "adapters/occt/shapes.h"

namespace {

struct Part {
  TopoDS_Shape shape;
  std::string name;
};

void require(bool holds, const std::string& claim) {
  if (!holds) throw std::runtime_error("does not hold: " + claim);
  std::cout << "  holds: " << claim << '\n';
}

// The only part of a STEP file.
Part read_part(const std::filesystem::path& file) {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  STEPCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone || !reader.Transfer(document))
    throw std::runtime_error(file.string() + " cannot be read");
  TDF_LabelSequence parts;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(parts);
  if (parts.Length() != 1) throw std::runtime_error(file.string() + " does not hold one part");
  Handle(TDataStd_Name) name;
  parts(1).FindAttribute(TDataStd_Name::GetID(), name);
  return {XCAFDoc_ShapeTool::GetShape(parts(1)),
          name.IsNull() ? "" : TCollection_AsciiString(name->Get()).ToCString()};
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

double area(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, 1e-8);
  return properties.Mass();
}

void check_part(const Part& part, int faces, int wires, const std::string& what) {
  require(BRepCheck_Analyzer(part.shape).IsValid(), what + " is valid");
  require(count(part.shape, TopAbs_FACE) == faces,
          what + " has " + std::to_string(faces) + " faces");
  require(count(part.shape, TopAbs_WIRE) == wires,
          what + " has " + std::to_string(wires) + " wires");
  require(part.name.find("Hull") != std::string::npos, what + " is still called Hull");
}

double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-8);
  return properties.Mass();
}

// Each root has the strip round its wing and the one along its trailing edge.
void check_aircraft(const std::filesystem::path& folder) {
  const Part sharp = read_part(folder / "aircraft.step");
  const Part round = read_part(folder / "faired.step");
  for (const auto& [part, what] : {std::pair{&sharp, "the aircraft"}, {&round, "the faired one"}})
    require(BRepCheck_Analyzer(part->shape).IsValid(), std::string(what) + " is valid");
  require(count(round.shape, TopAbs_FACE) == count(sharp.shape, TopAbs_FACE) + 4,
          "there are four fillets");
  const double more = volume(round.shape) - volume(sharp.shape);
  require(more > 1e7 && more < 2e7, "they add 10 to 20 litres");
}

void check(const std::filesystem::path& folder) {
  const double whole = area(read_part(folder / "hull.step").shape);

  // The two bulwarks above the deck, the body below with two holes, and two discs in the tunnel.
  const Part pieces = read_part(folder / "pieces.step");
  check_part(pieces, 5, 7, "the hull cut by both tools");
  require(std::abs(area(pieces.shape) - whole) < 1e-7 * whole, "the pieces have the whole's area");

  const Part body = read_part(folder / "boat.step");
  check_part(body, 1, 3, "the hull below the deck and outside the tunnel");
  require(area(body.shape) < 0.95 * whole && area(body.shape) > 0.5 * whole,
          "the bulwarks and the discs are gone");

  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(blossom::occt::read_model(folder / "intersection.step").shape(), TopAbs_EDGE,
                    edges);
  require(edges.Extent() == 4, "the intersection has four edges");
}

}  // namespace

int main(int argc, char** argv) {
  const bool of_aircraft = argc == 3 && std::string(argv[2]) == "aircraft";
  if (argc != 2 && !of_aircraft) {
    std::cerr << "usage: check_result FOLDER [aircraft]\n";
    return 2;
  }
  blossom::occt::quiet_messages();
  try {
    of_aircraft ? check_aircraft(argv[1]) : check(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "check_result: " << error.what() << '\n';
    return 1;
  } catch (const Standard_Failure& failure) {
    std::cerr << "check_result: " << failure.GetMessageString() << '\n';
    return 1;
  }
  return 0;
}
