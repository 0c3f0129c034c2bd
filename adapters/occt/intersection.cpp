// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/intersection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <string>
#include <utility>

#include "adapters/occt/curves.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/face_trims.h"
#include "adapters/occt/shared_edges.h"
#include "adapters/occt/surfaces.h"
#include "core/base/parallel.h"
#include "core/bounds/box_tree.h"

namespace blossom::occt {
namespace {

constexpr double kLeastEdgeTolerance = 1e-7;  // Open CASCADE's Precision::Confusion
constexpr double kEdgeMargin = 1.1;           // of the edge's tolerance over the deviation
constexpr double kSmoothAngle = 0.05;         // radians: so flat an edge is taken for smooth
constexpr double kExact = 1e-9;               // of the size: borders as near as this agree
constexpr double kEdgeReach = 4;     // of a shared edge's tolerance: what is so near is the edge
constexpr double kEdgeStrip = 2e-3;  // of the faces' size: so near, smooth faces are one
constexpr double kEdgeSag = 1e-4;    // of a shared edge's length, for the chords of its samples

struct FaceData {
  BezierSurface surface;
  FaceTrims trims;
  Box box;
};

Box box_of(const BezierSurface& surface, double margin) {
  Box box;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values()) {
      const Vec3 x{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
      box = joined(box, {x, x});
    }
  const Vec3 r{margin, margin, margin};
  return {box.low - r, box.high + r};
}

std::vector<FaceData> data_of(const std::vector<TopoDS_Face>& faces, const char* list,
                              double tolerance) {
  std::vector<FaceData> data;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::string place = std::string("face ") + std::to_string(i + 1) + " of " + list;
    try {
      FaceData face;
      face.surface = bezier_surface(faces[i], tolerance);
      face.trims = face_trims(faces[i]);
      face.box = box_of(face.surface, face.surface.error + tolerance);
      data.push_back(std::move(face));
    } catch (const BadModel& error) {
      throw BadModel(place + ": " + error.what());
    }
  }
  return data;
}

BoxTree tree_of(const std::vector<FaceData>& faces) {
  std::vector<Box> boxes;
  for (const FaceData& face : faces) boxes.push_back(face.box);
  return BoxTree(boxes);
}

// Both lists are increasing and disjoint.
std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> result;
  for (const Interval& x : a)
    for (const Interval& y : b) {
      const Interval both{std::max(x.from, y.from), std::min(x.to, y.to)};
      if (both.from < both.to) result.push_back(both);
    }
  return result;
}

SurfacePoint point_of(const IntersectionCurve& curve, double t) {
  return {point_at(curve.curve, t), point_at(curve.chart_a, t), point_at(curve.chart_b, t)};
}

// The part of a curve on an interval, its ends named where they are new.
IntersectionCurve part_of(const IntersectionCurve& whole, const Interval& part) {
  IntersectionCurve curve = whole;
  const Interval domain = whole.curve.domain();
  curve.closed = false;
  curve.curve = restricted(whole.curve, part);
  curve.chart_a = restricted(whole.chart_a, part);
  curve.chart_b = restricted(whole.chart_b, part);
  curve.ends = {part.from > domain.from || whole.closed ? CurveEnd::Trim : whole.ends[0],
                part.to < domain.to || whole.closed ? CurveEnd::Trim : whole.ends[1]};
  curve.length = length(part);  // splines are parametrised by arc length
  curve.samples.clear();
  curve.sample_parameters.clear();
  const auto add = [&](const SurfacePoint& p, double t) {
    curve.samples.push_back(p);
    curve.sample_parameters.push_back(t);
  };
  const double apart = 1e-3 * length(part);
  add(part.from > domain.from ? point_of(whole, part.from) : whole.samples.front(), part.from);
  for (std::size_t i = 0; i < whole.samples.size(); ++i) {
    const double t = whole.sample_parameters[i];
    if (t > part.from + apart && t < part.to - apart) add(whole.samples[i], t);
  }
  add(part.to < domain.to ? point_of(whole, part.to) : whole.samples.back(), part.to);
  return curve;
}

// A loop's last part and its first one are one curve through the loop's start.
IntersectionCurve appended(IntersectionCurve first, const IntersectionCurve& second) {
  const double shift = first.curve.domain().to - second.curve.domain().from;
  first.curve = joined(first.curve, second.curve);
  first.chart_a = joined(first.chart_a, second.chart_a);
  first.chart_b = joined(first.chart_b, second.chart_b);
  first.length += second.length;
  for (std::size_t i = 1; i < second.samples.size(); ++i) {
    first.samples.push_back(second.samples[i]);
    first.sample_parameters.push_back(second.sample_parameters[i] + shift);
  }
  return first;
}

void clip(const IntersectionCurve& whole, const std::vector<Interval>& parts,
          std::vector<IntersectionCurve>& result) {
  const Interval domain = whole.curve.domain();
  if (parts.empty()) return;
  if (parts.size() == 1 && parts[0] == domain) {
    result.push_back(whole);
    return;
  }
  std::vector<IntersectionCurve> curves;
  for (const Interval& part : parts) curves.push_back(part_of(whole, part));
  // Only where the charts close too: a curve round a period ends on the seam.
  const bool charts_close = whole.closed &&
                            distance(whole.samples.front().uv_a, whole.samples.back().uv_a) == 0 &&
                            distance(whole.samples.front().uv_b, whole.samples.back().uv_b) == 0;
  if (charts_close && curves.size() > 1 && parts.front().from == domain.from &&
      parts.back().to == domain.to) {
    curves.front() = appended(std::move(curves.back()), curves.front());
    curves.pop_back();
  }
  result.insert(result.end(), curves.begin(), curves.end());
}

bool inside(const FaceTrims& trims, const Vec2& uv) {
  return trims.natural || is_inside(trims, {uv[0] * trims.scale[0], uv[1] * trims.scale[1]});
}

void clip(SurfaceIntersection& found, const FaceData& a, const FaceData& b) {
  if (a.trims.natural && b.trims.natural) return;
  std::vector<IntersectionCurve> curves;
  for (const IntersectionCurve& curve : found.curves)
    clip(curve,
         common(clip_to_trims(a.trims, curve.chart_a), clip_to_trims(b.trims, curve.chart_b)),
         curves);
  found.curves = std::move(curves);
  const auto outside = [&](const SurfacePoint& p) {
    return !inside(a.trims, p.uv_a) || !inside(b.trims, p.uv_b);
  };
  std::erase_if(found.points, outside);
  std::erase_if(found.nodes, outside);
  // What the trims leave of a common region is not known: it stays among the places only.
  found.overlaps.clear();
}

EdgeCurves edge_curves(const IntersectionCurve& curve) {
  const Deviation& d = curve.deviation;
  return {to_occt(curve.curve), to_occt(curve.chart_a), to_occt(curve.chart_b),
          std::max(kLeastEdgeTolerance, kEdgeMargin * std::max({d.a, d.b, d.between}))};
}

void add(Certificate& sum, const Certificate& one) {
  sum.excluded += one.excluded;
  sum.certified += one.certified;
  sum.critical += one.critical;
  sum.cells_bezier += one.cells_bezier;
  sum.cells_monomial += one.cells_monomial;
  sum.depth = std::max(sum.depth, one.depth);
  sum.rounding_bound = std::max(sum.rounding_bound, one.rounding_bound);
  if (one.least_angle > 0)
    sum.least_angle =
        sum.least_angle > 0 ? std::min(sum.least_angle, one.least_angle) : one.least_angle;
  for (const std::string& reason : one.reasons)
    if (std::find(sum.reasons.begin(), sum.reasons.end(), reason) == sum.reasons.end())
      sum.reasons.push_back(reason);
}

// --- edges that two faces share

double distance_to(const std::vector<SurfacePoint>& polygon, const Vec3& p) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const Vec3 from = polygon[i].point, step = polygon[i + 1].point - from;
    const double square = dot(step, step);
    const double t = square > 0 ? std::clamp(dot(p - from, step) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, distance(p, from + step * t));
  }
  return least;
}

// Where the faces go on smoothly, or their borders agree only roughly, nothing beside the edge can
// be told apart.
KnownCurve known_curve(const SharedEdge& edge, double size) {
  KnownCurve known{{}, std::max(kEdgeReach * edge.tolerance, kEdgeStrip * size), 0};
  for (const SurfacePoint& x : edge.curve.samples) known.points.push_back(x.point);
  const Deviation& d = edge.curve.deviation;
  known.gap = std::max({d.a, d.b, d.between});
  return known;
}

// What was found along a shared edge is the edge.
void replace_by_edges(SurfaceIntersection& found, const std::vector<SharedEdge>& edges,
                      double tolerance) {
  const auto along_edge = [&](const Vec3& p) {
    return std::any_of(edges.begin(), edges.end(), [&](const SharedEdge& edge) {
      const double reach = kEdgeReach * std::max(edge.tolerance, tolerance) +
                           kEdgeSag * edge.curve.length;
      return distance_to(edge.curve.samples, p) <= reach;
    });
  };
  std::erase_if(found.curves, [&](const IntersectionCurve& curve) {
    return std::all_of(curve.samples.begin(), curve.samples.end(),
                       [&](const SurfacePoint& x) { return along_edge(x.point); });
  });
  std::erase_if(found.points, [&](const SurfacePoint& x) { return along_edge(x.point); });
  for (const SharedEdge& edge : edges) found.curves.push_back(edge.curve);
}

PartTest part_test(const FaceTrims& trims) {
  if (trims.natural) return {};
  return [&trims](const Interval& u, const Interval& v) { return part_side(trims, u, v); };
}

// One pair of faces at a time; pairs may be asked for at the same time.
class PairIntersector {
 public:
  PairIntersector(const std::vector<TopoDS_Face>& shapes_a,
                  const std::vector<TopoDS_Face>& shapes_b, const std::vector<FaceData>& faces_a,
                  const std::vector<FaceData>& faces_b, const IntersectionOptions& options)
      : shapes_a_(shapes_a),
        shapes_b_(shapes_b),
        faces_a_(faces_a),
        faces_b_(faces_b),
        options_(options) {}

  FaceIntersection of(const std::pair<int, int>& pair) const {
    const auto i = static_cast<std::size_t>(pair.first), j = static_cast<std::size_t>(pair.second);
    const FaceData &a = faces_a_[i], &b = faces_b_[j];
    const std::vector<SharedEdge> edges = shared_edges(shapes_a_[i], shapes_b_[j]);
    IntersectionOptions options = remaining();
    const double size = std::min(diagonal(a.box), diagonal(b.box));
    for (const SharedEdge& edge : edges) {
      KnownCurve known = known_curve(edge, size);
      if (edge.curve.least_angle < kSmoothAngle || known.gap > kExact * size)
        options.known.push_back(std::move(known));
    }
    options.part_a = part_test(a.trims);
    options.part_b = part_test(b.trims);
    FaceIntersection result{pair.first, pair.second, intersect(a.surface, b.surface, options), {}};
    clip(result.found, a, b);
    replace_by_edges(result.found, edges, options_.tolerances.point);
    for (const IntersectionCurve& curve : result.found.curves)
      result.edges.push_back(edge_curves(curve));
    return result;
  }

 private:
  // The time limit is for all pairs together; what is left when it is over stops at once, with its
  // place listed. All pairs share the threads they run on.
  IntersectionOptions remaining() const {
    constexpr double kLeastSeconds = 1e-3;
    IntersectionOptions left = options_;
    left.threads = 0;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started_;
    if (options_.time_limit > 0)
      left.time_limit = std::max(kLeastSeconds, options_.time_limit - spent.count());
    if (options_.cancelled)
      left.cancelled = [this] {
        const std::lock_guard lock(asking_);
        return options_.cancelled();
      };
    return left;
  }

  const std::vector<TopoDS_Face>& shapes_a_;
  const std::vector<TopoDS_Face>& shapes_b_;
  const std::vector<FaceData>& faces_a_;
  const std::vector<FaceData>& faces_b_;
  const IntersectionOptions& options_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  mutable std::mutex asking_;  // the caller's function is asked by one thread at a time
};

}  // namespace

ShapeIntersection intersect(const std::vector<TopoDS_Face>& a, const std::vector<TopoDS_Face>& b,
                            const IntersectionOptions& options) {
  const double tolerance = options.tolerances.point;
  const std::vector<FaceData> faces_a = data_of(a, "the first shape", tolerance);
  const std::vector<FaceData> faces_b = data_of(b, "the second shape", tolerance);
  std::vector<std::pair<int, int>> pairs;
  tree_of(faces_a).for_each_meeting(tree_of(faces_b),
                                    [&](int i, int j) { pairs.emplace_back(i, j); });
  std::sort(pairs.begin(), pairs.end());

  const PairIntersector intersector(a, b, faces_a, faces_b, options);
  std::vector<FaceIntersection> found(pairs.size());
  with_threads(options.threads, [&] {
    parallel_for(pairs.size(), 1, [&](std::size_t k) { found[k] = intersector.of(pairs[k]); });
  });
  ShapeIntersection result;
  result.face_pairs = static_cast<long>(pairs.size());
  for (FaceIntersection& pair : found) {
    result.status = weaker(result.status, pair.found.status);
    add(result.certificate, pair.found.certificate);
    if (!pair.found.curves.empty() || !pair.found.points.empty() || !pair.found.nodes.empty() ||
        !pair.found.places.empty())
      result.pairs.push_back(std::move(pair));
  }
  return result;
}

}  // namespace blossom::occt
