// SPDX-License-Identifier: LGPL-2.1-or-later
// Documents as STEP and IGES.

#include <sstream>
#include <string>
#include <utility>

#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_ChildIterator.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <XCAFDoc_DimTolTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/documents/beside_shapes.h"
#include "adapters/occt/documents/files.h"

namespace blossom::occt {
namespace {

/// Numbers to 5e-16, relative or below 1 absolute; the defaults keep only ten digits. Open CASCADE
/// prints into 24 characters, which leaves no room for more.
void set_precision(Interface_FloatWriter& numbers) {
  numbers.SetFormat("%.15E");
  numbers.SetFormatForRange("%.15f", 0.1, 1000);
  numbers.SetZeroSuppress(false);
}

/// AP214 is what most programs read, but only AP242 has dimensions and tolerances of faces.
const char* schema_for(const Document& document) {
  const auto tolerances = XCAFDoc_DocumentTool::DimTolTool(document.main());
  TDF_LabelSequence dimensions, deviations, datums;
  tolerances->GetDimensionLabels(dimensions);
  tolerances->GetGeomToleranceLabels(deviations);
  tolerances->GetDatumLabels(datums);
  const bool none = dimensions.IsEmpty() && deviations.IsEmpty() && datums.IsEmpty();
  return none ? "AP214IS" : "AP242DIS";
}

/// Open CASCADE writes letters as single bytes, and none beyond Latin-1: those of UTF-8 are given
/// to it as such bytes.
void split_letters(const Document& document) {
  Handle(TDataStd_Name) name;
  for (TDF_ChildIterator label(document.main(), true); label.More(); label.Next())
    if (label.Value().FindAttribute(TDataStd_Name::GetID(), name))
      name->Set(TCollection_ExtendedString(name_of(label.Value()).c_str(), false));
}

}  // namespace

FileContent step_content(const Document& document, const std::string& unit) {
  STEPControl_Controller::Init();
  // The writer's constructor reads the unit: set later, it gives a wrong size without a word.
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetCVal("write.step.unit", unit.c_str());
  Interface_Static::SetCVal("write.step.schema", schema_for(document));
  STEPCAFControl_Writer writer;
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  writer.SetColorMode(true);
  writer.SetNameMode(true);
  writer.SetLayerMode(true);
  writer.SetPropsMode(true);
  writer.SetDimTolMode(true);
  writer.SetMaterialMode(true);
  writer.SetSHUOMode(true);  // styles of single instances
  if (!writer.Transfer(document.handle(), STEPControl_AsIs))
    throw Failure("Open CASCADE cannot turn the model into STEP");
  const Handle(StepData_StepModel) model = writer.ChangeWriter().Model();
  StepData_StepWriter text(model);
  set_precision(text.FloatWriter());
  text.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
  std::ostringstream out;
  if (!text.Print(out)) throw Failure("Open CASCADE cannot write the model as STEP");
  return {std::move(out).str(), beside_shapes(*model)};
}

/// Every instance becomes a part: of an assembly Open CASCADE makes one part without the names of
/// those in it.
FileContent iges_content(const Document& document, const std::string& unit) {
  const Document parts;
  add_instances(document, parts);
  split_letters(parts);
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetCVal("write.iges.unit", unit.c_str());
  Interface_Static::SetIVal("write.iges.brep.mode", 1);
  IGESCAFControl_Writer writer;
  writer.SetColorMode(true);
  writer.SetNameMode(true);
  writer.SetLayerMode(true);
  if (!writer.Transfer(parts.handle()))
    throw Failure("Open CASCADE cannot turn the model into IGES");
  writer.ComputeModel();
  IGESData_IGESWriter text(writer.Model());
  set_precision(text.FloatWriter());
  text.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
  std::ostringstream out;
  if (!text.Print(out)) throw Failure("Open CASCADE cannot write the model as IGES");
  return {std::move(out).str(), layers_of(document)};
}

FileContent Document::content(Format format, const std::string& unit) const {
  name_instances(*this);
  switch (format) {
    case Format::Step: return step_content(*this, unit);
    case Format::Iges: return iges_content(*this, unit);
    case Format::Glb: return {glb_bytes(*this)};
    case Format::Brep: break;
  }
  throw Failure("BREP has no documents");
}

}  // namespace blossom::occt
