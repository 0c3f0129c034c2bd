// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/swept_faces.h"

#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Precision.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"

namespace blossom::occt {
namespace {

// All of a curve that has ends: faces on other parts of it are on the same surface.
CurveSpans whole_profile(const Handle(Geom_Curve) & curve, const Interval& part, double tolerance) {
  const Handle(Geom_Curve) basis = basis_of(curve);
  const Interval whole{basis->FirstParameter(), basis->LastParameter()};
  const bool endless = Precision::IsInfinite(whole.from) || Precision::IsInfinite(whole.to);
  return profile_spans(basis, endless ? part : whole, tolerance);
}

}  // namespace

std::optional<SweptProfile> swept_of(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                                     double tolerance) {
  const Handle(Geom_Surface) basis = basis_of(surface);
  try {
    if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(basis); !turned.IsNull())
      return turned_profile(whole_profile(turned->BasisCurve(), box.v, tolerance),
                            vec(turned->Location()), vec(turned->Direction().XYZ()));
    if (const auto moved = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(basis); !moved.IsNull())
      return moved_profile(whole_profile(moved->BasisCurve(), box.u, tolerance),
                           vec(moved->Direction().XYZ()));
  } catch (const BadModel&) {  // of a part of the curve without the face
  }
  return {};
}

}  // namespace blossom::occt
