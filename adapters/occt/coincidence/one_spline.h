// SPDX-License-Identifier: LGPL-2.1-or-later
// Two faces on one B-spline or Bezier surface, told by its control points.

#pragma once

#include <optional>

#include <TopoDS_Face.hxx>

#include "core/results/options.h"

namespace blossom::occt {

/// A bound on the distance of the faces' surfaces, model units, where the faces have nothing in
/// common but what their outlines leave of both.
///
/// The surfaces are one if their control points agree, or those of one with the other's over the
/// bounds of the first, in the same parameters; spans lie alike. It is proven that they do not meet
/// themselves, since faces on two sheets of one surface may meet there.
///
/// a, b      naturally bounded or not
/// options   the tolerance is that of the proof, and control points agree within it
/// returns   nothing if the surfaces are not both B-splines or Bezier surfaces, or it is not known
/// throws    BadModel if a surface cannot be converted
std::optional<double> gap_of_one_spline(const TopoDS_Face& a, const TopoDS_Face& b,
                                        const IntersectionOptions& options);

}  // namespace blossom::occt
