// SPDX-License-Identifier: LGPL-2.1-or-later
// A strip between two surfaces that meets both of them with a common tangent plane, exactly.
//
// The strip B(x, y) is cubic in y. Its first row is a border of surface a, its last row a border
// of surface b, and the rows next to them continue the surfaces across these borders. Everything
// is a product of polynomials, so edges and tangent planes agree to rounding, without fitting.
//
// Notation: E(x) the border curve and D(x) the derivative across it, both homogeneous
// (wx, wy, wz, w); D points out of the surface and is taken by the surface's own parameter.

#pragma once

#include <array>

#include "core/blending/surface_side.h"
#include "core/forms/surface.h"

namespace blossom {

/// How the parameters of the two borders correspond.
enum class Pairing {
  Nearest,   ///< the way that brings corresponding ends nearer; inner points decide a tie
  Forward,   ///< both in the direction of growing parameters
  Backward,  ///< the border of b runs backwards
};

struct StripOptions {
  Pairing pairing = Pairing::Nearest;

  /// Length factors: how far each surface's tangents reach into the strip, as a multiple of a
  /// third of the mean distance between the borders. Positive, dimensionless.
  double weight_a = 1;
  double weight_b = 1;
};

/// How well the strip meets one of the surfaces, measured at 33 parameters of every span.
struct StripContact {
  double gap = 0;           ///< largest distance between the borders, model units
  double normal_angle = 0;  ///< largest angle between the normals, radians, in [0, pi / 2]
  double scale = 0;         ///< the constant s in B_y = s D, by the surface's own parameter
};

struct Strip {
  BezierSurface surface;  ///< u along the borders, v from a to b; both ranges are [0, 1]
  bool backward = false;  ///< the border of b runs backwards
  std::array<StripContact, 2> contacts{};  ///< with a, with b
};

/// The strip from one border of `a` to one border of `b`.
///
///   B(x, 0) = E_a(x),   B_y(x, 0) =  s_a D_a(x)  modulo E_a(x)
///   B(x, 1) = E_b(x),   B_y(x, 1) = -s_b D_b(x)  modulo E_b(x)
///
///   (1) the first and the last row are the borders, degrees raised and knots inserted to meet
///   (2) along both the normals are those of the surfaces
///   (3) the strip leaves a and enters b outwards: it never folds back at a border
///
/// Where the weights of a side are not a product of a function of u and a function of v, the rows
/// of that side are multiplied by the border's weight; this doubles the degree along it.
///
/// a, b      surfaces, model units
/// returns   the strip; its degree along the borders is the larger of the two sides' degrees
/// throws    InvalidInput if a surface is not well formed, a weight is not positive and finite,
///           a border is a point, the borders coincide, the derivative across a border vanishes
///           along all of it, or the degree would exceed kMaxDegree
/// accuracy  gap: strip_gap_bound(surface); normals: a rounding error of that size in rows that
///           lie `scale` |D| / 3 apart
///
/// Source: Farin 2002, "Curves and Surfaces for CAGD", composite surfaces (cubic cross-boundary
/// Hermite data); Vlachkova 2025, Theorem 1, for the pieces between inserted knots.
Strip strip_between(const BezierSurface& a, SurfaceSide side_a, const BezierSurface& b,
                    SurfaceSide side_b, const StripOptions& options = {});

/// How well a surface with the spans of a strip meets the borders; for a strip that went through
/// other hands. `scale` stays 0.
/// throws    InvalidInput if a surface is not well formed or the strip has other spans
std::array<StripContact, 2> strip_contacts(const BezierSurface& strip, const BezierSurface& a,
                                           SurfaceSide side_a, const BezierSurface& b,
                                           SurfaceSide side_b, bool backward);

/// Bound on the gap between a strip and its neighbours, model units: (24 n + 32) u times the
/// largest coordinate, n the degree along the borders and u = 2^-53. A row goes through at most
/// two cuts and two products, each of 3 n roundings, and all weights of a row are of one size.
double strip_gap_bound(const BezierSurface& strip);

/// The mean distance between corresponding points of two borders, in the nearer pairing.
/// Model units; throws InvalidInput if a surface is not well formed.
double border_distance(const BezierSurface& a, SurfaceSide side_a, const BezierSurface& b,
                       SurfaceSide side_b);

}  // namespace blossom
