// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/intersection.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/faces/face_list.h"
#include "adapters/occt/faces/pairs/equal_faces.h"
#include "adapters/occt/faces/pairs/touched_planes.h"
#include "adapters/occt/pair_search/pair_intersector.h"
#include "core/base/parallel.h"

namespace blossom::occt {
namespace {

// By pair: the place of the one that is the same in the other order, if it comes first; else its
// own.
std::vector<std::size_t> exchanged_places(const FaceCopies& copies, const FacePairs& pairs) {
  std::vector<std::size_t> places(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto other = std::lower_bound(
        pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(k), copies.exchanged(pairs[k]));
    const auto place = static_cast<std::size_t>(other - pairs.begin());
    places[k] = *other == copies.exchanged(pairs[k]) ? place : k;
  }
  return places;
}

// The places of pairs, large ones first: the last one may be the work of one thread alone.
std::vector<std::size_t> largest_first(const PairIntersector& intersector, const FacePairs& pairs) {
  std::vector<std::size_t> sizes, order(pairs.size());
  for (const auto& pair : pairs) sizes.push_back(intersector.size_of(pair));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) { return sizes[k]; });
  return order;
}

// pairs    in increasing order
ShapeIntersection intersected(const PairIntersector& intersector, const FaceCopies& copies,
                              const FacePairs& pairs, const IntersectionOptions& options) {
  std::vector<FaceIntersection> found(pairs.size());
  const std::vector<std::size_t> places = exchanged_places(copies, pairs);
  const std::vector<std::size_t> order = largest_first(intersector, pairs);
  parallel_for(pairs.size(), 1, [&](std::size_t i) {
    const std::size_t k = order[i];
    if (places[k] == k) found[k] = intersector.of(pairs[k]);
  });
  parallel_for(pairs.size(), 1, [&](std::size_t k) {
    if (places[k] == k) return;
    found[k] = intersector.exchanged(found[places[k]], pairs[k]);
  });
  ShapeIntersection result;
  result.face_pairs = static_cast<long>(pairs.size());
  result.tolerance = options.tolerances.point;
  result.time_limit = options.time_limit;
  for (FaceIntersection& pair : found) {
    result.status = weaker(result.status, pair.found.status);
    add(result.certificate, pair.found.certificate);
    if (!pair.found.curves.empty() || !pair.found.points.empty() || !pair.found.nodes.empty() ||
        !pair.found.places.empty())
      result.pairs.push_back(std::move(pair));
  }
  return result;
}

}  // namespace

ShapeIntersection intersect(const std::vector<TopoDS_Face>& a, const std::vector<TopoDS_Face>& b,
                            const IntersectionOptions& options, Extent extent) {
  const double tolerance = options.tolerances.point;
  ShapeIntersection result;
  with_threads(options.threads, [&] {
    FaceList faces_a(a, "the first shape", tolerance, extent);
    FaceList faces_b(b, "the second shape", tolerance, extent);
    FacePairs pairs = meeting_pairs(faces_a, faces_b);
    convert_meeting(faces_a, faces_b, pairs);
    const FaceCopies copies(faces_a, faces_b, pairs, tolerance);
    const TouchedPlanes touched(faces_a, faces_b, pairs, tolerance);
    result = intersected({faces_a, faces_b, copies, touched, Shared::Listed, options}, copies,
                         pairs, options);
  });
  return result;
}

ShapeIntersection self_intersect(const std::vector<TopoDS_Face>& faces, SelfScope scope,
                                 const IntersectionOptions& options) {
  ShapeIntersection result;
  with_threads(options.threads, [&] {
    FaceList list(faces, "the shape", options.tolerances.point, Extent::Trims);
    FacePairs pairs = meeting_pairs(list, list);
    std::erase_if(pairs, [&](const std::pair<int, int>& pair) {
      return scope == SelfScope::EachFace ? pair.first != pair.second : pair.first > pair.second;
    });
    convert_meeting(list, list, pairs);
    const FaceCopies none(list, list, {}, options.tolerances.point);
    const TouchedPlanes untouched(list, list, {}, options.tolerances.point);
    result =
        intersected({list, list, none, untouched, Shared::LeftOut, options}, none, pairs, options);
  });
  return result;
}

}  // namespace blossom::occt
