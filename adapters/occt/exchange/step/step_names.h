// SPDX-License-Identifier: LGPL-2.1-or-later
// Names of parts and faces in a STEP file that has no assembly. For this folder only.

#pragma once

#include <StepData_StepModel.hxx>
#include <Transfer_TransientProcess.hxx>

#include "adapters/occt/exchange/plain_parts.h"

namespace blossom::occt {

/// Whether shapes that were made of a file are in no assembly, and no other file belongs to it.
bool are_plain(const PlainParts& parts, const StepData_StepModel& model,
               const Transfer_TransientProcess& made);

/// Gives parts the names of their products, and solids (where a part has several), shells and faces
/// those of their entities.
void name_parts(PlainParts& parts, const StepData_StepModel& model,
                const Transfer_TransientProcess& made);

}  // namespace blossom::occt
