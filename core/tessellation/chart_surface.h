// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a face as the mesher asks for it.

#pragma once

#include <array>
#include <variant>
#include <vector>

#include "core/math/grid.h"
#include "core/tessellation/charts/spline_chart.h"
#include "core/tessellation/facet_options.h"
#include "core/tessellation/shape_model.h"

namespace blossom {

/// Wanted facets per unit of the surface's parameters, constant in each cell.
struct FacetDensity {
  std::vector<double> u_ends, v_ends;  ///< of the cells, increasing
  Grid<Vec2> facets;                   ///< in u and in v; 0: none is needed
  /// Factors of the parameters with which facets are to be about equilateral.
  Vec2 scale{1, 1};
};

class ChartSurface {
 public:
  /// throws   InvalidInput if the surface is not well formed
  ChartSurface(const std::variant<ElementaryChart, BezierSurface>& surface,
               const FacetOptions& options);

  PointNormal frame_at(const Vec2& uv) const;

  /// A bound on the distance of a facet with its corners on the surface, and of the surface from
  /// facets that cover it once.
  double facet_distance(const std::array<Vec2, 3>& corners, const Vec3& normal) const;

  /// As much or more, at less cost: to compare sides of facets by.
  double rough_distance(const std::array<Vec2, 3>& corners, const Vec3& normal) const;

  /// low, high   box of the trims
  FacetDensity density(const Vec2& low, const Vec2& high) const;

  /// What the error leaves of the deviation for facets and borders, but half of it at least: where
  /// facets had to be nearer than the chords beside them, no point would do.
  double allowed() const;

  /// Distance to the surface it stands for; model units.
  double error() const;

 private:
  FacetOptions options_;
  std::variant<ElementaryChart, SplineChart> chart_;
};

}  // namespace blossom
