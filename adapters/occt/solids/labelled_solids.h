// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids on their way through the steps of one operation.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/solid_trim.h"
#include "adapters/occt/solids/independent_sets.h"

namespace blossom::occt {

/// Solids that touch none of each other, or a sheet, with the origins of their faces.
struct LabelledSolid {
  TrimTool solid;
  std::vector<SolidFace> faces;  ///< one for each of the solid's
};
using LabelledSolids = std::vector<LabelledSolid>;

/// What the faces of the inputs are called in messages: of the part, and of each tool.
using InputFaceNames = std::vector<std::vector<std::string>>;
InputFaceNames names_of_faces(const TrimTool& part, const std::vector<TrimTool>& tools);

/// Closed solids, turned outwards, whose faces are among known ones and are called what those are.
LabelledSolid labelled(const std::vector<TopoDS_Solid>& solids, const std::vector<SolidFace>& known,
                       const InputFaceNames& names);

/// The part and the tools of an operation, in layers of solids that touch none of their layer:
/// where two solids of one input touch, faces of another one would be cut twice in the same place.
class LabelledInputs {
 public:
  /// names              kept
  /// tolerance, limit   as of SolidContacts
  LabelledInputs(const TrimTool& part, const std::vector<TrimTool>& tools,
                 const InputFaceNames& names, double tolerance, const SharedLimit& limit);

  const LabelledSolids& part() const { return layers_.front(); }
  std::vector<LabelledSolids> tools() const { return {layers_.begin() + 1, layers_.end()}; }

  /// The tools in as few groups as it takes for none to meet another one of its group, neither from
  /// outside nor by holding it: what one after the other would cut, a group cuts at once. Nothing
  /// if a tool is a sheet or has several layers.
  LabelledSolids gathered_tools();

  /// What becomes one when everything is fused: solids that meet those of other inputs, however
  /// indirectly. Solids of one input that only touch each other stay apart. Of each set the layers
  /// of each input that is in it.
  std::vector<std::vector<LabelledSolids>> joined();

 private:
  LabelledSolids layers_of(const SolidPlaces& places, int input);

  const InputFaceNames& names_;
  std::vector<TopoDS_Solid> solids_;           // of all inputs
  std::vector<int> input_;                     // of each
  std::vector<std::vector<SolidFace>> faces_;  // of each input
  std::optional<SolidContacts> contacts_;
  std::vector<LabelledSolids> layers_;  // of each input
};

}  // namespace blossom::occt
