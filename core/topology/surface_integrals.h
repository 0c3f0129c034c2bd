// SPDX-License-Identifier: LGPL-2.1-or-later
// Integrals over trimmed surfaces: area, volume and moments under them, accurate enough to see that
// pieces add up.
//
//   integral over the chart of f(S, S_u x S_v) = integral along the loops of F dv,
//   F(u, v) = integral from the chart's left end to u of f(s, v) ds   (Green)
//
// Both integrals are adaptive and start from cells between the knots. Source: Green's theorem;
// `core/math/functions/quadrature.h`.

#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/forms/surface.h"
#include "core/math/vec.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// How an area or the volume of a cone runs along a surface's own lines. Along v it is constant
/// where that is a length along parallel straight lines; along u it is a + b cos u + c sin u where
/// all turns about one axis with u: points and normals turn alike. On a plane it is one constant.
enum class DensityLines { Any, Even, Turning, Constant };

/// A surface as integrals ask for it, over a box of its own parameters that holds the trims as far
/// as the surface goes.
struct IntegrandSurface {
  /// The surface over the box; without patches where `jet` is as quick, or no exact form is known.
  BezierSurface spans;
  std::function<SurfaceJet(const Vec2& uv)> jet;  ///< asked only where `spans` has no patches
  std::vector<double> u_knots, v_knots;  ///< where it is less than smooth, with the ends of the box
  DensityLines lines = DensityLines::Any;
};

/// Square model units.
///
/// cells     cells that each span starts with; more of them check the result
/// accuracy  1e-10 relative where the surface is smooth between its knots, and less where it is
///           rougher than some 260 000 halvings of cells resolve, or its density is noise; gaps of
///           loops in the chart within the edges' tolerances count for what they are
double trimmed_area(const IntegrandSurface& surface, const FaceTrims& trims, int cells = 1);

/// The volume of the cone from a point over the surface, cubic model units; positive where
/// S_u x S_v points away from the apex.
///
///   V = integral over the chart of (S - apex) . (S_u x S_v) / 3
///
/// enough     an error that does not matter, of each of the integrals that are added up, cubic
///            model units; 0: none
/// accuracy   as the area, relative to the integral of the integrand's absolute value, and 1e-12 of
///            the area times the coordinates
double trimmed_cone_volume(const IntegrandSurface& surface, const FaceTrims& trims,
                           const Vec3& apex, double enough = 0);

/// Moments of the cone from a point over a surface, with the sign of its volume. Those of the cones
/// of a closed shell add up to those of what it encloses.
///
///   first    integral of r over the cone      = integral over the chart of 3/4 s  (s . N) / 3
///   second   integral of r r^T over the cone  = integral over the chart of 3/5 s s^T (s . N) / 3
///
/// where r and s = S - apex are taken from the apex, and N = S_u x S_v.
struct ConeMoments {
  double volume = 0;      ///< cubic model units
  Vec3 first;             ///< model units^4
  Vec<double, 6> second;  ///< model units^5: xx, yy, zz, xy, xz, yz

  ConeMoments& operator+=(const ConeMoments& other);
  ConeMoments operator-() const { return {-volume, -first, -second}; }
};

/// What is integrated for these, at a point with the normal there times its share of the area.
ConeMoments cone_density(const Vec3& point, const Vec3& normal, const Vec3& apex);

/// accuracy   1e-10 of the integrals of the integrands' absolute values, as the area
ConeMoments trimmed_cone_moments(const IntegrandSurface& surface, const FaceTrims& trims,
                                 const Vec3& apex);

/// The integral of S - origin, model units^3: the area times what its centre is from there.
/// accuracy   as the moments
Vec3 trimmed_area_moment(const IntegrandSurface& surface, const FaceTrims& trims,
                         const Vec3& origin);

/// About the area within a closed polygon in the parameters of a surface, for summaries.
///
///   A = sum over the fan of triangles from the first corner of the integral of |S_u x S_v|, with
///       the triangles' signs
///
/// jet       of the surface
/// polygon   repeats its first corner; several loops one after the other as `joined_loops` makes
/// accuracy  that of the polygon, and of taking the middle line of each triangle for all of it
double polygon_area(const std::function<SurfaceJet(const Vec2& uv)>& jet,
                    std::span<const Vec2> polygon);

}  // namespace blossom
