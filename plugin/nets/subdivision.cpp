// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/subdivision.h"

#include <algorithm>
#include <chrono>
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
               {"nets", Json::array()},
               {"repairs", std::move(repairs)}};
  for (const Net& piece : made.pieces) json["nets"].push_back(to_json(piece));
  return json;
}

}  // namespace blossom::nets
