// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_names.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <NCollection_DataMap.hxx>
#include <StepBasic_DocumentFile.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>

#include "adapters/occt/exchange/file_text.h"

namespace blossom::occt {
namespace {

TopoDS_Shape shape_of(const Handle(Standard_Transient) & entity,
                      const Transfer_TransientProcess& made) {
  const Handle(Transfer_Binder) binder = made.Find(entity);
  return binder.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(binder);
}

/// In UTF-8; what is none is replaced. Its own length in use would not count letters beyond ASCII.
std::string text_of(const Handle(TCollection_HAsciiString) & name) {
  if (name.IsNull() || std::ranges::all_of(std::string_view(name->ToCString()), is_blank))
    return {};
  return TCollection_AsciiString(TCollection_ExtendedString(name->ToCString(), true)).ToCString();
}

/// The name of the product, or else its number.
std::string product_name(const StepBasic_ProductDefinition& definition) {
  if (definition.Formation().IsNull() || definition.Formation()->OfProduct().IsNull()) return {};
  const StepBasic_Product& product = *definition.Formation()->OfProduct();
  const std::string name = text_of(product.Name());
  return name.empty() ? text_of(product.Id()) : name;
}

/// Shapes of products and representations: a compound that has one of them in it is an assembly.
TopTools_MapOfShape possible_parts(const StepData_StepModel& model,
                                   const Transfer_TransientProcess& made) {
  TopTools_MapOfShape found;
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Handle(Standard_Transient)& entity = model.Value(i);
    if (!entity->IsKind(STANDARD_TYPE(StepBasic_ProductDefinition)) &&
        !entity->IsKind(STANDARD_TYPE(StepShape_ShapeRepresentation)))
      continue;
    if (const TopoDS_Shape shape = shape_of(entity, made); !shape.IsNull())
      found.Add(shape.Located({}));
  }
  return found;
}

/// Which part has a solid, shell or face, which of these has a name, and the rank of its kind.
struct NamedItem {
  std::size_t part;
  int rank;  ///< 0 of solids, 1 of shells, 2 of faces
  NamedShape named;
};

int rank_of(const Handle(Standard_Transient) & entity) {
  if (entity->IsKind(STANDARD_TYPE(StepShape_SolidModel))) return 0;
  if (entity->IsKind(STANDARD_TYPE(StepShape_ConnectedFaceSet))) return 1;
  return entity->IsKind(STANDARD_TYPE(StepShape_Face)) ? 2 : -1;
}

using PartNumbers = NCollection_DataMap<TopoDS_Shape, std::size_t, TopTools_ShapeMapHasher>;

/// The part that each solid, shell and face is in.
PartNumbers part_numbers(const PlainParts& parts) {
  PartNumbers numbers;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    TopTools_IndexedMapOfShape inner;
    for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE})
      TopExp::MapShapes(parts[i].shape, kind, inner);
    for (int k = 1; k <= inner.Extent(); ++k) numbers.Bind(inner(k), i);
  }
  return numbers;
}

std::vector<NamedItem> named_items(const PlainParts& parts, const StepData_StepModel& model,
                                   const Transfer_TransientProcess& made) {
  const PartNumbers numbers = part_numbers(parts);
  std::vector<NamedItem> items;
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Handle(Standard_Transient)& entity = model.Value(i);
    const int rank = rank_of(entity);
    if (rank < 0) continue;
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
    const std::string name = item.IsNull() ? std::string() : text_of(item->Name());
    if (name.empty()) continue;
    const TopoDS_Shape shape = shape_of(entity, made);
    if (const std::size_t* part = shape.IsNull() ? nullptr : numbers.Seek(shape))
      items.push_back({*part, rank, {shape, name}});
  }
  std::ranges::stable_sort(items, {}, &NamedItem::rank);
  return items;
}

/// The name of a part's only solid says no more than that of the part.
bool has_several_solids(const TopoDS_Shape& part) {
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(part, TopAbs_SOLID, solids);
  return solids.Extent() > 1;
}

}  // namespace

bool are_plain(const PlainParts& parts, const StepData_StepModel& model,
               const Transfer_TransientProcess& made) {
  for (int i = 1; i <= model.NbEntities(); ++i)
    if (model.Value(i)->IsKind(STANDARD_TYPE(StepBasic_DocumentFile))) return false;
  const TopTools_MapOfShape possible = possible_parts(model, made);
  return std::ranges::all_of(parts, [&](const PlainPart& part) {
    if (part.shape.IsNull() || !part.shape.Location().IsIdentity()) return false;
    if (part.shape.ShapeType() != TopAbs_COMPOUND) return true;
    for (TopoDS_Iterator it(part.shape); it.More(); it.Next())
      if (possible.Contains(it.Value().Located({}))) return false;
    return true;
  });
}

void name_parts(PlainParts& parts, const StepData_StepModel& model,
                const Transfer_TransientProcess& made) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const auto definition = Handle(StepBasic_ProductDefinition)::DownCast(model.Value(i));
    const TopoDS_Shape shape = definition.IsNull() ? TopoDS_Shape() : shape_of(definition, made);
    for (PlainPart& part : parts)
      if (!shape.IsNull() && part.shape.IsSame(shape)) part.name = product_name(*definition);
  }
  for (NamedItem& item : named_items(parts, model, made)) {
    PlainPart& part = parts[item.part];
    if (item.rank > 0 || has_several_solids(part.shape))
      part.named.push_back(std::move(item.named));
  }
}

}  // namespace blossom::occt
