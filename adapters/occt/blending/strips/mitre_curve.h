// SPDX-License-Identifier: LGPL-2.1-or-later
// The curve in which the strips of two balls run into each other.

#pragma once

#include <optional>

#include "adapters/occt/blending/strips/end_curves.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// The piece of the curve between two places where it is known to begin and end.
///
/// Where the contacts of both strips cross on a face the strips touch that face and each other, and
/// their common curves cross: there a search among all of them is slow and leaves gaps. This curve
/// is followed instead, from the end at which the strips cross at the larger angle, by the other
/// parameter of the first strip.
///
/// tolerance   of the curve, model units
/// returns     curves in the charts of the first strip (`on_strip`) and the second (`on_face`);
///             nothing if the strips touch at both ends, or the way does not come to the other end
std::optional<EndCurve> mitre_curve(const RolledStrip& strip, const RolledStrip& other,
                                    const Vec3& from, const Vec3& to, double tolerance);

}  // namespace blossom::occt
