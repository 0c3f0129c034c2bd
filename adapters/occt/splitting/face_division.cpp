// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/face_division.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace blossom::occt {
namespace {

bool has_split_edge(const TopoDS_Face& face, const EdgeSplits& splits) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (splits.is_split(TopoDS::Edge(it.Current()))) return true;
  return false;
}

bool holds(const Place& place, const Vec3& point) {
  for (int k = 0; k < 3; ++k)
    if (point[k] < place.box_low[k] || place.box_high[k] < point[k]) return false;
  return true;
}

// The size of the node, or of the contact in a point, that holds a point: curves that touch there
// end in it, but not all in one point; 0 if none does.
double node_reach(const std::vector<Place>& places, const Vec3& point) {
  for (const Place& place : places)
    if ((place.kind == PlaceKind::Node || place.kind == PlaceKind::Touch) && holds(place, point))
      return distance(place.box_low, place.box_high);
  return 0;
}

FaceCut cut_of(const FaceIntersection& pair, std::size_t place, const Spline2& chart) {
  const IntersectionCurve& curve = pair.found.curves[place];
  const auto reach = [&](double end) {
    return node_reach(pair.found.places, point_at(curve.curve, end));
  };
  const Interval domain = curve.curve.domain();
  return {curve.curve, chart, pair.edges[place].tolerance,           std::sin(curve.least_angle),
          curve.conic, false, {reach(domain.from), reach(domain.to)}};
}

}  // namespace

void FaceDivision::add_cut(FaceCut cut, CutSource source) {
  cuts_.push_back(std::move(cut));
  sources_.push_back(std::move(source));
}

void FaceDivision::begin(const DivisionJob& job) {
  if (!splitter_)
    splitter_ = std::make_unique<FaceSplitter>(face_, cuts_, job.splits, job.tolerance, job.limit);
}

void FaceDivision::settle() {
  if (splitter_) splitter_->settle();
}

void FaceDivision::finish(const DivisionJob& job, OpenCuts open) {
  if (!splitter_ && has_split_edge(face_, job.splits)) begin(job);
  if (splitter_)
    split_ = splitter_->split(open);
  else
    leave_whole();
}

void FaceDivision::leave_whole() { split_ = {{{face_, {}, {}}}, {}}; }

FaceCut cut_of_a(const FaceIntersection& pair, std::size_t curve) {
  return cut_of(pair, curve, pair.found.curves[curve].chart_a);
}

bool is_one_place(const FaceIntersection& pair, std::size_t curve) {
  constexpr std::array kPoints{PlaceKind::Touch, PlaceKind::Node, PlaceKind::Cusp, PlaceKind::Pole};
  return std::ranges::any_of(pair.found.places, [&](const Place& place) {
    return std::ranges::find(kPoints, place.kind) != kPoints.end() &&
           std::ranges::all_of(pair.found.curves[curve].samples,
                               [&](const SurfacePoint& x) { return holds(place, x.point); });
  });
}

FaceCut cut_of_b(const FaceIntersection& pair, std::size_t curve) {
  return cut_of(pair, curve, pair.found.curves[curve].chart_b);
}

}  // namespace blossom::occt
