// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids, sheets and wires cut by each other: what they have in common, what is left, what they are
// together.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/trim_tool.h"
#include "core/math/vec.h"
#include "core/surface_intersection.h"

namespace blossom::occt {

enum class SolidOperation {
  Cut,     ///< the part without the tools
  Common,  ///< what lies in the part and in all tools
  Fuse,    ///< what lies in any of them
  Split,   ///< the part in pieces, each of them inside or outside of every tool, with common faces;
           ///< and on the sides of sheets
};

/// Volumes by our own integration over faces and pieces, cubic model units; without what lies
/// between faces and their edges' curves.
struct SolidVolumes {
  double part = 0;
  double tool = 0;
  double cut = 0;
  double common = 0;
  double fuse = 0;

  /// |V(cut) + V(common) - V(part)| / V(part)
  double cut_error() const;
  /// |V(fuse) + V(common) - V(part) - V(tool)| / (V(part) + V(tool))
  double fuse_error() const;
};

/// Of all inputs and of what came out, however many steps that took; of shells that strips close
/// where faces end beside their edges (faces/border_strips.h), as `mass_of` has them.
struct TotalVolumes {
  double part = 0;
  double tools = 0;
  double result = 0;
};

/// Of sheets and of what they became, square model units.
struct TotalAreas {
  double part = 0;   ///< 0 of a solid
  double tools = 0;  ///< of those that are sheets
  double result = 0;
};

/// Above this error of volumes, or of the areas of sheets, a result is not given out, but for what
/// is between pieces that are apart and count as one.
inline constexpr double kVolumeError = 1e-6;

/// How a piece of a sheet lies to the solids that divided it: inside of one, or else on one, or
/// outside of all.
enum class SheetSide { Outside, On, Inside };

/// A face of a result and where it comes from.
struct SolidFace {
  TopoDS_Face face;
  int tool = -1;  ///< index of the tool; -1 of the part
  int from = 0;   ///< place of the face that it is a piece of among that one's faces
  SheetSide side = SheetSide::Outside;  ///< of a sheet's piece; else without a meaning
  bool as_given = false;                ///< all of an input's face; others were checked to be valid
  bool of_both = false;                 ///< it bounds both solids of the step that made it
};

/// A face of an input.
struct InputFace {
  int tool = -1;  ///< index of the tool; -1 of the part
  int face = 0;   ///< its place among all faces of that one
};

enum class FindingCode {
  InputMeetsItself,  ///< faces of one solid beside what they share, or one face
};

/// What stands against a result, or explains what does, as data.
struct Finding {
  FindingCode code = FindingCode::InputMeetsItself;
  std::vector<InputFace> faces{};
  std::optional<Vec3> point{};
  double size = 0;  ///< about how long what is found is, model units; 0: a point
};

/// Of the edges of inputs that have no faces, and of what they became, model units.
struct TotalLengths {
  double part = 0;
  double tools = 0;
  double result = 0;
};

struct SolidTrimResult {
  Status status = Status::Complete;  ///< of the intersection
  Certificate certificate;
  std::vector<TopoDS_Solid> solids;   ///< none if it is empty or refused
  std::vector<TopoDS_Shell> sheets;   ///< likewise, where sheets are combined
  bool of_sheets = false;             ///< whether they are: then there are areas, and no volumes
  std::vector<SolidFace> faces;       ///< of all solids, or of all sheets
  std::vector<SolidVolumes> volumes;  ///< one for each step, of the two that were combined then
  TotalVolumes total;                 ///< 0 if there is no result
  TotalAreas areas;                   ///< likewise; of sheets that are combined
  /// Where an input has no face: wires, and vertices off them; null if there is no result.
  TopoDS_Compound wires;
  bool of_wires = false;  ///< whether there are such inputs: then there are lengths alone
  TotalLengths lengths;   ///< 0 if there is no result
  std::string open_part;  ///< why the part is taken as a sheet, as `describe_open_shell`
  std::vector<std::string> left_out;    ///< faces of inputs that are loose beside closed solids
  std::vector<std::string> obstacles;   ///< why there is no result; none if it can be used
  std::vector<Finding> findings;        ///< causes of obstacles, looked for once there are some
  std::vector<std::string> merged;      ///< pieces, or cuts, that are apart and count as one; what
                                        ///< of a sheet ends inside of the part
  std::vector<std::string> tolerances;  ///< what was not true about those of the part and the tools
};

/// Why the faces of a tool that is no solid bound none: "1 of its 2 shells is open, at 4 edges".
std::string describe_open_shell(const TrimTool& tool);

/// Why sheets or wires among the inputs have no place in the operation; empty if they have, or
/// there are none.
std::string misplaced_sheet(const TrimTool& part, const std::vector<TrimTool>& tools,
                            SolidOperation operation);

/// Combines closed solids, or sheets with solids and with each other.
///
/// Loose faces of an input, beside its closed solids, are left out. They are told, with the status
/// Tolerance.
///
/// Faces are split along each other, pieces on the wanted sides put together by their common edges
/// into closed shells, and shells into solids: a shell that is turned inwards is a void of the
/// smallest solid around it. Every edge has to be used as often in one direction as in the other,
/// every solid with its shells and the faces that are new in it to be valid by BRepCheck, and
/// volumes to add up; what `solid_pieces` refuses is refused. Faces that nothing reached are those
/// of the inputs, as they were.
///
/// Tools are taken one after the other: the part, and then the result so far, is combined with the
/// next one, until the result is empty; to cut, those that meet none of each other are taken at
/// once. To split, each of them divides all pieces, which have copies of the common faces that it
/// goes through. Solids of one input that touch each other are worked on apart, in layers, and stay
/// apart; fused, they become one only where solids of another input join them.
///
/// A sheet, a tool that is no closed solid, splits: each divides all pieces. What of it ends freely
/// inside of a piece, or has one body on both sides, divides nothing. Where its cuts end in the
/// middle of a face without the sheet ending there, it is refused.
///
/// A sheet as the part is cut by solids: what is outside of them is left (cut), what is inside of
/// all of them or on them (common), or both (split). Sheets as tools of a sheet divide it, too, and
/// have in common with it what lies on both; sheets that are fused are divided alike, and what lies
/// on both is there once. What a solid has in common with sheets is what of the first one lies in
/// it, and on the others. The faces keep their turn, and hang together in sheets over edges that
/// two of them use in opposite directions.
///
/// Inputs without faces, of edges and vertices, are divided where they meet the others
/// (wires/wire_trim.h): what of them is outside of the tools is left (cut), in common is what of
/// them lies in or on all others, wires are fused with wires.
///
/// Pieces of two solids that have the same border and are less than two tolerances apart count as
/// one, and so do cuts of a face that keep within tolerance of each other from end to end; what is
/// between them is in no result; they are told, with the status Tolerance.
///
/// Points within the options' tolerance are one, and whatever lies nearer to each other than the
/// two solids state to be uncertain (solids/tolerances/stated_tolerance.h): no walls or voids
/// thinner than that are made, and the status is Tolerance. Where the two cannot be divided so,
/// there are two more looks at them, at another tolerance that is told (solids/solid_divisions.h).
///
/// Tolerances of edges and vertices that are not true are not used: see with_true_tolerances.
///
/// Where there is an obstacle, and no limit was reached, inputs are asked whether they meet
/// themselves (solids/validity/own_contacts.h), within a limit on work and not on time.
///
/// options       its time limit is that of the whole work; when it is reached, volumes and solids
///               too are left with the obstacle and the status Stopped
/// part, tools   each one or several solids that do not overlap, or a sheet; at least one tool
/// throws        InvalidInput with what `misplaced_sheet` tells, or if there is no tool;
///               BadModel if a face cannot be converted
SolidTrimResult trim_solids(const TrimTool& part, const std::vector<TrimTool>& tools,
                            SolidOperation operation, const IntersectionOptions& options = {});

}  // namespace blossom::occt
