// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_faults.h"

#include <cstddef>
#include <cstring>
#include <utility>

#include <Interface_EntityIterator.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepGeom_Placement.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_GeometricSet.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepShape_TopologicalRepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>

#include "adapters/occt/exchange/step/step_entity_faults.h"

namespace blossom::occt {
namespace {

using Entity = Handle(Standard_Transient);

using StepEdges = std::vector<Handle(StepShape_EdgeCurve)>;

StepEdges edges_along(const Interface_Graph& graph, const Entity& curve) {
  StepEdges edges;
  for (Interface_EntityIterator user = graph.Sharings(curve); user.More(); user.Next())
    if (const auto edge = Handle(StepShape_EdgeCurve)::DownCast(user.Value()); !edge.IsNull())
      edges.push_back(edge);
  return edges;
}

/// What an entity is used by.
struct Uses {
  std::vector<Handle(StepShape_FaceSurface)> faces;
  StepEdges edges;     ///< in curves in parameters of faces only
  StepEdges curves;    ///< in their curves in space, if asked for
  bool shape = false;  ///< faces, edges, solids, sets of curves, or places of parts
};

/// Goes up from an entity through geometry and topology.
class Climb {
 public:
  /// to_curves   what it meets in the curve of an edge it leaves at that
  Climb(const Interface_Graph& graph, bool to_curves) : graph_(graph), to_curves_(to_curves) {}

  Uses from(const Entity& entity) {
    push(entity);
    while (!open_.empty()) {
      const Entity next = open_.back();
      open_.pop_back();
      visit(next);
    }
    return uses_;
  }

 private:
  void push(const Entity& entity) {
    if (seen_.insert(entity.get()).second) open_.push_back(entity);
  }

  void visit(const Entity& entity) {
    if (entity->IsKind(STANDARD_TYPE(StepShape_TopologicalRepresentationItem)) ||
        entity->IsKind(STANDARD_TYPE(StepShape_SolidModel)) ||
        entity->IsKind(STANDARD_TYPE(StepShape_GeometricSet)) || is_place(entity))
      uses_.shape = true;
    if (const auto face = Handle(StepShape_FaceSurface)::DownCast(entity); !face.IsNull()) {
      uses_.faces.push_back(face);
      return;
    }
    const bool in_parameters = entity->IsKind(STANDARD_TYPE(StepGeom_Pcurve));
    for (Interface_EntityIterator user = graph_.Sharings(entity); user.More(); user.Next()) {
      if (in_parameters)
        add_edges_of(user.Value());
      else if (is_curve_of(entity, user.Value()))
        uses_.curves.push_back(Handle(StepShape_EdgeCurve)::DownCast(user.Value()));
      else if (may_go_to(user.Value()))
        push(user.Value());
    }
  }

  bool is_curve_of(const Entity& entity, const Entity& user) const {
    const auto edge = Handle(StepShape_EdgeCurve)::DownCast(user);
    return to_curves_ && !edge.IsNull() && edge->EdgeGeometry() == entity;
  }

  /// Of a part in an assembly.
  bool is_place(const Entity& entity) const {
    if (!entity->IsKind(STANDARD_TYPE(StepGeom_Placement))) return false;
    for (Interface_EntityIterator user = graph_.Sharings(entity); user.More(); user.Next())
      if (is_assembly(user.Value()) ||
          user.Value()->IsKind(STANDARD_TYPE(StepRepr_RepresentationMap)))
        return true;
    return false;
  }

  static bool may_go_to(const Entity& user) {
    if (user->IsKind(STANDARD_TYPE(StepRepr_DefinitionalRepresentation))) return true;
    return is_geometry(user) && !user->IsKind(STANDARD_TYPE(StepRepr_Representation));
  }

  void add_edges_of(const Entity& curve) {
    const auto on_surface = Handle(StepGeom_SurfaceCurve)::DownCast(curve);
    if (on_surface.IsNull()) return;
    if (on_surface->Curve3d().IsNull()) return push(curve);
    for (const auto& edge : edges_along(graph_, curve)) uses_.edges.push_back(edge);
  }

  const Interface_Graph& graph_;
  bool to_curves_;
  std::vector<Entity> open_;
  std::set<const Standard_Transient*> seen_;
  Uses uses_;
};

Uses uses_of(const Interface_Graph& graph, const Entity& entity, const Fault& fault) {
  const auto curve = Handle(StepGeom_SurfaceCurve)::DownCast(entity);
  if (curve.IsNull() || curve->Curve3d().IsNull()) return Climb(graph, fault.numeric).from(entity);
  // What it lacks is a curve in the parameters of a face: the one in space is there.
  return {{}, edges_along(graph, entity), {}, false};
}

void keep_curves_in_space(const StepEdges& edges) {
  for (const Handle(StepShape_EdgeCurve) & edge : edges)
    if (const auto curve = Handle(StepGeom_SurfaceCurve)::DownCast(edge->EdgeGeometry());
        !curve.IsNull())
      edge->SetEdgeGeometry(curve->Curve3d());
}

using Entities = std::set<const Standard_Transient*>;

/// The members of a list that are there and are not among `out`; null if none is left.
template <class Array, class Member>
Handle(Array) remaining(int count, const Member& member, const Entities& out) {
  std::vector<typename Array::value_type> kept;
  for (int i = 1; i <= count; ++i)
    if (const auto one = member(i); !one.IsNull() && !out.contains(one.get())) kept.push_back(one);
  if (kept.empty()) return {};
  const Handle(Array) list = new Array(1, static_cast<int>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) list->SetValue(static_cast<int>(i) + 1, kept[i]);
  return list;
}

/// Takes what is missing or damaged out of shells and representations: where Open CASCADE looks for
/// names, it does not ask whether there is anything.
void close_lists(const StepData_StepModel& model, const Entities& out) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Entity& entity = model.Value(i);
    if (const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(entity); !shell.IsNull())
      shell->SetCfsFaces(remaining<StepShape_HArray1OfFace>(
          shell->NbCfsFaces(), [&](int k) { return shell->CfsFacesValue(k); }, out));
    if (const auto whole = Handle(StepRepr_Representation)::DownCast(entity); !whole.IsNull())
      whole->SetItems(remaining<StepRepr_HArray1OfRepresentationItem>(
          whole->NbItems(), [&](int k) { return whole->ItemsValue(k); }, out));
  }
}

/// Open CASCADE makes no face on a surface of a kind that it does not know.
void leave_out(const Handle(StepShape_FaceSurface) & face) {
  face->SetFaceGeometry(new StepGeom_Surface);
}

Handle(StepGeom_CartesianPoint) origin() {
  const Handle(StepGeom_CartesianPoint) point = new StepGeom_CartesianPoint;
  point->Init3D(new TCollection_HAsciiString(""), 0, 0, 0);
  return point;
}

/// A point without coordinates is no location.
void replace_location(const Handle(StepGeom_CartesianPoint) & point, const Interface_Graph& graph) {
  if (point.IsNull() || point->NbCoordinates() >= 2) return;
  for (Interface_EntityIterator user = graph.Sharings(point); user.More(); user.Next())
    if (const auto place = Handle(StepGeom_Placement)::DownCast(user.Value()); !place.IsNull())
      place->SetLocation(origin());
}

/// Open CASCADE uses the location and the directions of a placement, and what a shape is defined
/// of, without asking whether they are there. What bounds faces is left out with them; the rest is
/// not moved, or not turned, or of no product.
void keep_usable(const Entity& entity, const Interface_Graph& graph) {
  if (const auto place = Handle(StepGeom_Placement)::DownCast(entity);
      !place.IsNull() && place->Location().IsNull())
    place->SetLocation(origin());
  replace_location(Handle(StepGeom_CartesianPoint)::DownCast(entity), graph);
  if (const auto shape = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(entity);
      !shape.IsNull() && shape->Definition().PropertyDefinition().IsNull()) {
    StepRepr_RepresentedDefinition nothing;
    nothing.SetValue(new StepRepr_PropertyDefinition);
    shape->SetDefinition(nothing);
  }
  const auto direction = Handle(StepGeom_Direction)::DownCast(entity);
  if (direction.IsNull() || !direction->DirectionRatios().IsNull()) return;
  for (Interface_EntityIterator user = graph.Sharings(entity); user.More(); user.Next()) {
    const auto place = Handle(StepGeom_Axis2Placement3d)::DownCast(user.Value());
    if (place.IsNull()) continue;
    if (place->HasAxis() && place->Axis() == direction) place->UnSetAxis();
    if (place->HasRefDirection() && place->RefDirection() == direction) place->UnSetRefDirection();
  }
}

/// Takes out what a fault harms, and says what is lost.
class Damage {
 public:
  Damage(const StepOwners& owners, ReadingReport& report) : owners_(owners), report_(report) {}

  void add(const Entity& entity, const Fault& fault) {
    if (is_of_two_shapes(entity) && !fault.unresolved) return;
    const Uses uses = fault.harm == Harm::Field && is_geometry(entity)
                          ? uses_of(owners_.graph(), entity, fault)
                          : Uses{};
    keep_curves_in_space(uses.edges);
    keep_usable(entity, owners_.graph());
    for (const Handle(StepShape_FaceSurface) & face : uses.faces) {
      if (fault.arbitrary) arbitrary_.insert(face.get());
      add_face(face, entity, fault);
    }
    for (const Handle(StepShape_EdgeCurve) & edge : uses.curves) add_curve(edge, entity, fault);
    if (fault.harm == Harm::Field && entity->IsKind(STANDARD_TYPE(StepShape_SolidModel)))
      damage_.out.insert(entity.get());
    if (!uses.faces.empty() || !uses.curves.empty()) return;
    const bool part = fault.harm == Harm::Field && is_assembly(entity);
    const bool item = fault.unresolved && entity->IsKind(STANDARD_TYPE(StepRepr_Representation)) &&
                      is_geometry(entity);
    const bool unit = loses_unit(entity, fault);
    Loss loss{owners_.type(entity), fault.cause, uses.shape || part || item || unit};
    loss.which.push_back(owners_.label(entity));
    report_.add(loss);
    if (is_of_two_shapes(entity)) damage_.out.insert(entity.get());
  }

  /// What is damaged in a face may be mended for another, so it is decided when all is known.
  StepDamage decide(const FaceChoice& keeps) {
    for (DamagedFace& damaged : faces_) {
      if (!arbitrary_.contains(damaged.face.get()) && keeps(damaged.face)) {
        damage_.kept.push_back(std::move(damaged));
        continue;
      }
      leave_out(damaged.face);
      damage_.out.insert(damaged.face.get());
      report_.add(damaged.loss);
    }
    return std::move(damage_);
  }

 private:
  /// The edge is one without a curve.
  void add_curve(const Handle(StepShape_EdgeCurve) & edge, const Entity& entity,
                 const Fault& fault) {
    edge->SetEdgeGeometry({});
    const Uses uses = Climb(owners_.graph(), false).from(edge);
    for (const Handle(StepShape_FaceSurface) & face : uses.faces) add_face(face, entity, fault);
  }

  void add_face(const Handle(StepShape_FaceSurface) & face, const Entity& entity,
                const Fault& fault) {
    if (!seen_.insert(face.get()).second) return;
    Loss loss{"face", owners_.type(entity) + ": " + fault.cause, true};
    loss.which.push_back(owners_.label(face) + " by " + owners_.label(entity));
    if (const std::string product = owners_.product(face).name; !product.empty())
      loss.belongs_to.push_back(product);
    faces_.push_back({face, loss});
  }

  const StepOwners& owners_;
  ReadingReport& report_;
  StepDamage damage_;
  std::vector<DamagedFace> faces_;
  Entities seen_, arbitrary_;
};

}  // namespace

StepDamage leave_out_damage(const StepOwners& owners, const FaceChoice& keeps,
                            ReadingReport& report) {
  Damage search(owners, report);
  bool any = false;
  for (int i = 1; i <= owners.model().NbEntities(); ++i)
    if (const Fault fault = fault_of(owners.model(), i); !fault.cause.empty()) {
      search.add(owners.model().Value(i), fault);
      any = true;
    }
  StepDamage damage = search.decide(keeps);
  if (any) close_lists(owners.model(), damage.out);
  return damage;
}

}  // namespace blossom::occt
