// SPDX-License-Identifier: LGPL-2.1-or-later
// What combining solids is told and what it tells; see plugin/cli/schemas/solid-1.md.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/plane_section.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "core/watertight/watertight.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// By its word: cut, common, fuse or split; nothing for another one.
std::optional<occt::SolidOperation> solid_operation(const std::string& word);

/// Why there is no result, in sentences: what was found to be the cause first.
std::vector<std::string> causes(const occt::SolidTrimResult& made);

struct SolidAnswer {
  std::string part{};
  std::vector<std::string> tools{};
  std::vector<occt::Plane> planes{};  ///< above which they cut like a tool, after the tools
  std::string operation{};
  occt::SolidTrimResult made{};
  std::vector<std::string> invalid{};  ///< faces of the result that were given so
  std::vector<std::string> idle{};     ///< tools and planes of which nothing is in the result
  std::optional<WatertightPieces> watertight{};
  bool written = false;
  double seconds = 0;
  Json repairs = Json::array();  ///< of all inputs
};

/// Notes what of the result was invalid as it was given, and which tools cut nothing of it.
void note_faces(SolidAnswer& answer);

/// Where the faces of a solid or a sheet come from, those of the part first. Faces that two solids
/// have in common stand twice among those of the result.
std::vector<occt::FaceOrigin> origins_of(const TopoDS_Shape& shape,
                                         const occt::SolidTrimResult& made, const occt::Model& part,
                                         const std::vector<const occt::Model*>& tools);

/// The sheets of a result as parts, named as their first face's part, numbered where they are
/// several, with names and colours of their faces.
occt::Model sheets_model(const occt::SolidTrimResult& made, const occt::Model& part,
                         const std::vector<const occt::Model*>& tools);

/// The wires of a result, and vertices off them, as one part: named as that of the part's first
/// face, or as its first part where it has no faces.
occt::Model wires_model(const occt::SolidTrimResult& made, const occt::Model& part);

/// How many edges and lone vertices they have: "3 edges and a vertex".
std::string counted_wires(const occt::SolidTrimResult& made);

/// The whole object, schema "blossom.solid/1".
Json solid_report(const SolidAnswer& answer);

}  // namespace blossom::reports
