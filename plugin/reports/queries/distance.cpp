// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/queries/distance.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/work_limit.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::reports {
namespace {

template <class Answer>
Json head(const char* kind, const Answer& answer) {
  return {{"schema", "blossom.query/1"},
          {"kind", kind},
          {"tolerance", answer.tolerance},
          {"status", to_string(answer.status)},
          {"seconds", answer.seconds}};
}

// The distance of the models: none where they have points in common, else that of their boundaries.
// While it is not known whether they do, it may be none.
DistanceBounds bounds_of(occt::Relation relation, const DistanceBounds& boundaries) {
  if (has_common_points(relation)) return {};
  const bool known = relation != occt::Relation::Unknown;
  return {known ? boundaries.lower : 0, boundaries.upper};
}

// A pair that has common points for sure proves the answer, whatever the others are.
Status status_of_meeting(const occt::ModelRelation& found) {
  const bool proven = std::ranges::any_of(found.pairs, [](const occt::BodyPair& pair) {
    return has_common_points(pair.relation) && pair.status == Status::Complete;
  });
  return proven ? Status::Complete : found.status;
}

Json feet_json(const MeasuredInput& side, const std::vector<occt::ShapeFoot>& feet) {
  Json list = Json::array();
  for (const occt::ShapeFoot& found : feet) {
    Json foot = side.json(found.at);
    foot["distance"] = found.foot.distance;
    foot["extremum"] = to_string(found.foot.extremum);
    foot["status"] = to_string(found.foot.status);
    foot["size"] = found.foot.size;
    list.push_back(foot);
  }
  return list;
}

Json places_json(const MeasuredInput& side, const std::vector<occt::PointPlace>& places) {
  Json list = Json::array();
  for (std::size_t i = 0; i < places.size(); ++i) {
    Json solid = side.body_json(i);
    solid["place"] = to_string(places[i]);
    list.push_back(std::move(solid));
  }
  return list;
}

void add_relation(const occt::ModelRelation& found, const MeasuredInput& a, const MeasuredInput& b,
                  Json& report) {
  report["relation"] = to_string(found.relation);
  report["pairs"] = Json::array();
  for (const occt::BodyPair& pair : found.pairs)
    report["pairs"].push_back({{"a", a.body_json(pair.a)},
                               {"b", b.body_json(pair.b)},
                               {"relation", to_string(pair.relation)},
                               {"status", to_string(pair.status)}});
  report["solids_a"] = a.solids();
  report["solids_b"] = b.solids();
  report["surface_faces_a"] = a.surface_faces();
  report["surface_faces_b"] = b.surface_faces();
}

// What distances and meetings tell alike.
void add_bounds(const MeasuredInput& a, const MeasuredInput& b, const DistanceAnswer& answer,
                Json& report) {
  report["distance"] = {answer.bounds.lower, answer.bounds.upper};
  report["boundary_distance"] = {answer.boundaries.lower, answer.boundaries.upper};
  report["nearest_a"] = a.json(answer.a);
  report["nearest_b"] = b.json(answer.b);
  report["repairs"] = Json::array({repairs_json(a.input), repairs_json(b.input)});
  add_relation(answer.relation, a, b, report);
}

}  // namespace

DistanceAnswer distance_between(MeasuredInput& a, MeasuredInput& b, double tolerance,
                                const DistanceLimits& limits) {
  const occt::ShapeDistance found =
      occt::least_distance(a.bodies->boundary(), b.bodies->boundary(), limits());
  const occt::ShapeMeeting meeting =
      occt::meeting_at(found, a.bodies->boundary(), b.bodies->boundary(), tolerance, limits());
  DistanceAnswer answer{.tolerance = tolerance,
                        .boundaries = {found.lower, found.upper},
                        .a = found.a,
                        .b = found.b,
                        .meeting = meeting.answer,
                        .status = found.status};
  answer.relation = occt::relation_of(*a.bodies, *b.bodies, meeting, tolerance, limits());
  const occt::Relation relation = answer.relation.relation;
  answer.bounds = bounds_of(relation, answer.boundaries);
  if (answer.bounds.lower < found.lower && !has_common_points(relation))
    answer.status = weaker(found.status, answer.relation.status);
  return answer;
}

DistanceAnswer meeting_of(MeasuredInput& a, MeasuredInput& b, double tolerance,
                          const DistanceLimits& limits) {
  const occt::ShapeMeeting found =
      occt::meeting(a.bodies->boundary(), b.bodies->boundary(), tolerance, limits());
  DistanceAnswer answer{.tolerance = tolerance,
                        .boundaries = {found.lower, found.upper},
                        .a = found.a,
                        .b = found.b,
                        .meeting = found.answer};
  answer.relation = occt::relation_of(*a.bodies, *b.bodies, found, tolerance, limits());
  answer.bounds = bounds_of(answer.relation.relation, answer.boundaries);
  answer.status = status_of_meeting(answer.relation);
  return answer;
}

const char* meeting_word(occt::Relation relation) {
  switch (relation) {
    case occt::Relation::Unknown: return "unknown";
    case occt::Relation::Disjoint: return "no";
    case occt::Relation::Touching: return "touching";
    default: return "yes";
  }
}

Json distance_report(const MeasuredInput& a, const MeasuredInput& b, const DistanceAnswer& answer) {
  Json report = head("distance", answer);
  report["a"] = a.input.name;
  report["b"] = b.input.name;
  add_bounds(a, b, answer, report);
  return report;
}

Json meeting_report(const MeasuredInput& a, const MeasuredInput& b, const DistanceAnswer& answer) {
  Json report = head("does-intersect", answer);
  report["a"] = a.input.name;
  report["b"] = b.input.name;
  report["answer"] = meeting_word(answer.relation.relation);
  add_bounds(a, b, answer, report);
  return report;
}

PointAnswer nearest_to(MeasuredInput& side, const Vec3& point, bool all, double tolerance,
                       const DistanceLimits& limits) {
  const occt::MeasuredShape& boundary = side.bodies->boundary();
  PointAnswer answer{.tolerance = tolerance,
                     .at = point,
                     .nearest = occt::nearest_point(boundary, point, limits()),
                     .all = all};
  if (all) {
    const DistanceOptions left = limits();
    const WorkLimit limit(left.time_limit, left.cancelled);
    answer.feet = occt::foot_points(boundary, point, tolerance, &limit);
  }
  answer.places = occt::places_of(*side.bodies, point, answer.nearest, tolerance, limits());
  answer.status = answer.nearest.status;
  for (const occt::ShapeFoot& foot : answer.feet)
    answer.status = weaker(answer.status, foot.foot.status);
  return answer;
}

Json point_report(const MeasuredInput& side, const PointAnswer& answer) {
  Json report = head("point", answer);
  report["file"] = side.input.name;
  report["at"] = answer.at.coordinates;
  report["distance"] = {answer.nearest.lower, answer.nearest.upper};
  report["nearest"] = side.json(answer.nearest.b);
  report["solids"] = places_json(side, answer.places);
  if (answer.all) report["feet"] = feet_json(side, answer.feet);
  report["repairs"] = Json::array({repairs_json(side.input)});
  return report;
}

}  // namespace blossom::reports
