// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets: edges of solids rounded by a rolling ball.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

#include "core/base/status.h"
#include "core/blending/balls/ball_strip.h"
#include "core/blending/balls/radius_law.h"
#include "core/math/vec.h"
#include "core/results/options.h"

namespace blossom::occt {

/// Why a fillet cannot be made.
enum class FilletFault {
  Edge,          ///< it cannot have a fillet: open, crowded, of mixed kind
  Nothing,       ///< there is nothing to be rounded: smooth, a seam, a point
  NoBall,        ///< no ball of that radius touches both faces beside the edge
  Pinch,         ///< the ball has a radius of curvature of a face
  LeavesFace,    ///< a contact goes over a border of its face
  EdgeConsumed,  ///< more of an edge would go than there is
  End,           ///< how the strip ends is not known how to build
  Corner,        ///< likewise of filleted edges that meet
  Setback,       ///< it is less than the strips that meet there take, or more than the edge has
  Interference,  ///< the strip runs into another face
  Result         ///< what came out is no valid solid
};

/// "edge", "no ball", ... as in the JSON report.
const char* to_string(FilletFault fault);

/// The same with where, and what would do.
struct FilletRefusal {
  FilletFault fault = FilletFault::Result;
  int edge = 0;  ///< number; 0: none in particular
  std::string cause;
  std::optional<double> parameter{};  ///< of the edge
  std::optional<Vec3> point{};        ///< model units
  /// The largest radius that works, model units, whatever radius was asked for: the edges were
  /// rounded with it, and cannot be with one larger by 1e-3 of it.
  std::optional<double> largest{};
  /// Of a chamfer: the largest is a distance, the first if there are two; the same is said of it.
  bool of_chamfer = false;
  /// Where blends take more of an edge than there is: that part of their size with which they would
  /// just meet, if what they take grew with it.
  double fits = 1;
  /// What other sizes showed, to follow the cause and the place: "; of the smaller radii ...".
  std::string tried{};
  bool at_least = false;  ///< the search for the largest ended early: larger ones may work

  /// The largest as all doors tell it, six digits, cut off: what is told is to work.
  std::optional<double> told_largest() const;

  /// "edge 12: ... at (x, y, z)".
  std::string text() const;
};

/// What a fillet is like across its edge.
struct FilletSection {
  SectionKind kind = SectionKind::Circle;  ///< but for Chamfer, which is an option of its own
  double rho = 0.5;  ///< of conics, in (0, 1): how far the shoulder is on the way from the chord to
                     ///< where the end tangents meet; 0.5 is a parabola
};

/// How far a chamfer reaches from its edge.
struct ChamferSize {
  double first = 1;  ///< distance of its one border from the edge, model units
  /// Of the other one, where it is another; or the angle between the chamfer and the first face.
  std::optional<double> second{};
  std::optional<double> angle{};  ///< radians, in (0, pi)
};

/// How large a fillet is along a run of edges.
struct EdgeRadius {
  double radius = 1;               ///< model units; of no account with a law
  std::optional<RadiusLaw> law{};  ///< along the run, as in `FilletOptions`
};

struct FilletOptions {
  double radius = 1;  ///< model units; of no account with a law
  /// Radii along each run of edges, over [0, 1]: the share of the run's length from its start, and
  /// within an edge linear in the edge's parameter. Runs start where their edge of the least number
  /// does. Radii are the law's where edges meet; between, its rates at the ends of edges become
  /// those by the way of the ball, so that strips meet. Round a closed run it has to come back.
  std::optional<RadiusLaw> law{};
  /// Radii of some edges' own, by number, in place of those above. They hold along all edges in
  /// which these go on smoothly: two of one run that differ are refused.
  std::map<int, EdgeRadius> own{};
  FilletSection section{};
  /// How far from the vertex, along each edge, the strips end where three and more meet, model
  /// units: a fill of many sides joins them there, also where one ball could. Nothing: as near as
  /// can be.
  std::optional<double> setback{};
  /// Chamfers in place of fillets. The first distance is on the face of the smaller number at the
  /// edge of the least number of a run, and on that side all along the run.
  std::optional<ChamferSize> chamfer{};
  bool partial = false;  ///< make those that can be made, instead of all or none
  /// Measure whole solids, before and after. What fillets take and add is measured in any case, on
  /// the faces that change alone.
  bool volumes = true;
  /// Look for the largest radius that works where a fillet of one radius is refused, or the largest
  /// distance of a chamfer: the edges are rounded, or cut off, with some more of them.
  bool largest = true;
  IntersectionOptions intersection{};

  /// Of an edge by number.
  EdgeRadius radius_of(int edge) const {
    const auto known = own.find(edge);
    return known == own.end() ? EdgeRadius{radius, law} : known->second;
  }
};

/// A face of a result and where it comes from. Numbers are those of the shape.
struct FilletFace {
  TopoDS_Face face;
  int from = 0;  ///< of the face that it is or is left of; 0: a blend
  int edge = 0;  ///< of a blend: of the edge in whose place it is; 0: of a corner
};

struct FilletedSolid {
  TopoDS_Solid solid;
  std::vector<FilletFace> faces;
  double volume = 0;  ///< cubic model units, by our own integration; 0 without `volumes`
};

struct FilletResult {
  /// Tolerance if a blend ends before its edge does, or strips along a run of edges do not quite
  /// meet, which notes say; Stopped when the time limit
  /// or the caller ended the work.
  Status status = Status::Complete;
  /// All solids of the shape, those without fillets as they were; none if anything is refused that
  /// could be rounded, and not `partial`, or nothing could be made.
  std::vector<FilletedSolid> solids;
  std::vector<int> edges;  ///< that have fillets: those asked for and those that they go on in
  std::vector<FilletRefusal> refused;  ///< edges with nothing to be rounded are last
  double volume_before = 0;            ///< of all solids; 0 without `volumes`
  std::vector<std::string> notes;      ///< how strips end, where that is not what one would think
};

/// Rounds edges of solids.
///
/// A fillet goes on along edges that continue an edge smoothly. Edges with nothing to be rounded
/// are refused, but do not keep the others from it. Nothing is given out that is not closed, valid
/// by BRepCheck, and changed in volume the way its edges say: less material at convex ones, more at
/// concave ones.
///
/// shape    solids, faces turned outwards
/// edges    numbers as in `edge_facts`
/// throws   InvalidInput if there is no edge of such a number, none is given, a radius is not
///          positive and finite, a law's below 0 somewhere, rho or an angle outside of its range,
///          or an edge has a radius of its own that is not among the edges or is to be cut off, or
///          a setback is not positive or of chamfers; BadModel if a face cannot be used
FilletResult fillet(const TopoDS_Shape& shape, const std::vector<int>& edges,
                    const FilletOptions& options = {});

}  // namespace blossom::occt
