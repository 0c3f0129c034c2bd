// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves and edges beside a surface that they may lie on, and their images in its chart.

#pragma once

#include <optional>
#include <vector>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/face_splitter.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// A curve with its images in the chart of a surface.
struct CurveOnSurfaceJet {
  Vec3 point, rate;
  Vec2 uv, uv_rate;  ///< of the surface
};

/// A curve seen on a surface beside it. The feet have to live as long.
class CurveBeside {
 public:
  /// The image of an edge's chart curve on its own face.
  /// throws   BadModel if it has none
  CurveBeside(const TopoDS_Edge& edge, const TopoDS_Face& face, const SurfaceProjector& feet);

  /// A curve in space.
  CurveBeside(Handle(Geom_Curve) curve, const Interval& range, const SurfaceProjector& feet);

  const Interval& range() const { return range_; }
  CurveOnSurfaceJet jet(double t, const std::optional<Vec2>& near) const;

  /// The same at an end of a run. In a pole of the surface, where one parameter is free, it is that
  /// which the curve has on its way there.
  /// inner   a parameter inside of the run
  CurveOnSurfaceJet end_jet(double end, double inner, const std::optional<Vec2>& near) const;

  /// The parts of a run between the poles of the surface that it goes through.
  std::vector<Interval> between_poles(const Interval& run) const;

  /// The parameters between which it is within reach of the surface and no farther past its border
  /// than a given length: found from samples, ends by halving.
  std::vector<Interval> runs(double reach, double past) const;

  /// Whether all of it is one such run. Where an end is in none, nothing else is looked at.
  bool is_one_run(double reach, double past) const;

  /// Pieces of degree 5 with the values and first two derivatives of the curve and of its image, as
  /// many as they need to be as near to these as wanted, at most 512 between knots.
  /// throws   Failure if they are farther off than the tolerance
  FaceCut fitted_cut(const Interval& run, double wanted, double tolerance) const;

 private:
  CurveOnSurfaceJet in_space(double t) const;  // without its images
  Vec3 bend(double t) const;                   // the second derivative
  CurveOnSurfaceJet pole_jet(const SurfacePole& pole, double t, const Vec2& beside) const;
  struct Standing {
    Vec3 point;
    double gap = 0;        // to the surface
    double clearance = 0;  // of its foot from the border, as SurfaceProjector has it
  };
  struct RunLimits {
    double reach = 0, past = 0;
    bool hold(const Standing& at) const { return at.gap <= reach && at.clearance >= -past; }
  };
  Standing standing(double t) const;
  bool lies_on(double t, const RunLimits& limits) const;
  double run_end(double on, double off, RunLimits limits) const;
  double least_clearance(Interval around) const;
  std::vector<double> joints(const Interval& run) const;
  void add_knot_lines(const Interval& run, std::vector<double>& joints) const;
  std::optional<Vec2> uv_bend(const CurveOnSurfaceJet& at, double t) const;
  FaceCut hermite_cut(const std::vector<double>& ends, double tolerance) const;
  double off(const FaceCut& cut, double t) const;

  const SurfaceProjector& feet_;
  Handle(Geom_Surface) surface_;  // with chart_, or else curve_
  Handle(Geom2d_Curve) chart_;
  Handle(Geom_Curve) curve_;
  Interval range_;
};

/// The edges of a face as cuts of another one, as far as they lie on its surface, divided at its
/// poles. Seams are none.
/// feet      of the face to be cut
/// reach     how near counts as on the surface, model units
std::vector<FaceCut> edge_cuts(const TopoDS_Face& face, const SurfaceProjector& feet, double reach,
                               double tolerance);

/// A curve on a surface in its chart, with the same parameter.
struct ChartImage {
  Handle(Geom2d_Curve) chart;
  double deviation = 0;  ///< largest sampled distance, model units
};

/// Exact where Open CASCADE knows a line, a conic or a spline that is the image, else fitted.
/// near      parameters of the middle, as far as periods and seams leave a choice
/// throws    Failure if no chart comes as near to the curve's feet as the tolerance, or it goes
/// through a pole; whether the curve is on the surface the deviation says
ChartImage image_of(const Handle(Geom_Curve) & curve, const Interval& range,
                    const SurfaceProjector& feet, const std::optional<Vec2>& near,
                    double tolerance);

}  // namespace blossom::occt
