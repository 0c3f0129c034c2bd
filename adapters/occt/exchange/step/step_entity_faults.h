// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with an entity of a STEP file by itself; what that harms, see step_faults.h.

#pragma once

#include <string>

#include <Standard_Transient.hxx>
#include <StepData_StepModel.hxx>

namespace blossom::occt {

/// What a damaged entity lacks.
enum class Harm {
  None,   ///< it is odd, and read all the same
  Field,  ///< a field that it refers to or a number is not there
};

struct Fault {
  std::string cause;
  Harm harm = Harm::None;
  bool unresolved = false;  ///< it refers to an entity that is not in the file
  bool arbitrary = false;   ///< Open CASCADE takes what is in its memory for a number
  bool numeric = false;     ///< a number is none or not finite: no curve is to be made with it
};

/// What Open CASCADE says of an entity that it has loaded, and what it does not: numbers and lists
/// that it would use without asking. The cause is empty if nothing is wrong.
Fault fault_of(const StepData_StepModel& model, int number);

/// Geometry and topology, and representations of curves in parameters of faces.
bool is_geometry(const Handle(Standard_Transient) & entity);

/// How parts are put together: what is lost there may be a whole part.
bool is_assembly(const Handle(Standard_Transient) & entity);

/// Whether a unit is not what the file says. The exponents of its dimensions are not needed.
bool loses_unit(const Handle(Standard_Transient) & entity, const Fault& fault);

}  // namespace blossom::occt
