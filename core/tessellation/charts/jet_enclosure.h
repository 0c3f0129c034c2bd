// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a flat facet is from a surface whose derivatives are enclosed.
//
// With corners a_i in the parameters and barycentric coordinates l_i of x = sum l_i a_i, Taylor's
// formula at x gives
//
//   L(x) - S(x) = 1/2 sum_i l_i S''(xi_i)[a_i - x, a_i - x],       L = sum l_i S(a_i)
//
// and for a constant second derivative M this is 1/2 sum_{i<j} l_i l_j M[a_i - a_j, a_i - a_j].
// Enclosures are M plus a rest R of bounded size, for which (l_u^2 R_uu + 2 l_u l_v R_uv + l_v^2
// R_vv) / 8 bounds the sum, with l_u, l_v the facet's extent (Filip, Magedson, Markot 1986).
//
// A form Q that leaves a rest within E takes the place of M, and 2 E that of R.
//
// Only the part along the normal n is a distance: what is across it moves points within the
// surface. With t the size of the part across, the parameters that cancel it are within
//
//   d_u = t |S_v| / m,  d_v = t |S_u| / m,       m <= n (S_u x S_v)
//
// and moving there changes the height by at most |n S_u| d_u + |n S_v| d_v and the second
// derivatives by 1/2 S''[d, d]. Facets from the surface need them once, the surface from facets
// twice and four times, as the facets' own slopes come in.

#pragma once

#include <array>
#include <optional>

#include "core/math/vec.h"

namespace blossom {

/// All vectors c + e with |e_k| <= r_k.
struct VectorRange {
  Vec3 centre;
  Vec3 radius;

  /// Largest |v| of the range.
  double size() const { return norm(absolute(centre) + radius); }
  /// Largest |n v - n c|.
  double spread_along(const Vec3& n) const { return dot(absolute(n), radius); }
  /// Largest |n v|.
  double size_along(const Vec3& n) const { return std::abs(dot(n, centre)) + spread_along(n); }
};

/// The smallest range that holds both.
VectorRange united(const VectorRange& a, const VectorRange& b);

/// A bound on |a x b| from below, with a and b anywhere in two ranges.
double least_area(const VectorRange& a, const VectorRange& b);

/// Derivatives of a surface over a rectangle of its parameters.
struct JetEnclosure {
  VectorRange uu, uv, vv;
  double length_u = 0;  ///< largest |S_u|
  double length_v = 0;
  double jacobian = 0;  ///< at most |S_u x S_v|; 0 if not known
  /// Sums of |jump of S_u|, |jump of S_v| at knots inside, by coordinate.
  Vec3 jump_u, jump_v;
};

/// A surface over a rectangle beside a quadratic form (quadratic_rest.h).
struct QuadraticRest {
  Vec3 uu, uv, vv;   ///< second derivatives of the form
  Vec3 rest;         ///< by coordinate, what the surface less the form is off an affine one at most
  VectorRange u, v;  ///< first derivatives of the surface
};

JetEnclosure united(const JetEnclosure& a, const JetEnclosure& b);

/// The largest value of sum_{i<j} l_i l_j q_ij over l_i >= 0 with sum 1, where a = q_23, b = q_13,
/// c = q_12; at most that if some are negative. For squares of lengths it is the square of the
/// radius of the circle through the corners, or of half the longest side.
double largest_mean(double a, double b, double c);

/// A bound on the distance of each point of a facet from the surface, and the other way round
/// where facets cover a region once.
///
/// jet       over the facet
/// n         about the unit normal
/// corners   in the parameters; two may be equal
/// form      over the facet, too, if it is known: of two bounds the lower one counts
double facet_distance(const JetEnclosure& jet, const Vec3& n, const std::array<Vec2, 3>& corners,
                      const std::optional<QuadraticRest>& form = {});

}  // namespace blossom
