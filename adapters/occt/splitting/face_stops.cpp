// SPDX-License-Identifier: LGPL-2.1-or-later
// Between the steps: what the faces on both sides of a cut tell each other of where it is divided.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <BRep_Tool.hxx>

#include "adapters/occt/splitting/face_splitter.h"
#include "core/base/sampled_margin.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

double uncertainty_of(const CutStop& stop) {
  if (stop.vertex.IsNull()) return 0;
  return std::max(kSampledMargin * BRep_Tool::Tolerance(stop.vertex), stop.uncertainty);
}

}  // namespace

std::vector<CutStop> FaceSplitter::stops(int cut) const {
  std::vector<CutStop> found;
  for (const LiftedCut& lifted_cut : lifted_cuts_) {
    if (lifted_cut.cut != cut) continue;
    for (const auto& [parameter, vertex] : lifted_cut.stops) {
      const Vertex& at = vertices_[static_cast<std::size_t>(vertex)];
      const bool border = at.split >= 0;
      found.push_back(
          {parameter,
           border ? splits_.vertex(edge_of(coedge(at.loop, at.coedge)), at.split) : TopoDS_Vertex(),
           at.uncertainty});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const CutStop& a, const CutStop& b) { return a.parameter < b.parameter; });
  return found;
}

// The place of the stop nearest to a parameter, -1 if none is within reach, or within the
// uncertainty of its vertex.
int FaceSplitter::stop_near(const LiftedCut& lifted_cut, double parameter, double reach) const {
  const Vec2 point = point_at(lifted_cut.curve, parameter);
  int nearest = -1;
  double least = kInfinity;
  for (std::size_t i = 0; i < lifted_cut.stops.size(); ++i) {
    const double own = lifted_cut.stops[i].first;
    const double gap = distance(point_at(lifted_cut.curve, own), point);
    const double uncertainty =
        vertices_[static_cast<std::size_t>(lifted_cut.stops[i].second)].uncertainty;
    if (gap >= least || !is_near(lifted_cut.curve, own, parameter, std::max(reach, uncertainty)))
      continue;
    least = gap;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

int FaceSplitter::met_stop(const LiftedCut& lifted_cut, const CutStop& stop) const {
  return stop_near(lifted_cut, stop.parameter,
                   std::max(8 * reach(lifted_cut), uncertainty_of(stop)));
}

void FaceSplitter::unite_borders(int cut, const CutStop& stop) {
  for (const LiftedCut& lifted_cut : lifted_cuts_) {
    if (lifted_cut.cut != cut) continue;
    const int near = met_stop(lifted_cut, stop);
    if (near < 0) continue;
    const int vertex = lifted_cut.stops[static_cast<std::size_t>(near)].second;
    const Vertex& at = vertices_[static_cast<std::size_t>(vertex)];
    if (at.split < 0) continue;
    const TopoDS_Vertex own = splits_.vertex(edge_of(coedge(at.loop, at.coedge)), at.split);
    if (BRep_Tool::Pnt(own).Distance(BRep_Tool::Pnt(stop.vertex)) <= reach(lifted_cut))
      splits_.unite(own, stop.vertex);
  }
}

void FaceSplitter::meet(int cut, const CutStop& stop) {
  const double uncertainty = uncertainty_of(stop);
  for (LiftedCut& lifted_cut : lifted_cuts_) {
    if (lifted_cut.cut != cut) continue;
    const int near = met_stop(lifted_cut, stop);
    if (near < 0) continue;
    auto& own = lifted_cut.stops[static_cast<std::size_t>(near)];
    Vertex& at = vertices_[static_cast<std::size_t>(own.second)];
    at.uncertainty = std::max(at.uncertainty, uncertainty);
    if (at.split < 0) {
      own.first = stop.parameter;
      lifted_cut.met.push_back(stop.parameter);
    }
    tie(own.second, stop.vertex);
  }
}

// Two cuts that lead from one vertex to another within the first one's uncertainty cross there only
// because they reach beyond the border at which they should end.
void FaceSplitter::unite_uncertain() {
  std::vector<std::pair<int, int>> known;
  for (const LiftedCut& lifted_cut : lifted_cuts_)
    for (std::size_t i = 0; i + 1 < lifted_cut.stops.size(); ++i) {
      const auto [a, b] = std::minmax(lifted_cut.stops[i].second, lifted_cut.stops[i + 1].second);
      const double uncertainty = std::max(vertices_[static_cast<std::size_t>(a)].uncertainty,
                                          vertices_[static_cast<std::size_t>(b)].uncertainty);
      if (a != b && is_near(lifted_cut.curve, lifted_cut.stops[i].first,
                            lifted_cut.stops[i + 1].first, uncertainty))
        known.emplace_back(a, b);
    }
  std::sort(known.begin(), known.end());
  for (auto pair = known.begin(); (pair = std::adjacent_find(pair, known.end())) != known.end();
       ++pair)
    unite(pair->first, pair->second);
}

// A cut that meets something at a small angle may go on past it, to a loose end that is no farther
// off than that place is uncertain.
void FaceSplitter::unite_loose_ends() {
  const auto is_loose = [&](int vertex) {
    std::size_t uses = 0;
    for (const LiftedCut& lifted_cut : lifted_cuts_)
      uses += static_cast<std::size_t>(
          std::ranges::count(lifted_cut.stops, vertex, &std::pair<double, int>::second));
    return uses == 1 && vertices_[static_cast<std::size_t>(vertex)].split < 0;
  };
  for (const LiftedCut& lifted_cut : lifted_cuts_) {
    const auto& stops = lifted_cut.stops;
    if (stops.size() < 2) continue;
    for (const auto& [end, next] :
         {std::pair{stops.front(), stops[1]}, std::pair{stops.back(), stops[stops.size() - 2]}})
      if (is_near(lifted_cut.curve, end.first, next.first,
                  vertices_[static_cast<std::size_t>(next.second)].uncertainty) &&
          is_loose(end.second))
        unite(next.second, end.second);
  }
}

// What is in a vertex of the border is that vertex, however it came to be so wide.
void FaceSplitter::tidy() {
  for (Vertex& at : vertices_)
    if (at.split >= 0)
      at.uncertainty =
          std::max(at.uncertainty, splits_.covered(edge_of(coedge(at.loop, at.coedge)), at.split));
  unite_uncertain();
  unite_loose_ends();
  for (LiftedCut& lifted_cut : lifted_cuts_) tidy_stops(lifted_cut, 8 * reach(lifted_cut));
  // What is one here is one everywhere.
  for (auto tied = aliases_.begin(); tied != aliases_.end(); ++tied)
    if (const auto first =
            std::ranges::find(aliases_, tied->second, &std::pair<TopoDS_Vertex, int>::second);
        first != tied)
      splits_.unite(first->first, tied->first);
}

void FaceSplitter::divide(int cut, const CutStop& stop) {
  const double uncertainty = uncertainty_of(stop);
  for (LiftedCut& lifted_cut : lifted_cuts_) {
    if (lifted_cut.cut != cut) continue;
    const Vec2 point = point_at(lifted_cut.curve, stop.parameter);
    const double reach_here = std::max(8 * reach(lifted_cut), uncertainty);
    const int near = stop_near(lifted_cut, stop.parameter, reach_here);
    int vertex = near < 0 ? -1 : lifted_cut.stops[static_cast<std::size_t>(near)].second;
    if (vertex < 0) {
      if (!is_inside(trims_, point)) continue;
      vertex = node_near(point);
      lifted_cut.stops.emplace_back(stop.parameter, vertex);
    }
    if (!stop.vertex.IsNull()) tie(vertex, stop.vertex);
    tidy_stops(lifted_cut, reach_here);
  }
}

// Whether two points are a period of the surface apart, or most of it: such vertices may be one in
// space, but never one in the face's plane.
bool FaceSplitter::are_images(int a, int b) const {
  const Vec2 &of_a = vertices_[static_cast<std::size_t>(a)].point,
             &of_b = vertices_[static_cast<std::size_t>(b)].point;
  for (int k = 0; k < 2; ++k)
    if (trims_.period[k] > 0 && std::abs(of_a[k] - of_b[k]) > 0.5 * trims_.period[k]) return true;
  return false;
}

// The vertex on a border, on this side of a seam, that is one with that of another shape, as edges
// that meet know; -1 if there is none, or one on each of several edges.
int FaceSplitter::border_vertex(const TopoDS_Vertex& other, int on_this_side) {
  int found = -1;
  for (std::size_t loop = 0; loop < trims_.loops.size(); ++loop)
    for (std::size_t i = 0; i < trims_.loops[loop].size(); ++i) {
      const TopoDS_Edge& edge = edge_of(trims_.loops[loop][i]);
      for (int split = 0; split < splits_.count(edge); ++split) {
        if (!splits_.are_one(splits_.vertex(edge, split), other)) continue;
        const int vertex = vertex_at_split(static_cast<int>(loop), static_cast<int>(i), split);
        if (are_images(vertex, on_this_side)) continue;
        if (found >= 0 && found != vertex) return -1;
        found = vertex;
      }
    }
  return found;
}

// Vertices that stand for the same vertex of another face become one.
void FaceSplitter::tie(int vertex, const TopoDS_Vertex& other) {
  const auto known = std::ranges::find_if(aliases_, [&](const auto& tied) {
    return splits_.are_one(tied.first, other) && !are_images(tied.second, vertex);
  });
  if (known == aliases_.end()) {
    const int own = border_vertex(other, vertex);
    aliases_.emplace_back(other, own >= 0 ? own : vertex);
    if (own >= 0) unite(own, vertex);
    return;
  }
  unite(known->second, vertex);
}

// Two vertices of the borders stay two.
void FaceSplitter::unite(int kept, int left) {
  const auto on_border = [&](int i) { return vertices_[static_cast<std::size_t>(i)].split >= 0; };
  if (on_border(left)) std::swap(kept, left);
  if (kept == left || on_border(left)) return;
  Vertex& of = vertices_[static_cast<std::size_t>(kept)];
  const Vertex& other = vertices_[static_cast<std::size_t>(left)];
  of.uncertainty = std::max(
      {of.uncertainty, other.uncertainty, kSampledMargin * distance(of.point, other.point)});
  of.touch = std::max(of.touch, other.touch);
  for (auto& tied : aliases_)
    if (tied.second == left) tied.second = kept;
  for (LiftedCut& lifted_cut : lifted_cuts_)
    for (auto& stop : lifted_cut.stops)
      if (stop.second == left) stop.second = kept;
}

}  // namespace blossom::occt
