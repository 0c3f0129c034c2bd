// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/run_profiles.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/strips/held_strip.h"
#include "adapters/occt/blending/strips/law_joints.h"
#include "adapters/occt/convert/curves.h"

namespace blossom::occt {
namespace {

// Radii of a law's ends that differ by less, of their size, are one.
constexpr double kSameRadius = 1e-12;

// The place of the edge with the least number.
std::size_t leading(const EdgeRun& run) {
  const auto least = std::ranges::min_element(run.edges, {}, &RunEdge::edge);
  return static_cast<std::size_t>(least - run.edges.begin());
}

[[noreturn]] void refuse(int edge, const std::string& cause) {
  throw FilletRefused({FilletFault::Edge, edge, cause, std::nullopt, std::nullopt, {}});
}

// The one radius or law of all edges of a run.
EdgeRadius common_radius(const EdgeRun& run, const FilletOptions& options) {
  const RunEdge& first = run.edges.front();
  const EdgeRadius common = options.radius_of(first.edge);
  for (const RunEdge& each : run.edges)
    if (!is_same(options.radius_of(each.edge), common))
      refuse(each.edge, "it goes on smoothly in edge " + std::to_string(first.edge) +
                            ", and one fillet along both cannot have two radii");
  return common;
}

// A law that comes back to where it began leaves no step there.
void check_closed(const RadiusLaw& law, int edge) {
  const double first = law.at(0).value, last = law.at(1).value;
  if (std::abs(first - last) <= kSameRadius * first) return;
  char figures[64];
  std::snprintf(figures, sizeof figures, "%.6g at its start, and %.6g at its end", first, last);
  refuse(edge, std::string("it is in a run of edges that closes, and the law has a radius of ") +
                   figures + ", which is the same place: there the strip would have a step");
}

}  // namespace

bool is_same(const EdgeRadius& a, const EdgeRadius& b) {
  if (!a.law && !b.law) return a.radius == b.radius;
  return a.law && b.law && *a.law == *b.law;
}

RunProfiles::RunProfiles(const BodyEdges& body, const EdgeRun& run, const FilletOptions& options)
    : run_(run), options_(options) {
  const std::size_t lead = leading(run);
  const RunEdge& first = run.edges[lead];
  if (options.chamfer) {
    const ChamferSize& size = *options.chamfer;
    const int left = body.use(first.edge, first.forward).face;
    const int right = body.use(first.edge, !first.forward).face;
    chamfer_.given = left < right ? 0 : 1;
    chamfer_.distance = {size.first, size.first};
    chamfer_.distance[1 - chamfer_.given] = size.second.value_or(size.first);
    chamfer_.angle = size.angle;
  }
  const EdgeRadius common = common_radius(run, options);
  if (common.law && run.closed) check_closed(*common.law, first.edge);
  std::vector<double> lengths{0};
  for (const RunEdge& each : run.edges)
    lengths.push_back(lengths.back() + edge_length(body.edge(each.edge)));
  const auto share_at = [&](double length) {
    const double share = length / lengths.back();
    return first.forward ? share : 1 - share;
  };
  for (std::size_t i = 0; i < run.edges.size(); ++i) {
    StripProfile profile{.radius = common.radius, .section = options.section};
    if (common.law) {
      Interval part{share_at(lengths[i]), share_at(lengths[i + 1])};
      if (!run.edges[i].forward) std::swap(part.from, part.to);
      profile.law = common.law->over(part, {0, 1});
      profile.radius = profile.law->extremes({0, 1}).to;
    }
    of_.push_back(std::move(profile));
  }
  if (common.law && !common.law->is_constant()) match_rates(body, run, of_);
}

// To the left and right of the forward edge.
ChamferProfile RunProfiles::chamfer_at(std::size_t place) const {
  ChamferProfile profile = chamfer_;
  if (!run_.edges[place].forward) {
    std::swap(profile.distance[0], profile.distance[1]);
    profile.given = 1 - profile.given;
  }
  return profile;
}

RolledStrip RunProfiles::guided(const BodyEdges& body, std::size_t place,
                                const GuidedPlace& at) const {
  if (options_.chamfer) return chamfer_strip(body, at, run_.concave, chamfer_at(place));
  return traced_strip(body, at, run_.concave, of_[place]);
}

RolledStrip RunProfiles::strip(const BodyEdges& body, std::size_t place) const {
  const RunEdge& edge = run_.edges[place];
  if (options_.chamfer) return chamfer_strip(body, edge.edge, run_.concave, chamfer_at(place));
  const StripProfile& profile = of_[place];
  if (profile.is_ball())
    if (auto strip = swept_or_held_strip(body, edge.edge, run_.concave, profile.radius))
      return *std::move(strip);
  return traced_strip(body, edge.edge, run_.concave, profile);
}

std::optional<StripProfile> RunProfiles::everywhere() const {
  if (options_.chamfer || of_.front().law) return std::nullopt;
  return of_.front();
}

}  // namespace blossom::occt
