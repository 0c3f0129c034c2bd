// SPDX-License-Identifier: LGPL-2.1-or-later
// A strip between two borders of surfaces that continues both exactly: their tangent planes, their
// curvatures, or the derivatives of these.
//
// Of order k the strip B(x, y) has degree 2k + 1 in y. Its first row is a border of surface a, its
// last row a border of surface b, and the k rows next to each continue the surface across it.
// Everything is a product of polynomials, so nothing is fitted.
//
// Notation: E(x) the border curve and D_j(x) the j-th derivative across it, both homogeneous
// (wx, wy, wz, w); D_j leads out of the surface.

#pragma once

#include <array>
#include <span>

#include "core/blending/border_rows.h"
#include "core/blending/continuity/continuity.h"
#include "core/blending/surface_side.h"
#include "core/forms/surface.h"

namespace blossom {

/// How the parameters of the two borders correspond.
enum class Pairing {
  Nearest,   ///< the way that brings corresponding ends nearer; inner points decide a tie. Of two
             ///< closed borders the second one starts where it is nearest, on average, to the first
  Forward,   ///< both in the direction of growing parameters
  Backward,  ///< the border of b runs backwards
};

/// Highest order of a strip: the derivative of the curvature is continuous.
inline constexpr int kMaxStripOrder = 3;

struct StripOptions {
  Pairing pairing = Pairing::Nearest;
  int order = 1;  ///< 1 to kMaxStripOrder: continuous tangent planes (G1), curvatures (G2), G3

  /// Length factors: how far each surface's tangents reach into the strip, as a multiple of the
  /// mean distance between the borders over the strip's degree. Positive, dimensionless.
  double weight_a = 1;
  double weight_b = 1;
};

/// How well the strip meets one of the surfaces: the largest at samples, as in continuity.h.
struct StripContact {
  double gap = 0;           ///< distance between the borders, model units
  double normal_angle = 0;  ///< angle between the normals, radians
  double curvature = 0;     ///< relative difference of curvatures
  double scale = 0;         ///< the constant s below, by the surface's own parameter
};

struct Strip {
  BezierSurface surface;  ///< u along the borders, v from a to b; both ranges are [0, 1]
  bool backward = false;  ///< the border of b runs backwards
  double start_b = 0;     ///< where on the border of b the strip starts, if that is closed
  std::array<StripContact, 2> contacts{};  ///< with a, with b
};

/// The strip from one border to another.
///
///   d^j B / dy^j (x, 0) = s_a^j D_j of a,    d^j B / dy^j (x, 1) = (-s_b)^j D_j of b,   j = 0..k,
///
/// both up to a factor f(x, y) with f = 1 on the border, which leaves the surface as it is:
///
///   (1) the first and the last row are the borders, degrees raised and knots inserted to meet
///   (2) along both the normals are those of the surfaces, and for k = 2 the curvatures, and for
///       k = 3 their derivatives
///   (3) the strip leaves a and enters b outwards: it never folds back at a border
///
/// The factor is chosen such that all rows of a side have the weights of its border. Where the
/// weights of a side are not a product of a function of u and a function of v, that takes a factor
/// of the border's weight for each order: the degree along it is k + 1 times the border's.
///
/// a, b      borders with rows of order k and of at least 2, model units
/// returns   the strip; its degree along the borders is the larger of the two sides' degrees
/// throws    InvalidInput if an option is out of range, rows are missing, a border is a point, the
///           borders coincide, the derivative across a border vanishes along all of it, or the
///           degree would exceed kMaxDegree
/// accuracy  gap: strip_gap_bound(surface); normals: a rounding error of that size in rows that
///           lie `scale` |D_1| / (2k + 1) apart
///
/// Source: Farin 2002, "Curves and Surfaces for CAGD", composite surfaces (cross-boundary Hermite
/// data); Vlachkova 2025, Theorem 1, for the pieces between inserted knots.
Strip strip_between(const Border& a, const Border& b, const StripOptions& options = {});

/// The same between borders of surfaces.
/// throws    InvalidInput also if a surface is not well formed
Strip strip_between(const BezierSurface& a, SurfaceSide side_a, const BezierSurface& b,
                    SurfaceSide side_b, const StripOptions& options = {});

/// How well a surface with the spans of a strip meets the borders, which have rows of order 2; for
/// a strip that went through other hands. `scale` stays 0.
/// throws    InvalidInput if the strip has other spans
std::array<StripContact, 2> strip_contacts(const BezierSurface& strip, const Border& a,
                                           const Border& b, bool backward, double start_b = 0);

/// The same at one side of a strip, VMin or VMax, for any face beside it.
/// beside    by the strip's u; the face is smooth between the breaks, which are those of u too
StripContact strip_contact(const BezierSurface& strip, SurfaceSide side, const EdgeSides& beside,
                           std::span<const double> breaks);

/// Bound on the gap between a strip and its neighbours, model units: (24 n + 32) u times the
/// largest coordinate, n the degree along the borders and u = 2^-53. A row goes through at most
/// two cuts and one product for each order, each of 3 n roundings of its own degree, and all
/// weights of a row are of one size.
double strip_gap_bound(const BezierSurface& strip);

/// The mean distance between corresponding points of two borders, in the nearer pairing.
/// Model units.
double border_distance(const Border& a, const Border& b);

}  // namespace blossom
