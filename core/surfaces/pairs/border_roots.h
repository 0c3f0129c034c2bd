// SPDX-License-Identifier: LGPL-2.1-or-later
// The arcs of a certified pair of cells, from the points where they cross its border.
//
// In a certified pair the intersection is a union of arcs, graphs over one of the four
// parameters, that run from border to border. So all there is to find are the roots of F on the
// eight faces of the pair's box; sorted along that parameter they pair up, in and out.

#pragma once

#include <optional>
#include <vector>

#include "core/cells/cell_pair.h"
#include "core/cells/cell_tree.h"
#include "core/cells/points.h"
#include "core/surfaces/pairs/surface_borders.h"

namespace blossom {

/// An arc from `from` to `to`, along which direction . x grows; both ends on the border. For
/// each value of direction . x there is one point.
struct CellArc {
  Point4 from;
  Point4 to;
  Point4 direction{};
  bool runs_along_border = false;  ///< it runs along the border of the pair
  bool tangential = false;         ///< the surfaces touch along it
  bool crosses = false;            ///< likewise, and they cross there: contact of odd order
  bool straight = false;  ///< a straight line in the parameters of a, in contact all the way
  int iso = -1;           ///< the parameter on whose iso-line it runs from end to end; or -1
  /// The parameter along whose border of the pair it runs, if a neighbour may hold it, too; or -1.
  int shared_border = -1;
  bool upper = false;  ///< that border is the upper one
};

/// What a certified pair holds.
struct PairArcs {
  std::vector<CellArc> arcs;

  /// Some of the arcs run along the border of the pair, as where a plane holds the seam of a
  /// cylinder. That is seen at points of the arc, not proven.
  bool along_border = false;

  /// Points at corners of the box that the curve passes without entering. Inside the surfaces
  /// the neighbours hold the curve; at a corner of a surface it is a contact of its own.
  std::vector<Point4> corner_contacts;
};

/// Two border points closer than this in every parameter are one. Fraction of a patch.
inline constexpr double kSamePoint = 1e-9;

/// All arcs in a certified pair.
///
/// bounds    of the pair's Jacobian; its minor `along` is regular
/// borders   tells for which of its upper borders no neighbour answers
/// returns   arcs and corner contacts; nothing if some face cannot be decided (an arc that is
///           nearly tangent to it, say): then the pair has to be halved
///
/// Source: Krawczyk 1969 for the faces; `core/surfaces/README.md`, "Arcs of a certified pair".
std::optional<PairArcs> arcs_in(const CellTree& tree_a, const Cell& a, const CellTree& tree_b,
                                const Cell& b, const JacobianBounds& bounds,
                                const SurfaceBorders& borders, int along);

}  // namespace blossom
