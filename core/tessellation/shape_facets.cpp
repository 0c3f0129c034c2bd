// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/shape_facets.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "core/math/index.h"
#include "core/tessellation/edge_polyline.h"

namespace blossom {
namespace {

void check(const ShapeModel& model, const FacetOptions& options) {
  if (!(options.deviation > 0) || !std::isfinite(options.deviation))
    throw InvalidInput("shape_facets: the deviation must be positive and finite, got " +
                       std::to_string(options.deviation));
  if (!(options.angle >= 0) || !(options.edge_length >= 0))
    throw InvalidInput("shape_facets: the angle and the length must not be negative");
  if (options.aspect != 0 && !(options.aspect >= 1))
    throw InvalidInput("shape_facets: nothing is less long than wide, got the aspect " +
                       std::to_string(options.aspect));
  const auto is_in = [](int i, std::size_t count) { return i >= 0 && index(i) < count; };
  for (const ModelEdge& edge : model.edges)
    if (!is_in(edge.from, model.vertices.size()) || !is_in(edge.to, model.vertices.size()))
      throw InvalidInput("shape_facets: an edge names a vertex that is not there");
  for (const ModelFace& face : model.faces) {
    if (face.edges.size() != face.chart.borders.size())
      throw InvalidInput("shape_facets: a face has as many edges as borders");
    if (!(face.part > 0) || !(face.part <= 1))
      throw InvalidInput("shape_facets: a part of the deviation is in 0..1");
    for (const int edge : face.edges)
      if (!is_in(edge, model.edges.size()))
        throw InvalidInput("shape_facets: a face names an edge that is not there");
  }
}

FacetOptions finer(FacetOptions options, double part) {
  options.deviation *= part;
  return options;
}

// Of the deviation, for each edge: what the finest of its faces is to keep.
std::vector<double> parts_of_edges(const ShapeModel& model) {
  std::vector<double> parts(model.edges.size(), 1);
  for (const ModelFace& face : model.faces)
    for (const int edge : face.edges) parts[index(edge)] = std::min(parts[index(edge)], face.part);
  return parts;
}

class Mesher {
 public:
  Mesher(const ShapeModel& model, const FacetOptions& options, const std::function<bool()>& ask)
      : model_(model),
        options_(options),
        ask_(ask),
        polylines_(model.edges.size()),
        surfaces_(model.faces.size()),
        parted_(model.faces.size()),
        attempts_(model.faces.size()) {}

  ShapeFacets facets() {
    const std::vector<double> parts = parts_of_edges(model_);
    parallel_for(model_.edges.size(), 16, [&](std::size_t k) {
      const ModelEdge& edge = model_.edges[k];
      if (edge.is_point) return;
      polylines_[k] = EdgePolyline(edge.curve, edge.from == edge.to, finer(options_, parts[k]));
    });
    part_common_chords();
    std::vector<std::size_t> open(model_.faces.size());
    for (std::size_t f = 0; f < open.size(); ++f) open[f] = f;
    for (int round = 0; round <= kLastRound && !open.empty(); ++round) {
      attempt(open, round);
      if (stopped_) break;
      open = faces_at(divide(open));
    }
    for (open = faces_with_common_diagonals(); !open.empty() && !stopped_;
         open = faces_with_common_diagonals())
      attempt(open, kLastRound);
    ShapeFacets result;
    result.stopped = stopped_;
    return stopped_ ? result : numbered();
  }

 private:
  bool goes_on() {
    if (!ask_) return true;
    const std::lock_guard<std::mutex> lock(asking_);
    if (!stopped_ && !ask_()) stopped_ = true;
    return !stopped_;
  }

  // Of edges between the same vertices one at most is its chord, the straightest: else all their
  // faces would have that side in common.
  void part_common_chords() {
    std::map<std::pair<int, int>, std::size_t> straightest;
    for (std::size_t k = 0; k < polylines_.size(); ++k) {
      if (polylines_[k].segments() != 1) continue;
      const auto ends = std::minmax(model_.edges[k].from, model_.edges[k].to);
      const auto [known, is_first] = straightest.try_emplace(ends, k);
      if (is_first) continue;
      std::size_t bent = k;
      if (polylines_[k].distance() < polylines_[known->second].distance())
        std::swap(bent, known->second);
      polylines_[bent].split({0});
    }
  }

  void attempt(const std::vector<std::size_t>& faces, int round) {
    parallel_for(faces.size(), 1, [&](std::size_t k) {
      if (!goes_on()) return;
      const std::size_t f = faces[k];
      const ModelFace& face = model_.faces[f];
      const FacetOptions options = finer(options_, face.part);
      if (!surfaces_[f]) surfaces_[f] = std::make_unique<ChartSurface>(face.surface, options);
      attempts_[f] = facets_of(face, model_, polylines_, *surfaces_[f], options, parted_[f], round,
                               [this] { return goes_on(); });
    });
  }

  // The edges that were divided.
  std::set<int> divide(const std::vector<std::size_t>& faces) {
    std::set<std::pair<int, std::size_t>> wanted;
    for (const std::size_t f : faces)
      for (const EdgeSegment& segment : attempts_[f].splits)
        wanted.insert({segment.edge, segment.number});
    std::set<int> edges;
    for (auto it = wanted.begin(); it != wanted.end();) {
      const int edge = it->first;
      std::vector<std::size_t> segments;
      for (; it != wanted.end() && it->first == edge; ++it) segments.push_back(it->second);
      polylines_[index(edge)].split(segments);
      edges.insert(edge);
    }
    return edges;
  }

  std::vector<std::size_t> faces_at(const std::set<int>& edges) const {
    std::vector<std::size_t> found;
    if (edges.empty()) return found;
    for (std::size_t f = 0; f < model_.faces.size(); ++f)
      if (std::ranges::any_of(model_.faces[f].edges, [&](int e) { return edges.contains(e); }))
        found.push_back(f);
    return found;
  }

  struct SideUse {
    FacetSide side;
    std::size_t face = 0;
  };

  // Between the same two points of edges, diagonals of different faces and chords are one side,
  // which would have more than two facets. One at most may stay, a chord if there is one; what the
  // other faces have to part is noted. They are done when nothing new is.
  std::vector<std::size_t> faces_with_common_diagonals() {
    std::vector<SideUse> uses;
    for (std::size_t f = 0; f < attempts_.size(); ++f)
      for (const FacetSide& side : attempts_[f].facets.sides) uses.push_back({side, f});
    std::ranges::stable_sort(uses, {}, [](const SideUse& use) { return use.side.ends; });
    std::set<std::size_t> changed;
    for (auto from = uses.begin(); from != uses.end();) {
      const auto to = std::find_if(
          from, uses.end(), [&](const SideUse& use) { return use.side.ends != from->side.ends; });
      const bool has_chord =
          std::any_of(from, to, [](const SideUse& use) { return !use.side.across; });
      const auto first =
          std::count_if(from, to, [&](const SideUse& use) { return use.face == from->face; });
      const bool first_stays = !has_chord && first <= 2;
      for (auto use = from; use != to && to - from > 2; ++use)
        if (use->side.across && !(first_stays && use->face == from->face) &&
            parted_[use->face].insert(use->side.ends).second)
          changed.insert(use->face);
      from = to;
    }
    return {changed.begin(), changed.end()};
  }

  // What is numbered goes: the points of all faces would be there twice.
  ShapeFacets numbered() {
    ShapeFacets result;
    result.points.reserve(point_count());
    result.points = model_.vertices;
    std::vector<int> first_inner(polylines_.size(), 0);  // of each edge
    for (std::size_t k = 0; k < polylines_.size(); ++k) {
      if (polylines_[k].segments() == 0) continue;
      first_inner[k] = static_cast<int>(result.points.size());
      const std::vector<Vec3>& points = polylines_[k].points();
      if (points.size() > 2)
        result.points.insert(result.points.end(), points.begin() + 1, points.end() - 1);
      const ModelEdge& edge = model_.edges[k];
      const double off = std::max(distance(points.front(), result.points[index(edge.from)]),
                                  distance(points.back(), result.points[index(edge.to)]));
      result.distance = std::max(result.distance, polylines_[k].distance() + off);
    }
    result.faces.reserve(attempts_.size());
    for (FaceAttempt& made : attempts_)
      result.faces.push_back(numbered(std::exchange(made, {}).facets, first_inner, result));
    return result;
  }

  std::size_t point_count() const {
    std::size_t count = model_.vertices.size();
    for (const EdgePolyline& line : polylines_) count += line.points().size();
    for (const FaceAttempt& made : attempts_)
      for (const FaceCorner& corner : made.facets.corners) count += corner.origin.edge < 0;
    return count;
  }

  MeshedFace numbered(FaceFacets facets, const std::vector<int>& first_inner,
                      ShapeFacets& all) const {
    MeshedFace face;
    face.triangles = std::move(facets.triangles);
    face.distance = facets.distance;
    face.moved = facets.moved;
    face.folded = facets.folded;
    face.obstacle = std::move(facets.obstacle);
    face.vertices.reserve(facets.corners.size());
    face.uv.reserve(facets.corners.size());
    face.normals.reserve(facets.corners.size());
    for (const FaceCorner& corner : facets.corners) {
      int vertex = static_cast<int>(all.points.size());
      if (corner.origin.edge < 0)
        all.points.push_back(corner.point);
      else
        vertex = number_of(corner.origin, first_inner);
      face.vertices.push_back(vertex);
      face.uv.push_back(corner.uv);
      face.normals.push_back(corner.normal);
    }
    all.distance = std::max(all.distance, face.distance);
    return face;
  }

  int number_of(const PolylinePoint& origin, const std::vector<int>& first_inner) const {
    const ModelEdge& edge = model_.edges[index(origin.edge)];
    if (origin.number == 0) return edge.from;
    if (origin.number == polylines_[index(origin.edge)].segments()) return edge.to;
    return first_inner[index(origin.edge)] + static_cast<int>(origin.number) - 1;
  }

  const ShapeModel& model_;
  const FacetOptions& options_;
  const std::function<bool()>& ask_;
  std::mutex asking_;
  std::atomic<bool> stopped_ = false;
  std::vector<EdgePolyline> polylines_;
  std::vector<std::unique_ptr<ChartSurface>> surfaces_;
  std::vector<std::set<CommonSide>> parted_;  // of each face
  std::vector<FaceAttempt> attempts_;
};

}  // namespace

ShapeFacets shape_facets(const ShapeModel& model, const FacetOptions& options,
                         const std::function<bool()>& ask) {
  check(model, options);
  return Mesher(model, options, ask).facets();
}

}  // namespace blossom
