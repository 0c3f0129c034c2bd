// SPDX-License-Identifier: LGPL-2.1-or-later
// The search over pairs of cells: exclude, certify, or halve.
//
// Every pair of cells ends as one of three: proven empty, certified with its arcs, or critical.
// Nothing else happens to a pair, so together they account for all of both surfaces.

#pragma once

#include <memory>
#include <vector>

#include "core/forms/surface.h"
#include "core/intersection/border_roots.h"
#include "core/intersection/cell_tree.h"
#include "core/intersection/options.h"
#include "core/intersection/result.h"

namespace blossom {

/// A surface as cell trees of its patches, made when first asked for.
class SurfaceCells {
 public:
  SurfaceCells(const BezierSurface& surface, const Vec3& origin, CellForm form, double cut);

  CellTree& tree(int patch);

  int patches() const { return static_cast<int>(trees_.size()); }
  const BezierSurface& surface() const { return surface_; }
  int span_u(int patch) const { return patch / surface_.patches.columns(); }
  int span_v(int patch) const { return patch % surface_.patches.columns(); }
  Interval knots_u(int patch) const;
  Interval knots_v(int patch) const;

  /// Cells made so far, and their control points in memory.
  long cells() const;
  long stored_points() const;
  bool monomial() const;

 private:
  const BezierSurface& surface_;
  Vec3 origin_;
  CellForm form_;
  double cut_;
  std::vector<std::unique_ptr<CellTree>> trees_;
};

/// An arc of the intersection in a pair of patches.
struct FoundArc {
  int patch_a = 0;
  int patch_b = 0;
  Box4 box;  ///< the certified pair it lies in
  CellArc arc;
};

/// A point where the intersection passes a corner of a pair without entering it.
struct FoundGraze {
  int patch_a = 0;
  int patch_b = 0;
  Point4 x;
};

/// A pair of cells that could be neither excluded nor certified.
struct CriticalPair {
  int patch_a = 0;
  int patch_b = 0;
  Box4 box;
  Vec3 low, high;     ///< the common part of their boxes, relative to the origin
  bool thin = false;  ///< the surfaces stay within tolerance of each other in it
};

struct PairSearchResult {
  std::vector<FoundArc> arcs;
  std::vector<FoundGraze> grazes;
  std::vector<CriticalPair> critical;
  Certificate certificate;
  bool along_border = false;  ///< an arc runs along a border; see PairArcs
  bool stopped = false;
};

/// Examines all pairs of patches of the two surfaces.
PairSearchResult search_pairs(SurfaceCells& a, SurfaceCells& b, const IntersectionOptions& options);

}  // namespace blossom
