// SPDX-License-Identifier: LGPL-2.1-or-later
// What a trim is told and what it tells; see plugin/cli/schemas/trim-1.md.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/plane_section.h"
#include "adapters/occt/trim.h"
#include "core/watertight/watertight.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// What to keep, by its word or the number of a piece; nothing if it is neither.
std::optional<occt::TrimOptions> trim_options(const std::string& keep);

/// Every face of the model, since neighbours of those to cut share edges with them.
std::vector<occt::PartFace> part_faces(const Input& part);

/// The faces of an input as a tool: solid only if it is all of a model.
occt::TrimTool tool_of(const Input& tool);

/// Where the wires of a tool's face cross, what it covers is not known, nor whether it cuts there:
/// that is noted.
void note_invalid_faces(const Input& tool, occt::TrimResult& made);

struct TrimAnswer {
  std::vector<occt::Plane> planes{};  ///< that cut after the tools
  std::string keep{};
  occt::TrimResult made{};
  std::optional<WatertightPieces> watertight{};
  bool written = false;
  double seconds = 0;
};

/// What a plane is called in messages and results: "plane 1" is the first.
std::string plane_name(std::size_t index);

/// [{"point", "normal"}, ...].
Json planes_json(const std::vector<occt::Plane>& planes);

/// The whole object, schema "blossom.trim/1".
Json trim_report(const Input& part, const std::vector<const Input*>& others,
                 const TrimAnswer& answer);

/// "above", "inside", ...; "side undecided" if it is not known.
std::string side_text(occt::PieceSide side);

}  // namespace blossom::reports
