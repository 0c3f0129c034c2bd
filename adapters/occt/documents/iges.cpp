// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from IGES files, and what Open CASCADE does not make of them.

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <IGESBasic_Name.hxx>
#include <IGESBasic_SubfigureDef.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_HArray1OfIGESEntity.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_UndefinedEntity.hxx>
#include <IGESGeom_Boundary.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_CurveOnSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESSolid_HArray1OfFace.hxx>
#include <IGESSolid_Loop.hxx>
#include <IGESSolid_Shell.hxx>
#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_Static.hxx>
#include <TColStd_HArray1OfInteger.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/documents/files.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/file_text.h"

namespace blossom::occt {
namespace {

constexpr std::size_t kSectionColumn = 72, kLineLength = 80;
constexpr std::string_view kSections = "SGDP";

/// Breaks a text that is one line, as old systems with lines of a fixed length have it.
void break_lines(std::string& text) {
  if (text.find('\n') != std::string::npos || text.size() <= kLineLength) return;
  std::string lines;
  for (std::size_t i = 0; i < text.size(); i += kLineLength)
    lines.append(text, i, kLineLength) += '\n';
  text = std::move(lines);
}

/// Lines of each section, and the last line, which says how many there should be.
struct Lines {
  std::array<long, kSections.size()> counted{};
  std::string_view last;
};

Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.size() <= kSectionColumn) continue;
    lines.last = line;
    const std::size_t section = kSections.find(line[kSectionColumn]);
    if (section != std::string_view::npos) ++lines.counted[section];
  }
  return lines;
}

/// The number behind the letter of a section in the last line; the counted one if there is none.
long stated(const Lines& lines, std::size_t section) {
  const std::size_t place = lines.last.substr(0, kSectionColumn).find(kSections[section]);
  if (place == std::string_view::npos) return lines.counted[section];
  std::string_view number = lines.last.substr(place + 1);
  while (!number.empty() && number.front() == ' ') number.remove_prefix(1);
  long value = 0;
  const auto end = std::from_chars(number.data(), number.data() + number.size(), value);
  return end.ec == std::errc() ? value : lines.counted[section];
}

/// Entities are in the sections D and P; the others have what is said of the whole file.
void list_missing_lines(const std::string& text, ReadingReport& report) {
  const Lines lines = lines_of(text);
  if (lines.last.empty() || lines.last[kSectionColumn] != 'T') {
    report.add({"the rest of the file", "it is cut off: its terminate section is missing", true});
    return;
  }
  for (std::size_t i = 0; i < kSections.size(); ++i)
    if (const long wanted = stated(lines, i); wanted != lines.counted[i])
      report.add({std::string("lines of section ") + kSections[i],
                  std::to_string(lines.counted[i]) + " lines are there instead of " +
                      std::to_string(wanted),
                  kSections[i] == 'D' || kSections[i] == 'P'});
}

/// A file in memory with a name, for a reader that takes names only.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view text) : descriptor_(memfd_create("model", 0)) {
    while (descriptor_ >= 0 && !text.empty()) {
      const ssize_t written = write(descriptor_, text.data(), text.size());
      if (written <= 0) break;
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (descriptor_ < 0 || !text.empty()) throw BadModel("there is no memory for its text");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_ = -1;
};

std::string label(const IGESData_IGESModel& model, const Handle(Standard_Transient) & entity) {
  return model.StringLabel(entity)->ToCString();
}

/// "TrimmedSurface" of IGESGeom_TrimmedSurface.
std::string kind_of(const Handle(Standard_Transient) & entity) {
  const std::string type = entity->DynamicType()->Name();
  return type.substr(type.find('_') + 1);
}

/// Of a fault in loading: Open CASCADE has no text for parameters that are too many or too few, and
/// leaves places for numbers open.
std::string loading_words(std::string fault) {
  if (fault.starts_with("Unknown message"))
    return "its parameters are too many, too few or of another kind";
  for (const std::string open : {" : %d", " : %s", " %d", " %s"})
    if (const std::size_t place = fault.find(open); place != std::string::npos)
      fault.erase(place, open.size());
  return fault;
}

/// Whether an entity of a kind that Open CASCADE does not know may have been a shape: of macros and
/// of kinds that users define (600 to 699, and from 5001 on) it is none.
bool may_be_shape(const Handle(Standard_Transient) & entity) {
  const auto unknown = Handle(IGESData_UndefinedEntity)::DownCast(entity);
  if (unknown.IsNull()) return false;
  const int type = unknown->TypeNumber();
  return type < 600 || (type > 699 && type <= 5000);
}

/// Entities that could not be loaded whole. Whether a shape is touched shows when faces are made.
void list_loading_faults(const IGESData_IGESModel& model, ReadingReport& report) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Handle(Interface_Check) check = model.Check(i, true);
    if (check.IsNull() || !check->HasFailed()) continue;
    const Handle(Standard_Transient) entity = model.Value(i);
    report.add({kind_of(entity),
                loading_words(check->CFail(1)),
                may_be_shape(entity),
                1,
                {label(model, entity)}});
  }
}

/// Open CASCADE reads the names of subfigures without asking whether they have one.
void name_subfigures(const IGESData_IGESModel& model) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const auto figure = Handle(IGESBasic_SubfigureDef)::DownCast(model.Value(i));
    if (figure.IsNull() || !figure->Name().IsNull()) continue;
    Handle(IGESData_HArray1OfIGESEntity) members;
    if (const int count = figure->NbEntities(); count > 0) {
      members = new IGESData_HArray1OfIGESEntity(1, count);
      for (int k = 1; k <= count; ++k) members->SetValue(k, figure->AssociatedEntity(k));
    }
    figure->Init(figure->Depth(), new TCollection_HAsciiString(""), members);
  }
}

/// Open CASCADE crashes on shells of which a face is of another kind, or could not be loaded.
void leave_out_lost_faces(const IGESData_IGESModel& model, ReadingReport& report) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const auto shell = Handle(IGESSolid_Shell)::DownCast(model.Value(i));
    if (shell.IsNull()) continue;
    std::vector<int> there;
    for (int k = 1; k <= shell->NbFaces(); ++k)
      if (!shell->Face(k).IsNull()) there.push_back(k);
    const int lost = shell->NbFaces() - static_cast<int>(there.size());
    if (lost == 0 || there.empty()) continue;
    const Handle(IGESSolid_HArray1OfFace) faces =
        new IGESSolid_HArray1OfFace(1, shell->NbFaces() - lost);
    const Handle(TColStd_HArray1OfInteger) turns =
        new TColStd_HArray1OfInteger(1, shell->NbFaces() - lost);
    for (int k = 1; const int face : there) {
      faces->SetValue(k, shell->Face(face));
      turns->SetValue(k++, shell->Orientation(face) ? 1 : 0);
    }
    shell->Init(faces, turns);
    report.add({"face", "its entity cannot be read", true, lost, {"of " + label(model, shell)}});
  }
}

Handle(TCollection_HAsciiString) utf8_name(const TCollection_HAsciiString& name) {
  return new TCollection_HAsciiString(as_utf8(name.ToCString()).c_str());
}

/// Open CASCADE takes all names as UTF-8: those of other letters would lose some.
void mend_names(const IGESData_IGESModel& model) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Handle(IGESData_IGESEntity) entity = model.Entity(i);
    if (const auto name = Handle(IGESBasic_Name)::DownCast(entity);
        !name.IsNull() && !name->Value().IsNull())
      name->Init(name->NbPropertyValues(), utf8_name(*name->Value()));
    if (entity->HasShortLabel())
      entity->SetLabel(utf8_name(*entity->ShortLabel()), entity->SubScriptNumber());
  }
}

bool is_face(const Handle(Standard_Transient) & entity) {
  return entity->IsKind(STANDARD_TYPE(IGESGeom_TrimmedSurface)) ||
         entity->IsKind(STANDARD_TYPE(IGESGeom_BoundedSurface)) ||
         entity->IsKind(STANDARD_TYPE(IGESSolid_Face));
}

/// What bounds a face; null for what is no such thing.
std::vector<Handle(Standard_Transient)> borders_of(const Handle(Standard_Transient) & face) {
  std::vector<Handle(Standard_Transient)> borders;
  if (const auto trimmed = Handle(IGESGeom_TrimmedSurface)::DownCast(face); !trimmed.IsNull()) {
    if (trimmed->OuterBoundaryType() != 0) borders.push_back(trimmed->OuterContour());
    for (int i = 1; i <= trimmed->NbInnerContours(); ++i)
      borders.push_back(trimmed->InnerContour(i));
  }
  if (const auto bounded = Handle(IGESGeom_BoundedSurface)::DownCast(face); !bounded.IsNull())
    for (int i = 1; i <= bounded->NbBoundaries(); ++i) borders.push_back(bounded->Boundary(i));
  if (const auto solid = Handle(IGESSolid_Face)::DownCast(face); !solid.IsNull())
    for (int i = 1; i <= solid->NbLoops(); ++i) borders.push_back(solid->Loop(i));
  return borders;
}

/// Whether Open CASCADE said something against a border and made none, or could not load it.
bool is_lost(const Handle(Standard_Transient) & border, const Transfer_TransientProcess& made) {
  if (border.IsNull()) return true;
  const Handle(Transfer_Binder) binder = made.Find(border);
  if (binder.IsNull() || !TransferBRep::ShapeResult(binder).IsNull()) return false;
  const Handle(Interface_Check) said = binder->Check();
  return !said.IsNull() && (said->HasFailed() || said->HasWarnings());
}

void list_lost_borders(const Handle(Standard_Transient) & face, const IGESData_IGESModel& model,
                       const Transfer_TransientProcess& made, ReadingReport& report) {
  for (const Handle(Standard_Transient) & border : borders_of(face))
    if (is_lost(border, made))
      report.add(
          {"border",
           kBorderLost,
           true,
           1,
           {(border.IsNull() ? "" : label(model, border) + " ") + "of " + label(model, face)}});
}

/// Faces that are not there, and borders that faces lack.
void list_lost_faces(const IGESData_IGESModel& model, const Transfer_TransientProcess& made,
                     ReadingReport& report) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model.Value(i);
    if (!is_face(entity)) continue;
    if (TransferBRep::ShapeResult(made.Find(entity)).IsNull())
      report.add({"face", "Open CASCADE makes no face of it", true, 1, {label(model, entity)}});
    else
      list_lost_borders(entity, model, made, report);
  }
}

/// Whether an entity that no other one takes should become a shape: geometry, solids and figures,
/// but no matrices, directions, or copious data and flashes, which drawings have.
bool should_be_shape(const Handle(Standard_Transient) & entity) {
  const std::string_view type = entity->DynamicType()->Name();
  for (const char* other : {"IGESGeom_TransformationMatrix", "IGESGeom_Direction",
                            "IGESGeom_CopiousData", "IGESGeom_Flash"})
    if (type == other) return false;
  return type.starts_with("IGESGeom_") || type.starts_with("IGESSolid_") ||
         type == "IGESBasic_SingularSubfigure";
}

/// Open CASCADE makes nothing of some kinds, of primitives and scaled figures, and does not say so.
void list_lost_roots(const IGESControl_Reader& reader, const IGESData_IGESModel& model,
                     ReadingReport& report) {
  const Handle(XSControl_WorkSession) session = reader.WS();
  const Handle(Transfer_TransientProcess) made = session->TransferReader()->TransientProcess();
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Handle(Standard_Transient) root = model.Value(i);
    if (!should_be_shape(root) || is_face(root)) continue;
    if (!TransferBRep::ShapeResult(made->Find(root)).IsNull()) continue;
    if (session->Graph().Sharings(root).NbEntities() > 0) continue;
    report.add({kind_of(root), "Open CASCADE makes no shape of it", true, 1, {label(model, root)}});
  }
}

/// Flags 1 to 11 are units, 3 says that the name is one. Without a unit Open CASCADE takes
/// millimetres, or makes nothing.
void list_unknown_unit(const IGESData_GlobalSection& section, ReadingReport& report) {
  constexpr int kByName = 3, kMaxUnits = 11;
  const int flag = section.UnitFlag();
  const std::string name = section.UnitName().IsNull() ? "" : section.UnitName()->ToCString();
  const bool known = flag == kByName ? names_unit(name) : 1 <= flag && flag <= kMaxUnits;
  if (known) return;
  report.add({"the unit of lengths",
              "the file has the flag " + std::to_string(flag) + " and the name '" + name +
                  "', which are none: lengths may be wrong",
              true});
}

void transfer_roots(IGESControl_Reader& reader, ReadingReport& report) {
  for (int i = 1; i <= reader.NbRootsForTransfer(); ++i) try {
      reader.TransferOneRoot(i);
    } catch (const Standard_Failure&) {
      report.add({"part", current_failure_text(), true, 1, {"number " + std::to_string(i)}});
    }
}

}  // namespace

void read_iges(Reading& reading) {
  IGESControl_Controller::Init();
  IGESCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  reading.begin("reading the entities");
  mend_line_ends(reading.text);
  break_lines(reading.text);
  if (reading.text.size() > kSectionColumn && reading.text[kSectionColumn] == 'C')
    refuse("is in the compressed form of IGES, which Open CASCADE does not read", reading.report);
  list_missing_lines(reading.text, reading.report);
  const MemoryFile text(reading.text);
  if (reader.ReadFile(text.name().c_str()) != IFSelect_RetDone)
    refuse("is no readable IGES file", reading.report);
  const auto model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
  list_loading_faults(*model, reading.report);
  list_unknown_unit(model->GlobalSection(), reading.report);
  name_subfigures(*model);
  leave_out_lost_faces(*model, reading.report);
  mend_names(*model);

  reading.begin("transferring the shapes");
  transfer_roots(reader, reading.report);
  list_lost_roots(reader, *model, reading.report);
  list_lost_faces(*model, *reader.WS()->TransferReader()->TransientProcess(), reading.report);
  const Handle(TCollection_HAsciiString) unit = model->GlobalSection().UnitName();
  if (!unit.IsNull()) reading.contents.unit = unit_named(unit->ToCString());

  for (int i = 1; i <= reader.NbShapes(); ++i) reading.contents.parts.push_back({reader.Shape(i)});
  add_with_names(reading, [&](Document& document) {
    Handle(TDocStd_Document) target = document.handle();
    return reader.Transfer(target);
  });
}

}  // namespace blossom::occt
