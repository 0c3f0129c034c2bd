// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_results.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepData_UndefinedEntity.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_ProductDefinitionShape.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_ShapeRepresentationRelationship.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_HArray1OfFaceBound.hxx>
#include <StepShape_Loop.hxx>
#include <StepShape_OrientedFace.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepToTopoDS_DataMapOfTRI.hxx>
#include <StepToTopoDS_NMTool.hxx>
#include <StepToTopoDS_Tool.hxx>
#include <StepToTopoDS_TranslateFace.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <gp_XYZ.hxx>

#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/numbers.h"

namespace blossom::occt {
namespace {

constexpr double kScaleRounding = 1e-9;  // relative: numbers of files have so many digits

/// What Open CASCADE says against an entity while it makes shapes.
std::string transfer_cause(const Transfer_TransientProcess& made,
                           const Handle(Standard_Transient) & entity) {
  const Handle(Transfer_Binder) binder = made.Find(entity);
  if (binder.IsNull()) return {};
  const Handle(Interface_Check) check = binder->Check();
  if (check.IsNull()) return {};
  if (check->HasFailed()) return check->CFail(1);
  return check->HasWarnings() ? check->CWarning(1) : "";
}

/// False for compounds and shells of nothing.
bool has_anything(const TopoDS_Shape& shape) {
  if (shape.IsNull()) return false;
  if (shape.ShapeType() > TopAbs_SHELL) return true;
  for (TopoDS_Iterator part(shape); part.More(); part.Next())
    if (has_anything(part.Value())) return true;
  return false;
}

/// A face without a surface, as old faceted models have them.
bool is_plain_face(const Handle(Standard_Transient) & entity) {
  return entity->IsKind(STANDARD_TYPE(StepShape_Face)) &&
         !entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface)) &&
         !entity->IsKind(STANDARD_TYPE(StepShape_OrientedFace));
}

gp_XYZ vector_of(const StepGeom_Direction& direction) {
  gp_XYZ vector;
  for (int i = 1; i <= std::min(3, direction.NbDirectionRatios()); ++i)
    vector.SetCoord(i, direction.DirectionRatiosValue(i));
  return vector;
}

/// What Open CASCADE, which moves and turns alone, leaves out of a transformation.
std::string left_out_of(const StepGeom_CartesianTransformationOperator3d& place) {
  const bool scales = place.HasScale() && std::abs(place.Scale() - 1) > kScaleRounding;
  const Handle(StepGeom_Direction) x = place.Axis1(), y = place.Axis2(), z = place.Axis3();
  const bool mirrors = !x.IsNull() && !y.IsNull() && !z.IsNull() &&
                       vector_of(*x).DotCross(vector_of(*y), vector_of(*z)) < 0;
  if (scales) return mirrors ? "the scale and the mirror" : "the scale";
  return mirrors ? "the mirror" : "";
}

/// Kinds that Open CASCADE does not know, the first few.
std::string unknown_kinds(const StepData_StepModel& model) {
  constexpr std::size_t kMaxNames = 3;
  std::vector<std::string> names;
  for (int i = 1; i <= model.NbEntities() && names.size() < kMaxNames; ++i) {
    if (!model.Value(i)->IsKind(STANDARD_TYPE(StepData_UndefinedEntity))) continue;
    const std::string name = model.TypeName(model.Value(i), false);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? ": " : ", ") + name;
  return list;
}

}  // namespace

bool can_be_made(const Handle(StepShape_FaceSurface) & face) try {
  const Handle(Transfer_TransientProcess) aside = new Transfer_TransientProcess;
  StepToTopoDS_DataMapOfTRI shapes;
  StepToTopoDS_Tool tool(shapes, aside);
  StepToTopoDS_NMTool several;
  const StepToTopoDS_TranslateFace made(face, tool, several);
  return made.IsDone() && BadShapes(made.Value(), NumberSource(nullptr)).none();
} catch (const Standard_Failure&) {
  return false;
}

void StepResults::list_turned(const std::vector<Handle(StepShape_FaceSurface)>& faces) {
  for (const auto& face : faces)
    add(face, "face",
        "it is not what the file says: Open CASCADE takes its border for that of the rest of the "
        "surface");
}

void StepResults::list_kept(const std::vector<DamagedFace>& faces) {
  for (const DamagedFace& damaged : faces) {
    Loss loss = damaged.loss;
    const bool made = became_a_shape(damaged.face);
    if (made) loss.cause += "; it is made of what is left";
    report_.add(loss);
    if (made) list_borders(*damaged.face);
  }
}

void StepResults::list(const std::set<const Standard_Transient*>& known) {
  for (int i = 1; i <= owners_.model().NbEntities(); ++i)
    if (const Entity& entity = owners_.model().Value(i); !known.contains(entity.get()))
      list_entity(entity);
}

void StepResults::list_entity(const Entity& entity) {
  if (const auto face = Handle(StepShape_FaceSurface)::DownCast(entity); !face.IsNull())
    return list_face(face);
  if (entity->IsKind(STANDARD_TYPE(StepShape_SolidModel)) && has_failed(entity))
    return add(entity, owners_.type(entity), transfer_cause(made_, entity));
  if (is_plain_face(entity) && !made_.Find(entity).IsNull())
    return add(entity, "face", "it has no surface");
  list_place(entity);
  list_items(entity);
  list_product(entity);
  list_relationship(entity);
}

void StepResults::list_face(const Handle(StepShape_FaceSurface) & face) {
  const Handle(Transfer_Binder) binder = made_.Find(face);
  if (!TransferBRep::ShapeResult(binder).IsNull()) return list_borders(*face);
  // Faces that nobody asked for: of features, of the history of a part.
  if (binder.IsNull() && !owners_.product(face).expected) return;
  const std::string cause = transfer_cause(made_, face);
  add(face, "face", cause.empty() ? "Open CASCADE makes no face of it" : cause);
}

void StepResults::list_borders(const StepShape_FaceSurface& face) {
  for (int i = 1; i <= face.NbBounds(); ++i) {
    if (face.BoundsValue(i).IsNull()) continue;
    const Handle(StepShape_Loop) loop = face.BoundsValue(i)->Bound();
    if (loop.IsNull() || !has_failed(loop)) continue;
    if (TransferBRep::ShapeResult(made_.Find(loop)).IsNull()) add(loop, "border", kBorderLost);
  }
}

void StepResults::list_place(const Entity& entity) {
  const auto item = Handle(StepRepr_MappedItem)::DownCast(entity);
  if (item.IsNull() || made_.Find(item).IsNull()) return;
  const auto place =
      Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(item->MappingTarget());
  if (place.IsNull()) return;
  if (const std::string lost = left_out_of(*place); !lost.empty())
    add(item, owners_.type(item), "Open CASCADE leaves out " + lost + " of its place");
}

/// Of a representation that is a product's.
void StepResults::list_items(const Entity& entity) {
  const auto whole = Handle(StepShape_ShapeRepresentation)::DownCast(entity);
  if (whole.IsNull()) return;
  for (int i = 1; i <= whole->NbItems(); ++i) {
    const Handle(StepRepr_RepresentationItem) item = whole->ItemsValue(i);
    if (item.IsNull() || std::strncmp(item->DynamicType()->Name(), "StepShape_", 10) != 0) continue;
    if (!became_a_shape(item) && !has_failed(item) && owners_.product(item).expected)
      add(item, owners_.type(item), "Open CASCADE makes no shape of it");
  }
}

/// A product whose representation is of a kind that is not known, or has an item of such a kind,
/// and that has no other shape.
void StepResults::list_product(const Entity& entity) {
  const auto definition = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(entity);
  if (definition.IsNull()) return;
  const Handle(StepRepr_Representation) whole = definition->UsedRepresentation();
  const int number = owners_.model().Number(whole.IsNull() ? entity : Entity(whole));
  const Handle(Interface_Check) check = owners_.model().Check(number, true);
  if (check.IsNull() || !check->HasFailed()) return;
  const auto shape = Handle(StepRepr_ProductDefinitionShape)::DownCast(
      definition->Definition().PropertyDefinition());
  if (shape.IsNull()) return;
  const Handle(StepBasic_ProductDefinition) product = shape->Definition().ProductDefinition();
  if (product.IsNull() || became_a_shape(product)) return;
  add(entity, "part",
      "its shape is of a kind that Open CASCADE does not read" + unknown_kinds(owners_.model()),
      true, product_name(shape));
}

/// Another representation of what one is of: of triangles, say.
void StepResults::list_relationship(const Entity& entity) {
  if (!is_of_two_shapes(entity)) return;
  const auto both = Handle(StepRepr_ShapeRepresentationRelationship)::DownCast(entity);
  const Handle(StepRepr_Representation) one = both->Rep1(), other = both->Rep2();
  if (one.IsNull() == other.IsNull()) return;
  const Entity known(one.IsNull() ? other : one);
  add(entity, owners_.type(entity),
      "one of its representations is of a kind that Open CASCADE does not read" +
          unknown_kinds(owners_.model()),
      !became_a_shape(known));
}

void StepResults::add(const Entity& entity, const std::string& what, const std::string& cause,
                      bool of_shape, std::string product) {
  Loss loss{what, cause, of_shape};
  loss.which.push_back(owners_.label(entity));
  if (product.empty()) product = owners_.product(entity).name;
  if (!product.empty()) loss.belongs_to.push_back(product);
  report_.add(loss);
}

bool StepResults::has_failed(const Entity& entity) const {
  const Handle(Transfer_Binder) binder = made_.Find(entity);
  return !binder.IsNull() && !binder->Check().IsNull() && binder->Check()->HasFailed();
}

bool StepResults::became_a_shape(const Entity& entity) const {
  return has_anything(TransferBRep::ShapeResult(made_.Find(entity)));
}

}  // namespace blossom::occt
