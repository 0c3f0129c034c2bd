// SPDX-License-Identifier: LGPL-2.1-or-later
// Adaptive integration of smooth functions with few kinks.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "core/math/vec.h"

namespace blossom {

/// Of a number, or of several that are integrated together, a vector.
template <class Value>
struct IntegralOf {
  Value value{};
  Value error{};  ///< estimate, the sum over all cells; not a bound
  Value size{};   ///< integral of the absolute value, about
};

using Integral = IntegralOf<double>;

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
// A choice: a hundred kinks take a few thousand; what asks for more is noise above the tolerance,
// and would go on for 2^40 without becoming better.
inline constexpr long kMostHalvings = 1L << 14;

// Below these no halving helps: rounding of the sums, relative to the size; and a part of the
// wanted tolerance, so that noise in the function does not ask for ever smaller cells.
inline constexpr double kRounding = 1e-14;
inline constexpr double kMinPart = 1.0 / 1024;

inline double absolute(double a) { return std::abs(a); }
using blossom::absolute;

inline bool is_enough(double error, double tolerance, double least, double size) {
  return error <= std::max({tolerance, least, kRounding * size});
}

template <int Dim>
bool is_enough(const Vec<double, Dim>& error, const Vec<double, Dim>& tolerance,
               const Vec<double, Dim>& least, const Vec<double, Dim>& size) {
  for (int i = 0; i < Dim; ++i)
    if (!is_enough(error[i], tolerance[i], least[i], size[i])) return false;
  return true;
}

template <class Function>
auto cell(Function& function, double from, double to) {
  using Value = std::invoke_result_t<Function&, double>;
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  Value fine{}, coarse{}, size{};
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const bool centre = kNodes[i] == 0;
    const Value low = function(middle - half * kNodes[i]);
    const Value high = centre ? Value{} : function(middle + half * kNodes[i]);
    const Value sum = low + high;
    fine += kWeights[i] * sum;
    size += kWeights[i] * (absolute(low) + absolute(high));
    if (i % 2 == 1) coarse += kGaussWeights[i / 2] * sum;
  }
  return IntegralOf<Value>{half * fine, absolute(half * (fine - coarse)), std::abs(half) * size};
}

template <class Function, class Value>
IntegralOf<Value> halved(Function& function, double from, double to, const Value& tolerance,
                         const Value& least, int depth, long& halvings) {
  const IntegralOf<Value> whole = cell(function, from, to);
  if (is_enough(whole.error, tolerance, least, whole.size) || depth >= kDeepest || halvings <= 0)
    return whole;
  --halvings;
  const double middle = 0.5 * (from + to);
  const Value half = 0.5 * tolerance;
  const IntegralOf<Value> low = halved(function, from, middle, half, least, depth + 1, halvings);
  const IntegralOf<Value> high = halved(function, middle, to, half, least, depth + 1, halvings);
  return {low.value + high.value, low.error + high.error, low.size + high.size};
}

}  // namespace quadrature

/// The integral of `function` from `from` to `to`, in cells that are halved until the two rules
/// agree within `tolerance` in total. from > to changes the sign.
///
/// function   double -> double or a vector, finite on the interval
/// tolerance  absolute, positive, for each component; the finer rule that is returned is far better
///            than this where the function is smooth
/// halvings   how many are left, less those that are made; where none is, cells stay as they are,
///            and `error` says so
/// cost       15 calls a cell
///
/// Source: Gauss and Kronrod's pair of 7 and 15 points.
template <class Function, class Value = std::invoke_result_t<Function&, double>>
IntegralOf<Value> integral(Function&& function, double from, double to,
                           const std::type_identity_t<Value>& tolerance, long& halvings) {
  const Value least = quadrature::kMinPart * tolerance;
  return quadrature::halved(function, from, to, tolerance, least, 0, halvings);
}

/// With `kMostHalvings` of its own.
template <class Function, class Value = std::invoke_result_t<Function&, double>>
IntegralOf<Value> integral(Function&& function, double from, double to,
                           const std::type_identity_t<Value>& tolerance) {
  long halvings = quadrature::kMostHalvings;
  return integral(function, from, to, tolerance, halvings);
}

}  // namespace blossom
