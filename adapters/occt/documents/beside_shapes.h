// SPDX-License-Identifier: LGPL-2.1-or-later
// What STEP files have beside shapes, counted, so that what gets lost on the way from one to the
// other can be said. For this folder only.

#pragma once

#include <StepData_StepModel.hxx>

#include "adapters/occt/documents/document.h"
#include "adapters/occt/exchange/contents.h"

namespace blossom::occt {

/// Annotations, views, layers, properties and so on of a file, also of kinds that Open CASCADE does
/// not know. Names and colours are not among them: they are the same whatever entities say them.
BesideShapes beside_shapes(const StepData_StepModel& model);

/// Layers, which IGES has too.
BesideShapes layers_of(const Document& document);

}  // namespace blossom::occt
