// SPDX-License-Identifier: LGPL-2.1-or-later
// What covers a distance that was measured at samples.

#pragma once

namespace blossom {

/// Times a distance that was measured at samples: tolerances of edges are stated with this margin,
/// and vertices cover the ends of their edges with it. A choice: between two of n samples a smooth
/// distance grows by its second difference over 8, a part of (pi / n)^2 / 2 of it.
inline constexpr double kSampledMargin = 1.1;

}  // namespace blossom
