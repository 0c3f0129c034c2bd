// SPDX-License-Identifier: LGPL-2.1-or-later
// What the density of facets follows: how a surface bends and how long its parameters are.

#pragma once

#include "core/math/vec.h"

namespace blossom {

/// A point of a surface, and its unit normal along S_u x S_v; zero where that vanishes.
struct PointNormal {
  Vec3 point;
  Vec3 normal;
};

/// At one point: |n S_uu|, |n S_uv|, |n S_vv|, |S_u|, |S_v|, with n the unit normal.
struct CurvatureSample {
  double uu = 0;
  double uv = 0;
  double vv = 0;
  double length_u = 0;
  double length_v = 0;
};

}  // namespace blossom
