// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/intersect/intersection_text.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/intersection_edges.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/arguments/vectors.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/reports/models/parts.h"

namespace blossom::cli {
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

std::string shown_point(const Vec3& point) {
  const Vec3 shown = without_roundings(point);
  return vector_text({rounded(shown[0]), rounded(shown[1]), rounded(shown[2])});
}

std::string near_text(const Vec3& point) { return "near " + shown_point(point); }

std::string gap_text(const Place& place) {
  return "gap " + short_number(place.gap_low) + " to " + short_number(place.gap_high);
}

// The places of a pair that tell of its overlaps, in their order; none if they are not as many.
std::vector<const Place*> places_of_overlaps(const occt::FaceIntersection& pair) {
  std::vector<const Place*> places;
  for (const Place& place : pair.found.places)
    if (place.kind == PlaceKind::Overlap) places.push_back(&place);
  if (places.size() != pair.found.overlaps.size()) places.clear();
  return places;
}

bool is_in(const Place& place, const Vec3& point) {
  bool inside = true;
  for (int k = 0; k < 3; ++k)
    inside = inside && place.box_low[k] <= point[k] && point[k] <= place.box_high[k];
  return inside;
}

std::vector<Vec3> points_of(const occt::FaceIntersection& pair) {
  std::vector<Vec3> points;
  for (const SurfacePoint& point : pair.found.points) points.push_back(point.point);
  return points;
}

// The corner of the boundary farthest from nothing in particular would do; its middle tells more.
std::string overlap_text(const Input& a, const occt::FaceIntersection& pair,
                         const Overlap& overlap) {
  std::string text = "overlap of about " + short_number(overlap_area(a, pair, overlap)) + " mm²";
  if (overlap.boundary.empty()) return text + ", all of a face";
  Vec3 low = overlap.boundary.front().point, high = low;
  for (const SurfacePoint& p : overlap.boundary)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p.point[k]);
      high[k] = std::max(high[k], p.point[k]);
    }
  return text + " " + near_text(0.5 * (low + high)) + ", " + short_number(distance(low, high)) +
         " across";
}

// What was found of a pair, one line each; what is in places comes apart, since it can be very
// much.
void list_findings(const Input& a, const PairNames& names, const occt::FaceIntersection& pair,
                   std::ostream& text) {
  const std::string head = "  " + names.of(pair) + ": ";
  const bool detail = verbosity() == Verbosity::Verbose;
  const std::vector<const Place*> gaps = places_of_overlaps(pair);
  for (std::size_t i = 0; i < pair.found.overlaps.size(); ++i)
    text << head << overlap_text(a, pair, pair.found.overlaps[i])
         << (gaps.empty() ? "" : ", " + gap_text(*gaps[i])) << "\n";
  for (const CurveChain& chain : pair.chains)
    text << head << curve_text(pair, chain, detail) << "\n";
  for (const SurfacePoint& point : pair.found.points)
    if (std::ranges::none_of(pair.found.places, [&](const Place& place) {
          return reports::is_contact(place) && is_in(place, point.point);
        }))
      text << head << "point " << near_text(point.point) << "\n";
  for (const SurfacePoint& node : pair.found.nodes)
    text << head << "branching point " << near_text(node.point) << "\n";
}

void list_places(const PairNames& names, const occt::ShapeIntersection& found, std::ostream& text) {
  constexpr std::size_t kFew = 20;
  std::vector<std::string> lines;
  for (const occt::FaceIntersection& pair : found.pairs) {
    const bool told = !places_of_overlaps(pair).empty();
    for (const Place& place : pair.found.places)
      if (!told || place.kind != PlaceKind::Overlap)
        lines.push_back("  " + names.of(pair) + ": " + place_text(place, points_of(pair)) + "\n");
  }
  const bool all = verbosity() == Verbosity::Verbose || lines.size() <= kFew;
  for (std::size_t i = 0; i < (all ? lines.size() : kFew); ++i) text << lines[i];
  if (!all) text << "  and " << lines.size() - kFew << " more such places, which -v lists\n";
}

// Whether the pairs of faces of one model are all of different solids or sheets.
bool are_between_parts(const Input& input, const occt::ShapeIntersection& found) {
  if (found.pairs.empty()) return false;
  std::map<int, std::size_t> part_of;
  const std::vector<reports::NamedPart> parts = reports::named_parts(input);
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const int face : reports::faces_of(parts[i]).numbers) part_of.emplace(face, i);
  const auto part = [&](int face) {
    return part_of.at(input.numbers[static_cast<std::size_t>(face)]);
  };
  return std::ranges::all_of(found.pairs, [&](const occt::FaceIntersection& pair) {
    return part(pair.face_a) != part(pair.face_b);
  });
}

void list_edge_meetings(const reports::EdgeMeetingLists& lists, std::ostream& text) {
  for (const reports::EdgeMeeting& each : lists.points)
    text << "  " << each.of_a << " x " << each.of_b << ": point " << near_text(each.point) << "\n";
  for (const reports::EdgeMeeting& each : lists.stretches)
    text << "  " << each.of_a << " x " << each.of_b << ": common stretch of length "
         << short_number(each.length) << " from " << shown_point(each.point) << " to "
         << shown_point(each.end) << "\n";
}

}  // namespace

double overlap_area(const Input& a, const occt::FaceIntersection& pair, const Overlap& overlap) {
  const TopoDS_Face& face = a.faces[static_cast<std::size_t>(pair.face_a)];
  if (!pair.equal_edges.empty() || overlap.boundary.empty()) return occt::area(face);
  std::vector<Vec2> polygon;
  for (const SurfacePoint& point : overlap.boundary) polygon.push_back(point.uv_a);
  return occt::polygon_area(face, polygon);
}

IntersectionCounts counts_of(const Input& a, const occt::ShapeIntersection& found,
                             const reports::EdgeFindings& edges) {
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
      if (reports::is_contact(place) ||
          (place.kind == PlaceKind::Overlap && pair.found.overlaps.empty()))
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
  const reports::ChainFacts facts = reports::facts_of(pair.found.curves, chain);
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
  const bool at_point = known != points.end() && reports::is_contact(place);
  const Vec3 where = at_point ? *known : (place.box_low + place.box_high) * 0.5;
  return std::string(words_of(place.kind)) + " " + near_text(where) + ", " +
         short_number(distance(place.box_low, place.box_high)) + " across, " + gap_text(place);
}

// What the curves of all pairs come to.
std::string joined_text(const occt::JoinedIntersection& whole) {
  const reports::WireFacts joined = reports::facts_of(whole.wires);
  std::ostringstream text;
  text << "  joined: " << counted(joined.wires, "wire") << " (" << joined.closed << " closed), "
       << counted(joined.edges, "edge");
  if (joined.points > 0) text << ", " << counted(joined.points, "point");
  text << ", length " << short_number(joined.length) << "\n";
  for (const std::string& reason : whole.lost)
    text << "  borders of common regions are not all in it: " << reason << "\n";
  return text.str();
}

bool tells_joined(const IntersectionCounts& counts) {
  return counts.curves > 1 || counts.overlaps > 0;
}

std::string intersection_text(const reports::IntersectionFindings& findings,
                              const std::string& title, const IntersectionCounts& counts,
                              const reports::RunTimes& times) {
  const auto& [a, b, found, joined, edges] = findings;
  std::ostringstream text;
  text << title << ": ";
  if (&a == &b) text << reports::verdict_of(found) << ", ";
  text << to_string(stated(found.status)) << ", " << counts_text(counts) << ", "
       << seconds_text(times.seconds) << "\n";
  if (tells_joined(counts)) text << joined_text(joined);
  if (&a == &b && counts.any() && are_between_parts(a, found))
    text << "  no part meets itself: all is between different parts, which `blossom clash` tells "
            "apart by whether they touch or penetrate\n";
  const PairNames names(a, b);
  for (const occt::FaceIntersection& pair : found.pairs) list_findings(a, names, pair, text);
  list_edge_meetings(reports::meetings_of(edges, a, b), text);
  list_places(names, found, text);
  for (const std::string& reason : found.certificate.reasons) text << "  " << reason << "\n";
  return text.str();
}

}  // namespace blossom::cli
