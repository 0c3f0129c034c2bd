// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/coincidence/one_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/base/limits.h"
#include "adapters/occt/coincidence/trimmed_overlaps.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/pairs/edge_contacts.h"
#include "adapters/occt/faces/pairs/run_curves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"
#include "core/math/segment.h"
#include "core/neighbours/along_shared_edges.h"
#include "core/results/contact_places.h"

namespace blossom::occt {
namespace {

// The direction from an edge into its face, at a parameter of the edge.
Vec3 inwards(const OutlineEdge& of, const Handle(Geom_Surface) & surface, double t) {
  gp_Pnt2d uv;
  gp_Vec2d step;
  of.chart->D1(t, uv, step);
  const SurfaceJet frame = frame_at(surface, {uv.X(), uv.Y()});
  const Vec3 along = step.X() * frame.du + step.Y() * frame.dv;
  const Vec3 left = cross(cross(frame.du, frame.dv), along);
  return of.edge.Orientation() == TopAbs_REVERSED ? -left : left;
}

double distance_to(const std::vector<SurfacePoint>& polygon, const Vec3& p) {
  double least = kUnbounded;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    least = std::min(least, segment_gap(p, polygon[i].point, polygon[i + 1].point));
  return least;
}

bool lies_inside(const FaceTrims& trims, const Vec2& uv) {
  return part_side(trims, {uv[0], uv[0]}, {uv[1], uv[1]}) == PartSide::Inside;
}

class OneSurface {
 public:
  OneSurface(const TopoDS_Face& a, const TopoDS_Face& b, const std::vector<SharedEdge>& edges,
             double gap, double within, double tolerance)
      : a_(TopoDS::Face(a.Oriented(TopAbs_FORWARD))),
        b_(TopoDS::Face(b.Oriented(TopAbs_FORWARD))),
        edges_(edges),
        gap_(gap),
        within_(within),
        tolerance_(tolerance),
        contacts_(outline_contacts(a_, b_, tolerance)) {}

  SurfaceIntersection run(const WorkLimit& limit) {
    if (gap_ <= within_)
      identify(found_.certificate, gap_);
    else
      weaken(Status::Tolerance, "the surfaces coincide in the listed contacts");
    judge_contacts();
    add_regions(limit);
    for (const OutlineRun& run : contacts_.runs)
      if (lie_side_by_side(run)) add_curve(run);
    for (const OutlinePoint& point : contacts_.points)
      if (!is_known(point.at.point)) add_point(point);
    return std::move(found_);
  }

 private:
  void weaken(Status status, const char* reason) {
    found_.status = weaker(found_.status, status);
    found_.certificate.reasons.emplace_back(reason);
  }

  void judge_contacts() {
    bool exact = contacts_.complete;
    const auto judge = [&](double gap) {
      if (gap <= within_)
        identify(found_.certificate, gap);
      else
        exact = false;
    };
    for (const OutlineRun& run : contacts_.runs) judge(run.proven ? run.gap : 2 * run.gap);
    for (const OutlinePoint& point : contacts_.points)
      if (!point.crosses) judge(point.gap);
    if (!exact) weaken(Status::Tolerance, "edges of faces on one surface come near each other");
  }

  void add_regions(const WorkLimit& limit) {
    TrimmedOverlaps trimmed = trimmed_overlaps(a_, b_, {{{}, gap_}}, tolerance_, limit);
    for (Overlap& region : trimmed.regions) {
      found_.places.push_back(
          place_of(region.boundary, PlaceKind::Overlap, region.gap_high, tolerance_));
      found_.overlaps.push_back(std::move(region));
    }
    if (!trimmed.complete)
      weaken(Status::Stopped, trimmed.stopped != nullptr
                                  ? trimmed.stopped
                                  : "the trims divide a common region in an unknown way");
  }

  // Along a seam its face lies on both sides.
  bool lie_side_by_side(const OutlineRun& run) const {
    if (run.a.seam || run.b.seam) return false;
    const Vec3 in_a = inwards(run.a, BRep_Tool::Surface(a_), at(run.at_a, 0.5));
    const double half_way = parameter_beside(run, at(run.at_a, 0.5));
    return dot(in_a, inwards(run.b, BRep_Tool::Surface(b_), half_way)) < 0;
  }

  void add_curve(const OutlineRun& run) {
    IntersectionCurve curve = run_curve(run, a_, b_, tolerance_);
    if (keeps_to_edges(curve, edges_, tolerance_)) return;
    found_.places.push_back(
        place_of(curve.samples, PlaceKind::Tangential, std::max(run.gap, gap_), tolerance_));
    found_.curves.push_back(std::move(curve));
  }

  // Whether both faces have a point in common as far from a given one: then a region is there, even
  // if its border is not, as round a pole. A seam lies along one or two of the directions at most.
  bool are_both_beside(const Vec3& point, double reach) const {
    const SurfaceProjector on_a(a_, tolerance_), on_b(b_, tolerance_);
    const FaceTrims trims_a = face_trims(a_), trims_b = face_trims(b_);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 to_corner{corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0,
                           corner & 4 ? 1.0 : -1.0};
      const Vec2 uv_a = on_a.foot(point + reach / std::sqrt(3.0) * to_corner, {});
      const Vec2 uv_b = on_b.foot(frame_at(on_a.surface(), uv_a).point, {});
      if (lies_inside(trims_a, uv_a) && lies_inside(trims_b, uv_b)) return true;
    }
    return false;
  }

  bool is_known(const Vec3& point) const {
    // Borders are where they are to the tolerances of their edges.
    const double reach =
        kOnIt * std::max({tolerance_, largest_edge_tolerance(a_), largest_edge_tolerance(b_)});
    return keeps_to_edges(point, edges_, tolerance_) ||
           std::ranges::any_of(found_.overlaps,
                               [&](const Overlap& region) {
                                 return distance_to(region.boundary, point) <= reach;
                               }) ||
           std::ranges::any_of(found_.curves,
                               [&](const IntersectionCurve& curve) {
                                 return distance_to(curve.samples, point) <= reach;
                               }) ||
           (!found_.overlaps.empty() && are_both_beside(point, reach));
  }

  void add_point(const OutlinePoint& point) {
    if (point.crosses) weaken(Status::Tolerance, "edges cross beside no common region");
    found_.points.push_back(point.at);
    found_.places.push_back(
        place_of({point.at}, PlaceKind::Touch, std::max(point.gap, gap_), tolerance_));
  }

  const TopoDS_Face a_, b_;
  const std::vector<SharedEdge>& edges_;
  const double gap_, within_, tolerance_;
  const OutlineContacts contacts_;
  SurfaceIntersection found_;
};

}  // namespace

SurfaceIntersection on_one_surface(const TopoDS_Face& a, const TopoDS_Face& b,
                                   const std::vector<SharedEdge>& edges, double gap, double within,
                                   double tolerance, const WorkLimit& limit) {
  return OneSurface(a, b, edges, gap, within, tolerance).run(limit);
}

}  // namespace blossom::occt
