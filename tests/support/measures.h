// SPDX-License-Identifier: LGPL-2.1-or-later
// What tests measure of Open CASCADE's shapes and points.

#pragma once

#include <numbers>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

#include "core/math/vec.h"

namespace blossom::testing {

inline constexpr double kPi = std::numbers::pi;

inline double gap(const Vec3& a, const gp_Pnt& b) { return distance(a, Vec3{b.X(), b.Y(), b.Z()}); }

inline double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

}  // namespace blossom::testing
