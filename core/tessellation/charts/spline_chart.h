// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface of Bezier patches, made ready for many points and many bounds on facets.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/forms/surface.h"
#include "core/math/grid.h"
#include "core/tessellation/charts/cell_jets.h"
#include "core/tessellation/charts/curvature_sample.h"
#include "core/tessellation/charts/jet_enclosure.h"

namespace blossom {

class SplineChart {
 public:
  /// fine      patches are divided into cells until second derivatives change little in each, or
  ///           a facet as large as a cell would be nearer than this; model units
  /// throws    InvalidInput if the surface is not well formed
  SplineChart(const BezierSurface& surface, double fine);

  /// At the surface's own parameters, clamped to its range.
  PointNormal frame_at(const Vec2& uv) const;

  /// See jet_enclosure.h. Corners out of the surface's range count as in it.
  ///
  /// wanted   where derivatives in whole cells do not prove this, those over the facet's own
  ///          rectangle are asked
  double facet_distance(std::array<Vec2, 3> corners, const Vec3& normal, double wanted) const;

  /// Ends of the cells.
  const std::vector<double>& u_cells() const { return u_; }
  const std::vector<double>& v_cells() const { return v_; }
  const CurvatureSample& curvature(int i, int j) const { return curvatures_(i, j); }

  /// Distance to the surface it stands for.
  double error() const { return surface_.error; }

 private:
  JetEnclosure jet_over(const std::array<Vec2, 3>& corners) const;
  Vec2 clamped(const Vec2& uv) const;
  JetEnclosure jet_of_cells(const Vec2& low, const Vec2& high) const;
  std::optional<double> own_distance(const JetEnclosure& of_cells,
                                     const std::array<Vec2, 3>& corners, const Vec3& normal) const;
  void add_jumps(const Vec2& low, const Vec2& high, JetEnclosure& jet) const;
  Grid<CellJet> choose_cells(double fine);  // of each whole patch
  void enclose(const Grid<CellJet>& wholes);
  void find_jumps();

  BezierSurface surface_;
  Grid<BezierPatch> polynomials_;        // its patches, if none is rational
  std::vector<double> u_, v_;            // ends of cells
  std::vector<int> u_parts_, v_parts_;   // cells of each span
  Grid<JetEnclosure> jets_;              // of each cell, without jumps
  Grid<CurvatureSample> curvatures_;     // in the middle of each cell
  std::vector<Vec3> jumps_u_, jumps_v_;  // at each knot, the largest along it
};

}  // namespace blossom
