// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines and conics in space, with the parameters that CAD formats give them.

#pragma once

#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

enum class ConicKind { Line, Circle, Ellipse, Parabola, Hyperbola };

/// "line", "circle", ... as in the JSON report.
const char* to_string(ConicKind kind);

/// A line or a conic over all of its parameter; of a hyperbola one branch. With X, Y unit vectors
/// at right angles and a, b the lengths `major` and `minor`:
///
///   line        C(t) = centre + t X
///   circle      C(t) = centre + a cos t X + a sin t Y
///   ellipse     C(t) = centre + a cos t X + b sin t Y,     a >= b
///   parabola    C(t) = centre + t^2 / (4 a) X + t Y,       a: from the apex to the focus
///   hyperbola   C(t) = centre + a cosh t X + b sinh t Y
///
/// These are the parameters of STEP and of Open CASCADE.
struct Conic {
  ConicKind kind = ConicKind::Line;
  Vec3 centre;       ///< of a line a point of it, of a parabola its apex; model units
  Vec3 x, y;         ///< X and Y
  double major = 0;  ///< model units
  double minor = 0;  ///< likewise; of a circle that of `major`

  bool is_closed() const { return kind == ConicKind::Circle || kind == ConicKind::Ellipse; }
  friend bool operator==(const Conic&, const Conic&) = default;
};

/// The point at a parameter, and the first two derivatives there.
Vec3 point_at(const Conic& conic, double t);
Vec3 derivative_at(const Conic& conic, double t);
Vec3 second_derivative_at(const Conic& conic, double t);

/// The parameter of a point of the conic; of one beside it, of a point not far from the nearest.
/// Angles lie in (-pi, pi].
double parameter_at(const Conic& conic, const Vec3& point);

/// The length between two parameters, model units; to 1e-12 of the lengths `major` and `minor`.
double arc_length(const Conic& conic, const Interval& range);

/// A bound on the length of the sixth derivative over a range of parameters, model units.
double sixth_derivative_bound(const Conic& conic, const Interval& range);

}  // namespace blossom
