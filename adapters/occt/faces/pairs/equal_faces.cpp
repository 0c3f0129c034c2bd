// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/pairs/equal_faces.h"

#include <cstddef>

#include "adapters/occt/faces/face_trims.h"
#include "core/base/parallel.h"

namespace blossom::occt {
namespace {

constexpr double kEqual = 1e-3;     // of the tolerance: what differs by less is rounding
constexpr std::size_t kGrain = 16;  // pairs that one thread compares in a row

bool is_exact(const FaceMatch& match) {
  return match.gap == 0 && match.same_tolerances && !match.map.exchanged &&
         match.map.slope == Vec2{1, 1} && match.map.offset == Vec2{0, 0};
}

}  // namespace

FaceCopies::FaceCopies(const FaceList& a, const FaceList& b,
                       const std::vector<std::pair<int, int>>& pairs, double tolerance)
    : a_(a),
      b_(b),
      originals_(b.size(), -1),
      exact_originals_(b.size(), -1),
      exact_copies_(a.size(), -1) {
  std::vector<std::optional<FaceMatch>> found(pairs.size());
  parallel_for(pairs.size(), kGrain, [&](std::size_t k) {
    found[k] = match(a.data(static_cast<std::size_t>(pairs[k].first)),
                     b.data(static_cast<std::size_t>(pairs[k].second)), kEqual * tolerance);
  });
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!found[k] || found[k]->gap > tolerance) continue;
    int& original = originals_[static_cast<std::size_t>(pairs[k].second)];
    if (original < 0) original = pairs[k].first;
    if (is_exact(*found[k])) {
      exact_originals_[static_cast<std::size_t>(pairs[k].second)] = pairs[k].first;
      exact_copies_[static_cast<std::size_t>(pairs[k].first)] = pairs[k].second;
    }
    matches_.emplace(pairs[k], *std::move(found[k]));
  }
}

const FaceMatch* FaceCopies::between(int a, int b) const {
  const auto found = matches_.find({a, b});
  return found == matches_.end() ? nullptr : &found->second;
}

std::pair<int, int> FaceCopies::exchanged(const std::pair<int, int>& pair) const {
  const auto turned = [&](const std::pair<int, int>& of) {
    return std::pair{exact_originals_[static_cast<std::size_t>(of.second)],
                     exact_copies_[static_cast<std::size_t>(of.first)]};
  };
  const std::pair<int, int> other = turned(pair);
  // Where there are several equal faces each has one copy that is taken for its own.
  return other.first >= 0 && other.second >= 0 && turned(other) == pair ? other : pair;
}

std::vector<SharedEdge> FaceCopies::shared(int a, int b) const {
  const TopoDS_Face& face_a = a_.face(static_cast<std::size_t>(a));
  const TopoDS_Face& face_b = b_.face(static_cast<std::size_t>(b));
  const int original = originals_[static_cast<std::size_t>(b)];
  if (original < 0) return shared_edges(face_a, face_b);
  const TopoDS_Face& copied = a_.face(static_cast<std::size_t>(original));
  const ChartMap& map = matches_.at({original, b}).map;
  std::vector<SharedEdge> edges = shared_edges(face_a, copied);
  if (edges.empty()) return edges;
  const TrimShapes of_original = trim_shapes(copied), of_b = trim_shapes(face_b);
  for (SharedEdge& edge : edges) {
    if (edge.in_b >= 0) edge.in_b = of_b.edges.FindIndex(of_original.edges(edge.in_b + 1)) - 1;
    for (Vec2& point : edge.curve.chart_b.points) point = map(point);
    for (SurfacePoint& sample : edge.curve.samples) sample.uv_b = map(sample.uv_b);
  }
  return edges;
}

}  // namespace blossom::occt
