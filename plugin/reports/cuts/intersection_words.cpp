// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/cuts/intersection_words.h"

#include <algorithm>
#include <sstream>

#include "adapters/occt/faces/area.h"
#include "plugin/reports/text/json.h"
#include "plugin/reports/text/number_text.h"
#include "plugin/reports/text/vectors.h"

namespace blossom::reports {
namespace {

const char* words_of(PlaceKind kind) {
  switch (kind) {
    case PlaceKind::Touch: return "touching in a point";
    case PlaceKind::Node: return "branches crossing";
    case PlaceKind::Cusp: return "a curve turning back";
    case PlaceKind::Pole: return "contact at a pole";
    case PlaceKind::Tangential: return "touching along a curve";
    case PlaceKind::Overlap: return "coinciding over an area";
    case PlaceKind::Open: break;
  }
  return "unresolved";
}

std::string short_number(double value) { return number_text(rounded(value)); }

}  // namespace

std::string shown_point(const Vec3& point) {
  const Vec3 shown = without_roundings(point);
  return vector_text({rounded(shown[0]), rounded(shown[1]), rounded(shown[2])});
}

std::string gap_text(const Place& place) {
  return "gap " + short_number(place.gap_low) + " to " + short_number(place.gap_high);
}

bool is_in(const Place& place, const Vec3& point) {
  bool inside = true;
  for (int k = 0; k < 3; ++k)
    inside = inside && place.box_low[k] <= point[k] && point[k] <= place.box_high[k];
  return inside;
}

double overlap_area(const Input& a, const occt::FaceIntersection& pair, const Overlap& overlap) {
  const TopoDS_Face& face = a.faces[static_cast<std::size_t>(pair.face_a)];
  if (!pair.equal_edges.empty() || overlap.boundary.empty()) return occt::area(face);
  std::vector<Vec2> polygon;
  for (const SurfacePoint& point : overlap.boundary) polygon.push_back(point.uv_a);
  return occt::polygon_area(face, polygon);
}

IntersectionCounts counts_of(const Input& a, const occt::ShapeIntersection& found,
                             const EdgeFindings& edges) {
  IntersectionCounts counts;
  counts.points = edges.points();
  counts.stretches = edges.stretches();
  counts.stretches_length = edges.length();
  for (const occt::FaceIntersection& pair : found.pairs) {
    counts.curves += pair.chains.size();
    counts.closed +=
        static_cast<std::size_t>(std::ranges::count_if(pair.chains, &CurveChain::closed));
    counts.points += pair.found.points.size();
    counts.nodes += pair.found.nodes.size();
    counts.overlaps += pair.found.overlaps.size();
    for (const Overlap& overlap : pair.found.overlaps)
      counts.overlap_area += overlap_area(a, pair, overlap);
    for (const Place& place : pair.found.places) {
      if (is_contact(place) || (place.kind == PlaceKind::Overlap && pair.found.overlaps.empty()))
        ++counts.contacts;
      if (place.kind == PlaceKind::Open) ++counts.unresolved;
    }
  }
  return counts;
}

std::string counts_text(const IntersectionCounts& counts) {
  std::ostringstream text;
  const auto item = [&text](std::size_t count, const char* noun) -> std::ostream& {
    return text << (text.tellp() > 0 ? ", " : "") << counted(count, noun);
  };
  if (counts.curves > 0) item(counts.curves, "curve") << " (" << counts.closed << " closed)";
  if (counts.points > 0) item(counts.points, "point");
  if (counts.nodes > 0) item(counts.nodes, "branching point");
  if (counts.overlaps > 0)
    item(counts.overlaps, "overlap")
        << " of about " << number_text(rounded(counts.overlap_area)) << " mm²";
  if (counts.stretches > 0)
    text << (text.tellp() > 0 ? ", " : "") << counts.stretches
         << (counts.stretches == 1 ? " common stretch" : " common stretches") << " of "
         << number_text(rounded(counts.stretches_length)) << " mm";
  if (counts.contacts > 0) item(counts.contacts, "contact") << " within tolerance";
  if (counts.unresolved > 0) item(counts.unresolved, "unresolved region");
  return text.tellp() > 0 ? text.str() : "no curve and no point";
}

PairNames::PairNames(const Input& a, const Input& b)
    : a_(a), b_(b), parts_a_(a.model.part_paths()), parts_b_(b.model.part_paths()) {}

std::string PairNames::of(const occt::FaceIntersection& pair) const {
  const int face_a = a_.numbers[static_cast<std::size_t>(pair.face_a)];
  const int face_b = b_.numbers[static_cast<std::size_t>(pair.face_b)];
  const auto part = [](const std::vector<std::string>& parts, int face) {
    return given_name(parts.at(static_cast<std::size_t>(face) - 1));
  };
  const std::string part_a = part(parts_a_, face_a), part_b = part(parts_b_, face_b);
  const bool itself = &a_ == &b_;
  const std::string face = "face " + std::to_string(face_a);
  if (part_a.empty() && !part_b.empty())
    return face + " x " + part_b + ", face " + std::to_string(face_b);
  std::string parts = part_a;
  if (!part_b.empty() && !(itself && part_a == part_b)) parts += " x " + part_b;
  return (parts.empty() ? "" : parts + ", ") + face +
         (itself && face_a == face_b ? "" : " x face " + std::to_string(face_b));
}

std::string curve_text(const occt::FaceIntersection& pair, const CurveChain& chain, bool detail) {
  const ChainFacts facts = facts_of(pair.found.curves, chain);
  const Deviation& d = facts.deviation;
  std::ostringstream text;
  text << (chain.closed ? "closed" : "open") << (facts.tangential ? ", tangential" : "")
       << ", length " << short_number(facts.length);
  if (detail) text << ", degree " << facts.degree << ", " << counted(facts.poles, "pole");
  text << ", deviation " << short_number(std::max({d.a, d.b, d.between}));
  return text.str();
}

std::string place_text(const Place& place, const std::vector<Vec3>& points) {
  const auto known =
      std::ranges::find_if(points, [&](const Vec3& point) { return is_in(place, point); });
  const bool at_point = known != points.end() && is_contact(place);
  const Vec3 where = at_point ? *known : (place.box_low + place.box_high) * 0.5;
  return std::string(words_of(place.kind)) + " near " + shown_point(where) + ", " +
         short_number(distance(place.box_low, place.box_high)) + " across, " + gap_text(place);
}

}  // namespace blossom::reports
