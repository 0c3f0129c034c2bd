// SPDX-License-Identifier: LGPL-2.1-or-later
// Files made with Open CASCADE alone, without the code under test.

#include "tests/adapters/occt/exchange/shapes_files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>

#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Bnd_Box.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDF_AttributeSequence.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDimTolObjects_DimensionObject.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DimTolTool.hxx>
#include <XCAFDoc_Dimension.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_GraphNode.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/shapes.h"

namespace blossom::testing {
namespace {

namespace fs = std::filesystem;

Handle(TDocStd_Document) new_document() {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  return document;
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "-";
  return TCollection_AsciiString(name->Get()).ToCString();
}

Quantity_Color colour(double r, double g, double b) { return {r, g, b, Quantity_TOC_sRGB}; }

/// Writes a document and closes it.
void write(const Handle(TDocStd_Document) & document, const fs::path& file,
           const std::string& unit) {
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->UpdateAssemblies();
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit.c_str());
  STEPCAFControl_Writer writer;
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  writer.SetSHUOMode(true);
  writer.Transfer(document, STEPControl_AsIs);
  writer.Write(file.c_str());
  XCAFApp_Application::GetApplication()->Close(document);
}

/// Tells the labels of a document.
class Teller {
 public:
  explicit Teller(const Handle(TDocStd_Document) & document)
      : colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        layers_(XCAFDoc_DocumentTool::LayerTool(document->Main())) {
    TDF_LabelSequence roots;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
    for (const TDF_Label& root : roots) tell(root, 0);
    TDF_LabelSequence layers;
    layers_->GetLayerLabels(layers);
    for (const TDF_Label& layer : layers) {
      TDF_LabelSequence members;
      layers_->GetShapesOfLayer(layer, members);
      out_ << "layer " << name_of(layer) << ":";
      for (const TDF_Label& member : members) out_ << " " << name_of(member);
      out_ << "\n";
    }
    tell_dimensions(XCAFDoc_DocumentTool::DimTolTool(document->Main()));
  }

  std::string text() const { return out_.str(); }

 private:
  std::string looks(const TDF_Label& label) const {
    Quantity_Color found;
    std::string text;
    if (colours_->GetColor(label, XCAFDoc_ColorSurf, found) ||
        colours_->GetColor(label, XCAFDoc_ColorGen, found))
      text += std::string(" ") + Quantity_Color::ColorToHex(found).ToCString();
    return text;
  }

  /// The looks that a component gives to parts below it.
  std::vector<std::string> styles(const TDF_Label& component, const std::string& indent) const {
    std::vector<std::string> lines;
    TDF_AttributeSequence occurrences;
    XCAFDoc_ShapeTool::GetAllComponentSHUO(component, occurrences);
    for (const Handle(TDF_Attribute) & occurrence : occurrences) {
      TDF_LabelSequence upper, next;
      if (XCAFDoc_ShapeTool::GetSHUOUpperUsage(occurrence->Label(), upper)) continue;
      std::string path = name_of(component);
      XCAFDoc_ShapeTool::GetSHUONextUsage(occurrence->Label(), next);
      while (!next.IsEmpty()) {
        const TDF_Label below = next.First();
        path += "/" + name_of(below.Father());
        next.Clear();
        XCAFDoc_ShapeTool::GetSHUONextUsage(below, next);
      }
      lines.push_back(indent + "  > " + path + looks(occurrence->Label()) + "\n");
    }
    return lines;
  }

  static std::string size(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, false, false);
    std::ostringstream text;
    text << std::fixed << std::setprecision(3);
    const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
    const auto rounded = [](double x) { return std::round(1e3 * x) / 1e3 + 0.0; };  // no -0.000
    for (int i = 1; i <= 3; ++i)
      text << " " << rounded(low.Coord(i)) << ".." << rounded(high.Coord(i));
    return text.str();
  }

  void tell_dimensions(const Handle(XCAFDoc_DimTolTool) & tolerances) {
    TDF_LabelSequence dimensions;
    tolerances->GetDimensionLabels(dimensions);
    for (const TDF_Label& label : dimensions) {
      Handle(XCAFDoc_Dimension) attribute;
      label.FindAttribute(XCAFDoc_Dimension::GetID(), attribute);
      const Handle(XCAFDimTolObjects_DimensionObject) found = attribute->GetObject();
      TDF_LabelSequence first, second;
      tolerances->GetRefShapeLabel(label, first, second);
      out_ << "dimension " << found->GetValue() << " +" << found->GetUpperTolValue() << " -"
           << found->GetLowerTolValue();
      for (const TDF_LabelSequence* side : {&first, &second})
        for (const TDF_Label& face : *side) out_ << " " << name_of(face);
      out_ << "\n";
    }
  }

  void tell(const TDF_Label& label, int depth) {
    const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
    TDF_Label part = label;
    XCAFDoc_ShapeTool::GetReferredShape(label, part);
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    out_ << indent << name_of(label);
    if (part != label) out_ << looks(label) << " of " << name_of(part);
    out_ << looks(part) << size(shape)
         << (BRepCheck_Analyzer(shape).IsValid() ? " valid" : " invalid") << "\n";
    TDF_LabelSequence subs, components;
    XCAFDoc_ShapeTool::GetSubShapes(part, subs);
    std::vector<std::string> lines = styles(label, indent);
    for (const TDF_Label& sub : subs)
      lines.push_back(indent + "  * " + name_of(sub) + looks(sub) + "\n");
    std::sort(lines.begin(), lines.end());
    for (const std::string& line : lines) out_ << line;
    XCAFDoc_ShapeTool::GetComponents(part, components);
    for (const TDF_Label& component : components) tell(component, depth + 1);
  }

  Handle(XCAFDoc_ColorTool) colours_;
  Handle(XCAFDoc_LayerTool) layers_;
  std::ostringstream out_;
};

// A document to which parts are added.
struct PartsFile {
  Handle(TDocStd_Document) document = new_document();
  Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  Handle(XCAFDoc_LayerTool) layers = XCAFDoc_DocumentTool::LayerTool(document->Main());

  TDF_Label add(const TopoDS_Shape& shape, const char* name, const Quantity_Color& look) const {
    const TDF_Label label = shapes->AddShape(shape, false);
    TDataStd_Name::Set(label, name);
    colours->SetColor(label, look, XCAFDoc_ColorSurf);
    return label;
  }

  TDF_Label name_face(const TDF_Label& part, int number, const char* name) const {
    TopExp_Explorer face(XCAFDoc_ShapeTool::GetShape(part), TopAbs_FACE);
    while (--number > 0) face.Next();
    const TDF_Label label = shapes->AddSubShape(part, face.Current());
    TDataStd_Name::Set(label, name);
    return label;
  }
};

}  // namespace

Folder::Folder() {
  occt::quiet_messages();
  std::string pattern = (fs::temp_directory_path() / "blossom-test-XXXXXX").string();
  path_ = ::mkdtemp(pattern.data());
}

Folder::~Folder() {
  std::error_code ignored;
  fs::permissions(path_, fs::perms::owner_all, ignored);
  fs::remove_all(path_, ignored);
}

std::vector<std::string> Folder::names() const {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(path_))
    found.push_back(entry.path().filename().string());
  std::sort(found.begin(), found.end());
  return found;
}

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_content(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

void write_machine(const fs::path& file, const std::string& unit) {
  const PartsFile parts;
  const auto& [document, shapes, colours, layers] = parts;
  const TDF_Label plate =
      parts.add(BRepPrimAPI_MakeBox(40, 30, 10).Shape(), "Base plate", colour(0.2, 0.4, 0.8));
  const TDF_Label pin = parts.add(BRepPrimAPI_MakeBox(gp_Pnt(-4, -4, 0), gp_Pnt(4, 4, 20)).Shape(),
                                  "Pin", colour(0.8, 0.8, 0));
  layers->SetLayer(plate, "plates");
  colours->SetColor(parts.name_face(plate, 6, "TopFace"), colour(1, 0, 0), XCAFDoc_ColorSurf);
  colours->SetColor(parts.name_face(plate, 3, "SideFace"), colour(0, 1, 0), XCAFDoc_ColorSurf);
  parts.name_face(pin, 1, "Left");
  colours->SetColor(parts.name_face(pin, 2, "Right"), colour(1, 0, 1), XCAFDoc_ColorSurf);
  const TDF_Label machine = shapes->NewShape();
  TDataStd_Name::Set(machine, "Machine");
  TDataStd_Name::Set(shapes->AddComponent(machine, plate, TopLoc_Location()), "plate:1");
  for (const int i : {1, 2}) {
    gp_Trsf move;
    move.SetTranslation(gp_Vec(20 * i - 10, 15, 10));
    TDataStd_Name::Set(shapes->AddComponent(machine, pin, TopLoc_Location(move)),
                       TCollection_ExtendedString("pin:") + i);
  }
  write(document, file, unit);
}

void write_roots(const fs::path& file) {
  const PartsFile parts;
  const TDF_Label block = parts.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "Block", colour(1, 0, 0));
  double step = 0;
  for (const char* name : {"Left", "Right"}) {
    const TDF_Label root = parts.shapes->NewShape();
    TDataStd_Name::Set(root, name);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(step += 10, 0, 0));
    parts.shapes->AddComponent(root, block, TopLoc_Location(move));
  }
  write(parts.document, file, "MM");
}

void write_gauge(const fs::path& file) {
  const PartsFile parts;
  const TDF_Label gauge =
      parts.add(BRepPrimAPI_MakeBox(40, 30, 10).Shape(), "Gauge", colour(1, 0, 0));
  const auto tolerances = XCAFDoc_DocumentTool::DimTolTool(parts.document->Main());
  const TDF_Label dimension = tolerances->AddDimension();
  const Handle(XCAFDimTolObjects_DimensionObject) width = new XCAFDimTolObjects_DimensionObject;
  width->SetType(XCAFDimTolObjects_DimensionType_Location_LinearDistance);
  width->SetValue(40);
  width->SetUpperTolValue(0.1);
  width->SetLowerTolValue(0.2);
  Handle(XCAFDoc_Dimension) attribute;
  dimension.FindAttribute(XCAFDoc_Dimension::GetID(), attribute);
  attribute->SetObject(width);
  tolerances->SetDimension(parts.name_face(gauge, 1, "Left"), parts.name_face(gauge, 2, "Right"),
                           dimension);
  Interface_Static::SetCVal("write.step.schema", "AP242DIS");
  write(parts.document, file, "MM");
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
}

void write_pairs(const fs::path& file) {
  const Handle(TDocStd_Document) document = new_document();
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const TDF_Label box = shapes->AddShape(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), false);
  TDataStd_Name::Set(box, "Box");
  const TopoDS_Shape face =
      TopExp_Explorer(XCAFDoc_ShapeTool::GetShape(box), TopAbs_FACE).Current();
  TDataStd_Name::Set(shapes->AddSubShape(box, face), TCollection_ExtendedString("Fläche", true));
  const auto pair_of = [&](const TDF_Label& part, const char* name, const char* item, double step) {
    const TDF_Label assembly = shapes->NewShape();
    TDataStd_Name::Set(assembly, name);
    for (const int i : {1, 2}) {
      gp_Trsf move;
      move.SetTranslation(gp_Vec(step * i, 0, 0));
      TDataStd_Name::Set(shapes->AddComponent(assembly, part, TopLoc_Location(move)),
                         TCollection_ExtendedString(item) + i);
    }
    return assembly;
  };
  pair_of(pair_of(box, "Pair", "box:", 2), "Pairs", "pair:", 10);
  write(document, file, "MM");
}

void write_works(const fs::path& file, const std::string& unit) {
  const PartsFile parts;
  const auto& [document, shapes, colours, layers] = parts;
  const auto put = [&](const TDF_Label& part, const TDF_Label& into, const char* name,
                       const gp_Vec& step, double degrees) {
    gp_Trsf move, turn;
    move.SetTranslation(step);
    turn.SetRotation(gp::OZ(), degrees * M_PI / 180);
    const TDF_Label label = shapes->AddComponent(into, part, TopLoc_Location(move * turn));
    TDataStd_Name::Set(label, name);
    return label;
  };
  const TDF_Label plate =
      parts.add(BRepPrimAPI_MakeBox(40, 30, 10).Shape(), "Plate", colour(0, 0, 1));
  const TDF_Label bolt = parts.add(BRepPrimAPI_MakeBox(8, 8, 20).Shape(), "Bolt", colour(1, 1, 0));
  layers->SetLayer(plate, "plates");
  layers->SetLayer(bolt, "bolts");
  const TDF_Label top = parts.name_face(plate, 6, "Top");
  colours->SetColor(top, colour(1, 0, 0), XCAFDoc_ColorSurf);
  layers->SetLayer(top, "tops");
  parts.name_face(bolt, 6, "Head");
  const TDF_Label machine = shapes->NewShape(), works = shapes->NewShape();
  TDataStd_Name::Set(machine, "Machine");
  TDataStd_Name::Set(works, "Works");
  put(plate, machine, "plate:1", {0, 0, 0}, 0);
  const TDF_Label first = put(bolt, machine, "bolt:1", {5, 5, 10}, 0);
  colours->SetColor(put(bolt, machine, "bolt:2", {25, 5, 10}, 0), colour(0, 0, 1),
                    XCAFDoc_ColorSurf);
  put(machine, works, "machine:1", {0, 0, 0}, 0);
  const TDF_Label second = put(machine, works, "machine:2", {0, 100, 0}, 90);
  put(bolt, works, "bolt:9", {200, 0, 0}, 0);
  TDF_LabelSequence path;
  path.Append(second);
  path.Append(first);
  Handle(XCAFDoc_GraphNode) style;
  shapes->SetSHUO(path, style);
  colours->SetColor(style->Label(), colour(1, 0, 1), XCAFDoc_ColorSurf);
  write(document, file, unit);
}

std::string story(const fs::path& file) {
  Handle(TDocStd_Document) document = new_document();
  STEPCAFControl_Reader reader;
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  reader.SetSHUOMode(true);
  reader.SetGDTMode(true);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) return "unreadable";
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  if (!reader.Transfer(document)) return "nothing";
  const std::string text =
      "in " + std::string(lengths.First().ToCString()) + "\n" + Teller(document).text();
  XCAFApp_Application::GetApplication()->Close(document);
  return text;
}

}  // namespace blossom::testing
