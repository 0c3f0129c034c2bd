// SPDX-License-Identifier: LGPL-2.1-or-later
// Adaptive integration of smooth functions with few kinks.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace blossom {

struct Integral {
  double value = 0;
  double error = 0;  ///< estimate, the sum over all cells; not a bound
  double size = 0;   ///< integral of the absolute value, about
};

namespace quadrature {

// Nodes of the 15-point Kronrod rule on [-1, 1], the largest first; every second one is a node
// of the 7-point Gauss rule. Source: Kronrod 1965; the weights are exact for degree 22 and 13.
inline constexpr std::array kNodes{
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144691258380, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0};
inline constexpr std::array kWeights{
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
inline constexpr std::array kGaussWeights{
    0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
    0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

inline constexpr int kDeepest = 40;

// Below these no halving helps: rounding of the sums, relative to the size; and a part of the
// wanted tolerance, so that noise in the function does not ask for ever smaller cells.
inline constexpr double kRounding = 1e-14;
inline constexpr double kMinPart = 1.0 / 1024;

template <class Function>
Integral cell(Function& function, double from, double to) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double fine = 0, coarse = 0, size = 0;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const bool centre = kNodes[i] == 0;
    const double low = function(middle - half * kNodes[i]);
    const double high = centre ? 0 : function(middle + half * kNodes[i]);
    const double sum = low + high;
    fine += kWeights[i] * sum;
    size += kWeights[i] * (std::abs(low) + std::abs(high));
    if (i % 2 == 1) coarse += kGaussWeights[i / 2] * sum;
  }
  return {half * fine, std::abs(half * (fine - coarse)), std::abs(half) * size};
}

template <class Function>
Integral halved(Function& function, double from, double to, double tolerance, double least,
                int depth) {
  const Integral whole = cell(function, from, to);
  const double enough = std::max({tolerance, least, kRounding * whole.size});
  if (whole.error <= enough || depth >= kDeepest) return whole;
  const double middle = 0.5 * (from + to);
  const Integral low = halved(function, from, middle, 0.5 * tolerance, least, depth + 1);
  const Integral high = halved(function, middle, to, 0.5 * tolerance, least, depth + 1);
  return {low.value + high.value, low.error + high.error, low.size + high.size};
}

}  // namespace quadrature

/// The integral of `function` from `from` to `to`, in cells that are halved until the two rules
/// agree within `tolerance` in total. from > to changes the sign.
///
/// function   double -> double, finite on the interval
/// tolerance  absolute, positive; the finer rule that is returned is far better than this where
///            the function is smooth
/// cost       15 calls a cell
///
/// Source: Gauss and Kronrod's pair of 7 and 15 points.
template <class Function>
Integral integral(Function&& function, double from, double to, double tolerance) {
  return quadrature::halved(function, from, to, tolerance, quadrature::kMinPart * tolerance, 0);
}

}  // namespace blossom
