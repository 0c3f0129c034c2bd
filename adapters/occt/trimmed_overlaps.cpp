// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/trimmed_overlaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/face_splitter.h"
#include "adapters/occt/face_trims.h"
#include "adapters/occt/trim_sides.h"

namespace blossom::occt {
namespace {

constexpr double kReach = 10;     // tolerances: what is so near the other surface lies on it
constexpr int kEdgeSamples = 64;  // of an edge, to see where it lies on the other surface
constexpr int kHalvings = 48;     // of the interval between two samples, for the end of a run
constexpr int kNewtonSteps = 4;
constexpr int kLeastPieces = 16, kMostPieces = 512;  // of a fitted run
constexpr double kFitShare = 0.1;                    // of the tolerance
constexpr int kBorderSamples = 128;                  // of an edge of a region
constexpr int kStraightSamples = 4;                  // of a straight one
constexpr double kStraight = 1e-12;                  // of its length

Vec3 vec(const gp_Vec& v) { return {v.X(), v.Y(), v.Z()}; }
Vec3 vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

struct OutOfTime {};

// --- the nearest point of a surface

struct Frame {
  Vec3 point, du, dv;
};

Frame frame_at(const Handle(Geom_Surface) & surface, const Vec2& uv) {
  gp_Pnt p;
  gp_Vec du, dv;
  surface->D1(uv[0], uv[1], p, du, dv);
  return {vec(p), vec(du), vec(dv)};
}

// The steps of u and v along the tangent plane that come nearest to a step in space.
Vec2 chart_step(const Frame& at, const Vec3& step) {
  const Vec3 area = cross(at.du, at.dv);
  const double square = dot(area, area);
  if (!(square > 0)) return {};
  return {dot(cross(step, at.dv), area) / square, dot(cross(at.du, step), area) / square};
}

class Feet {
 public:
  Feet(const TopoDS_Face& face, double tolerance, PolledLimit& limit)
      : surface_(BRep_Tool::Surface(face)),
        finder_(new ShapeAnalysis_Surface(surface_)),
        tolerance_(tolerance),
        limit_(limit) {
    if (surface_->IsUPeriodic()) period_[0] = surface_->UPeriod();
    if (surface_->IsVPeriodic()) period_[1] = surface_->VPeriod();
  }

  const Handle(Geom_Surface) & surface() const { return surface_; }

  // Its parameters near others, as far as periods leave a choice. Throws OutOfTime.
  Vec2 foot(const Vec3& point, const std::optional<Vec2>& near) const {
    if (limit_.reached()) throw OutOfTime();
    const gp_Pnt p(point[0], point[1], point[2]);
    const gp_Pnt2d found = finder_->ValueOfUV(p, tolerance_);
    Vec2 uv{found.X(), found.Y()};
    for (int i = 0; i < kNewtonSteps; ++i) {
      const Frame at = frame_at(surface_, uv);
      const Vec2 next = bounded(uv + chart_step(at, point - at.point));
      if (distance(frame_at(surface_, next).point, point) > distance(at.point, point)) break;
      uv = next;
    }
    for (int k = 0; near && k < 2; ++k)
      if (period_[k] > 0) uv[k] += period_[k] * std::round(((*near)[k] - uv[k]) / period_[k]);
    return uv;
  }

  double gap(const Vec3& point, const Vec2& uv) const {
    return distance(point, frame_at(surface_, uv).point);
  }

 private:
  Vec2 bounded(Vec2 uv) const {
    Vec2 low, high;
    surface_->Bounds(low[0], high[0], low[1], high[1]);
    for (int k = 0; k < 2; ++k)
      if (period_[k] == 0) uv[k] = std::clamp(uv[k], low[k], high[k]);
    return uv;
  }

  Handle(Geom_Surface) surface_;
  Handle(ShapeAnalysis_Surface) finder_;
  double tolerance_;
  PolledLimit& limit_;
  Vec2 period_;
};

// --- edges of one face as cuts of the other

struct EdgeJet {
  Vec3 point, rate;
  Vec2 uv, uv_rate;  // of the cut face
};

// An edge of a face, seen on the surface of another one.
class EdgeBeside {
 public:
  EdgeBeside(const TopoDS_Edge& edge, const TopoDS_Face& face, const Feet& feet)
      : feet_(feet), surface_(BRep_Tool::Surface(face)) {
    chart_ = BRep_Tool::CurveOnSurface(edge, face, range_.from, range_.to);
    if (chart_.IsNull()) throw BadModel("an edge has no parametric curve on the face it bounds");
  }

  const Interval& range() const { return range_; }

  EdgeJet jet(double t, const std::optional<Vec2>& near) const {
    gp_Pnt2d c;
    gp_Vec2d dc;
    chart_->D1(t, c, dc);
    const Frame own = frame_at(surface_, {c.X(), c.Y()});
    EdgeJet jet{own.point, dc.X() * own.du + dc.Y() * own.dv, feet_.foot(own.point, near), {}};
    jet.uv_rate = chart_step(frame_at(feet_.surface(), jet.uv), jet.rate);
    return jet;
  }

  bool lies_on(double t, double reach) const {
    const EdgeJet at = jet(t, {});
    return feet_.gap(at.point, at.uv) <= reach;
  }

  // Where it lies on the surface, in runs.
  std::vector<Interval> runs(double reach) const {
    std::vector<Interval> runs;
    const auto border = [&](double on, double off) {
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (on + off);
        (lies_on(middle, reach) ? on : off) = middle;
      }
      return on;
    };
    double before = range_.from;
    for (int i = 0; i <= kEdgeSamples; ++i) {
      const double t = at(range_, static_cast<double>(i) / kEdgeSamples);
      const bool on = lies_on(t, reach);
      const bool goes_on = !runs.empty() && runs.back().to == before;
      if (on && goes_on)
        runs.back().to = t;
      else if (on)
        runs.push_back({i > 0 ? border(t, before) : t, t});
      else if (goes_on)
        runs.back().to = border(before, t);
      before = t;
    }
    std::erase_if(runs, [](const Interval& run) { return !(run.from < run.to); });
    return runs;
  }

 private:
  const Feet& feet_;
  Handle(Geom_Surface) surface_;
  Handle(Geom2d_Curve) chart_;
  Interval range_;
};

// Cubic pieces with the values and first derivatives of the edge.
FaceCut hermite_cut(const EdgeBeside& edge, const Interval& run, int pieces, double tolerance) {
  FaceCut cut;
  cut.tolerance = tolerance;
  const double third = length(run) / pieces / 3;
  std::optional<Vec2> near;
  for (int i = 0; i <= pieces; ++i) {
    const double t = at(run, static_cast<double>(i) / pieces);
    const EdgeJet jet = edge.jet(t, near);
    near = jet.uv;
    const bool inner = i > 0 && i < pieces;
    const auto add = [&](double step) {
      cut.curve.points.push_back(jet.point + step * jet.rate);
      cut.chart.points.push_back(jet.uv + step * jet.uv_rate);
    };
    if (i > 0) add(-third);
    if (!inner) add(0);
    if (i < pieces) add(third);
    cut.curve.knots.push_back(t);
    cut.curve.multiplicities.push_back(inner ? 2 : 4);
  }
  cut.curve.degree = cut.chart.degree = 3;
  cut.chart.knots = cut.curve.knots;
  cut.chart.multiplicities = cut.curve.multiplicities;
  return cut;
}

FaceCut fitted_cut(const EdgeBeside& edge, const Interval& run, const Feet& feet,
                   double tolerance) {
  for (int pieces = kLeastPieces;; pieces *= 2) {
    FaceCut cut = hermite_cut(edge, run, pieces, tolerance);
    double off = 0;
    for (int i = 0; i < pieces; ++i) {
      const double t = at(run, (i + 0.5) / pieces);
      const Vec3 point = edge.jet(t, {}).point;
      off = std::max(
          {off, distance(point, point_at(cut.curve, t)), feet.gap(point, point_at(cut.chart, t))});
    }
    if (off <= kFitShare * tolerance) return cut;
    if (pieces < kMostPieces) continue;
    // As where it crosses the seam of a surface that is closed but has no period.
    if (off > tolerance) throw Failure("an edge has no image in the chart of the other face");
    return cut;
  }
}

std::vector<FaceCut> edge_cuts(const TopoDS_Face& face, const Feet& feet, double reach,
                               double tolerance) {
  std::vector<FaceCut> cuts;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) continue;
    const EdgeBeside beside(edge, face, feet);
    for (const Interval& run : beside.runs(reach))
      cuts.push_back(
          fitted_cut(beside, run, feet, std::max(tolerance, BRep_Tool::Tolerance(edge))));
  }
  return cuts;
}

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

// The boundary of a face, which lies on its left.
std::vector<SurfacePoint> boundary_of(const TopoDS_Face& piece, const Feet& on_a,
                                      const Feet& on_b) {
  const FaceTrims trims = face_trims(piece);
  std::vector<std::vector<SurfacePoint>> loops;
  std::optional<Vec2> near;
  const auto uv_at = [&](const Coedge& coedge, double t) {
    const Vec2 c = point_at(coedge.curve, t);
    return Vec2{c[0] / trims.scale[0], c[1] / trims.scale[1]};
  };
  const auto add = [&](const Coedge& coedge) {
    const int samples = samples_of(
        coedge, [&](double t) { return frame_at(on_a.surface(), uv_at(coedge, t)).point; });
    for (int i = 0; i < samples; ++i) {
      const double part = static_cast<double>(i) / samples;
      const Vec2 uv = uv_at(coedge, at(coedge.curve.domain(), coedge.reversed() ? 1 - part : part));
      const Vec3 point = frame_at(on_a.surface(), uv).point;
      near = on_b.foot(point, near);
      loops.back().push_back({point, uv, *near});
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

double largest_gap(const std::vector<SurfacePoint>& boundary, const Feet& on_b) {
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
  const Feet on_a(cut_face, tolerance, limit), on_b(b, tolerance, limit);
  const FaceTrims trims_a = face_trims(cut_face), trims_b = face_trims(b);
  double gap = 0;
  for (const Overlap& region : whole) gap = std::max(gap, region.gap_high);
  const double reach = std::max(kReach * tolerance, 2 * gap);
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
    region.boundary = boundary_of(TopoDS::Face(piece.face.Oriented(TopAbs_FORWARD)), on_a, on_b);
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
  } catch (const OutOfTime&) {
    return {{}, false, polled.reason()};
  }
}

}  // namespace blossom::occt
