// SPDX-License-Identifier: LGPL-2.1-or-later
// Area, volume, centre of gravity and inertia of bodies, by integration over their faces.

#pragma once

#include <TopoDS_Shape.hxx>

#include "core/base/work_limit.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// Of a body of density 1; of a surface, which has no inside, of area density 1.
struct Mass {
  bool is_solid = false;
  double area = 0;    ///< of all faces, square model units
  double volume = 0;  ///< cubic model units; negative if the faces are turned inwards
  Vec3 centre;        ///< of gravity, model units
  /// The moments of a solid about axes through its centre, model units^5: the integrals of
  /// y^2 + z^2, x^2 + z^2, x^2 + y^2 (xx, yy, zz), and of -x y, -x z, -y z (xy, xz, yz).
  Vec<double, 6> inertia;

  /// Adds a body that has no point inside in common with this one. Solids and surfaces do not mix.
  Mass& operator+=(const Mass& other);
};

/// One closed solid, or faces that bound none.
///
/// accuracy   1e-10 of the area; of the volume and the moments 1e-10 of their integrals' absolute
///            values over the faces. Where faces end beside their common edge, strips of straight
///            lines to its curve close the shell (faces/border_strips.h)
/// limit      asked before each face; null: none
/// throws     LimitFailure when it is reached; BadModel as `area` (faces/area.h)
///
/// Source: the divergence theorem, over cones from one point to all faces.
Mass mass_of(const TopoDS_Shape& body, const WorkLimit* limit = nullptr);

}  // namespace blossom::occt
