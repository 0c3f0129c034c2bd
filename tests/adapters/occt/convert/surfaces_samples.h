// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves and surfaces of every type of Open CASCADE, for tests of the conversions.

#pragma once

#include <string>
#include <vector>

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "core/math/interval.h"
#include "tests/support/random.h"

namespace blossom::testing {

struct NamedCurve {
  std::string name;
  Handle(Geom_Curve) curve;
  Interval range;
  bool exact = true;
};

struct NamedSurface {
  std::string name;
  Handle(Geom_Surface) surface;
  occt::ParameterBox box;
  bool exact = true;
};

/// A frame in general position.
gp_Ax3 tilted_frame(bool left_handed = false);

/// A curve with control points in [-5, 5]^3; weights in [0.3, 3] if rational.
Handle(Geom_BezierCurve) random_bezier_curve(Random& random, int degree, bool rational);

/// Degree 3, eight control points, inner knots of multiplicity 1, 2 and 1.
Handle(Geom_BSplineCurve) random_spline_curve(Random& random, bool rational);
Handle(Geom_BSplineCurve) random_periodic_curve(Random& random, bool rational);
/// No knot has multiplicity above 1: the curve starts inside its knots.
Handle(Geom_BSplineCurve) random_unclamped_curve(Random& random);

Handle(Geom_BezierSurface)
    random_bezier_surface(Random& random, int u_degree, int v_degree, bool rational);
Handle(Geom_BSplineSurface)
    random_spline_surface(Random& random, bool rational, bool periodic_u, bool unclamped_v);

/// One of every type, natural and cut boxes.
std::vector<NamedCurve> all_curves(Random& random);
std::vector<NamedSurface> all_surfaces(Random& random);

}  // namespace blossom::testing
