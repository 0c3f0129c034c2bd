// SPDX-License-Identifier: LGPL-2.1-or-later
// The borders of a trimmed region divided into arcs: each in one patch, within tolerance, turning
// little.

#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "core/base/tolerances.h"
#include "core/regions/arc_forms.h"
#include "core/regions/limits.h"
#include "core/regions/line_runs.h"
#include "core/regions/trimmed_chart.h"

namespace blossom {

/// Highest degree of a patch over a curved triangle that `composition` takes.
inline constexpr int kMaxComposed = 2 * kMaxDegree;

/// Degree of arcs that is worth triangles above the highest degree: the number of straight arcs
/// grows with the root of the inverse of the tolerance, that of cubic ones with its fourth root.
inline constexpr int kCommonArcs = 3;

struct RegionOptions {
  /// How far the border of the pieces may lie from the trims, along the surface, and lowered ones
  /// besides from the surface; model units.
  double tolerance = Tolerances{}.point;
  /// Of triangles, at least n + m. Where trims have no exact arcs of a degree that leaves, or
  /// borders are common, surfaces are composed in up to kMaxComposed over arcs of degree
  /// kCommonArcs, and lowered: with common borders by those who move them.
  int highest_degree = kMaxDegree;
  /// Rows and columns of cells in each patch; a power of two, 0 for as many as seem right.
  int cells = 0;
  /// Borders will be common curves with other faces: arcs run as evenly as the border's parameter,
  /// and nothing but triangles touches them, unless they are points in space.
  bool common_borders = false;
};

/// A piece of a border, which is one side of one triangle or one side of a whole cell.
struct RegionArc {
  int border = 0;
  Interval place;  ///< the border's parameters, in the direction of its walk
  int patch_u = 0;
  int patch_v = 0;
  PlanarBezier curve;  ///< in the parameters of the patch; runs from vertex to vertex exactly
  int from = 0;        ///< vertices
  int to = 0;
  /// Direction of which the line that it runs along, between patches or round them all, is a value;
  /// -1: none. Its halves run along the same.
  int across = -1;
  bool exact = true;     ///< the very trim, as far as the doubles go
  double fit_error = 0;  ///< bound on what the fit alone adds to it; model units
  double error = 0;      ///< bound on the distance between its and the trim's image; model units
};

/// Divides the borders of one region, first where it has to be, later where it is asked to.
class BorderArcs {
 public:
  /// throws   InvalidInput if the patches' degrees leave no triangle below the highest degree, or a
  ///          border takes more than kMaxArcs
  BorderArcs(const BezierSurface& surface, const TrimmedChart& chart, const RegionOptions& options,
             int cells);

  /// Highest number of arcs of one border: as many triangles of the highest degree take 45 MB.
  static constexpr std::size_t kMaxArcs = 5'000;

  const std::vector<RegionArc>& arcs() const { return arcs_; }
  const std::vector<Vec2>& vertices() const { return vertices_; }  ///< grid coordinates

  /// The vertex at a point, a new one unless there is one with the same coordinates.
  int vertex_at(const Vec2& grid);

  /// The point of a vertex of a patch, or near it, in space.
  Vec3 point_in(const std::array<int, 2>& patch, int vertex) const;

  /// Divides an arc in the middle of its place: it keeps the first half, and the number of the
  /// second is returned; -1 if its place is too short for that.
  int halve(int arc);

  /// Powers of two by which the parameters of a patch become about lengths in space.
  Vec2 metric(int patch_u, int patch_v) const;

  /// How far arcs of a border may lie from it; model units.
  double tolerance_of(int border) const;

  /// Whether a cell may have a piece of the border for a side.
  bool takes_cells(int border) const;

  bool is_rational() const { return surface_.rational; }
  bool has_common_borders() const { return options_.common_borders; }

  const RationalBezierPatch& patch(const std::array<int, 2>& at) const {
    return surface_.patches(at[0], at[1]);
  }

  const RegionOptions& options() const { return options_; }

  /// Bound on how far arcs and their triangles reach beyond the patches' lines, model units: as far
  /// as common borders cross these beside another stop, where the crossing is taken to be.
  double beyond_lines() const { return beyond_; }

  /// The highest degree of arcs that triangles of a patch can have.
  int arc_degree(int patch_u, int patch_v) const;

 private:
  /// Where a border crosses a line between patches.
  struct LineStop {
    double at;      ///< parameter
    int direction;  ///< of which the line is a value
    double line;    ///< grid coordinate
  };
  struct BorderStops {
    std::vector<double> at;
    std::vector<LineStop> lines;
  };

  void divide(int border, BorderStops stops);
  BorderStops stops_of(int border) const;
  void join_near(int border, BorderStops& stops);
  void join_at_corners(int border, BorderStops& stops);
  void settle_corners(int border, const BorderStops& stops);
  LineRun run_between(int border, const Interval& place) const;
  int corner_at(const RegionBorder& border, double parameter) const;
  double way_along(const RegionBorder& border, double from, double to) const;
  void add_line_stops(const RegionBorder& border, int direction, std::vector<double>& at,
                      std::vector<LineStop>& lines) const;
  Vec2 point_at_stop(const RegionBorder& border, const std::vector<double>& at, std::size_t stop,
                     const std::vector<LineStop>& lines) const;
  void add_cell_stops(const RegionBorder& border, std::vector<double>& at) const;
  void add(int border, const Interval& place, int from, int to, int across, std::size_t first);
  RegionArc made(int border, const Interval& place, int from, int to, int across) const;
  ArcForm form_in(const RegionArc& arc) const;
  int direction_across(int border, const Interval& place, int from, int to) const;
  void settle_ends(RegionArc& arc, const ArcForm& form) const;
  Vec2 steepest_about(const RegionArc& arc, const Vec2& error) const;
  bool is_too_long(const RegionArc& arc) const;
  Vec2 snapped(Vec2 grid) const;
  int vertex_within(const RegionArc& arc, double parameter);

  const BezierSurface& surface_;
  const TrimmedChart& chart_;
  RegionOptions options_;
  int cells_;
  Grid<Vec2> steepest_;        // bounds of derivatives of each patch
  std::vector<Vec2> corners_;  // of the chart, grid coordinates
  double beyond_ = 0;
  std::vector<RegionArc> arcs_;
  std::vector<Vec2> vertices_;
  std::map<std::pair<double, double>, int> vertex_of_;
};

}  // namespace blossom
