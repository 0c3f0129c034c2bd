// SPDX-License-Identifier: LGPL-2.1-or-later
// What Open CASCADE made of the entities of a STEP file, and what not: the model can be used
// without that, but not silently. For this folder only.

#pragma once

#include <set>
#include <string>
#include <vector>

#include <StepShape_FaceSurface.hxx>
#include <Transfer_TransientProcess.hxx>

#include "adapters/occt/exchange/step/step_faults.h"
#include "adapters/occt/reading.h"

namespace blossom::occt {

/// Whether Open CASCADE makes a face of a damaged one, all of whose numbers are some, without an
/// exception that would take the faces round it along. It may crash, or never come back.
bool can_be_made(const Handle(StepShape_FaceSurface) & face);

/// Lists what became no shape, or another one than the file says.
class StepResults {
 public:
  StepResults(const StepOwners& owners, const Transfer_TransientProcess& made,
              ReadingReport& report)
      : owners_(owners), made_(made), report_(report) {}

  /// Faces that are the rest of their surface.
  void list_turned(const std::vector<Handle(StepShape_FaceSurface)>& faces);

  /// Damaged faces, and of those that became a shape the borders that they lack.
  void list_kept(const std::vector<DamagedFace>& faces);

  /// Faces and solids that could not be made, borders that faces lack, shapes of kinds that are not
  /// read, and places whose scale or mirror is left out.
  ///
  /// known   what is listed already
  void list(const std::set<const Standard_Transient*>& known);

 private:
  using Entity = Handle(Standard_Transient);

  void list_entity(const Entity& entity);
  void list_face(const Handle(StepShape_FaceSurface) & face);
  void list_borders(const StepShape_FaceSurface& face);
  void list_place(const Entity& entity);
  void list_items(const Entity& entity);
  void list_product(const Entity& entity);
  void list_relationship(const Entity& entity);
  /// product   that of the entity if empty
  void add(const Entity& entity, const std::string& what, const std::string& cause,
           bool of_shape = true, std::string product = {});

  bool has_failed(const Entity& entity) const;
  bool became_a_shape(const Entity& entity) const;

  const StepOwners& owners_;
  const Transfer_TransientProcess& made_;
  ReadingReport& report_;
};

}  // namespace blossom::occt
