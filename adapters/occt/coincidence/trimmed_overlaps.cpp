// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/coincidence/trimmed_overlaps.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/limits.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/face_splitter.h"
#include "adapters/occt/splitting/trim_sides.h"

namespace blossom::occt {
namespace {

constexpr int kBorderSamples = 128;  // of an edge of a region
constexpr int kStraightSamples = 4;  // of a straight one
constexpr double kStraight = 1e-12;  // of its length

// --- borders of the common region of the surfaces

PartSide side_at(const FaceTrims& trims, const Vec2& uv) {
  return part_side(trims, {uv[0], uv[0]}, {uv[1], uv[1]});
}

// Chords of a region's border between samples inside of both faces.
std::vector<FaceCut> border_cuts(const Overlap& region, const FaceTrims& a, const FaceTrims& b,
                                 double tolerance) {
  std::vector<FaceCut> cuts;
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < region.boundary.size(); ++i) {
    const SurfacePoint &p = region.boundary[i], &q = region.boundary[i + 1];
    const Vec2 middle_a = 0.5 * (p.uv_a + q.uv_a), middle_b = 0.5 * (p.uv_b + q.uv_b);
    const bool inside = distance(p.point, q.point) > 0 &&
                        side_at(a, middle_a) == PartSide::Inside &&
                        side_at(b, middle_b) == PartSide::Inside;
    if (inside && !goes_on) {
      cuts.push_back({{1, {0}, {}, {p.point}}, {1, {0}, {}, {p.uv_a}}, tolerance});
    }
    if (inside) {
      FaceCut& cut = cuts.back();
      cut.curve.knots.push_back(cut.curve.knots.back() + distance(p.point, q.point));
      cut.curve.points.push_back(q.point);
      cut.chart.points.push_back(q.uv_a);
    }
    goes_on = inside;
  }
  for (FaceCut& cut : cuts) {
    cut.curve.multiplicities.assign(cut.curve.knots.size(), 1);
    cut.curve.multiplicities.front() = cut.curve.multiplicities.back() = 2;
    cut.chart.knots = cut.curve.knots;
    cut.chart.multiplicities = cut.curve.multiplicities;
  }
  return cuts;
}

// --- regions

// A chord is as good as what it spans where the edge is straight in space.
int samples_of(const Coedge& coedge, const std::function<Vec3(double)>& point) {
  const Interval range = coedge.curve.domain();
  const Vec3 from = point(range.from), step = point(range.to) - from;
  const auto off = [&](double part) { return norm(point(at(range, part)) - from - part * step); };
  const bool straight = std::max({off(0.25), off(0.5), off(0.75)}) <= kStraight * norm(step);
  return straight ? kStraightSamples : kBorderSamples;
}

// The boundary of a face, which lies on its left. `place_of(point, uv)` gives the parameters on the
// other face.
template <class PlaceOf>
std::vector<SurfacePoint> boundary_of(const FaceTrims& trims, const Handle(Geom_Surface) & surface,
                                      const PlaceOf& place_of) {
  std::vector<std::vector<SurfacePoint>> loops;
  const auto uv_at = [&](const Coedge& coedge, double t) {
    const Vec2 c = point_at(coedge.curve, t);
    return Vec2{c[0] / trims.scale[0], c[1] / trims.scale[1]};
  };
  const auto add = [&](const Coedge& coedge) {
    const int samples =
        samples_of(coedge, [&](double t) { return frame_at(surface, uv_at(coedge, t)).point; });
    for (int i = 0; i < samples; ++i) {
      const double part = static_cast<double>(i) / samples;
      const Vec2 uv = uv_at(coedge, at(coedge.curve.domain(), coedge.reversed ? 1 - part : part));
      const Vec3 point = frame_at(surface, uv).point;
      loops.back().push_back({point, uv, place_of(point, uv)});
    }
  };
  for (const auto& loop : trims.loops) {
    std::vector<char> used(loop.size());
    for (std::size_t first = 0; first < loop.size(); ++first) {
      if (used[first]) continue;
      loops.emplace_back();
      for (std::size_t at = first; at < loop.size() && !used[at];) {
        used[at] = 1;
        add(loop[at]);
        const auto next = std::find_if(loop.begin(), loop.end(), [&](const Coedge& coedge) {
          return coedge.from == loop[at].to;
        });
        at = static_cast<std::size_t>(next - loop.begin());
      }
      loops.back().push_back(loops.back().front());
    }
  }
  return joined_loops(loops);
}

double largest_gap(const std::vector<SurfacePoint>& boundary, const SurfaceProjector& on_b) {
  double largest = 0;
  for (const SurfacePoint& x : boundary) largest = std::max(largest, on_b.gap(x.point, x.uv_b));
  return largest;
}

TrimmedOverlaps clipped(const TopoDS_Face& a, const TopoDS_Face& b,
                        const std::vector<Overlap>& whole, double tolerance, PolledLimit& limit) {
  TrimmedOverlaps result;
  // Splitting writes tolerances of vertices; other pairs of faces may be at work on them.
  const TopoDS_Face cut_face = TopoDS::Face(
      BRepBuilderAPI_Copy(a.Oriented(TopAbs_FORWARD), Standard_False, Standard_False).Shape());
  const SurfaceProjector on_a(cut_face, tolerance, &limit), on_b(b, tolerance, &limit);
  const FaceTrims trims_a = face_trims(cut_face), trims_b = face_trims(b);
  double gap = 0;
  for (const Overlap& region : whole) gap = std::max(gap, region.gap_high);
  const double reach = std::max(kOnIt * tolerance, 2 * gap);
  std::vector<FaceCut> cuts = edge_cuts(b, on_a, reach, tolerance);
  for (const Overlap& region : whole)
    for (FaceCut& cut : border_cuts(region, trims_a, trims_b, tolerance))
      cuts.push_back(std::move(cut));
  const FaceSplit split = split_face(cut_face, cuts, tolerance);
  for (const FacePiece& piece : split.pieces) {
    const std::optional<gp_Pnt> inside = point_inside(piece.face);
    if (!inside) {
      result.complete = false;
      continue;
    }
    const Vec2 uv_b = on_b.foot(vec(*inside), {});
    if (on_b.gap(vec(*inside), uv_b) > reach || side_at(trims_b, uv_b) == PartSide::Outside)
      continue;
    Overlap region;
    std::optional<Vec2> near;
    region.boundary = boundary_of(face_trims(TopoDS::Face(piece.face.Oriented(TopAbs_FORWARD))),
                                  on_a.surface(), [&](const Vec3& point, const Vec2&) {
                                    near = on_b.foot(point, near);
                                    return *near;
                                  });
    region.gap_high = std::max(gap, largest_gap(region.boundary, on_b));
    result.complete = result.complete && region.gap_high <= reach;
    result.regions.push_back(std::move(region));
  }
  return result;
}

}  // namespace

TrimmedOverlaps trimmed_overlaps(const TopoDS_Face& a, const TopoDS_Face& b,
                                 const std::vector<Overlap>& whole, double tolerance,
                                 const WorkLimit& limit) {
  PolledLimit polled(limit);
  try {
    return clipped(a, b, whole, tolerance, polled);
  } catch (const LimitReached&) {
    return {{}, false, polled.reason()};
  }
}

Overlap whole_overlap(const TopoDS_Face& face, const FaceTrims& trims, const ChartMap& to_b,
                      double gap) {
  const TrimShapes shapes = trim_shapes(face);
  const bool bounded = std::ranges::any_of(trims.loops, [&](const std::vector<Coedge>& loop) {
    return std::ranges::any_of(loop, [&](const Coedge& coedge) {
      return !coedge.degenerated && !is_seam(shapes.edge(coedge), face);
    });
  });
  if (!bounded) return {{}, gap};
  return {boundary_of(trims, BRep_Tool::Surface(face),
                      [&](const Vec3&, const Vec2& uv) { return to_b(uv); }),
          gap};
}

}  // namespace blossom::occt
