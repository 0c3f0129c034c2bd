// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and vectors of Open CASCADE as core's, and back.

#pragma once

#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <gp_XYZ.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

inline Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 vec(const gp_Pnt& p) { return vec(p.XYZ()); }
inline Vec3 vec(const gp_Vec& v) { return vec(v.XYZ()); }
inline Vec2 vec(const gp_Pnt2d& p) { return {p.X(), p.Y()}; }

inline gp_Pnt pnt(const Vec3& p) { return {p[0], p[1], p[2]}; }

/// throws   Standard_ConstructionError if all components are nearly 0
inline gp_Dir dir(const Vec3& d) { return {d[0], d[1], d[2]}; }

}  // namespace blossom::occt
