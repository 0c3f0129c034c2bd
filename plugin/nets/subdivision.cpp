// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/subdivision.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "plugin/nets/net_json.h"

namespace blossom::nets {
namespace {

using reports::Json;

// So many pieces need some gigabytes.
constexpr double kMaxPieces = 1 << 20;

std::string box_of(const std::vector<Net>& nets) {
  std::ostringstream text;
  Interval u = nets.front().u, v = nets.front().v;
  for (const Net& net : nets) {
    u = {std::min(u.from, net.u.from), std::max(u.to, net.u.to)};
    v = {std::min(v.from, net.v.from), std::max(v.to, net.v.to)};
  }
  text << "[" << u.from << ", " << u.to << "]";
  if (!is_curve(nets.front())) text << " x [" << v.from << ", " << v.to << "]";
  return text.str();
}

// The rectangle round the place that is wanted of each net, if one is; of curves u alone.
std::optional<std::array<Interval, 2>> place_of(const Cut& cut) {
  const auto joined = [](const Interval& a, double x) {
    return Interval{std::min(a.from, x), std::max(a.to, x)};
  };
  const auto forward = [](const Interval& a) {
    return Interval{std::min(a.from, a.to), std::max(a.from, a.to)};
  };
  if (cut.interval) return std::array{forward(*cut.interval), forward(*cut.interval)};
  if (cut.rectangle) return std::array{forward((*cut.rectangle)[0]), forward((*cut.rectangle)[1])};
  if (!cut.triangle) return std::nullopt;
  const Vec2& first = cut.triangle->front();
  std::array place{Interval{first[0], first[0]}, Interval{first[1], first[1]}};
  for (const Vec2& corner : *cut.triangle)
    place = {joined(place[0], corner[0]), joined(place[1], corner[1])};
  return place;
}

bool leaves(const Interval& wanted, const Interval& all) {
  const double room = kOneKnot * (all.to - all.from);
  return wanted.from < all.from - room || wanted.to > all.to + room;
}

// The faces and edges, by their nets, that do not fill the place.
std::vector<ClippedSource> clipped_sources(const std::vector<Net>& nets, const Cut& cut) {
  const auto place = place_of(cut);
  if (!place) return {};
  std::map<std::pair<int, int>, ClippedSource> sources;
  for (const Net& net : nets) {
    const auto [face, edge] = std::pair(net.source.face, net.source.edge);
    if (face == 0 && edge == 0) continue;  // of a file of nets, which are taken on all of it
    ClippedSource& all =
        sources.try_emplace({face, edge}, ClippedSource{face, edge, net.u, net.v}).first->second;
    all.u = {std::min(all.u.from, net.u.from), std::max(all.u.to, net.u.to)};
    all.v = {std::min(all.v.from, net.v.from), std::max(all.v.to, net.v.to)};
  }
  std::vector<ClippedSource> clipped;
  for (const auto& [numbers, all] : sources)
    if (leaves((*place)[0], all.u) || (all.edge == 0 && leaves((*place)[1], all.v)))
      clipped.push_back(all);
  return clipped;
}

Json clipped_json(const std::vector<ClippedSource>& clipped) {
  Json json = Json::array();
  for (const ClippedSource& each : clipped) {
    Json entry = {{"u", {each.u.from, each.u.to}}};
    if (each.edge > 0) entry["edge"] = each.edge;
    if (each.edge == 0) {
      entry["face"] = each.face;
      entry["v"] = {each.v.from, each.v.to};
    }
    json.push_back(std::move(entry));
  }
  return json;
}

Json rectangle_json(const std::array<Interval, 2>& rectangle) {
  const auto& [u, v] = rectangle;
  return {u.from, u.to, v.from, v.to};
}

Json triangle_json(const TriangleCorners& corners) {
  Json json = Json::array();
  for (const Vec2& corner : corners) json.insert(json.end(), {corner[0], corner[1]});
  return json;
}

}  // namespace

Subdivision subdivided(const std::string& input, const std::vector<Net>& nets, const Cut& cut) {
  double count = 0;
  for (const Net& net : nets) count += piece_count(net, cut);
  if (count > kMaxPieces)
    throw occt::BadModel(input + ": these would be more than a million pieces; fewer levels");
  const auto start = std::chrono::steady_clock::now();
  Subdivision made{.input = input, .cut = cut};
  for (const Net& net : nets)
    for (Net& piece : pieces(net, cut)) made.pieces.push_back(std::move(piece));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  made.seconds = took.count();
  if (made.pieces.empty())
    throw occt::BadModel(input + ": what is to be cut out lies outside of the parameters " +
                         box_of(nets));
  made.clipped = clipped_sources(nets, cut);
  return made;
}

Json subdivision_report(const Subdivision& made, Json repairs) {
  const Cut& cut = made.cut;
  Json json = {{"schema", "blossom.subdivision/1"},
               {"file", made.input},
               {"interval", cut.interval ? Json{cut.interval->from, cut.interval->to} : Json()},
               {"rectangle", cut.rectangle ? rectangle_json(*cut.rectangle) : Json()},
               {"triangle", cut.triangle ? triangle_json(*cut.triangle) : Json()},
               {"levels", cut.levels},
               {"q", cut.q ? Json{cut.q->q1, cut.q->q2} : Json()},
               {"seconds", made.seconds},
               {"pieces", made.pieces.size()},
               {"clipped", clipped_json(made.clipped)},
               {"nets", Json::array()},
               {"repairs", std::move(repairs)}};
  for (const Net& piece : made.pieces) json["nets"].push_back(to_json(piece));
  return json;
}

}  // namespace blossom::nets
