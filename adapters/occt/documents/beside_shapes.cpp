// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/documents/beside_shapes.h"

#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <StepData_UndefinedEntity.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>

namespace blossom::occt {
namespace {

/// Layers by their names: a file may say one as often as there are items in it.
BesideShapes layers_among(const std::set<std::string>& names) {
  if (names.empty()) return {};
  return {{"layer", static_cast<int>(names.size())}};
}

/// Names of entities, of ISO 10303-41, -42, -45, -46, -47, -101 and of the application protocols
/// 203, 214 and 242, with what users call them.
constexpr std::pair<std::string_view, std::string_view> kKinds[] = {
    {"ANNOTATION_CURVE_OCCURRENCE", "annotation"},
    {"ANNOTATION_FILL_AREA_OCCURRENCE", "annotation"},
    {"ANNOTATION_SYMBOL_OCCURRENCE", "annotation"},
    {"ANNOTATION_TEXT_OCCURRENCE", "annotation"},
    {"TESSELLATED_ANNOTATION_OCCURRENCE", "annotation"},
    {"CAMERA_MODEL_D2", "view"},
    {"CAMERA_MODEL_D3", "view"},
    {"CAMERA_MODEL_D3_MULTI_CLIPPING", "view"},
    {"ANGULAR_LOCATION", "dimension"},
    {"ANGULAR_SIZE", "dimension"},
    {"DIMENSIONAL_LOCATION", "dimension"},
    {"DIMENSIONAL_SIZE", "dimension"},
    {"ANGULARITY_TOLERANCE", "tolerance"},
    {"CIRCULAR_RUNOUT_TOLERANCE", "tolerance"},
    {"COAXIALITY_TOLERANCE", "tolerance"},
    {"CONCENTRICITY_TOLERANCE", "tolerance"},
    {"CYLINDRICITY_TOLERANCE", "tolerance"},
    {"FLATNESS_TOLERANCE", "tolerance"},
    {"LINE_PROFILE_TOLERANCE", "tolerance"},
    {"PARALLELISM_TOLERANCE", "tolerance"},
    {"PERPENDICULARITY_TOLERANCE", "tolerance"},
    {"POSITION_TOLERANCE", "tolerance"},
    {"ROUNDNESS_TOLERANCE", "tolerance"},
    {"STRAIGHTNESS_TOLERANCE", "tolerance"},
    {"SURFACE_PROFILE_TOLERANCE", "tolerance"},
    {"SYMMETRY_TOLERANCE", "tolerance"},
    {"TOTAL_RUNOUT_TOLERANCE", "tolerance"},
    {"DATUM", "datum"},
    {"PROPERTY_DEFINITION_REPRESENTATION", "property value"},
    {"MATERIAL_DESIGNATION", "material"},
    {"INVISIBILITY", "hidden-item list"},
    {"CONTEXT_DEPENDENT_INVISIBILITY", "hidden-item list"},
    {"CONSTRUCTIVE_GEOMETRY_REPRESENTATION", "reference geometry set"},
    {"INSTANCED_FEATURE", "machining feature"},
    {"GROUP", "group"},
    {"APPLIED_DOCUMENT_REFERENCE", "document"},
    {"APPROVAL", "approval"},
    {"PERSON_AND_ORGANIZATION", "person"},
    {"SECURITY_CLASSIFICATION", "security classification"},
};

using KindsByName = std::unordered_map<std::string_view, std::string_view>;

/// type   "DATUM", or of several in one "(LENGTH_UNIT,NAMED_UNIT,SI_UNIT)"
std::set<std::string_view> kinds_in(const std::string& type) {
  static const KindsByName by_name(std::begin(kKinds), std::end(kKinds));
  std::set<std::string_view> found;
  std::istringstream names(type.starts_with('(') ? type.substr(1, type.size() - 2) : type);
  for (std::string name; std::getline(names, name, ',');)
    if (const auto kind = by_name.find(name); kind != by_name.end()) found.insert(kind->second);
  return found;
}

}  // namespace

BesideShapes beside_shapes(const StepData_StepModel& model) {
  std::set<std::string> layers;
  BesideShapes counts;
  // Millions of entities are of some hundred types.
  std::unordered_map<const Standard_Type*, std::set<std::string_view>> known;
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Handle(Standard_Transient)& entity = model.Value(i);
    if (const auto layer = Handle(StepVisual_PresentationLayerAssignment)::DownCast(entity);
        !layer.IsNull()) {
      layers.insert(layer->Name().IsNull() ? "" : layer->Name()->ToCString());
      continue;
    }
    const Standard_Type* const type = entity->DynamicType().get();
    std::set<std::string_view> own;
    if (entity->IsKind(STANDARD_TYPE(StepData_UndefinedEntity)))
      own = kinds_in(model.TypeName(entity, false));
    else if (!known.contains(type))
      known[type] = kinds_in(model.TypeName(entity, false));
    const auto of_type = known.find(type);
    for (const std::string_view kind : of_type == known.end() ? own : of_type->second)
      ++counts[std::string(kind)];
  }
  counts.merge(layers_among(layers));
  return counts;
}

BesideShapes layers_of(const Document& document) {
  TDF_LabelSequence layers;
  const Handle(XCAFDoc_LayerTool) tool = XCAFDoc_DocumentTool::LayerTool(document.main());
  tool->GetLayerLabels(layers);
  std::set<std::string> names;
  for (const TDF_Label& label : layers) {
    TCollection_ExtendedString name;
    tool->GetLayer(label, name);
    names.insert(TCollection_AsciiString(name).ToCString());
  }
  return layers_among(names);
}

}  // namespace blossom::occt
