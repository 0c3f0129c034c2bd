// SPDX-License-Identifier: LGPL-2.1-or-later
// The search over pairs of a piece of a curve and a cell of a surface.
//
// C(t) = S(u, v) has three equations and three unknowns. A pair is excluded when boxes or fat
// planes are apart. Where the Jacobian is regular for every matrix within the derivatives' bounds
// there is at most one common point: Newton's method finds it, or Krawczyk's operator proves that
// there is none. Pieces that run nearly along a cell are valleys. Pairs that stay within tolerance
// all over are contacts.

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/work_limit.h"
#include "core/cells/cell_pair.h"
#include "core/cells/cell_tree.h"
#include "core/cells/curve_cells.h"
#include "core/curves/with_surfaces/curve_surface_valley.h"
#include "core/forms/surface.h"
#include "core/results/options.h"

namespace blossom {

/// A surface as the cells of its patches, relative to an origin.
class SurfaceTrees {
 public:
  SurfaceTrees(const BezierSurface& surface, const Vec3& origin, CellForm form);

  int count() const { return static_cast<int>(trees_.size()); }
  CellTree& operator[](int patch) { return *trees_[static_cast<std::size_t>(patch)]; }
  const CellTree& operator[](int patch) const { return *trees_[static_cast<std::size_t>(patch)]; }

  /// The surface's own parameters of a place on a patch.
  Vec2 parameters(int patch, const Vec2& uv) const;

  /// Bound on the error of a coordinate of a point, model units.
  double evaluation_margin() const { return evaluation_margin_; }

 private:
  const BezierSurface& surface_;
  std::vector<std::unique_ptr<CellTree>> trees_;
  double evaluation_margin_ = 0;
};

/// A piece of the curve and a cell within tolerance of each other.
struct CurveSurfaceContact {
  int span = 0;
  Interval t;  ///< local parameters
  int patch = 0;
  Interval u, v;
  int cell = -1;  ///< indices in the trees; -1: not a cell
  int surface_cell = -1;
};

struct CurveSurfaceFindings {
  std::vector<FoundCurveSurfacePoint> points;
  std::vector<CurveSurfaceTouch> touches;
  std::vector<CurveSurfaceContact> contacts;
  std::vector<CurveSurfaceContact> open;  ///< not examined when the search was stopped
  long excluded = 0;
  long certified = 0;
  const char* stopped = nullptr;  ///< why
};

class CurveSurfaceSearch {
 public:
  CurveSurfaceSearch(CurveTree& curve, SurfaceTrees& surface, SharedWork& work, double tolerance);

  /// All pairs; pieces of the curve in `inside` lie in the surface, and only common points
  /// elsewhere are sought.
  CurveSurfaceFindings run(const std::vector<CurveSurfaceContact>& inside);

  /// The same within contacts that a search with a larger tolerance has left.
  CurveSurfaceFindings run_within(const std::vector<CurveSurfaceContact>& contacts,
                                  const std::vector<CurveSurfaceContact>& inside);

 private:
  struct Pair {
    int cell;
    int patch;
    int surface_cell;
  };

  void work_off();
  void examine(const Pair& pair);
  void halve(const Pair& pair, bool curve);
  bool separated(const CurveCell& c, const Cell& s) const;
  bool within_slab(const CurveCell& c, const Cell& s) const;
  enum class Over { All, Part, None, Unknown };
  Over over(const CurveCell& c, const Cell& s, const RationalBezierPatch& patch) const;
  bool is_inside(const CurveCell& c, const Pair& pair, const Cell& s) const;
  VectorBounds derivative(const CurveCell& c) const;
  bool settle(const CurveCell& c, const Pair& pair, const Cell& s);
  bool settle_valley(const CurveCell& c, const Pair& pair, const Cell& s);
  bool krawczyk_empties(const CurveCell& c, int patch, const Cell& s, const Minor& minor) const;
  CurveSurfaceContact contact(const Pair& pair) const;

  CurveTree& curve_;
  SurfaceTrees& surface_;
  SharedWork& work_;
  double tolerance_;
  CurveSurfaceValleyOptions valley_;
  const std::vector<CurveSurfaceContact>* inside_ = nullptr;
  std::vector<Pair> pairs_;
  CurveSurfaceFindings found_;
};

/// Newton's method for C(t) = S(u, v).
///
/// returns   the solution, clamped to the span and the patch only by the caller; nothing if the
///           steps do not settle or leave the given ranges blown up to twice their size
struct CurveSurfaceParameters {
  double t;
  Vec2 uv;
};
std::optional<CurveSurfaceParameters> curve_surface_point(const CurveTree& curve, int span,
                                                          const Interval& t,
                                                          const RationalBezierPatch& patch,
                                                          const Interval& u, const Interval& v);

}  // namespace blossom
