// SPDX-License-Identifier: LGPL-2.1-or-later
// The masses of the parts of a model, and their JSON report; see plugin/cli/schemas/query-1.md.

#pragma once

#include <vector>

#include "adapters/occt/mass.h"
#include "core/base/status.h"
#include "core/base/work_limit.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/models/parts.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

struct PartMass {
  NamedPart part;
  occt::Mass mass;
};

struct MassAnswer {
  std::vector<PartMass> parts{};     ///< those that were measured: closed solids, then other faces
  occt::Mass solids{};               ///< together; overlaps of solids count twice
  Status status = Status::Complete;  ///< Complete, or Stopped
  double seconds = 0;
};

/// limit    asked before each face
/// throws   occt::BadModel if a face cannot be measured
MassAnswer masses_of(const Input& input, const WorkLimit& limit);

/// Of a volume in mm³, and a density in kg/m³.
double kilograms(double volume, double density);

/// Schema "blossom.query/1", kind "mass".
/// density   kg/m³; 0: masses are not wanted
Json mass_report(const Input& input, const MassAnswer& answer, double density = 0);

}  // namespace blossom::reports
