// SPDX-License-Identifier: LGPL-2.1-or-later
// Intersections: two models with each other, one with itself.

#include <memory>
#include <optional>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/border_numbers.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "plugin/pictures/results/intersection.h"
#include "plugin/python/answers.h"
#include "plugin/python/arrays.h"
#include "plugin/python/json.h"
#include "plugin/reports/cuts/edge_findings.h"
#include "plugin/reports/cuts/intersection.h"

namespace py = pybind11;
using namespace py::literals;

namespace blossom::python {
namespace {

struct Found {
  SharedModel a, b;
  bool itself = false;  // a model's faces with each other
  occt::ShapeIntersection intersection;
  double seconds = 0;
  reports::EdgeFindings edges{};
  reports::EdgeMeetingLists edge_meetings{};
  mutable std::optional<occt::JoinedIntersection> joined{};  // made when it is first asked for
};
using SharedFound = std::shared_ptr<const Found>;

struct Faces {
  int a = 0, b = 0;
};

py::dict spline(const Spline& curve) {
  return py::dict("degree"_a = curve.degree,
                  "poles"_a = points_array(std::span<const Vec3>(curve.points)),
                  "weights"_a = py::none(), "knots"_a = numbers_array(curve.knots),
                  "multiplicities"_a = numbers_array(curve.multiplicities));
}

py::dict curve_record(const IntersectionCurve& curve, const Faces& faces) {
  py::dict record("points"_a = points_array(curve.samples, &SurfacePoint::point),
                  "uv_a"_a = points_array(curve.samples, &SurfacePoint::uv_a),
                  "uv_b"_a = points_array(curve.samples, &SurfacePoint::uv_b),
                  "closed"_a = curve.closed, "tangential"_a = curve.tangential,
                  "length"_a = curve.length, "least_angle"_a = curve.least_angle,
                  "deviation"_a = py::dict("a"_a = curve.deviation.a, "b"_a = curve.deviation.b,
                                           "between"_a = curve.deviation.between),
                  "deviation_proven"_a = curve.deviation.proven, "face_a"_a = faces.a,
                  "face_b"_a = faces.b);
  record["conic"] = to_python(reports::to_json(curve.conic, curve.curve.domain()));
  const py::dict form = spline(curve.curve);
  for (const auto& [key, value] : form) record[key] = value;
  return record;
}

py::dict chain_record(const occt::FaceIntersection& pair, const CurveChain& chain,
                      std::size_t first, const Faces& faces) {
  py::list curves;
  double length = 0;
  for (const ChainUse& use : chain.uses) {
    curves.append(py::make_tuple(first + static_cast<std::size_t>(use.curve), use.forward));
    length += pair.found.curves[static_cast<std::size_t>(use.curve)].length;
  }
  return py::dict("curves"_a = curves, "closed"_a = chain.closed, "length"_a = length,
                  "face_a"_a = faces.a, "face_b"_a = faces.b);
}

py::dict contact_record(const SurfacePoint& where, const Faces& faces) {
  return py::dict("point"_a = point_array(where.point), "uv_a"_a = point_array(where.uv_a),
                  "uv_b"_a = point_array(where.uv_b), "on_a"_a = py::none(), "on_b"_a = py::none(),
                  "face_a"_a = faces.a, "face_b"_a = faces.b);
}

py::object number_pair(const occt::BorderNumber& on) { return py::make_tuple(on.kind, on.number); }

py::dict overlap_record(const Overlap& overlap, const Faces& faces) {
  return py::dict("boundary"_a = points_array(overlap.boundary, &SurfacePoint::point),
                  "uv_a"_a = points_array(overlap.boundary, &SurfacePoint::uv_a),
                  "uv_b"_a = points_array(overlap.boundary, &SurfacePoint::uv_b),
                  "face_a"_a = faces.a, "face_b"_a = faces.b);
}

py::dict place_record(const Place& place, const Faces& faces) {
  return py::dict("kind"_a = to_string(place.kind),
                  "box"_a = py::make_tuple(point_array(place.box_low), point_array(place.box_high)),
                  "gap"_a = py::make_tuple(place.gap_low, place.gap_high), "face_a"_a = faces.a,
                  "face_b"_a = faces.b);
}

// The numbers of edges and vertices are made only where something is on one.
class Numbers {
 public:
  explicit Numbers(const LoadedModel& model) : model_(model) {}
  py::object of(const TopoDS_Shape& on, int face) {
    if (on.IsNull()) return number_pair({"face", face});
    if (!known_)
      known_.emplace(in_turn(model_, [](const LoadedModel& m) { return m.whole_shape(); }));
    return number_pair(known_->of(on, face));
  }

 private:
  const LoadedModel& model_;
  std::optional<occt::BorderNumbers> known_;
};

py::dict edge_record(const reports::EdgeMeeting& each) {
  const auto on = [](const reports::Json& place) {
    return py::make_tuple(place["kind"].get<std::string>(), place["number"].get<int>());
  };
  return py::dict("on_a"_a = on(each.on_a), "on_b"_a = on(each.on_b));
}

// What edges have in common with the other shape.
void add_edge_records(const reports::EdgeMeetingLists& lists, py::dict& records) {
  py::list points, stretches;
  for (const reports::EdgeMeeting& each : lists.points) {
    py::dict record = edge_record(each);
    record["point"] = point_array(each.point);
    record["parameter"] = each.range.from;
    points.append(record);
  }
  for (const reports::EdgeMeeting& each : lists.stretches) {
    py::dict record = edge_record(each);
    record["start"] = point_array(each.point);
    record["end"] = point_array(each.end);
    record["length"] = each.length;
    record["parameters"] = py::make_tuple(each.range.from, each.range.to);
    stretches.append(record);
  }
  records["edge_points"] = points;
  records["edge_stretches"] = stretches;
}

py::dict records_of(const Found& found) {
  py::list curves, chains, points, nodes, overlaps, places;
  Numbers numbers_a(*found.a), numbers_b(*found.b);
  for (const occt::FaceIntersection& pair : found.intersection.pairs) {
    const Faces faces{found.a->number_of(pair.face_a), found.b->number_of(pair.face_b)};
    const std::size_t first = curves.size();
    for (const IntersectionCurve& curve : pair.found.curves)
      curves.append(curve_record(curve, faces));
    for (const CurveChain& chain : pair.chains)
      chains.append(chain_record(pair, chain, first, faces));
    for (std::size_t i = 0; i < pair.found.points.size(); ++i) {
      py::dict record = contact_record(pair.found.points[i], faces);
      record["on_a"] = numbers_a.of(pair.borders[i].on_a, faces.a);
      record["on_b"] = numbers_b.of(pair.borders[i].on_b, faces.b);
      points.append(record);
    }
    for (const SurfacePoint& node : pair.found.nodes) nodes.append(contact_record(node, faces));
    for (const Overlap& overlap : pair.found.overlaps)
      overlaps.append(overlap_record(overlap, faces));
    for (const Place& place : pair.found.places) places.append(place_record(place, faces));
  }
  py::dict records("curves"_a = curves, "chains"_a = chains, "points"_a = points, "nodes"_a = nodes,
                   "overlaps"_a = overlaps, "places"_a = places,
                   "certificate"_a = to_python(reports::to_json(found.intersection.certificate)));
  add_edge_records(found.edge_meetings, records);
  return records;
}

// In the turns of both models.
const occt::JoinedIntersection& joined_of(const Found& found) {
  if (!found.joined) {
    found.joined = occt::joined_intersection(found.intersection, found.a->input().faces,
                                             found.b->input().faces);
    reports::add_edges(found.edges, *found.joined);
  }
  return *found.joined;
}

// Likewise.
reports::IntersectionFindings findings_of(const Found& found) {
  return {found.a->input(), found.b->input(), found.intersection, joined_of(found), found.edges};
}

reports::Json report_of(const Found& found) {
  const Watch watch;
  const BothTurns turns(*found.a, *found.b, watch);
  const reports::RunTimes times{found.seconds, found.seconds};
  const reports::IntersectionFindings findings = findings_of(found);
  return found.itself ? reports::self_intersection_report(findings, times)
                      : reports::intersection_report(findings, times);
}

Answer answer_of(SharedFound found) {
  return {.report =
              [found] {
                return with_reading(report_of(*found), {found->a, found->b});
              },
          .model =
              [found] {
                const BothTurns turns(*found->a, *found->b, Watch());
                return std::make_shared<LoadedModel>("intersection", joined_of(*found).wires);
              },
          .records =
              [found] {
                py::dict records = records_of(*found);
                const std::vector<SharedModel> both{found->a, found->b};
                records["status"] = to_string(stated_status(found->intersection.status, both));
                records["seconds"] = found->seconds;
                return records;
              },
          .picture = in_turns({found->a, found->b}, [found] {
            const Status status = stated_status(found->intersection.status, {found->a, found->b});
            return pictures::intersection_picture(findings_of(*found), status);
          })};
}

template <class Work>
SharedFound found_by(const SharedModel& a, const SharedModel& b, bool itself, const Watch& watch,
                     const Work& work) {
  auto found = std::make_shared<Found>(Found{a, b, itself, {}, 0});
  const double start = watch.seconds();
  work(*found);
  found->seconds = watch.seconds() - start;
  return found;
}

// Faces as they are, or edges.
const reports::Input& intersected(LoadedModel& model, const Watch& watch) {
  const reports::Input& input = model.repaired_input(watch, reports::LooseFaces::Kept);
  if (input.faces.empty() && reports::edges_to_intersect(input).empty())
    throw occt::BadModel(model.name() + ": there is no face and no edge in it");
  return input;
}

}  // namespace

Answer intersect(const SharedModel& a, const SharedModel& b, const Control& control) {
  return answer_of(interruptible(control, [&](const Watch& watch) {
    const BothTurns turns(*a, *b, watch);
    const reports::Input& in_a = intersected(*a, watch);
    const reports::Input& in_b = intersected(*b, watch);
    return found_by(a, b, false, watch, [&](Found& found) {
      found.intersection = occt::intersect(in_a.faces, in_b.faces, watch.engine());
      found.edges = reports::edge_findings(in_a, in_b, watch.engine());
      reports::add_status(found.edges, found.intersection);
      found.edge_meetings = reports::meetings_of(found.edges, in_a, in_b);
    });
  }));
}

Answer self_intersect(const SharedModel& model, bool all_faces, const Control& control) {
  const auto scope = all_faces ? occt::SelfScope::AllFaces : occt::SelfScope::EachFace;
  return answer_of(interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    const std::vector<TopoDS_Face>& faces = model->faces(watch);
    return found_by(model, model, true, watch, [&](Found& found) {
      found.intersection = occt::self_intersect(faces, scope, watch.engine());
    });
  }));
}

}  // namespace blossom::python
