// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/results/result.h"

#include <algorithm>

#include "core/base/sampled_margin.h"

namespace blossom {
namespace {

constexpr double kMinEdgeTolerance = 1e-7;  // Open CASCADE's Precision::Confusion

}  // namespace

double edge_tolerance(const Deviation& d) {
  return std::max(kMinEdgeTolerance, kSampledMargin * std::max({d.a, d.b, d.between}));
}

const char* to_string(PlaceKind kind) {
  switch (kind) {
    case PlaceKind::Touch: return "touch";
    case PlaceKind::Node: return "node";
    case PlaceKind::Cusp: return "cusp";
    case PlaceKind::Pole: return "pole";
    case PlaceKind::Tangential: return "tangential";
    case PlaceKind::Overlap: return "overlap";
    case PlaceKind::Open: break;
  }
  return "open";
}

void identify(Certificate& certificate, double within) {
  ++certificate.identified;
  certificate.identified_within = std::max(certificate.identified_within, within);
}

std::vector<SurfacePoint> joined_loops(const std::vector<std::vector<SurfacePoint>>& loops) {
  std::vector<SurfacePoint> joined;
  for (const auto& loop : loops) joined.insert(joined.end(), loop.begin(), loop.end());
  for (std::size_t i = loops.size(); i-- > 1;) joined.push_back(loops[i - 1].front());
  return joined;
}

void widen(Place& place, const SurfacePoint& x, double gap) {
  widen(place, {Interval{x.uv_a[0], x.uv_a[0]}, Interval{x.uv_a[1], x.uv_a[1]},
                Interval{x.uv_b[0], x.uv_b[0]}, Interval{x.uv_b[1], x.uv_b[1]}});
  place.gap_low = std::min(place.gap_low, gap);
  place.gap_high = std::max(place.gap_high, gap);
}

void widen(Place& place, const std::array<Interval, 4>& parameters) {
  for (std::size_t k = 0; k < 4; ++k) {
    place.parameters[k].from = std::min(place.parameters[k].from, parameters[k].from);
    place.parameters[k].to = std::max(place.parameters[k].to, parameters[k].to);
  }
}

}  // namespace blossom
