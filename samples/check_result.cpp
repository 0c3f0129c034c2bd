// SPDX-License-Identifier: LGPL-2.1-or-later
// Opens what samples/boat.sh has written with Open CASCADE alone, and checks it: validity, number
// of faces and holes, names, and that the pieces have the area of the whole.
//
// usage: check_result FOLDER

#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

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
  if (argc != 2) {
    std::cerr << "usage: check_result FOLDER\n";
    return 2;
  }
  blossom::occt::quiet_messages();
  try {
    check(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "check_result: " << error.what() << '\n';
    return 1;
  } catch (const Standard_Failure& failure) {
    std::cerr << "check_result: " << failure.GetMessageString() << '\n';
    return 1;
  }
  return 0;
}
