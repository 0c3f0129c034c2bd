// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/ray_casting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/intersection_edges.h"
#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"
#include "core/rays/ray_batches.h"
#include "core/topology/chart_region.h"

namespace blossom::occt {
namespace {

// A hit beside an edge lies in its neighbour within this many times the edge's tolerance.
constexpr double kBesideEdge = 4;

struct RayFace {
  FaceTrims trims;
  TrimShapes shapes;
  ChartRegion region;
  bool reversed = false;

  explicit RayFace(const TopoDS_Face& face)
      : trims(face_trims(face)),
        shapes(trim_shapes(face)),
        region(trims),
        reversed(face.Orientation() == TopAbs_REVERSED) {}
};

// number   of the face in messages, from 1
BezierSurface surface_of(const TopoDS_Face& face, std::size_t number, double tolerance) {
  try {
    return bezier_surface(face, tolerance);
  } catch (const std::runtime_error& error) {
    throw BadModel("face " + std::to_string(number) + ": " + error.what());
  }
}

constexpr const char* kPreparing = "preparing faces for rays";

RayCaster caster_of(const std::vector<TopoDS_Face>& faces, double tolerance,
                    const WorkLimit* limit) {
  if (faces.empty()) throw BadModel("there is no face to cast rays at");
  std::vector<BezierSurface> surfaces;
  std::vector<double> reaches;
  for (const TopoDS_Face& face : faces) {
    check_limit(limit, kPreparing);
    surfaces.push_back(surface_of(face, surfaces.size() + 1, tolerance));
    reaches.push_back(std::max(tolerance, largest_edge_tolerance(face)));
  }
  return RayCaster(std::move(surfaces), {.point = tolerance}, std::move(reaches));
}

// What of an edge is near a hit.
struct NearEdge {
  double distance = kInfinity;  // to the edge's image on the face
  double tolerance = 0;         // of the edge
  TopoDS_Shape shape;           // the edge, or the vertex that is as near
};

}  // namespace

struct ShapeRays::Impl {
  Impl(const std::vector<TopoDS_Face>& all, double within, const WorkLimit* limit)
      : faces(all), tolerance(within), caster(caster_of(all, within, limit)) {
    rayed.reserve(all.size());
    for (const TopoDS_Face& face : all) {
      check_limit(limit, kPreparing);
      rayed.emplace_back(face);
      TopExp::MapShapes(face, TopAbs_EDGE, named);
    }
    for (const TopoDS_Face& face : all) TopExp::MapShapes(face, TopAbs_VERTEX, named);
  }

  Vec3 image(int face, const Vec2& chart) const {
    const Vec2& scale = rayed[static_cast<std::size_t>(face)].trims.scale;
    return point_at(caster.cells().surfaces()[static_cast<std::size_t>(face)],
                    {chart[0] / scale[0], chart[1] / scale[1]});
  }

  NearEdge nearest_edge(int face, const Vec2& chart, const Vec3& point) const;
  bool has_edge(int face, const TopoDS_Shape& edge) const;

  std::vector<TopoDS_Face> faces;
  double tolerance;
  RayCaster caster;
  std::vector<RayFace> rayed;
  TopTools_IndexedMapOfShape named;  // edges, then vertices

  // Marks of hits say which of the named shapes they are on or, within its tolerance, beside. Of
  // hits that are joined the largest mark stays, so what is on a shape has the larger ones.
  int mark_beside(const TopoDS_Shape& shape) const { return named.FindIndex(shape); }
  int mark_on(const TopoDS_Shape& shape) const { return named.Extent() + named.FindIndex(shape); }
  bool is_on(int mark) const { return mark > named.Extent(); }
  const TopoDS_Shape& marked(int mark) const {
    return named.FindKey(is_on(mark) ? mark - named.Extent() : mark);
  }
};

// The edge of the face that is nearest to a hit; a vertex wins where it is as near.
NearEdge ShapeRays::Impl::nearest_edge(int face, const Vec2& chart, const Vec3& point) const {
  const FaceTrims& trims = rayed[static_cast<std::size_t>(face)].trims;
  const TrimShapes& shapes = rayed[static_cast<std::size_t>(face)].shapes;
  const double margin = 0.05 * norm(trims.box.high - trims.box.low);
  NearEdge best;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      if (!holds(box_of(coedge.curve), chart, margin)) continue;
      const PlanarFoot foot = nearest(coedge.curve, chart);
      const double gap = distance(image(face, point_at(coedge.curve, foot.parameter)), point);
      if (gap < best.distance) {
        best.distance = gap;
        best.tolerance = coedge.tolerance;
        if (best.shape.IsNull() || best.shape.ShapeType() != TopAbs_VERTEX)
          best.shape = shapes.edge(coedge);
      }
      const Interval domain = coedge.curve.domain();
      for (const bool last : {false, true}) {
        const Vec2 end = point_at(coedge.curve, last ? domain.to : domain.from);
        if (distance(image(face, end), point) > tolerance) continue;
        best.shape = shapes.vertices((last != coedge.reversed ? coedge.end : coedge.start) + 1);
      }
    }
  return best;
}

bool ShapeRays::Impl::has_edge(int face, const TopoDS_Shape& edge) const {
  const RayFace& of = rayed[static_cast<std::size_t>(face)];
  const int number = of.shapes.edges.FindIndex(edge) - 1;
  return std::ranges::any_of(of.trims.loops, [&](const std::vector<Coedge>& loop) {
    return std::ranges::any_of(loop, [&](const Coedge& coedge) { return coedge.edge == number; });
  });
}

ShapeRays::ShapeRays(const std::vector<TopoDS_Face>& faces, double tolerance,
                     const WorkLimit* limit)
    : impl_(guarded(kPreparing, [&] { return std::make_unique<Impl>(faces, tolerance, limit); })) {}
ShapeRays::ShapeRays(const TopoDS_Shape& shape, double tolerance)
    : ShapeRays(faces_of(shape), tolerance) {}
ShapeRays::~ShapeRays() = default;
ShapeRays::ShapeRays(ShapeRays&&) noexcept = default;
ShapeRays& ShapeRays::operator=(ShapeRays&&) noexcept = default;

const std::vector<TopoDS_Face>& ShapeRays::faces() const { return impl_->faces; }

ShapeRayQuery::ShapeRayQuery(const ShapeRays& rays)
    : rays_(*rays.impl_),
      query_(rays_.caster),
      filter_([this](RayHit& hit) { return accept(ray_, hit); }) {}

// Whether a hit counts: inside of the trims, or on an edge as far as its tolerance goes.
bool ShapeRayQuery::accept(const Ray& ray, RayHit& hit) {
  const RayFace& face = rays_.rayed[static_cast<std::size_t>(hit.surface)];
  const double speed = norm(ray.direction);
  if ((hit.last - hit.first) * speed > 2 * rays_.tolerance && !face.trims.natural)
    return clip_stretch(ray, hit);
  const Vec2 chart{hit.uv[0] * face.trims.scale[0], hit.uv[1] * face.trims.scale[1]};
  const ChartRegion::Place place = face.region.place(chart);
  if (place == ChartRegion::Place::Outside) return false;
  if (place == ChartRegion::Place::Inside && !hit.border) return true;
  const NearEdge edge = rays_.nearest_edge(hit.surface, chart, hit.point);
  const bool inside = place == ChartRegion::Place::Inside || is_inside(face.trims, chart);
  const double off = std::max(hit.beyond, inside ? 0 : edge.distance);
  if (off > std::max(edge.tolerance, rays_.tolerance)) return false;
  if (off > rays_.tolerance) {
    hit.status = weaker(hit.status, Status::Tolerance);
    hit.approximate = false;
  }
  const bool at_edge = edge.distance <= rays_.tolerance || off > rays_.tolerance;
  if (at_edge && !edge.shape.IsNull())
    hit.mark = rays_.mark_on(edge.shape);
  else if (edge.distance <= edge.tolerance && !edge.shape.IsNull())
    hit.mark = rays_.mark_beside(edge.shape);
  hit.border = hit.border || at_edge;  // patches of the face may meet where no edge is
  return true;
}

// A stretch of the ray in a trimmed face: the parts that are inside. The chart of the stretch is a
// straight line, as in planes and along rulings; the ray's own chart differs from it elsewhere by
// less than what makes it a stretch.
bool ShapeRayQuery::clip_stretch(const Ray& ray, RayHit& hit) {
  const auto& cells = rays_.caster.cells();
  const auto patch = static_cast<std::size_t>(hit.patch);
  const PatchJet jet = jet_at(*cells.patches()[patch].patch, hit.local[0], hit.local[1], 1);
  const Vec3 area = cross(jet.u, jet.v);
  const double per_square = 1 / dot(area, area);
  if (!std::isfinite(per_square)) return true;
  const auto uv_at = [&](double t) {
    const Vec3 r = blossom::point_at(ray, t) - jet.point;
    const Vec2 local{std::clamp(hit.local[0] + dot(r, cross(jet.v, area)) * per_square, 0.0, 1.0),
                     std::clamp(hit.local[1] + dot(r, cross(area, jet.u)) * per_square, 0.0, 1.0)};
    return cells.parameters(hit.patch, local);
  };
  const Interval whole{hit.first, hit.last};
  const Vec2 from = uv_at(whole.from), to = uv_at(whole.to);
  const FaceTrims& trims = rays_.rayed[static_cast<std::size_t>(hit.surface)].trims;
  if (from == to) return is_inside(trims, {from[0] * trims.scale[0], from[1] * trims.scale[1]});
  const std::vector<Interval> inside = clip_to_trims(trims, Spline2{1, {0, 1}, {2, 2}, {from, to}});
  for (std::size_t i = 0; i < inside.size(); ++i) {
    RayHit part = hit;
    part.first = at(whole, inside[i].from);
    part.last = at(whole, inside[i].to);
    part.parameter = at(whole, at(inside[i], 0.5));
    part.uv = uv_at(part.parameter);
    part.point = point_at(cells.surfaces()[static_cast<std::size_t>(hit.surface)], part.uv);
    if (i == 0)
      hit = part;
    else
      more_.push_back(part);
  }
  return !inside.empty();
}

// Whether a hit is there only because the tolerance of an edge makes its two faces overlap, or
// keeps what is outside of the trims: another hit near by stands for both, on a face with that edge
// or, for what is outside, on any that is hit from the same side.
bool ShapeRayQuery::is_repeated(const Ray& ray, std::size_t index) const {
  const RayHit& hit = raw_[index];
  const auto is_outside = [](const RayHit& h) {
    return h.status == Status::Tolerance && h.mark > 0;
  };
  const auto side = [&](const RayHit& h) {
    const bool reversed = rays_.rayed[static_cast<std::size_t>(h.surface)].reversed;
    return (dot(h.normal, ray.direction) > 0) != reversed;
  };
  for (std::size_t k = 0; k < raw_.size(); ++k) {
    const RayHit& other = raw_[k];
    if (other.surface == hit.surface || hit.mark + other.mark == 0) continue;
    const RayHit& marked = hit.mark > 0 ? hit : other;
    const double reach =
        rays_.caster.cells().patches()[static_cast<std::size_t>(marked.patch)].reach;
    if (std::abs(hit.parameter - other.parameter) * norm(ray.direction) > kBesideEdge * reach)
      continue;
    const bool shared =
        rays_.has_edge((hit.mark > 0 ? other : hit).surface, rays_.marked(marked.mark));
    const bool same_side = side(hit) == side(other);
    if (is_outside(hit) ? (k < index || !is_outside(other)) && (same_side || shared)
                        : k < index && !is_outside(other) && same_side && shared)
      return true;
  }
  return false;
}

// Names what hits are on, and leaves out those that are repeated.
std::span<const ShapeHit> ShapeRayQuery::finished(const Ray& ray, std::span<const RayHit> hits,
                                                  bool first_only) {
  raw_.assign(hits.begin(), hits.end());
  if (!more_.empty()) {
    raw_.insert(raw_.end(), more_.begin(), more_.end());
    join_hits(raw_, norm(ray.direction), rays_.tolerance);
  }
  hits_.clear();
  for (std::size_t i = 0; i < raw_.size(); ++i) {
    if (is_repeated(ray, i)) continue;
    ShapeHit next{raw_[i], {}};
    if (rays_.is_on(next.hit.mark)) next.on = rays_.marked(next.hit.mark);
    if (rays_.rayed[static_cast<std::size_t>(next.hit.surface)].reversed)
      next.hit.normal = -next.hit.normal;
    hits_.push_back(next);
    if (first_only && next.hit.status == Status::Complete) break;
  }
  return hits_;
}

std::span<const ShapeHit> ShapeRayQuery::all_hits(const Ray& ray) {
  ray_ = ray;
  more_.clear();
  return finished(ray, query_.all_hits(ray, filter_), false);
}

std::span<const ShapeHit> ShapeRayQuery::first_hits(const Ray& ray) {
  ray_ = ray;
  more_.clear();
  return finished(ray, query_.first_hits(ray, filter_), true);
}

std::vector<ShapeHit> ShapeRays::all_hits(const Ray& ray) const {
  ShapeRayQuery query(*this);
  const std::span<const ShapeHit> hits = query.all_hits(ray);
  return {hits.begin(), hits.end()};
}

std::vector<ShapeHit> ShapeRays::first_hits(const Ray& ray) const {
  ShapeRayQuery query(*this);
  const std::span<const ShapeHit> hits = query.first_hits(ray);
  return {hits.begin(), hits.end()};
}

std::vector<std::vector<ShapeHit>> ShapeRays::all_hits(std::span<const Ray> rays) const {
  return for_all_rays<ShapeRayQuery>(
      *this, rays, [](ShapeRayQuery& query, const Ray& ray) { return query.all_hits(ray); });
}

std::vector<std::vector<ShapeHit>> ShapeRays::first_hits(std::span<const Ray> rays) const {
  return for_all_rays<ShapeRayQuery>(
      *this, rays, [](ShapeRayQuery& query, const Ray& ray) { return query.first_hits(ray); });
}

}  // namespace blossom::occt
