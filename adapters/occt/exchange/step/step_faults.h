// SPDX-License-Identifier: LGPL-2.1-or-later
// Entities of a STEP file that came in damaged, and what becomes of the faces that use them. For
// this folder only.

#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <Interface_Graph.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_FaceSurface.hxx>

#include "adapters/occt/reading.h"

namespace blossom::occt {

/// The product that a shape is in.
struct StepProduct {
  std::string name;       ///< "product 'Bolt'"; empty if there is none
  bool expected = false;  ///< the shape is in a representation, and not in that of a feature alone
};

/// Whose faces and parts entities are.
class StepOwners {
 public:
  StepOwners(const StepData_StepModel& model, const Interface_Graph& graph)
      : model_(model), graph_(graph) {}

  /// "#12" of an entity.
  std::string label(const Handle(Standard_Transient) & entity) const;
  /// "EDGE_CURVE"; in a complex entity the last name.
  std::string type(const Handle(Standard_Transient) & entity) const;
  StepProduct product(const Handle(Standard_Transient) & entity) const;

  const StepData_StepModel& model() const { return model_; }
  const Interface_Graph& graph() const { return graph_; }

 private:
  const StepData_StepModel& model_;
  const Interface_Graph& graph_;
};

/// "product 'Bolt'" of what a property or shape is defined of; empty if that is no product.
std::string product_name(const Handle(Standard_Transient) & definition);

/// Whether an entity relates two representations of one shape, neither of which is placed in the
/// other. What is lost if one of them is not read shows when shapes are made.
bool is_of_two_shapes(const Handle(Standard_Transient) & entity);

/// A face whose geometry or border is damaged, and how that is told if nothing becomes of it.
struct DamagedFace {
  Handle(StepShape_FaceSurface) face;
  Loss loss;
};

/// Whether a face is kept.
using FaceChoice = std::function<bool(const Handle(StepShape_FaceSurface)&)>;

/// What is done about damage.
struct StepDamage {
  std::vector<DamagedFace> kept;            ///< not listed yet
  std::set<const Standard_Transient*> out;  ///< faces and solids that are out, already listed
};

/// Lists the entities that Open CASCADE could not load whole or would read wrong. Faces whose
/// geometry or border is among these are taken out of their shells unless they are kept; an edge
/// whose curve is damaged in the parameters of a face only keeps its curve in space.
/// keeps   asked for each damaged face
StepDamage leave_out_damage(const StepOwners& owners, const FaceChoice& keeps,
                            ReadingReport& report);

}  // namespace blossom::occt
