// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from STEP files, and what Open CASCADE does not make of them.

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <utility>

#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/step/step.h"
#include "adapters/occt/exchange/step/step_faults.h"
#include "adapters/occt/exchange/step/step_names.h"
#include "adapters/occt/exchange/step/step_other_files.h"
#include "adapters/occt/exchange/step/step_results.h"
#include "adapters/occt/exchange/step/step_sides.h"
#include "adapters/occt/exchange/step/step_text.h"

namespace blossom::occt {
namespace {

/// The unit of the file, "MM" if it has none.
void find_unit(STEPControl_Reader& reader, Contents& contents) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  if (!lengths.IsEmpty()) contents.unit = unit_named(lengths.First().ToCString());
}

/// One root after the other, so that one that fails does not take the others with it.
void transfer_roots(STEPControl_Reader& reader, ReadingReport& report) {
  for (int i = 1; i <= reader.NbRootsForTransfer(); ++i) try {
      reader.TransferOneRoot(i);
    } catch (const Standard_Failure&) {
      Loss loss{"part", current_failure_text(), true};
      loss.which.push_back("number " + std::to_string(i));
      report.add(loss);
    }
}

void take_names(Reading& reading, const StepData_StepModel& model,
                const Transfer_TransientProcess& made) {
  if (!reading.options.names) return reading.lose_names(kNamesNotRead);
  reading.begin(kReadingNames);
  try {
    name_parts(reading.contents.parts, model, made);
  } catch (const Standard_Failure&) {
    reading.lose_names(current_failure_text());
  }
}

/// Empty if it is none.
std::string known_unit(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::pair<const char*, const char*> words[] = {
      {"milli", "MM"}, {"mm", "MM"},    {"centi", "CM"}, {"cm", "CM"},     {"kilo", "KM"},
      {"km", "KM"},    {"micro", "UM"}, {"um", "UM"},    {"inch", "INCH"}, {"foot", "FT"},
      {"feet", "FT"},  {"ft", "FT"},    {"mile", "MI"},  {"mil", "MIL"},   {"in", "INCH"},
      {"mi", "MI"},    {"uin", "UIN"},  {"m", "M"}};
  for (const auto& [word, unit] : words)
    if (name.starts_with(word)) return unit;
  return {};
}

}  // namespace

std::string unit_named(const std::string& name) {
  const std::string unit = known_unit(name);
  return unit.empty() ? "MM" : unit;
}

bool names_unit(const std::string& name) { return !known_unit(name).empty(); }

Handle(Standard_Transient) read_step(Reading& reading) {
  STEPControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reading.begin("reading the entities");
  mend_step_text(reading.text, reading.report);
  std::istringstream in(std::move(reading.text));
  if (reader.ReadStream(reading.file.c_str(), in) != IFSelect_RetDone)
    refuse("is no readable STEP file", reading.report);
  const auto model = Handle(StepData_StepModel)::DownCast(reader.Model());
  if (model->NbEntities() == 0) refuse("has a header, but nothing in it", reading.report);
  const StepOwners owners(*model, reader.WS()->Graph());
  bool tried = false;
  const auto keeps = [&](const Handle(StepShape_FaceSurface) & face) {
    if (reading.options.damaged && !std::exchange(tried, true)) reading.begin(kMakingDamaged);
    return tried && can_be_made(face);
  };
  StepDamage damage = leave_out_damage(owners, keeps, reading.report);

  if (damage.kept.empty()) reading.begin("transferring the shapes");
  transfer_roots(reader, reading.report);
  find_unit(reader, reading.contents);
  Transfer_TransientProcess& made = *reader.WS()->TransferReader()->TransientProcess();
  const TurnedFaces turned = mend_turned_faces(*model, made);
  StepResults results(owners, made, reading.report);
  results.list_kept(damage.kept);
  for (const DamagedFace& kept : damage.kept) damage.out.insert(kept.face.get());
  results.list(damage.out);
  results.list_turned(turned.left);
  PlainParts& parts = reading.contents.parts;
  for (int i = 1; i <= reader.NbShapes(); ++i)
    parts.push_back(
        {turned.mended.IsNull() ? reader.Shape(i) : turned.mended->Apply(reader.Shape(i))});

  take_other_files(reader.WS(), reading);
  if (reading.options.names &&
      (!reading.others.empty() || reading.options.looks || !are_plain(parts, *model, made)))
    return reader.WS();
  take_names(reading, *model, made);
  return {};
}

}  // namespace blossom::occt
