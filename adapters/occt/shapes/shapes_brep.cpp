// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from BREP text, and why Open CASCADE leaves a surface out, which it does not tell.

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomTools_Curve2dSet.hxx>
#include <GeomTools_CurveSet.hxx>
#include <GeomTools_SurfaceSet.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/forms/curves_detail.h"
#include "adapters/occt/shapes/shapes_detail.h"

namespace blossom::occt {
namespace {

/// Keeps what Open CASCADE says instead of printing it.
class Notes : public Message_Printer {
 public:
  const std::string& text() const { return text_; }

 protected:
  void send(const TCollection_AsciiString& text, const Message_Gravity) const override {
    text_ += std::string(text.ToCString()) + "\n";
  }

 private:
  mutable std::string text_;
};

/// Keeps what Open CASCADE says for as long as this lives: its messages and, since its BREP reader
/// complains there, what goes to std::cout, where our results belong.
class Listening {
 public:
  Listening() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    Message::DefaultMessenger()->AddPrinter(notes_);
    output_ = std::cout.rdbuf(printed_.rdbuf());
  }
  ~Listening() {
    std::cout.rdbuf(output_);
    Message::DefaultMessenger()->ChangePrinters() = printers_;
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

  /// The first line that was said, or nothing.
  std::string first() const {
    std::istringstream lines(notes_->text() + "\n" + printed_.str());
    std::string line;
    while (line.empty() && std::getline(lines, line)) {
    }
    return line;
  }

 private:
  Handle(Notes) notes_ = new Notes;
  std::ostringstream printed_;
  std::streambuf* output_ = nullptr;
  Message_SequenceOfPrinters printers_;
};

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

/// The text of a table from its first entry on, and the number of entries.
struct Table {
  std::istringstream in;
  int count = 0;

  Table(const std::string& text, const std::string& name) {
    const std::size_t start = text.find("\n" + name + " ");
    if (start == std::string::npos) return;
    in.str(text.substr(start));
    std::string word;
    in >> word >> count;
  }
};

/// Why the first surface is refused that Open CASCADE cannot read; nothing if it reads them all.
std::string refused_surface(const std::string& text) {
  Table table(text, "Surfaces");
  for (int i = 0; i < table.count && table.in; ++i) {
    const std::istringstream::pos_type place = table.in.tellg();
    if (!GeomTools_SurfaceSet::ReadSurface(table.in).IsNull()) continue;
    try {
      table.in.clear();
      table.in.seekg(place);
      check_surface_text(table.in);
    } catch (const BadModel& cause) {
      return cause.what();
    }
    return "its numbers make no surface";
  }
  return {};
}

/// Open CASCADE leaves out curves whose numbers it refuses, a weight of 0 for one.
template <class Read>
void check_curves(const std::string& text, const std::string& name, Read read) {
  Table table(text, name);
  for (int i = 1; i <= table.count; ++i)
    if (read(table.in).IsNull())
      throw BadModel("is damaged: the numbers of curve " + std::to_string(i) + " in the table '" +
                     name + "' make no curve");
}

}  // namespace

std::string read_brep(Document& document, const std::string& text) {
  TopoDS_Shape shape;
  std::istringstream in(text);
  const Listening listening;
  BRepTools::Read(shape, in, BRep_Builder());
  if (shape.IsNull())
    throw BadModel(listening.first().empty() ? "holds no shape"
                                             : "is damaged: " + listening.first());
  const TDF_Label label = document.shapes()->NewShape();
  document.shapes()->SetShape(label, shape);
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    TopLoc_Location location;
    if (BRep_Tool::Surface(TopoDS::Face(face.Current()), location).IsNull())
      return refused_surface(text);
  }
  check_curves(text, "Curves", GeomTools_CurveSet::ReadCurve);
  check_curves(text, "Curve2ds", GeomTools_Curve2dSet::ReadCurve2d);
  return {};
}

}  // namespace blossom::occt
