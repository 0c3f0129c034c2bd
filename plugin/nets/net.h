// SPDX-License-Identifier: LGPL-2.1-or-later
// One net of control points or coefficients, as `subdivide` and `convert` take and give them.

#pragma once

#include <functional>
#include <string>
#include <variant>

#include "core/blossom/triangle_blossom.h"
#include "core/forms/curve.h"
#include "core/forms/patch.h"
#include "core/forms/surface.h"
#include "core/forms/triangle.h"
#include "core/math/interval.h"
#include "core/papers/q_curve.h"
#include "core/papers/q_patch.h"

namespace blossom::nets {

using QCurve = QBezierCurveOf<Vec4>;
using QPatch = QBezierPatchOf<Vec4>;

/// All points are homogeneous, (wx, wy, wz, w).
using NetValue = std::variant<RationalBezierCurve, RationalBezierPatch, RationalBezierTriangle,
                              RationalMonomialCurve, RationalMonomialPatch, QCurve, QPatch>;

/// Of the range of parameters: what is nearer to a knot, or to an end, is that one.
inline constexpr double kOneKnot = 1e-9;

/// Where a net comes from; numbers are 1-based, 0 for none.
struct NetSource {
  std::string file;
  int face = 0;      ///< of the file's model
  int edge = 0;      ///< likewise
  int net = 0;       ///< of a file of nets
  std::string name;  ///< of the face or net; may be empty
  double error = 0;  ///< largest distance to the surface or curve it stands for, model units
};

struct Net {
  NetValue value;
  bool rational = false;  ///< otherwise every weight is 1
  /// The source's parameters where the net begins and ends; a curve has u alone. Monomial forms
  /// have their centre and scale in the same parameters.
  Interval u;
  Interval v;
  /// How these parameters run in between; of a piece of an arc only that they are angles.
  ParameterLaw u_law = ParameterLaw::Linear;
  ParameterLaw v_law = ParameterLaw::Linear;
  /// The source's parameters of a triangle's corners; without a source, or where its sides are
  /// curved in the parameters, the barycentric ones.
  TriangleCorners corners = {Vec2{1, 0}, Vec2{0, 1}, Vec2{0, 0}};
  NetSource source;
  double border_error = 0;  ///< how far its border may lie from the trims it follows, model units
};

template <class Form>
bool holds(const Net& net) {
  return std::holds_alternative<Form>(net.value);
}
inline bool is_curve(const Net& net) {
  return holds<RationalBezierCurve>(net) || holds<RationalMonomialCurve>(net) || holds<QCurve>(net);
}
inline bool is_triangle(const Net& net) { return holds<RationalBezierTriangle>(net); }

/// What ends work by an exception; none does nothing.
using Stop = std::function<void()>;

inline void ask(const Stop& stop) {
  if (stop) stop();
}

/// "wing.step: face 3" or "nets.json: net 2", for messages.
std::string text_of(const NetSource& source);

/// What to name a piece after: the source's own name, else "face 3" or "net 2".
std::string name_of(const NetSource& source);

/// Runs `work` on a net of this source; what it throws as InvalidInput or BadModel gets the source
/// in front and leaves as occt::BadModel.
template <class Work>
auto named(const NetSource& source, Work&& work) -> decltype(work());

}  // namespace blossom::nets

#include "plugin/nets/net_impl.h"
