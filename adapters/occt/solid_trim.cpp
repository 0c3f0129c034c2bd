// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solid_trim.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/kept_tolerances.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/faces/face_data.h"
#include "adapters/occt/repair/narrowed_vertices.h"
#include "adapters/occt/repair/true_inputs.h"
#include "adapters/occt/solids/combined_pair.h"
#include "adapters/occt/solids/labelled_solids.h"
#include "adapters/occt/solids/sheets.h"
#include "adapters/occt/solids/tolerances/stated_tolerance.h"
#include "adapters/occt/solids/validity/own_contacts.h"
#include "adapters/occt/solids/validity/solid_validity.h"
#include "adapters/occt/wires/wire_trim.h"
#include "core/base/errors.h"
#include "core/base/parallel.h"

namespace blossom::occt {
namespace {

constexpr double kCornerMargin = 1.1;  // of the gap between edges that are one

// All of a step but its solids and faces.
void add_facts(const SolidTrimResult& step, SolidTrimResult& result) {
  result.status = weaker(result.status, step.status);
  add(result.certificate, step.certificate);
  result.volumes.insert(result.volumes.end(), step.volumes.begin(), step.volumes.end());
  result.obstacles.insert(result.obstacles.end(), step.obstacles.begin(), step.obstacles.end());
  result.merged.insert(result.merged.end(), step.merged.begin(), step.merged.end());
}

// Of solids that nothing was done to, or of a step: the solids with their faces.
void append(const LabelledSolid& unchanged, SolidTrimResult& result) {
  const std::vector<TopoDS_Solid>& solids = unchanged.solid.solids;
  result.solids.insert(result.solids.end(), solids.begin(), solids.end());
  result.faces.insert(result.faces.end(), unchanged.faces.begin(), unchanged.faces.end());
}

void append(const SolidTrimResult& made, SolidTrimResult& result) {
  result.solids.insert(result.solids.end(), made.solids.begin(), made.solids.end());
  result.faces.insert(result.faces.end(), made.faces.begin(), made.faces.end());
}

// The steps of one operation on layers, and what was told of them.
struct LayerWork {
  const SharedLimit& limit;
  ConeVolumes& cones;
  TopTools_MapOfShape valid;  // faces that need not be checked
  double stated;              // by corners: what is nearer is one
  const InputFaceNames& names;
  SolidTrimResult told;  // no solids

  bool is_refused() const { return !told.obstacles.empty(); }
  /// Of two solids; the faces of the result come from where those of the two do.
  SolidTrimResult step(const LabelledSolid& first, const LabelledSolid& second,
                       SolidOperation operation);
  /// The layer without all tools, or together with them.
  SolidTrimResult folded(LabelledSolid layer, std::span<const LabelledSolid> tools,
                         SolidOperation operation);
  /// The layer in pieces, each of which one tool after the other divides.
  SolidTrimResult split(const LabelledSolid& layer, std::span<const LabelledSolid> tools);
  /// What is in the layer and in every tool.
  SolidTrimResult common(const LabelledSolid& layer, std::span<const LabelledSolids> tools);
};

SolidTrimResult LayerWork::step(const LabelledSolid& first, const LabelledSolid& second,
                                SolidOperation operation) {
  SolidTrimResult made =
      combined_pair(first.solid, second.solid, operation, limit.remaining(), stated, cones, valid);
  for (SolidFace& face : made.faces) {
    const LabelledSolid& of = face.tool < 0 ? first : second;
    const SolidFace& origin = of.faces[static_cast<std::size_t>(face.from)];
    face = {.face = face.face, .tool = origin.tool, .from = origin.from, .of_both = face.of_both};
    valid.Add(face.face);
  }
  add_facts(made, told);
  return made;
}

// One tool after the other, until there is an obstacle or nothing left.
SolidTrimResult LayerWork::folded(LabelledSolid layer, std::span<const LabelledSolid> tools,
                                  SolidOperation operation) {
  SolidTrimResult made;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    made = step(layer, tools[i], operation);
    if (is_refused() || made.solids.empty()) break;
    if (i + 1 < tools.size()) layer = labelled(made.solids, made.faces, names);
  }
  return made;
}

// One solid of a result with the origins of its faces.
LabelledSolid piece_of(const SolidTrimResult& made, const TopoDS_Solid& solid,
                       const InputFaceNames& names) {
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(solid, TopAbs_FACE, own);
  std::vector<SolidFace> known;
  std::ranges::copy_if(made.faces, std::back_inserter(known),
                       [&](const SolidFace& face) { return own.RemoveKey(face.face); });
  return labelled({solid}, known, names);
}

// Pieces have faces in common, so each is worked on by itself.
SolidTrimResult LayerWork::split(const LabelledSolid& layer, std::span<const LabelledSolid> tools) {
  LabelledSolids pieces{layer};
  SolidTrimResult made;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    made = {};
    for (const LabelledSolid& piece : pieces) {
      const SolidTrimResult divided = step(piece, tools[i], SolidOperation::Split);
      if (is_refused()) return {};
      append(divided, made);
    }
    pieces.clear();
    if (i + 1 < tools.size())
      for (const TopoDS_Solid& solid : made.solids) pieces.push_back(piece_of(made, solid, names));
  }
  return made;
}

SolidTrimResult LayerWork::common(const LabelledSolid& layer,
                                  std::span<const LabelledSolids> tools) {
  SolidTrimResult all;
  for (const LabelledSolid& tool : tools.front()) {
    const SolidTrimResult made = step(layer, tool, SolidOperation::Common);
    if (is_refused()) break;
    if (made.solids.empty()) continue;
    append(tools.size() == 1 ? made
                             : common(labelled(made.solids, made.faces, names), tools.subspan(1)),
           all);
  }
  return all;
}

// All layers of one input as one. Where they touch they fit each other better than what another
// solid has left of one of them fits the next.
LabelledSolid fused(const LabelledSolids& layers, LayerWork& work) {
  if (layers.size() == 1) return layers.front();
  const SolidTrimResult made =
      work.folded(layers.front(), std::span(layers).subspan(1), SolidOperation::Fuse);
  return work.is_refused() ? LabelledSolid{} : labelled(made.solids, made.faces, work.names);
}

LabelledSolids each_fused(const std::vector<LabelledSolids>& inputs, LayerWork& work) {
  LabelledSolids made;
  for (const LabelledSolids& layers : inputs)
    if (!work.is_refused()) made.push_back(fused(layers, work));
  return made;
}

// Sets of solids that become one, each by itself.
SolidTrimResult fused(const std::vector<std::vector<LabelledSolids>>& sets, LayerWork& work) {
  SolidTrimResult all;
  for (const std::vector<LabelledSolids>& set : sets) {
    const LabelledSolids inputs = each_fused(set, work);
    if (work.is_refused()) break;
    if (inputs.size() > 1)
      append(work.folded(inputs.front(), std::span(inputs).subspan(1), SolidOperation::Fuse), all);
    else
      append(inputs.front(), all);
  }
  return all;
}

// Each layer of the part by itself.
SolidTrimResult divided(LabelledInputs& inputs, SolidOperation operation, LayerWork& work) {
  const std::vector<LabelledSolids> tools = inputs.tools();
  LabelledSolids cutters;
  if (operation == SolidOperation::Cut) cutters = inputs.gathered_tools();
  if (operation != SolidOperation::Common && cutters.empty()) cutters = each_fused(tools, work);
  SolidTrimResult all;
  for (const LabelledSolid& layer : inputs.part()) {
    if (work.is_refused()) break;
    switch (operation) {
      case SolidOperation::Common: append(work.common(layer, tools), all); break;
      case SolidOperation::Split: append(work.split(layer, cutters), all); break;
      default: append(work.folded(layer, cutters, operation), all); break;
    }
  }
  return all;
}

// Those of inputs, which are as they were given.
TopTools_MapOfShape faces_given_of(const TrimTool& part, const std::vector<TrimTool>& tools) {
  TopTools_MapOfShape faces;
  for (const TopoDS_Face& face : part.faces) faces.Add(face);
  for (const TrimTool& tool : tools)
    for (const TopoDS_Face& face : tool.faces) faces.Add(face);
  return faces;
}

// With what lies between faces and their edges, which pieces do not share out exactly.
double closed_volume_of(const std::vector<TopoDS_Face>& faces, ConeVolumes& cones) {
  double volume = 0;
  for (const TopoDS_Face& face : faces)
    volume += cones.of(face) + cone_volume_beside(face, cones.apex());
  return volume;
}

// Steps measure what they combine, which is not always all of an input.
TotalVolumes total_of(const TrimTool& part, const std::vector<TrimTool>& tools,
                      const std::vector<TopoDS_Solid>& solids, ConeVolumes& cones) {
  TotalVolumes total{closed_volume_of(part.faces, cones), 0, 0};
  for (const TrimTool& tool : tools)
    if (tool.is_solid()) total.tools += closed_volume_of(tool.faces, cones);
  for (const TopoDS_Solid& solid : solids) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
      faces.push_back(TopoDS::Face(it.Current()));
    total.result += closed_volume_of(faces, cones);
  }
  return total;
}

std::vector<const TrimTool*> all_of(const TrueInputs& inputs) {
  std::vector<const TrimTool*> all{&inputs.part()};
  for (const TrimTool& tool : inputs.tools()) all.push_back(&tool);
  return all;
}

SolidTrimResult trimmed(const TrimTool& part, const std::vector<TrimTool>& tools,
                        SolidOperation operation, double stated,
                        const IntersectionOptions& options) {
  const SharedLimit limit(options);
  const WorkLimit own_limit(options);
  SolidTrimResult result;
  try {
    const TrueInputs sound(part, tools, own_limit);
    const InputFaceNames names = names_of_faces(part, tools);
    LabelledInputs inputs(sound.part(), sound.tools(), names,
                          std::max(options.tolerances.point, stated), limit);
    ConeVolumes cones(cone_apex(sound.part()));
    LayerWork work{limit, cones, faces_given_of(part, tools), stated, names, {}};
    result = operation == SolidOperation::Fuse ? fused(inputs.joined(), work)
                                               : divided(inputs, operation, work);
    add_facts(work.told, result);
    result.tolerances = sound.told();
    // Later steps may have changed edges and vertices of faces that are left of earlier ones.
    if (result.obstacles.empty() && result.volumes.size() > 1 &&
        !are_valid(result.solids, faces_given_of(part, tools), own_limit))
      result.obstacles.emplace_back(kInvalidSolid);
    if (result.obstacles.empty()) {
      narrow_vertices(result.solids, all_of(sound));
      result.total = total_of(sound.part(), sound.tools(), result.solids, cones);
    }
  } catch (const Failure& error) {
    result.obstacles.emplace_back(error.what());
    if (own_limit.reached_after_search() != nullptr) result.status = Status::Stopped;
  }
  return result;
}

SolidTrimResult trimmed_sheets(const TrimTool& part, const std::vector<TrimTool>& tools,
                               SolidOperation operation, double stated,
                               const IntersectionOptions& options) try {
  const SharedLimit limit(options);
  const WorkLimit own_limit(options);
  const TrueInputs sound(part, tools, own_limit);
  SolidTrimResult result =
      trim_sheets(sound.part(), sound.tools(), operation, stated, limit.remaining_alone());
  result.tolerances = sound.told();
  return result;
} catch (const Failure& error) {  // the limit, before anything was divided
  SolidTrimResult result;
  result.of_sheets = true;
  result.obstacles.emplace_back(error.what());
  result.status = Status::Stopped;
  return result;
}

// The largest gap between edges of two inputs that are one by what their corners state.
double corner_gap(const TrimTool& part, const std::vector<TrimTool>& tools) {
  double gap = 0;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    gap = std::max(gap, gap_between_corners(part, tools[i]));
    for (std::size_t k = 0; k < i; ++k)
      gap = std::max(gap, gap_between_corners(tools[k], tools[i]));
  }
  return gap;
}

// Says which faces of the inputs are loose, and numbers the faces of results among all that their
// inputs have, loose ones too.
void report_loose_faces(const TrimTool& part, const std::vector<TrimTool>& tools,
                        SolidTrimResult& result) {
  const auto tell = [&](const TrimTool& input, const std::string& name) {
    if (input.loose > 0) result.left_out.push_back(describe_loose_faces(input, name));
  };
  tell(part, part_name(part));
  for (std::size_t i = 0; i < tools.size(); ++i) tell(tools[i], tool_name(tools, i));
  if (!result.left_out.empty()) result.status = weaker(result.status, Status::Tolerance);
  for (SolidFace& face : result.faces) {
    const TrimTool& of = face.tool < 0 ? part : tools[static_cast<std::size_t>(face.tool)];
    if (!of.places.empty()) face.from = of.places[static_cast<std::size_t>(face.from)];
  }
  for (Finding& finding : result.findings)
    for (InputFace& face : finding.faces) {
      const TrimTool& of = face.tool < 0 ? part : tools[static_cast<std::size_t>(face.tool)];
      if (!of.places.empty()) face.face = of.places[static_cast<std::size_t>(face.face)];
    }
}

// What is not known of inputs then is no further obstacle.
void find_own_contacts(const TrimTool& part, const std::vector<TrimTool>& tools,
                       const IntersectionOptions& options, SolidTrimResult& result) try {
  result.findings = own_contacts(part, tools, options);
} catch (const BadModel&) {
}

void require_shape(const TrimTool& input, const std::string& name) {
  if (input.faces.empty() && input.wires.IsNull())
    throw BadModel(name + ": there is nothing in it");
}

// What grew with a cut has grown in the result alone.
void part_from_inputs(BRepTools_ReShape& copies, SolidTrimResult& result) {
  for (TopoDS_Solid& solid : result.solids) solid = TopoDS::Solid(copies.Apply(solid));
  for (TopoDS_Shell& sheet : result.sheets) sheet = TopoDS::Shell(copies.Apply(sheet));
  for (SolidFace& face : result.faces) face.face = TopoDS::Face(copies.Apply(face.face));
}

// What all operations tell of their inputs, and what is not given out where there is an obstacle.
void finish(const TrimTool& part, const std::vector<TrimTool>& tools, SolidTrimResult& result) {
  report_loose_faces(part, tools, result);
  if (result.obstacles.empty()) return;
  // Two ends of curves may have one cause.
  std::vector<std::string> causes;
  for (std::string& cause : result.obstacles)
    if (std::ranges::find(causes, cause) == causes.end()) causes.push_back(std::move(cause));
  result.obstacles = std::move(causes);
  result.solids.clear();
  result.sheets.clear();
  result.faces.clear();
}

}  // namespace

std::string misplaced_sheet(const TrimTool& part, const std::vector<TrimTool>& tools,
                            SolidOperation operation) {
  if (takes_wires(part, tools)) return misplaced_wires(part, tools, operation);
  if (!takes_sheets(part, tools, operation) || operation == SolidOperation::Split ||
      operation == SolidOperation::Common)
    return {};
  const std::size_t sheet = first_sheet(tools);
  const auto told = [](const TrimTool& input, const std::string& name) {
    return name + " is no closed solid: " + describe_open_shell(input);
  };
  if (operation == SolidOperation::Cut)
    return part.is_solid() ? told(tools[sheet], tool_name(tools, sheet)) +
                                 "; a sheet takes nothing off a solid, split divides it by one"
                           : "";
  const bool any_solid = part.is_solid() || std::ranges::any_of(tools, &TrimTool::is_solid);
  if (!any_solid) return {};
  return (part.is_solid() ? told(tools[sheet], tool_name(tools, sheet))
                          : told(part, part_name(part))) +
         "; solids are fused with solids, and sheets with sheets";
}

SolidTrimResult trim_solids(const TrimTool& part, const std::vector<TrimTool>& tools,
                            SolidOperation operation, const IntersectionOptions& options) {
  if (tools.empty()) throw InvalidInput("trim: there is no tool");
  require_shape(part, part_name(part));
  for (std::size_t i = 0; i < tools.size(); ++i) require_shape(tools[i], tool_name(tools, i));
  if (const std::string cause = misplaced_sheet(part, tools, operation); !cause.empty())
    throw InvalidInput("trim: " + cause);
  if (takes_wires(part, tools)) {
    SolidTrimResult result = trim_wires(part, tools, operation, options);
    finish(part, tools, result);
    return result;
  }
  KeptTolerances kept(part.faces);
  for (const TrimTool& tool : tools) kept.remember(tool.faces);
  const SharedLimit limit(options);
  SolidTrimResult result;
  with_threads(options.threads, [&] {
    const auto combine = takes_sheets(part, tools, operation) ? trimmed_sheets : trimmed;
    result = combine(part, tools, operation, kCornerMargin * corner_gap(part, tools), options);
    if (result.obstacles.empty() || limit.is_reached()) return;
    find_own_contacts(part, tools, limit.remaining(), result);
  });
  const TopTools_MapOfShape given = faces_given_of(part, tools);
  for (SolidFace& of : result.faces) of.as_given = given.Contains(of.face);
  if (const auto copies = kept.parted(); !copies.IsNull()) part_from_inputs(*copies, result);
  if (!part.is_solid()) result.open_part = describe_open_shell(part);
  finish(part, tools, result);
  return result;
}

}  // namespace blossom::occt
