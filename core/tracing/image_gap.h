// SPDX-License-Identifier: LGPL-2.1-or-later
// The distance of a curve from the image of its chart curve, as a Bezier form.
//
// On a piece that stays in one patch, S(p(t)) - C(t) is the patch composed with the chart curve,
// less the curve: a form whose control points bound it. A polynomial of low degree takes its place
// within a proven error: of the composition and of a weight's inverse as power series
// (`core/tracing/image_series.h`), of an angle (`core/tracing/local_form.h`).

#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "core/forms/surface.h"
#include "core/tracing/image_series.h"
#include "core/tracing/local_form.h"
#include "core/tracing/spline_fit.h"

namespace blossom {

/// E(t) = S(p(t)) - C(t) on a piece: |E - form| <= relative |E| + margin.
struct ImageGap {
  SeriesForm form;      ///< model units
  double relative = 0;  ///< below 1
  double margin = 0;    ///< model units; rounding included
};

/// Gaps between a curve and its images on one surface. The surface has to outlive it.
class ImageGaps {
 public:
  /// chart   place of the surface's parameters in the seven coordinates: 3 or 5
  ImageGaps(const BezierSurface& surface, int chart);

  /// Appends the parameters in (0, 1) where the chart curve passes into another patch, found to
  /// rounding; perhaps also some where it does not.
  void add_cuts(const QuinticPoints& points, std::vector<double>& cuts) const;

  /// The gap over [0, 1].
  ///
  /// halvings   of a span until this piece; for the rounding of its points
  /// returns    nothing if the piece is too long, or leaves its patch by more than 1e-3 of it
  std::optional<ImageGap> on(const QuinticPoints& piece, int halvings);

 private:
  /// Bounds on |S_u| and |S_v| over a patch, by its local parameters.
  struct Slopes {
    double u = 0, v = 0;
  };

  static Slopes slopes_of(const RationalBezierPatch& patch);
  const Slopes& slopes(int i, int j);
  Slopes slopes_beside(int i, int j);
  std::optional<ImageGap> composed(const RationalBezierPatch& patch, const LocalForm& u,
                                   const LocalForm& v, const QuinticPoints& piece, double rounding,
                                   std::size_t degree) const;

  const BezierSurface& surface_;
  const int first_;
  bool short_series_;                            // has been enough for all pieces so far
  std::map<std::array<int, 2>, Slopes> slopes_;  // of the patches that pieces came to
};

}  // namespace blossom
