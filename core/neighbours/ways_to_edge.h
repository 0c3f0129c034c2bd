// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells of a face, and the parameter lines that lead from them to an edge of it.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/cells/direction_cones.h"
#include "core/cells/surface_cells.h"
#include "core/forms/elementary.h"
#include "core/math/interval.h"
#include "core/plane/planar_curves.h"
#include "core/surfaces/pairs/elementary_side.h"
#include "core/topology/face_data.h"

namespace blossom {

/// Parameter lines that lead from all points of a cell which count to an edge.
struct WaysToEdge {
  Interval on_edge;                      ///< where they may end
  std::vector<VectorBounds> directions;  ///< in space
  double shortfall = 0;                  ///< so long are what of them is left out, and the way
                                         ///< from where they end to the edge
};

/// Keeps a reference to the face's data.
class FaceCells {
 public:
  FaceCells(const FaceData& data, const Vec3& origin);

  SurfaceCells& cells() { return cells_; }

  /// Whether nothing of a cell counts, looked at more closely than cells are.
  bool is_outside(int patch, int cell);

  /// The edge's parameter nearest to the middle of a cell in the chart.
  double nearest_on(const Coedge& edge, int patch, const Cell& cell) const;

  /// Nothing if not all that counts of the cell is seen to lie beside one stretch of the edge.
  /// Stays where it is until another edge is asked about.
  const std::optional<WaysToEdge>& ways(const Coedge& edge, int patch, int cell);

  /// How deep a cell gets behind an elementary surface that the face touches along an edge, model
  /// units. Infinity if it is not seen to bend to one side, or if the line of the edge goes on in
  /// the face farther than the edge and a tolerance. To be asked about one surface and tolerance.
  double depth_behind(const Elementary& surface, const Coedge& edge, double tolerance, int patch,
                      int cell);

  /// The same where the line along which they touch is a parameter line of the face through a point
  /// of its chart; all of the cell counts.
  ///
  /// across    the chart coordinate that is constant on the line
  double depth_beside(const Elementary& surface, const Vec2& through, int across, int patch,
                      int cell);

 private:
  // What was found out about a cell, which takes part in many pairs.
  struct Facts {
    std::optional<bool> outside;
    std::vector<std::pair<const Coedge*, std::optional<WaysToEdge>>> ways;
    std::vector<std::pair<const Coedge*, double>> depths;
  };
  Facts& facts(int patch, int cell) {
    return facts_[static_cast<std::uint64_t>(patch) << 32 | static_cast<std::uint32_t>(cell)];
  }
  bool finds_outside(int patch, const Cell& cell) const;
  double found_depth(const Elementary& surface, const Coedge& edge, double tolerance, int patch,
                     int cell);
  double depth_beside(const Elementary& surface, const PlanarBox& line, int across, int patch,
                      int cell);
  const std::optional<ElementarySide>& side(const Elementary& surface, int patch);
  std::optional<WaysToEdge> found_ways(const Coedge& edge, int patch, const Cell& cell);
  bool is_empty(const PlanarBox& box) const;
  bool meets_gap(const PlanarBox& box) const;
  PlanarBox chart_box(int patch, const Cell& cell) const;
  void add_directions(const PlanarBox& box, int across, double sign, double strip,
                      WaysToEdge& ways);
  double width(int patch, int across);
  std::optional<Interval> local(ParameterLaw law, const Interval& span, const PlanarBox& box,
                                int k) const;
  const SlopeNets& slopes(int patch);

  const FaceData& data_;
  SurfaceCells cells_;
  std::vector<PlanarBox> gaps_;  // round what closes them between the ends of coedges
  std::vector<std::optional<SlopeNets>> slopes_;
  std::vector<std::array<std::optional<double>, 2>> widths_;      // of patches, across u and v
  std::unordered_map<int, std::optional<ElementarySide>> sides_;  // of patches
  std::unordered_map<std::uint64_t, Facts> facts_;
};

}  // namespace blossom
