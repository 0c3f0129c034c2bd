// SPDX-License-Identifier: LGPL-2.1-or-later
// The JSON reports of plane sections; see plugin/cli/schemas/query-1.md and sections-1.md.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/plane_section.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// The whole object, schema "blossom.query/1", kind "plane".
Json section_report(const Input& input, const occt::Plane& plane, double tolerance,
                    const occt::PlaneSection& section, double seconds);

struct NamedPlane {
  occt::Plane plane;
  std::string name;
  bool named = false;              ///< by the user, else by its place among all
  std::optional<double> offset{};  ///< from the point that was given, along the normal; model units
};

/// A part of the model with what a plane makes of it.
struct PartSection {
  std::string name;
  bool solid = false;
  std::vector<int> numbers{};  ///< of its faces, in the order in which the section has them
  occt::PlaneSection section{};
};

struct SectionsOfPlane {
  NamedPlane plane;
  std::vector<PartSection> parts;  ///< that the plane meets
};

struct SectionsAnswer {
  double tolerance = 0;
  Status status = Status::Complete;
  double seconds = 0;
  std::vector<SectionsOfPlane> planes;
};

/// Whether there is any wire or point, which a file could have.
bool has_shape(const SectionsAnswer& answer);

/// The whole object, schema "blossom.sections/1".
Json sections_report(const Input& input, const SectionsAnswer& answer);

}  // namespace blossom::reports
