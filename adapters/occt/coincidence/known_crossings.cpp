// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/coincidence/known_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/base/limits.h"
#include "adapters/occt/coincidence/conic_images.h"
#include "adapters/occt/faces/elementary_faces.h"
#include "adapters/occt/tessellation/elementary_charts.h"
#include "core/base/not_zero.h"
#include "core/results/contact_places.h"
#include "core/tracing/conic_deviation.h"
#include "core/tracing/deviation.h"

namespace blossom::occt {
namespace {

// Of a spline's range: so far it is looked at beyond its bounds, so that what ends on them is found
// to go on. A choice; curves that go on beyond boxes farther than that are searched for.
constexpr double kBeyondSpline = 0.05;

// The parameters of a line at which it is in a ball that holds the box; empty if it misses it.
Interval inside(const Box& box, const Conic& line) {
  const Vec3 middle = 0.5 * (box.low + box.high);
  const double radius = (0.5 + kBeyondBox) * diagonal(box);
  const double nearest = dot(middle - line.centre, line.x);
  const double off = distance(middle, line.centre + nearest * line.x);
  if (off >= radius) return {1, 0};
  const double half = std::sqrt((radius - off) * (radius + off));
  return {nearest - half, nearest + half};
}

// Where a circle or an ellipse is beyond the sides of a box that it crosses: one interval of its
// parameter for each, within a turn and a half round 0. All of it, if it is beyond one side.
std::vector<Interval> arcs_beyond(const Box& box, const Conic& conic) {
  const double beside = kBeyondBox * diagonal(box);
  std::vector<Interval> beyond;
  for (int k = 0; k < 3; ++k)
    for (const int side : {-1, 1}) {
      // The coordinate is centre + r cos(t - phase), from the centre to this side.
      const double x = side * conic.major * conic.x[k], y = side * conic.minor * conic.y[k];
      const double r = std::hypot(x, y), phase = std::atan2(y, x);
      const double height = side * ((side < 0 ? box.low : box.high)[k] - conic.centre[k]) + beside;
      if (height >= r) continue;
      const double half = std::acos(std::max(-1.0, height / r));
      beyond.push_back({phase - half, phase + half});
    }
  return beyond;
}

// Goes back from the end of an interval as far as intervals on a circle overlap.
double begin_of_gap(const std::vector<Interval>& gaps, const Interval& last) {
  double begin = last.from;
  const auto covers = [&](const Interval& gap) {
    const double into = std::remainder(begin - gap.from - length(gap) / 2, kTurn);
    return std::abs(into) <= length(gap) / 2 ? into + length(gap) / 2 : 0;
  };
  for (std::size_t i = 0; i < gaps.size(); ++i)
    for (const Interval& gap : gaps) begin -= covers(gap);
  return begin;
}

// Of a closed conic all but the longest stretch that is beyond a box; empty if all is.
Interval inside_closed(const Box& box, const Conic& conic) {
  const std::vector<Interval> beyond = arcs_beyond(box, conic);
  Interval longest{0, 0};
  for (const Interval& last : beyond) {
    const Interval gap{begin_of_gap(beyond, last), last.to};
    if (length(gap) > length(longest)) longest = gap;
  }
  if (length(longest) >= kTurn) return {1, 0};
  return {longest.to, longest.from + kTurn};
}

Interval range_of(const Conic& conic, const Box& box) {
  return conic.is_closed() ? inside_closed(box, conic) : inside(box, conic);
}

double angle_between(const SurfaceJet& a, const SurfaceJet& b) {
  const Vec3 x = cross(a.du, a.dv), y = cross(b.du, b.dv);
  return std::atan2(norm(cross(x, y)), std::abs(dot(x, y)));
}

// Ranges of both parameters that hold all within a reach in space; in a pole that is all.
void widen_charts(const Handle(Geom_Surface) & surface, const Vec2& uv, double reach,
                  Interval* ranges) {
  const SurfaceJet frame = frame_at(surface, uv);
  for (int d = 0; d < 2; ++d) {
    const double size = norm(d == 0 ? frame.du : frame.dv);
    const double beside = std::min(reach / std::max(size, kNotZero), kTurn);
    ranges[d] = {uv[d] - beside, uv[d] + beside};
  }
}

class KnownCrossings {
 public:
  KnownCrossings(const std::array<const ChartSheet*, 2>& sheets,
                 const std::array<const FaceTrims*, 2>& trims, const Box& common, double within,
                 double tolerance)
      : sheets_(sheets), trims_(trims), common_(common), within_(within), tolerance_(tolerance) {}

  bool add(const MeetingCurve& known) {
    const Interval range = range_of(known.conic, common_);
    if (!(range.from < range.to)) return true;
    if (!lies_on_sheets(known, range)) return false;
    auto parts =
        curves_on_sheets(known.conic, range, known.nodes, sheets_, std::max(known.gap, tolerance_));
    if (!parts) return false;
    for (IntersectionCurve& curve : *parts) {
      curve.tangential = known.tangential;
      curve.least_angle = least_angle(curve);
      if (known.tangential && lies_in_both(curve)) {
        judge(known.gap);
        found_.places.push_back(
            place_of(curve.samples, PlaceKind::Tangential, known.gap, tolerance_));
      }
      found_.curves.push_back(std::move(curve));
    }
    return true;
  }

  bool add(const PipeCrossing& known) {
    auto parts = curves_on_sheets(known, {0, kTurn}, known.nodes, sheets_, tolerance_);
    if (!parts) return false;
    for (IntersectionCurve& curve : *parts) {
      curve.least_angle = least_angle(curve);
      found_.curves.push_back(std::move(curve));
    }
    return true;
  }

  void add(const MeetingPoint& known) {
    const auto place = place_at(known.point, PlaceKind::Touch, known.gap);
    if (!place) return;
    judge(known.gap);
    found_.points.push_back(place->first);
    found_.places.push_back(place->second);
  }

  void add_node(const MeetingNode& known) {
    const auto place = place_at(known.point, PlaceKind::Node, known.gap, known.reach);
    if (!place) return;
    judge(known.gap);
    found_.nodes.push_back(place->first);
    found_.places.push_back(place->second);
  }

  SurfaceIntersection result() && {
    Certificate& certificate = found_.certificate;
    certificate.certified = static_cast<long>(found_.curves.size() + found_.points.size());
    certificate.excluded = certificate.certified == 0 ? 1 : 0;
    for (const IntersectionCurve& curve : found_.curves)
      certificate.least_angle = certificate.least_angle > 0
                                    ? std::min(certificate.least_angle, curve.least_angle)
                                    : curve.least_angle;
    return std::move(found_);
  }

 private:
  // False where a spline ends before the curve does: that saves the work of its images.
  bool lies_on_sheets(const MeetingCurve& known, const Interval& range) const {
    constexpr int kPlaces = 32;
    for (const ChartSheet* sheet : sheets_) {
      if (elementary_of(sheet->feet.surface())) continue;
      std::optional<Vec2> near;
      for (int i = 0; i <= kPlaces; ++i) {
        const Vec3 point = point_at(known.conic, at(range, i / double{kPlaces}));
        near = sheet->feet.foot(point, near);
        if (sheet->feet.gap(point, *near) > std::max(known.gap, tolerance_)) return false;
      }
    }
    return true;
  }

  // Nothing if it is proven to be outside of the trims.
  std::optional<std::pair<SurfacePoint, Place>> place_at(const Vec3& point, PlaceKind kind,
                                                         double gap, double reach = 0) const {
    const SurfacePoint at{point, in_sheet(*sheets_[0], sheets_[0]->feet.foot(point, {})),
                          in_sheet(*sheets_[1], sheets_[1]->feet.foot(point, {}))};
    Place place = place_of({at}, kind, gap, reach + tolerance_);
    for (std::size_t k = 0; k < 2; ++k)
      widen_charts(sheets_[k]->feet.surface(), k == 0 ? at.uv_a : at.uv_b, gap + reach + tolerance_,
                   &place.parameters[2 * k]);
    for (std::size_t k = 0; k < 2; ++k)
      if (part_side(*trims_[k], place.parameters[2 * k], place.parameters[2 * k + 1]) ==
          PartSide::Outside)
        return {};
    return std::pair{at, place};
  }

  void judge(double gap) {
    if (gap <= within_) return identify(found_.certificate, gap);
    found_.status = weaker(found_.status, Status::Tolerance);
    if (found_.certificate.reasons.empty()) found_.certificate.reasons.emplace_back(kTouchInPlaces);
  }

  double least_angle(const IntersectionCurve& curve) const {
    double least = 0.5 * std::numbers::pi;
    for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i) {
      const double t = 0.5 * (curve.sample_parameters[i] + curve.sample_parameters[i + 1]);
      least = std::min(
          least, angle_between(frame_at(sheets_[0]->feet.surface(), point_at(curve.chart_a, t)),
                               frame_at(sheets_[1]->feet.surface(), point_at(curve.chart_b, t))));
    }
    return least;
  }

  // Whether both faces have a part of the curve: where one ends and the other begins they have only
  // the point, which is a touch of the trims.
  bool lies_in_both(const IntersectionCurve& curve) const {
    const auto in_a = clip_to_trims(*trims_[0], curve.chart_a);
    const auto in_b = clip_to_trims(*trims_[1], curve.chart_b);
    const auto place = [&](double t) {
      return sheets_[0]->feet.surface()->Value(point_at(curve.chart_a, t)[0],
                                               point_at(curve.chart_a, t)[1]);
    };
    for (const Interval& a : in_a)
      for (const Interval& b : in_b) {
        const Interval common{std::max(a.from, b.from), std::min(a.to, b.to)};
        if (!(common.from < common.to)) continue;
        const gp_Pnt middle = place(at(common, 0.5));
        if (middle.Distance(place(common.from)) > tolerance_ ||
            middle.Distance(place(common.to)) > tolerance_)
          return true;
      }
    return false;
  }

  const std::array<const ChartSheet*, 2>& sheets_;
  const std::array<const FaceTrims*, 2>& trims_;
  const Box common_;
  const double within_, tolerance_;
  SurfaceIntersection found_;
};

}  // namespace

std::optional<SurfaceIntersection> known_crossings(const TopoDS_Face& face_a, const FaceData& a,
                                                   const TopoDS_Face& face_b, const FaceData& b,
                                                   const Box& common, double within,
                                                   double tolerance) {
  if (!a.elementary || !b.elementary) return {};
  const Ball ball{0.5 * (common.low + common.high), 0.5 * diagonal(common)};
  const auto known = elementary_meeting(*a.elementary, *b.elementary, ball, {within, tolerance});
  if (!known) return {};
  const SurfaceProjector feet_a = SurfaceProjector::going_on(face_a, tolerance, kBeyondSpline),
                         feet_b = SurfaceProjector::going_on(face_b, tolerance, kBeyondSpline);
  const ChartSheet sheet_a = sheet_of(feet_a, a.surface), sheet_b = sheet_of(feet_b, b.surface);
  const std::array sheets{&sheet_a, &sheet_b};
  const std::array trims{&a.trims, &b.trims};
  KnownCrossings crossings(sheets, trims, common, within, tolerance);
  for (const MeetingCurve& curve : known->curves)
    if (!crossings.add(curve)) return {};
  for (const PipeCrossing& crossing : known->crossings)
    if (!crossings.add(crossing)) return {};
  for (const MeetingPoint& point : known->points) crossings.add(point);
  for (const MeetingNode& node : known->nodes) crossings.add_node(node);
  return std::move(crossings).result();
}

FaceTrims cutting_trims(FaceTrims trims) {
  trims.natural = false;
  return trims;
}

void prove_deviations(const TopoDS_Face& face_a, const FaceData& a, const TopoDS_Face& face_b,
                      const FaceData& b, double tolerance, SurfaceIntersection& found) {
  const auto chart_a = elementary_chart(BRep_Tool::Surface(face_a));
  const auto chart_b = elementary_chart(BRep_Tool::Surface(face_b));
  for (IntersectionCurve& curve : found.curves) {
    if (curve.deviation.proven) continue;
    std::optional<Deviation> known;
    if (curve.conic && chart_a && chart_b)
      known = conic_deviation(curve, *chart_a, *chart_b, tolerance);
    curve.deviation = known ? *known : proven_deviation(curve, a.surface, b.surface);
  }
}

}  // namespace blossom::occt
