// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/cuts/edge_findings.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/base/shared_limit.h"
#include "plugin/reports/models/edges.h"
#include "plugin/reports/models/measured_input.h"
#include "plugin/reports/models/shape_numbers.h"

namespace blossom::reports {
namespace {

// What is found lies on shapes of this input.
class MetPlaces {
 public:
  explicit MetPlaces(const Input& input) : input_(input), numbers_(input.model.shape()) {}

  Json json(const TopoDS_Shape& on) const {
    const int face = face_number(input_, on);
    return numbers_.place(face > 0 ? TopoDS_Shape() : on, face);
  }

  std::string text(const TopoDS_Shape& on) const {
    const int face = face_number(input_, on);
    const std::string part = part_with(input_, on);
    return numbers_.text(face > 0 ? TopoDS_Shape() : on, face) +
           (part.empty() ? "" : " (" + part + ")");
  }

 private:
  const Input& input_;
  ShapeNumbers numbers_;
};

Vec3 point_of(const TopoDS_Edge& edge, double parameter) {
  double from = 0, to = 0;
  return occt::vec(BRep_Tool::Curve(edge, from, to)->Value(parameter));
}

// of_edges   the input of the edges; the other one has what they meet
void list_meetings(const EdgesOf& of, const MetPlaces& of_edges, const MetPlaces& other,
                   bool swapped, EdgeMeetingLists& lists) {
  const auto named = [&](int number, const TopoDS_Shape& on) {
    const TopoDS_Edge& edge = of.edges[static_cast<std::size_t>(number)];
    EdgeMeeting made;
    made.on_a = of_edges.json(edge);
    made.of_a = of_edges.text(edge);
    made.on_b = other.json(on);
    made.of_b = other.text(on);
    if (swapped) {
      std::swap(made.on_a, made.on_b);
      std::swap(made.of_a, made.of_b);
    }
    return made;
  };
  for (const occt::EdgePoint& point : of.met.points) {
    EdgeMeeting made = named(point.edge, point.on);
    made.point = made.end = point.point;
    made.range = {point.parameter, point.parameter};
    lists.points.push_back(std::move(made));
  }
  for (const occt::EdgeStretch& stretch : of.met.stretches) {
    const TopoDS_Edge& edge = of.edges[static_cast<std::size_t>(stretch.edge)];
    EdgeMeeting made = named(stretch.edge, stretch.on);
    made.point = point_of(edge, stretch.range.from);
    made.end = point_of(edge, stretch.range.to);
    made.range = stretch.range;
    made.length = stretch.length;
    lists.stretches.push_back(std::move(made));
  }
}

EdgesOf met_by(std::vector<TopoDS_Edge> edges, const TopoDS_Shape& shape,
               const IntersectionOptions& options) {
  EdgesOf of{std::move(edges)};
  if (!of.edges.empty()) of.met = occt::intersect_edges(of.edges, shape, options);
  return of;
}

Json coordinates(const Vec3& point) { return Json::array({point[0], point[1], point[2]}); }

}  // namespace

std::vector<TopoDS_Edge> edges_to_intersect(const Input& input) {
  if (input.edges.empty() && !input.faces.empty()) return {};
  return edges_without_faces(input);
}

std::vector<int> edges_left_out(const Input& input) {
  std::vector<int> numbers;
  if (!edges_to_intersect(input).empty()) return numbers;
  const std::vector<TopoDS_Edge> others = edges_without_faces(input);
  if (others.empty()) return numbers;
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(input.model.shape(), TopAbs_EDGE, all);
  for (const TopoDS_Edge& edge : others) numbers.push_back(all.FindIndex(edge));
  return numbers;
}

double EdgeFindings::length() const {
  double sum = 0;
  for (const EdgesOf* of : {&a, &b})
    for (const occt::EdgeStretch& stretch : of->met.stretches) sum += stretch.length;
  return sum;
}

EdgeFindings edge_findings(const Input& a, const Input& b, const IntersectionOptions& options) {
  const occt::SharedLimit limit(options);
  std::vector<TopoDS_Edge> of_a = edges_to_intersect(a), of_b = edges_to_intersect(b);
  std::vector<TopoDS_Shape> all_of_b(b.faces.begin(), b.faces.end());
  all_of_b.insert(all_of_b.end(), of_b.begin(), of_b.end());
  EdgeFindings found;
  found.a = met_by(std::move(of_a), occt::compound_of(all_of_b), limit.remaining_alone());
  found.b = met_by(std::move(of_b), occt::compound_of(a.faces), limit.remaining_alone());
  return found;
}

void add_status(const EdgeFindings& edges, occt::ShapeIntersection& found) {
  std::vector<std::string>& reasons = found.certificate.reasons;
  for (const EdgesOf* of : {&edges.a, &edges.b}) {
    found.status = weaker(found.status, of->met.status);
    for (const std::string& reason : of->met.reasons)
      if (std::ranges::find(reasons, reason) == reasons.end()) reasons.push_back(reason);
  }
}

void add_edges(const EdgeFindings& edges, occt::JoinedIntersection& joined) {
  const BRep_Builder builder;
  if (joined.wires.IsNull()) builder.MakeCompound(joined.wires);
  for (const EdgesOf* of : {&edges.a, &edges.b}) {
    if (of->met.points.empty() && of->met.stretches.empty()) continue;
    const TopoDS_Compound own = occt::joined_edges(of->edges, of->met);
    for (TopoDS_Iterator it(own); it.More(); it.Next()) builder.Add(joined.wires, it.Value());
  }
}

EdgeMeetingLists meetings_of(const EdgeFindings& edges, const Input& a, const Input& b) {
  EdgeMeetingLists lists;
  if (edges.points() + edges.stretches() == 0) return lists;
  const MetPlaces of_a(a), of_b(b);
  list_meetings(edges.a, of_a, of_b, false, lists);
  list_meetings(edges.b, of_b, of_a, true, lists);
  return lists;
}

void add_edge_findings(const EdgeFindings& edges, const Input& a, const Input& b, Json& report) {
  report["edge_points"] = report["edge_stretches"] = Json::array();
  const EdgeMeetingLists lists = meetings_of(edges, a, b);
  for (const EdgeMeeting& each : lists.points)
    report["edge_points"].push_back({{"point", coordinates(each.point)},
                                     {"on_a", each.on_a},
                                     {"on_b", each.on_b},
                                     {"parameter", each.range.from}});
  for (const EdgeMeeting& each : lists.stretches)
    report["edge_stretches"].push_back({{"from", coordinates(each.point)},
                                        {"to", coordinates(each.end)},
                                        {"length", each.length},
                                        {"on_a", each.on_a},
                                        {"on_b", each.on_b},
                                        {"parameters", {each.range.from, each.range.to}}});
}

}  // namespace blossom::reports
