// SPDX-License-Identifier: LGPL-2.1-or-later
// From what a search over pieces of a curve and cells of a surface found to their intersection.

#pragma once

#include <functional>
#include <vector>

#include "core/curves/with_surfaces/curve_in_surface.h"
#include "core/results/curve_surface_result.h"

namespace blossom {

using CloserSearch = std::function<CurveSurfaceFindings(
    const std::vector<CurveSurfaceContact>& contacts, double tolerance)>;

class CurveSurfaceAssembly {
 public:
  /// surface   the whole of what `trees` holds; its knots and closed directions are used
  CurveSurfaceAssembly(const CurveTree& curve, const BezierSurface& surface,
                       const SurfaceTrees& trees, double tolerance);

  /// closer   searches contacts again, with a smaller tolerance
  CurveSurfaceIntersection finish(const std::vector<CurveInSurface>& inside,
                                  const CurveSurfaceFindings& found, CloserSearch closer);

 private:
  enum class CloserLook { Points, Empty, Undecided };
  struct Candidate {
    SpanPoint t;
    double parameter = 0;
    int patch = 0;
    Vec2 uv;
    CurveJet on_curve;
    PatchJet on_surface;
    ValueRange gap;
    double signed_gap = 0;  // along the surface's normal
    double sine = 0;        // of the angle between curve and tangent plane
    bool touch = false, proven = false, crosses = false;
    Interval box;
    double half_length = 0;
  };

  Candidate candidate(const SpanPoint& t, int patch, const Vec2& uv) const;
  void prove(Candidate& point, const Vec3& reach) const;
  bool passes_joins(const Candidate& point, const Vec3& reach) const;
  bool is_free_border(int patch, int axis, bool high) const;
  int neighbour(int patch, int axis, bool high) const;
  bool same(const Candidate& p, const Candidate& q) const;
  void add(const Candidate& point);
  void add_inside(const std::vector<CurveInSurface>& inside);
  bool on_overlap(const Candidate& point) const;
  void add_contacts(const std::vector<CurveSurfaceContact>& contacts);
  void add_points(const std::vector<FoundCurveSurfacePoint>& points);
  void add_touches(const std::vector<CurveSurfaceTouch>& touches);
  bool in_one_run(const Candidate& p, const Candidate& q) const;
  CloserLook look_closer(const std::vector<CurveSurfaceContact>& pieces);
  void add_run(const Interval& run, const std::vector<CurveSurfaceContact>& pieces);
  void add_touch(const Interval& run, const std::vector<CurveSurfaceContact>& pieces,
                 double length);
  void add_least(const Interval& run, const Candidate& whole,
                 const std::vector<CurveSurfaceContact>& pieces, CloserLook look);
  void add_contact(double parameter, bool crosses, const Candidate& run,
                   const std::vector<CurveSurfaceContact>& pieces);
  CurvePlace place_of(const Candidate& point) const;
  Candidate nearest(double parameter, const std::vector<CurveSurfaceContact>& pieces) const;
  double root_between(double from, double to, const std::vector<CurveSurfaceContact>& pieces) const;
  void write(CurveSurfaceIntersection& result) const;

  const CurveTree& curve_;
  const BezierSurface& surface_;
  const SurfaceTrees& trees_;
  double tolerance_;
  CloserSearch closer_;
  double margin_;
  double touch_length_;
  std::vector<Candidate> points_;
  std::vector<CurveSurfaceOverlap> overlaps_;
  std::vector<CurvePlace> places_;
};

}  // namespace blossom
