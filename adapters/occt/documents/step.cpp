// SPDX-License-Identifier: LGPL-2.1-or-later
// What STEP and IGES have beside shapes.

#include <exception>
#include <functional>
#include <memory>

#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TDocStd_Document.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/documents/beside_shapes.h"
#include "adapters/occt/documents/files.h"
#include "adapters/occt/documents/other_files.h"

namespace blossom::occt {
namespace {

void want_attributes(STEPCAFControl_Reader& reader) {
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  reader.SetPropsMode(true);
  reader.SetGDTMode(true);
  reader.SetMatMode(true);
  reader.SetViewMode(true);
  reader.SetSHUOMode(true);  // styles of single instances
}

/// Names of faces are wanted, but Open CASCADE looks for them in all shells without asking what is
/// there: beside damaged shapes they are given up, and the names of parts are kept.
void ask_for_face_names(ReadingReport& report) {
  const bool sound = report.grade() != ReadingGrade::ShapesLost;
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", sound ? 1 : 0);
  if (!sound) report.add({"the names of faces", "they are not read beside damaged shapes"});
}

/// The same session with the shapes that it has made.
void take_over(STEPCAFControl_Reader& reader, const Handle(XSControl_WorkSession) & session) {
  const auto made = session->TransferReader()->TransientProcess();
  reader.ChangeReader().SetWS(session, false);  // forgets them
  session->SetMapReader(made);
}

}  // namespace

void add_step(const Handle(Standard_Transient) & session, Reading& reading) {
  STEPCAFControl_Reader reader;
  const auto work = Handle(XSControl_WorkSession)::DownCast(session);
  take_over(reader, work);
  if (reading.options.looks)
    reading.contents.beside = beside_shapes(*Handle(StepData_StepModel)::DownCast(work->Model()));
  want_attributes(reader);
  ask_for_face_names(reading.report);
  add_with_names(reading, [&](Document& document) {
    Handle(TDocStd_Document) target = document.handle();
    const bool done = reader.Transfer(target);
    put_other_files(reader, reading, document);
    return done;
  });
  if (!reading.contents.document) list_others(reading);
}

void add_with_names(Reading& reading, const std::function<bool(Document&)>& transfer) {
  if (!reading.options.names) return reading.lose_names(kNamesNotRead);
  reading.begin(kReadingNames);
  try {
    const auto document = std::make_shared<Document>();
    if (!transfer(*document)) return;
    reading.contents.document = document;
    reading.contents.parts.clear();
  } catch (const Standard_Failure&) {
    reading.lose_names(current_failure_text());
  } catch (const std::exception&) {
    reading.lose_names(current_failure_text());
  }
}

}  // namespace blossom::occt
