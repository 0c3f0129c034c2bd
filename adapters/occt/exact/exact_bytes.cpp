// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exact/exact_bytes.h"

#include <cstring>
#include <set>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>

#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TFace.hxx>
#include <BinTools_ShapeSet.hxx>
#include <Geom2d_Conic.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Conic.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/exact/exact_places.h"

namespace blossom::occt {
namespace {

// As a byte, a bit each.
unsigned char flags_of(const TopoDS_TShape& shape) {
  return static_cast<unsigned char>(shape.Free() | shape.Modified() << 1 | shape.Checked() << 2 |
                                    shape.Orientable() << 3 | shape.Closed() << 4 |
                                    shape.Infinite() << 5 | shape.Convex() << 6);
}

void put_flags(TopoDS_TShape& shape, unsigned char flags) {
  shape.Free((flags & 1) != 0);
  shape.Modified((flags & 2) != 0);
  shape.Checked((flags & 4) != 0);  // after Modified, which takes it away
  shape.Orientable((flags & 8) != 0);
  shape.Closed((flags & 16) != 0);
  shape.Infinite((flags & 32) != 0);
  shape.Convex((flags & 64) != 0);
}

// Calls visit(value, put) for the flags of all shapes in a shape and the placements of all curves
// and surfaces, each once; put sets the value.
template <class Visit>
class HiddenParts {
 public:
  explicit HiddenParts(const Visit& visit) : visit_(visit) {}

  void of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, parts);
    for (int i = 1; i <= parts.Extent(); ++i) {
      const Handle(TopoDS_TShape)& part = parts(i).TShape();
      if (!seen_.insert(part.get()).second) continue;
      visit_(flags_of(*part), [&](unsigned char flags) { put_flags(*part, flags); });
      if (const auto face = Handle(BRep_TFace)::DownCast(part); !face.IsNull()) of(face->Surface());
      if (const auto edge = Handle(BRep_TEdge)::DownCast(part); !edge.IsNull()) of(*edge);
    }
  }

 private:
  void of(const BRep_TEdge& edge) {
    for (const Handle(BRep_CurveRepresentation) & each : edge.Curves()) {
      if (each->IsCurve3D()) of(each->Curve3D());
      if (!each->IsCurveOnSurface()) continue;
      of(each->Surface());
      of(each->PCurve());
      if (each->IsCurveOnClosedSurface()) of(each->PCurve2());
    }
  }

  void of(const Handle(Geom_Surface) & surface) {
    if (!is_new(surface)) return;
    if (const auto plain = Handle(Geom_ElementarySurface)::DownCast(surface); !plain.IsNull()) {
      visit_(plain->Position(), [&](const gp_Ax3& place) { plain->SetPosition(place); });
    } else if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
               !turned.IsNull()) {
      visit_(turned->Axis(), [&](const gp_Ax1& axis) { turned->SetAxis(axis); });
      of(turned->BasisCurve());
    } else if (const auto drawn = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface);
               !drawn.IsNull()) {
      visit_(drawn->Direction(), [&](const gp_Dir& way) { drawn->SetDirection(way); });
      of(drawn->BasisCurve());
    } else if (const auto cut = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
               !cut.IsNull()) {
      of(cut->BasisSurface());
    } else if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
               !offset.IsNull()) {
      of(offset->BasisSurface());
    }
  }

  void of(const Handle(Geom_Curve) & curve) {
    of_curve<Geom_Line, Geom_Conic, Geom_TrimmedCurve, Geom_OffsetCurve>(
        curve, [](Geom_Conic& conic, const gp_Ax2& place) { conic.SetPosition(place); });
  }

  void of(const Handle(Geom2d_Curve) & curve) {
    of_curve<Geom2d_Line, Geom2d_Conic, Geom2d_TrimmedCurve, Geom2d_OffsetCurve>(
        curve, [](Geom2d_Conic& conic, const gp_Ax22d& place) { conic.SetAxis(place); });
  }

  template <class Line, class Conic, class Trimmed, class Offset, class Curve, class Place>
  void of_curve(const Handle(Curve) & curve, const Place& place_conic) {
    if (!is_new(curve)) return;
    if (const auto line = Handle(Line)::DownCast(curve); !line.IsNull())
      visit_(line->Position(), [&](const auto& place) { line->SetPosition(place); });
    else if (const auto conic = Handle(Conic)::DownCast(curve); !conic.IsNull())
      visit_(conic->Position(), [&](const auto& place) { place_conic(*conic, place); });
    else if (const auto cut = Handle(Trimmed)::DownCast(curve); !cut.IsNull())
      of(cut->BasisCurve());
    else if (const auto offset = Handle(Offset)::DownCast(curve); !offset.IsNull())
      of(offset->BasisCurve());
  }

  template <class Geometry>
  bool is_new(const Handle(Geometry) & geometry) {
    return !geometry.IsNull() && seen_.insert(geometry.get()).second;
  }

  const Visit& visit_;
  std::set<const Standard_Transient*> seen_;
};

// What Open CASCADE writes, and what it loses.
struct ExactForm {
  std::string form, places, hidden;
};

std::string hidden_of(const TopoDS_Shape& shape) {
  std::string bytes;
  const auto visit = [&](const auto& value, const auto&) {
    static_assert(std::is_trivially_copyable_v<std::decay_t<decltype(value)>>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  HiddenParts(visit).of(shape);
  return bytes;
}

void put_hidden(const std::string& bytes, const TopoDS_Shape& shape) {
  std::size_t at = 0;
  const auto visit = [&](auto value, const auto& put) {
    if (at + sizeof(value) > bytes.size()) throw std::ios_base::failure("values are missing");
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    at += sizeof(value);
    put(value);
  };
  HiddenParts(visit).of(shape);
  if (at != bytes.size()) throw std::ios_base::failure("there are too many values");
}

// Instances in the same places, of a walk over both.
bool are_placed_alike(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  TopTools_IndexedMapOfShape of_a, of_b;
  TopExp::MapShapes(a, of_a);
  TopExp::MapShapes(b, of_b);
  if (of_a.Extent() != of_b.Extent()) return false;
  for (int i = 1; i <= of_a.Extent(); ++i) {
    const gp_Trsf &at = of_a(i).Location().Transformation(),
                  &other = of_b(i).Location().Transformation();
    if (at.ScaleFactor() != other.ScaleFactor() || at.Form() != other.Form()) return false;
    for (int row = 1; row <= 3; ++row)
      for (int column = 1; column <= 4; ++column)
        if (at.Value(row, column) != other.Value(row, column)) return false;
  }
  return true;
}

ExactForm form_of(const TopoDS_Shape& shape) {
  BinTools_ShapeSet set;
  set.SetWithTriangles(true);
  set.SetWithNormals(true);
  set.Add(shape);
  std::ostringstream out(std::ios::out | std::ios::binary);
  set.Write(out);
  set.Write(shape, out);
  return {std::move(out).str(), bytes_of(set.Locations()), hidden_of(shape)};
}

TopoDS_Shape shape_of(const ExactForm& exact) {
  std::istringstream in(exact.form, std::ios::in | std::ios::binary);
  ExactPlacesSet set(exact.places);
  set.SetWithTriangles(true);
  set.Read(in);
  TopoDS_Shape shape;
  set.ReadSubs(shape, in, set.NbShapes());
  put_hidden(exact.hidden, shape);
  return shape;
}

// Takes a part of bytes that stands behind its length.
std::string taken_part(std::string_view& bytes) {
  std::uint64_t length = 0;
  if (bytes.size() < sizeof(length)) throw std::ios_base::failure("a length is missing");
  std::memcpy(&length, bytes.data(), sizeof(length));
  bytes.remove_prefix(sizeof(length));
  if (length > bytes.size()) throw std::ios_base::failure("the shape is cut off");
  std::string part(bytes.substr(0, length));
  bytes.remove_prefix(length);
  return part;
}

}  // namespace

std::optional<std::string> exact_bytes(const TopoDS_Shape& shape) {
  const ExactForm exact = form_of(shape);
  const TopoDS_Shape again = shape_of(exact);
  const ExactForm of_again = form_of(again);
  if (of_again.form != exact.form || of_again.hidden != exact.hidden ||
      !are_placed_alike(shape, again))
    return std::nullopt;
  std::string bytes;
  for (const std::string* part : {&exact.form, &exact.places, &exact.hidden}) {
    const std::uint64_t length = part->size();
    bytes.append(reinterpret_cast<const char*>(&length), sizeof(length));
    bytes += *part;
  }
  return bytes;
}

TopoDS_Shape shape_of_exact_bytes(const std::string& bytes) {
  std::string_view rest = bytes;
  ExactForm exact;
  for (std::string* part : {&exact.form, &exact.places, &exact.hidden}) *part = taken_part(rest);
  if (!rest.empty()) throw std::ios_base::failure("there are too many parts");
  return shape_of(exact);
}

// What is put into a compound loses a flag, which is given back.
std::optional<std::string> exact_bytes(const std::vector<TopoDS_Shape>& shapes) {
  std::vector<bool> free;
  for (const TopoDS_Shape& shape : shapes) free.push_back(shape.Free());
  const TopoDS_Compound all = compound_of(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i) shapes[i].TShape()->Free(free[i]);
  return exact_bytes(static_cast<const TopoDS_Shape&>(all));
}

std::vector<TopoDS_Shape> shapes_of_exact_bytes(const std::string& bytes) {
  const TopoDS_Shape all = shape_of_exact_bytes(bytes);  // iterators do not keep it
  std::vector<TopoDS_Shape> shapes;
  for (TopoDS_Iterator it(all); it.More(); it.Next()) shapes.push_back(it.Value());
  return shapes;
}

}  // namespace blossom::occt
