// SPDX-License-Identifier: LGPL-2.1-or-later
// Whose faces and parts entities are: from a shape up to its product.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <Interface_EntityIterator.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepRepr_RepresentationRelationship.hxx>
#include <StepRepr_RepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepRepr_ShapeRepresentationRelationship.hxx>
#include <TCollection_HAsciiString.hxx>

#include "adapters/occt/exchange/step/step_faults.h"

namespace blossom::occt {
namespace {

// Whether the name of an entity's type begins so.
bool is_named_as(const Handle(Standard_Transient) & entity, std::string_view name) {
  return std::string_view(entity->DynamicType()->Name()).starts_with(name);
}

// What a shape is used by on the way to its product.
bool is_part_of_shape(const Handle(Standard_Transient) & entity) {
  return (is_named_as(entity, "StepShape_") &&
          !is_named_as(entity, "StepShape_ShapeDefinitionRepresentation")) ||
         entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationRelationship)) ||
         entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationMap)) ||
         entity->IsKind(STANDARD_TYPE(StepRepr_MappedItem));
}

}  // namespace

std::string product_name(const Handle(Standard_Transient) & entity) {
  const auto definition = Handle(StepRepr_PropertyDefinition)::DownCast(entity);
  if (definition.IsNull()) return {};
  const Handle(StepBasic_ProductDefinition) product = definition->Definition().ProductDefinition();
  if (product.IsNull() || product->Formation().IsNull()) return {};
  const Handle(StepBasic_Product) of = product->Formation()->OfProduct();
  return of.IsNull() || of->Name().IsNull()
             ? ""
             : "product '" + std::string(of->Name()->ToCString()) + "'";
}

bool is_of_two_shapes(const Handle(Standard_Transient) & entity) {
  return entity->IsKind(STANDARD_TYPE(StepRepr_ShapeRepresentationRelationship)) &&
         !entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationRelationshipWithTransformation));
}

std::string StepOwners::label(const Handle(Standard_Transient) & entity) const {
  return model_.StringLabel(entity)->ToCString();
}

std::string StepOwners::type(const Handle(Standard_Transient) & entity) const {
  return model_.TypeName(entity, false);
}

StepProduct StepOwners::product(const Handle(Standard_Transient) & entity) const {
  StepProduct product;
  bool represented = false, defined = false;
  std::vector<Handle(Standard_Transient)> open{entity};
  std::set<const Standard_Transient*> seen;
  while (!open.empty()) {
    const Handle(Standard_Transient) next = open.back();
    open.pop_back();
    represented = represented || next->IsKind(STANDARD_TYPE(StepRepr_Representation));
    for (Interface_EntityIterator user = graph_.Sharings(next); user.More(); user.Next()) {
      const Handle(Standard_Transient)& above = user.Value();
      if (is_part_of_shape(above) && seen.insert(above.get()).second) open.push_back(above);
      if (!is_named_as(above, "StepShape_ShapeDefinitionRepresentation")) continue;
      defined = true;
      for (Interface_EntityIterator used = graph_.Shareds(above); used.More(); used.Next())
        if (product.name.empty()) product.name = product_name(used.Value());
    }
  }
  product.expected = !product.name.empty() || (represented && !defined);
  return product;
}

}  // namespace blossom::occt
