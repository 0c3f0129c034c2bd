// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/intersect/intersection_text.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "adapters/occt/intersection_edges.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/reports/models/parts.h"

namespace blossom::cli {
namespace {

using reports::gap_text;
using reports::is_in;
using reports::shown_point;

std::string short_number(double value) { return number_text(rounded(value)); }

std::string near_text(const Vec3& point) { return "near " + shown_point(point); }

// The places of a pair that tell of its overlaps, in their order; none if they are not as many.
std::vector<const Place*> places_of_overlaps(const occt::FaceIntersection& pair) {
  std::vector<const Place*> places;
  for (const Place& place : pair.found.places)
    if (place.kind == PlaceKind::Overlap) places.push_back(&place);
  if (places.size() != pair.found.overlaps.size()) places.clear();
  return places;
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
