// SPDX-License-Identifier: LGPL-2.1-or-later
// Forms of faces that take long to make, made once for several questions.

#pragma once

#include <mutex>

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Face.hxx>

#include "core/forms/surface.h"

namespace blossom::occt {

/// What questions that must not tell near from touching ask of forms that have to be approximated,
/// model units: a fifth of the usual tolerance.
inline constexpr double kFineForm = 2e-8;

/// Approximated forms of faces within kFineForm. For as long as no shape changes.
class KeptForms {
 public:
  /// Converts a face, and keeps the form if it is approximated: others are soon made again.
  /// throws   as bezier_surface
  void make(const TopoDS_Face& face);

  /// The form that is kept of a face, which then is gone, or one that is made now.
  /// throws   as bezier_surface
  BezierSurface take(const TopoDS_Face& face);

 private:
  std::mutex mutex_;
  NCollection_DataMap<TopoDS_Shape, BezierSurface, TopTools_ShapeMapHasher> forms_;
};

}  // namespace blossom::occt
