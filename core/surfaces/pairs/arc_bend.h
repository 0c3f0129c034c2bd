// SPDX-License-Identifier: LGPL-2.1-or-later
// Which way the arc of a certified pair bends.

#pragma once

#include <optional>

#include "core/cells/pair_model.h"
#include "core/math/interval.h"
#include "core/surfaces/pairs/arc_stretches.h"

namespace blossom {

/// Bounds of the second derivative of one of an arc's parameters by another over a stretch, both
/// the cells' own. With z' and z'' by z_k, so that z'_k = 1 and z''_k = 0,
///
///   J z' = 0,  J z'' = -(A_uu u'^2 + 2 A_uv u' v' + A_vv v'^2) + (B_ss s'^2 + 2 B_st s' t' + B_tt
///   t'^2)
///
/// for all matrices and second derivatives within their bounds.
///
/// along     k, the arc's parameter
/// returns   nothing where J is not known well enough
std::optional<Interval> bend_over(const PairModel& model, const ArcStretch& stretch, int along,
                                  int parameter);

}  // namespace blossom
