// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from BREP, text and binary, and why Open CASCADE leaves a surface out, which it does not
// tell.

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <ios>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <BRepTools_ShapeSet.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <GeomTools_CurveSet.hxx>
#include <GeomTools_SurfaceSet.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/listening.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/exchange/brep_words.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/file_text.h"
#include "adapters/occt/exchange/places.h"

namespace blossom::occt {
namespace {

/// Open CASCADE's readers of BREP go on for ever when a stream has failed; this one throws.
class StrictStream : public std::istringstream {
 public:
  explicit StrictStream(std::string text)
      : std::istringstream(std::move(text), std::ios::in | std::ios::binary) {
    exceptions(std::ios::failbit | std::ios::badbit);
  }
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The count behind the name of a table, and what follows it.
struct Table {
  bool found = false;
  long count = -1;
  std::string_view rest;
};

/// The tables of a text, each by the last line that begins with its name.
class Tables {
 public:
  explicit Tables(std::string_view text) {
    for (std::size_t end = text.find('\n'); end != std::string_view::npos;
         end = text.find('\n', end + 1))
      look_at(text.substr(end + 1));
  }

  Table operator[](std::string_view name) const {
    Table table;
    for (std::size_t i = 0; i < kNames.size(); ++i)
      if (kNames[i] == name) table.rest = rests_[i];
    table.found = table.rest.data() != nullptr;
    if (!table.found) return table;
    while (!table.rest.empty() && is_blank(table.rest.front())) table.rest.remove_prefix(1);
    const char* const last = table.rest.data() + table.rest.size();
    const auto end = std::from_chars(table.rest.data(), last, table.count);
    table.rest.remove_prefix(static_cast<std::size_t>(end.ptr - table.rest.data()));
    return table;
  }

 private:
  static constexpr std::array<std::string_view, 8> kNames = {
      "Locations", "Curve2ds",       "Curves", "Polygon3D", "PolygonOnTriangulations",
      "Surfaces",  "Triangulations", "TShapes"};

  /// text   from the beginning of a line on
  void look_at(std::string_view text) {
    if (text.empty() || std::isupper(static_cast<unsigned char>(text.front())) == 0) return;
    for (std::size_t i = 0; i < kNames.size(); ++i)
      if (text.starts_with(kNames[i]) && text.substr(kNames[i].size()).starts_with(' '))
        rests_[i] = text.substr(kNames[i].size() + 1);
  }

  std::array<std::string_view, kNames.size()> rests_{};  // what follows; null of what is not there
};

/// No table has more entries than the text has lines: Open CASCADE would look for as many as a
/// damaged number says.
void check_tables(std::string_view text, const Tables& tables) {
  const long lines = std::count(text.begin(), text.end(), '\n');
  for (const char* name : {"Locations", "Curve2ds", "Curves", "Polygon3D",
                           "PolygonOnTriangulations", "Surfaces", "Triangulations"}) {
    const Table table = tables[name];
    if (table.found && (table.count < 0 || table.count > lines))
      throw BadModel(std::string("is damaged: it cannot have as many entries as its table '") +
                     name + "' says");
  }
}

/// The shapes stand behind all that they are made of, each closed by a star; then comes the whole's
/// orientation and place ("+1 0"). Shapes are counted from the end: when there are more or less of
/// them than the table says, though the end is there, their references are wrong.
/// returns   whether the text is cut off among the shapes, by their table
bool is_cut_off(const Table& table) {
  if (!table.found || table.count < 0) throw BadModel("is cut off before its shapes");
  if (table.count == 0) return false;  // it holds none
  const long stars = std::count(table.rest.begin(), table.rest.end(), '*');
  const std::size_t last = table.rest.rfind('*');
  const std::string_view end =
      trimmed(last == std::string_view::npos ? table.rest : table.rest.substr(last + 1));
  const bool ends =
      !end.empty() && std::string_view("+-ie").find(end.front()) != std::string_view::npos;
  if (stars > table.count || (ends && stars < table.count))
    throw BadModel("is damaged: " + std::to_string(stars) + " of " + std::to_string(table.count) +
                   " shapes are there");
  return stars < table.count || !ends;
}

/// What is whole when the rest is not there: shapes that are no part of others, faces and what is
/// made of them, or else edges.
TopoDS_Shape whole_shapes(const TopTools_ShapeSet& set) {
  TopTools_MapOfShape parts;
  for (int i = 1; i <= set.NbShapes(); ++i)
    for (TopoDS_Iterator part(set.Shape(i), false, false); part.More(); part.Next())
      parts.Add(part.Value().Located({}));
  std::vector<TopoDS_Shape> faces, edges;
  for (int i = 1; i <= set.NbShapes(); ++i) {
    const TopoDS_Shape& shape = set.Shape(i);
    if (parts.Contains(shape)) continue;
    if (shape.ShapeType() <= TopAbs_FACE) faces.push_back(shape);
    if (shape.ShapeType() == TopAbs_EDGE || shape.ShapeType() == TopAbs_WIRE)
      edges.push_back(shape);
  }
  const std::vector<TopoDS_Shape>& whole = faces.empty() ? edges : faces;
  return whole.empty() ? TopoDS_Shape() : compound_of(whole);
}

/// Open CASCADE knows three of them by their whole lines.
void check_version(std::string_view text) {
  const std::string_view line = trimmed(text.substr(0, text.find('\n')));
  for (const char* known :
       {"CASCADE Topology V1, (c) Matra-Datavision", "CASCADE Topology V2, (c) Matra-Datavision",
        "CASCADE Topology V3, (c) Open Cascade"})
    if (line == known) return;
  throw BadModel("is of no version that is known: '" + std::string(line.substr(0, 80)) + "'");
}

TopoDS_Shape text_shape(std::string_view text, ReadingReport& report) {
  text.remove_prefix(text.find("CASCADE Topology V"));
  check_version(text);
  const Tables tables(text);
  check_tables(text, tables);
  const Table shapes = tables["TShapes"];
  const bool cut = is_cut_off(shapes);
  if (shapes.count == 0) return {};
  check_counts(text, false);
  std::string fit(text);
  if (const Table places = tables["Locations"]; places.found)
    spoil_unfit_places(
        fit, {static_cast<std::size_t>(places.rest.data() - text.data()), places.count, false});
  StrictStream in{std::move(fit)};
  BRepTools_ShapeSet set{BRep_Builder()};
  TopoDS_Shape shape;
  if (!cut) {
    set.Read(in);
    set.Read(shape, in);
    return shape;
  }
  try {
    set.Read(in);
  } catch (const std::ios_base::failure&) {
    // The end of what is there.
  } catch (const Standard_Failure&) {
    // A reference that the end has cut to another one.
  }
  report.add({"the rest of the file",
              "it is cut off: " + std::to_string(set.NbShapes()) + " of " +
                  std::to_string(shapes.count) + " shapes are there",
              true});
  return whole_shapes(set);
}

/// Both kinds of binary BRep write a set of shapes. FreeCAD ends it with three integers (shape,
/// location, orientation), BinTools::Write with a shape of nine bytes.
constexpr std::streamoff kFreeCadEnding = 12;

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

/// Of binary BREP, in which this table is the first.
EntriesOfPlaces places_in(const std::string& bytes) {
  constexpr std::string_view kName = "\nLocations ";
  EntriesOfPlaces places{.binary = true};
  const std::size_t name = bytes.find(kName), end = bytes.find('\n', name + 1);
  if (name == std::string::npos || end == std::string::npos) return places;
  places.at = end + 1;
  std::from_chars(bytes.data() + name + kName.size(), bytes.data() + end, places.count);
  return places;
}

TopoDS_Shape binary_shape(const std::string& bytes) {
  check_counts(bytes, true);
  std::string fit = bytes;
  spoil_unfit_places(fit, places_in(bytes));
  StrictStream in(std::move(fit));
  BinTools_ShapeSet set;
  set.Read(in);
  if (set.NbShapes() == 0) return {};
  if (static_cast<std::streamoff>(bytes.size()) - in.tellg() == kFreeCadEnding)
    return freecad_shape(set, in);
  TopoDS_Shape shape;
  set.ReadSubs(shape, in, set.NbShapes());
  return shape;
}

/// A number as Open CASCADE writes it, "nan" too, which streams do not read.
double next_number(std::istream& in) {
  std::string word;
  in >> word;
  return std::strtod(word.c_str(), nullptr);
}

/// Control points and weights in the text of a Bezier (type 8) or B-spline (type 9) surface.
void check_surface_text(std::istream& in) {
  constexpr int kBezier = 8, kSpline = 9;
  int type = 0, u_rational = 0, v_rational = 0, rows = 0, columns = 0, other = 0;
  in >> type >> u_rational >> v_rational;
  if (type == kBezier) {
    in >> rows >> columns;
    ++rows;
    ++columns;
  } else if (type == kSpline) {
    in >> other >> other >> other >> other >> rows >> columns >> other >> other;
  }
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns && in; ++j) {
      const std::string place = " (" + std::to_string(i) + ", " + std::to_string(j) + ")";
      const double x = next_number(in), y = next_number(in), z = next_number(in);
      check_finite({x, y, z}, "control point" + place);
      if (u_rational != 0 || v_rational != 0) check_weight(next_number(in), "weight" + place);
    }
}

/// Why the first surface is refused that Open CASCADE cannot read; nothing if it reads them all.
std::string refused_surface(const std::string& text) {
  const Table table = Tables(text)["Surfaces"];
  std::istringstream in{std::string(table.rest)};
  for (long i = 0; i < table.count && in; ++i) {
    const std::istringstream::pos_type place = in.tellg();
    if (!GeomTools_SurfaceSet::ReadSurface(in).IsNull()) continue;
    try {
      in.clear();
      in.seekg(place);
      check_surface_text(in);
    } catch (const BadModel& cause) {
      return cause.what();
    }
    return "its numbers make no surface";
  }
  return {};
}

}  // namespace

TopoDS_Shape brep_shape(const std::string& bytes, ReadingReport& report) {
  const Listening listening;
  TopoDS_Shape shape;
  try {
    shape = is_binary_brep(bytes) ? binary_shape(bytes) : text_shape(bytes, report);
  } catch (const Standard_Failure&) {
    throw BadModel("is damaged: " + current_failure_text());
  } catch (const std::ios_base::failure&) {
    throw BadModel("is damaged: " + current_failure_text());
  }
  if (shape.IsNull() && !listening.first().empty())
    throw BadModel("is damaged: " + listening.first());
  return shape;
}

std::string why_without_surface(const std::string& text) {
  if (is_binary_brep(text)) return {};
  const Listening listening;
  return refused_surface(text);
}

bool loses_curves(const std::string& text) {
  if (is_binary_brep(text)) return false;
  const Listening listening;
  const Table table = Tables(text)["Curves"];
  std::istringstream in{std::string(table.rest)};
  for (long i = 0; i < table.count && in; ++i)
    if (GeomTools_CurveSet::ReadCurve(in).IsNull()) return true;
  return false;
}

void read_brep(Reading& reading) {
  reading.begin("reading the shapes");
  mend_line_ends(reading.text);
  const TopoDS_Shape shape = brep_shape(reading.text, reading.report);
  if (!shape.IsNull()) reading.contents.parts.push_back({shape});
}

}  // namespace blossom::occt
