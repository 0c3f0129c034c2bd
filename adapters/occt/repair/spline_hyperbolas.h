// SPDX-License-Identifier: LGPL-2.1-or-later
// Hyperbolas as splines, for files whose readers hang on them.

#pragma once

#include <vector>

#include <BRep_Curve3D.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// For as long as it lives, edges of a shape on hyperbolas have splines with the same parameters
/// instead, within 1e-9 of them: Open CASCADE never ends reading slim hyperbolas (half axes of 2e-5
/// and 0.02, say) from IGES.
class SplineHyperbolas {
 public:
  /// The shape is changed, and is as it was when this ends: nobody else may work with it. What no
  /// spline comes near enough to stays.
  explicit SplineHyperbolas(const TopoDS_Shape& shape);
  ~SplineHyperbolas();
  SplineHyperbolas(const SplineHyperbolas&) = delete;
  SplineHyperbolas& operator=(const SplineHyperbolas&) = delete;

 private:
  struct Given {
    Handle(BRep_Curve3D) of;
    Handle(Geom_Curve) curve;
  };

  std::vector<Given> given_;
};

}  // namespace blossom::occt
