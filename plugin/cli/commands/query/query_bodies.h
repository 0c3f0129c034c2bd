// SPDX-License-Identifier: LGPL-2.1-or-later
// Models of a question as bodies, and how answers speak of these.

#pragma once

#include <cstddef>
#include <string>

#include "adapters/occt/bodies.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/output/output.h"
#include "plugin/reports/models/measured_input.h"

namespace blossom::cli {

/// One model of a question.
struct QuerySide : reports::MeasuredInput {
  explicit QuerySide(const std::string& name)
      : MeasuredInput(read_usable_input(name, Faces::Optional)) {}

  std::string text(const occt::ShapePoint& place) const;

  /// What is taken as a surface and why, as a line; empty if nothing is.
  std::string displayed_surface() const;

  /// "solid 2 of bolt.step (bolt)", "the surface of lid.brep".
  std::string body_text(std::size_t body) const;
};

/// "A is inside B", "touching", with the names of the inputs.
std::string relation_text(occt::Relation relation, const QuerySide& a, const QuerySide& b);

/// The lines that follow an answer: pairs where there are several bodies, and what is taken as a
/// surface.
std::string relation_lines(const occt::ModelRelation& found, const QuerySide& a,
                           const QuerySide& b);

}  // namespace blossom::cli
