// SPDX-License-Identifier: LGPL-2.1-or-later
// The radius of a blend as a function of the parameter of its guide.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/math/interval.h"

namespace blossom {

/// A radius and its first two derivatives by the guide's parameter.
struct RadiusJet {
  double value = 0;  ///< model units
  double first = 0;
  double second = 0;
};

enum class LawKind {
  Constant,
  Linear,  ///< from the first radius to the last
  Smooth,  ///< the same with slopes of 0 at both ends: the cubic 3 t^2 - 2 t^3
  Table,   ///< radii at parameters, joined by the natural cubic spline
};

/// "constant", "linear", "smooth" or "table".
const char* to_string(LawKind kind);

/// r(x) over the guide's range; beside it, the polynomial of the nearest end goes on.
class RadiusLaw {
 public:
  /// All throw InvalidInput unless radii are positive and finite and the range is not empty.
  static RadiusLaw constant(double radius);
  static RadiusLaw linear(const Interval& range, double first, double last);
  static RadiusLaw smooth(const Interval& range, double first, double last);

  /// parameters   increasing, at least 2
  /// radii        as many
  /// Source: de Boor 1978, A Practical Guide to Splines, chapter 4.
  static RadiusLaw table(const std::vector<double>& parameters, const std::vector<double>& radii);

  LawKind kind() const { return kind_; }
  bool is_constant() const { return kind_ == LawKind::Constant; }
  RadiusJet at(double parameter) const;

  /// Where a derivative jumps, inside of the range: increasing. A blend has knots there.
  std::vector<double> knots() const;

  /// The least and the largest radius over a range, which may go beyond the law's own.
  Interval extremes(const Interval& range) const;

  /// The law over `range` that goes as this one goes over `part`; from > to reverses it. Equal ends
  /// make it constant.
  RadiusLaw over(const Interval& part, const Interval& range) const;

  /// The same with other derivatives at the ends of a range, which is where the law is used: the
  /// cubic is added that has these there, and no values.
  RadiusLaw with_rates(const Interval& range, double first, double last) const;

  /// Of the same kind, with the same numbers.
  bool operator==(const RadiusLaw& other) const = default;

 private:
  std::size_t piece_at(double parameter) const;

  LawKind kind_ = LawKind::Constant;
  std::vector<double> breaks_;
  std::vector<std::array<double, 4>> pieces_;  // powers of (x - break)
};

}  // namespace blossom
