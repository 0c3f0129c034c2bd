// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids cut by solids: what they have in common, what is left, what they are together.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Solid.hxx>

#include "adapters/occt/trim_sides.h"
#include "core/surface_intersection.h"

namespace blossom::occt {

enum class SolidOperation {
  Cut,     ///< the part without the tool
  Common,  ///< what lies in both
  Fuse,    ///< what lies in either
  Split,   ///< the part in pieces: cut and common side by side, with common faces
};

/// Volumes by our own integration over faces and pieces, cubic model units.
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

/// Above this error of volumes a result is not given out.
inline constexpr double kVolumeError = 1e-6;

/// A face of a result and where it comes from.
struct SolidFace {
  TopoDS_Face face;
  bool of_tool = false;  ///< of the part otherwise
  int from = 0;          ///< place of the face that it is a piece of among that one's faces
};

struct SolidTrimResult {
  Status status = Status::Complete;  ///< of the intersection
  Certificate certificate;
  std::vector<TopoDS_Solid> solids;  ///< valid by BRepCheck; none if it is empty or refused
  std::vector<SolidFace> faces;      ///< of all solids
  SolidVolumes volumes;
  std::vector<std::string> obstacles;  ///< why there is no result; none if it can be used
};

/// Combines two closed solids.
///
/// Faces are split along each other, pieces on the wanted sides put together by their common edges
/// into closed shells, and shells into solids: a shell that is turned inwards is a void of the
/// smallest solid around it. Every edge has to be used once in each direction, every solid to be
/// valid, and volumes to add up; contacts without crossing are refused, see `solid_pieces`.
///
/// throws    InvalidInput if an input is no closed solid; BadModel if a face cannot be converted
SolidTrimResult trim_solids(const TrimTool& part, const TrimTool& tool, SolidOperation operation,
                            const IntersectionOptions& options = {});

}  // namespace blossom::occt
