// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/brep_bytes.h"

#include <istream>
#include <sstream>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/shapes/shapes_detail.h"

namespace blossom::occt {
namespace {

/// Both kinds of binary BRep write a set of shapes. FreeCAD ends it with three integers (shape,
/// location, orientation), BinTools::Write with a shape of nine bytes.
constexpr std::streamoff kFreeCadEnding = 12;

/// Binary BRep has these words at its beginning, text has them without "Open ".
constexpr std::string_view kBinaryMark = "Open CASCADE Topology V";
constexpr std::string_view kTextMark = "CASCADE Topology V";

TopoDS_Shape freecad_shape(BinTools_ShapeSet& set, std::istream& in) {
  Standard_Integer index = 0, location = 0, orientation = 0;
  BinTools::GetInteger(in, index);
  BinTools::GetInteger(in, location);
  BinTools::GetInteger(in, orientation);
  if (index < 1 || index > set.NbShapes() || location < 0 ||
      location > set.Locations().NbLocations() || orientation < TopAbs_FORWARD ||
      orientation > TopAbs_EXTERNAL)
    return {};
  TopoDS_Shape shape = set.Shape(index);
  shape.Location(set.Locations().Location(location));
  shape.Orientation(static_cast<TopAbs_Orientation>(orientation));
  return shape;
}

TopoDS_Shape binary_shape(std::istream& in, std::size_t size) {
  BinTools_ShapeSet set;
  set.Read(in);
  if (!in || set.NbShapes() == 0) return {};
  if (static_cast<std::streamoff>(size) - in.tellg() == kFreeCadEnding)
    return freecad_shape(set, in);
  TopoDS_Shape shape;
  set.ReadSubs(shape, in, set.NbShapes());
  return shape;
}

TopoDS_Shape any_shape(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 64);
  std::istringstream in{std::string(bytes)};
  if (head.find(kBinaryMark) != std::string_view::npos) return binary_shape(in, bytes.size());
  TopoDS_Shape shape;
  if (head.find(kTextMark) == std::string_view::npos) return shape;
  check_whole(Format::Brep, bytes);  // the reader never returns from a text that is cut off
  BRepTools::Read(shape, in, BRep_Builder());
  return shape;
}

}  // namespace

TopoDS_Shape shape_from_bytes(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw BadModel(name + ": there are no bytes");
  TopoDS_Shape shape;
  try {
    shape = any_shape(bytes);
  } catch (const Standard_Failure&) {
    const std::string text = current_failure_text();  // ends in an address now and then
    throw BadModel(name + ": the BRep is damaged: " + text.substr(0, text.find('\n')));
  } catch (const BadModel& bad) {
    throw BadModel(name + ": " + bad.what());
  }
  if (shape.IsNull())
    throw BadModel(name + ": these " + std::to_string(bytes.size()) + " bytes hold no BRep shape");
  return shape;
}

std::string brep_text(const TopoDS_Shape& shape) {
  return guarded("writing BRep", [&] {
    std::ostringstream out;
    BRepTools::Write(shape, out);
    return out.str();
  });
}

}  // namespace blossom::occt
