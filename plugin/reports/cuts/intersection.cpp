// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/cuts/intersection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/intersection_edges.h"
#include "core/base/unbounded.h"
#include "plugin/reports/models/repairs.h"
#include "plugin/reports/models/shape_numbers.h"

namespace blossom::reports {
namespace {

constexpr double kSameConic = 1e-7;  // of the larger half axis: what conics of one curve differ by

struct FaceNumbers {
  int a = 0;
  int b = 0;
};

Json with_faces(const FaceNumbers& faces, Json json) {
  json["face_a"] = faces.a;
  json["face_b"] = faces.b;
  return json;
}

Json point_json(const SurfacePoint& point, const FaceNumbers& faces) {
  Json json = with_faces(faces, {{"point", to_json(point.point)}});
  json["uv_a"] = to_json(point.uv_a);
  json["uv_b"] = to_json(point.uv_b);
  return json;
}

// A list of points as three lists of coordinates, the first one named `points`.
void add_points(const std::vector<SurfacePoint>& list, const char* points, Json& json) {
  for (const char* name : {points, "uv_a", "uv_b"}) json[name] = Json::array();
  for (const SurfacePoint& p : list) {
    json[points].push_back(to_json(p.point));
    json["uv_a"].push_back(to_json(p.uv_a));
    json["uv_b"].push_back(to_json(p.uv_b));
  }
}

// The samples of a chain; where it crosses a seam, the point is there with both parameters.
std::vector<SurfacePoint> samples_of(const std::vector<IntersectionCurve>& curves,
                                     const CurveChain& chain) {
  std::vector<SurfacePoint> samples;
  for (const ChainUse& use : chain.uses) {
    std::vector<SurfacePoint> more = curves[static_cast<std::size_t>(use.curve)].samples;
    if (!use.forward) std::reverse(more.begin(), more.end());
    samples.insert(samples.end(), more.begin(), more.end());
  }
  // Pieces meet within rounding; who draws a closed curve wants it closed.
  if (chain.closed) samples.back().point = samples.front().point;
  return samples;
}

bool same_conic(const Conic& a, const Conic& b) {
  const double near = kSameConic * a.major;
  return a.kind == b.kind && a.is_closed() && distance(a.centre, b.centre) <= near &&
         std::abs(a.major - b.major) <= near && std::abs(a.minor - b.minor) <= near;
}

// The circle or ellipse that all pieces lie on, from the first one on.
Json conic_json(const std::vector<IntersectionCurve>& curves, const CurveChain& chain) {
  const IntersectionCurve& first = curves[static_cast<std::size_t>(chain.uses.front().curve)];
  Interval range = first.curve.domain();
  if (chain.uses.size() == 1 || !first.conic) return to_json(first.conic, range);
  double turned = 0;
  for (const ChainUse& use : chain.uses) {
    const IntersectionCurve& curve = curves[static_cast<std::size_t>(use.curve)];
    if (!curve.conic || !same_conic(*first.conic, *curve.conic)) return nullptr;
    turned += blossom::length(curve.curve.domain());
  }
  (chain.uses.front().forward ? range.to : range.from) =
      chain.uses.front().forward ? range.from + turned : range.to - turned;
  return to_json(first.conic, range);
}

Json curve_json(const std::vector<IntersectionCurve>& curves, const CurveChain& chain,
                const FaceNumbers& faces) {
  const ChainFacts facts = facts_of(curves, chain);
  Json json = with_faces(faces, {{"closed", chain.closed}, {"tangential", facts.tangential}});
  add_points(samples_of(curves, chain), "points", json);
  json["length"] = facts.length;
  json["conic"] = conic_json(curves, chain);
  json["edges"] = chain.uses.size();
  json["degree"] = facts.degree;
  json["poles"] = facts.poles;
  json["least_angle"] = facts.least_angle;
  json["deviation"] = {
      {"a", facts.deviation.a}, {"b", facts.deviation.b}, {"between", facts.deviation.between}};
  json["deviation_proven"] = facts.deviation.proven;
  return json;
}

Json overlap_json(const Overlap& overlap, const FaceNumbers& faces) {
  Json json = with_faces(faces, Json::object());
  add_points(overlap.boundary, "boundary", json);
  for (const char* list : {"edges_a", "edges_b"}) json[list] = Json::array();
  return json;
}

void add_times(const occt::ShapeIntersection& found, const RunTimes& times, Json& report) {
  report["status"] = to_string(found.status);
  report["seconds"] = times.seconds;
  report["seconds_first"] = times.first;
}

void add_findings(const IntersectionFindings& findings, Json& report) {
  const auto& [a, b, found, whole, edges] = findings;
  for (const char* list : {"curves", "points", "nodes", "overlaps", "places"})
    report[list] = Json::array();
  const ShapeNumbers numbers_a(a.shape), numbers_b(b.shape);
  for (const occt::FaceIntersection& pair : found.pairs) {
    const FaceNumbers faces{a.numbers[static_cast<std::size_t>(pair.face_a)],
                            b.numbers[static_cast<std::size_t>(pair.face_b)]};
    for (const CurveChain& chain : pair.chains)
      report["curves"].push_back(curve_json(pair.found.curves, chain, faces));
    for (std::size_t i = 0; i < pair.found.points.size(); ++i) {
      Json point = point_json(pair.found.points[i], faces);
      point["on_a"] = numbers_a.place(pair.borders[i].on_a, faces.a);
      point["on_b"] = numbers_b.place(pair.borders[i].on_b, faces.b);
      report["points"].push_back(std::move(point));
    }
    for (const SurfacePoint& node : pair.found.nodes)
      report["nodes"].push_back(point_json(node, faces));
    for (const Overlap& overlap : pair.found.overlaps) {
      Json json = overlap_json(overlap, faces);
      for (const auto& [on_a, on_b] : pair.equal_edges) {
        json["edges_a"].push_back(numbers_a.place(on_a, faces.a)["number"]);
        json["edges_b"].push_back(numbers_b.place(on_b, faces.b)["number"]);
      }
      report["overlaps"].push_back(std::move(json));
    }
    for (const Place& place : pair.found.places)
      report["places"].push_back(with_faces(faces, to_json(place)));
  }
  const WireFacts joined = facts_of(whole.wires);
  report["joined"] = {{"wires", joined.wires},   {"closed", joined.closed}, {"edges", joined.edges},
                      {"points", joined.points}, {"length", joined.length}, {"lost", whole.lost}};
  report["certificate"] = to_json(found.certificate);
  report["certificate"]["face_pairs"] = found.face_pairs;
}

// The parts of faces with anything to tell: {"machine:2/bolt:1": [7, 9]}.
Json parts_json(const Input& input, const occt::ShapeIntersection& found,
                int occt::FaceIntersection::*face) {
  const std::vector<std::string> paths = input.model.part_paths();
  std::map<std::string, std::set<int>> parts;
  for (const occt::FaceIntersection& pair : found.pairs) {
    const int number = input.numbers[static_cast<std::size_t>(pair.*face)];
    if (const std::string& path = paths[static_cast<std::size_t>(number - 1)]; !path.empty())
      parts[path].insert(number);
  }
  Json json = Json::object();
  for (const auto& [path, numbers] : parts) json[path] = numbers;
  return json;
}

}  // namespace

ChainFacts facts_of(const std::vector<IntersectionCurve>& curves, const CurveChain& chain) {
  ChainFacts facts;
  facts.least_angle = kInfinity;
  for (const ChainUse& use : chain.uses) {
    const IntersectionCurve& curve = curves[static_cast<std::size_t>(use.curve)];
    facts.tangential = facts.tangential && curve.tangential;
    facts.length += curve.length;
    facts.least_angle = std::min(facts.least_angle, curve.least_angle);
    facts.degree = std::max(facts.degree, curve.curve.degree);
    facts.poles += curve.curve.points.size();
    facts.deviation.a = std::max(facts.deviation.a, curve.deviation.a);
    facts.deviation.b = std::max(facts.deviation.b, curve.deviation.b);
    facts.deviation.between = std::max(facts.deviation.between, curve.deviation.between);
    facts.deviation.proven = facts.deviation.proven && curve.deviation.proven;
  }
  return facts;
}

WireFacts facts_of(const TopoDS_Compound& wires) {
  WireFacts facts;
  for (TopoDS_Iterator it(wires); it.More(); it.Next()) {
    if (it.Value().ShapeType() == TopAbs_VERTEX) {
      ++facts.points;
      continue;
    }
    ++facts.wires;
    if (it.Value().Closed()) ++facts.closed;
    for (TopoDS_Iterator edge(it.Value()); edge.More(); edge.Next()) {
      ++facts.edges;
      facts.length += occt::edge_length(TopoDS::Edge(edge.Value()));
    }
  }
  return facts;
}

bool is_contact(const Place& place) {
  return place.kind != PlaceKind::Open && place.kind != PlaceKind::Overlap;
}

const char* verdict_of(const occt::ShapeIntersection& found) {
  bool open = found.status == Status::Stopped;
  for (const occt::FaceIntersection& pair : found.pairs) {
    if (!pair.chains.empty() || !pair.found.points.empty() || !pair.found.overlaps.empty())
      return "found";
    for (const Place& place : pair.found.places) {
      if (place.kind != PlaceKind::Open) return "found";
      open = true;
    }
  }
  return open ? "undecided" : "none found";
}

Json to_json(const Vec2& point) { return Json::array({point[0], point[1]}); }

Json to_json(const Vec3& point) { return Json::array({point[0], point[1], point[2]}); }

Json to_json(const Certificate& certificate) {
  return {{"excluded", certificate.excluded},
          {"certified", certificate.certified},
          {"critical", certificate.critical},
          {"cells_bezier", certificate.cells_bezier},
          {"cells_monomial", certificate.cells_monomial},
          {"depth", certificate.depth},
          {"identified", certificate.identified},
          {"identified_within", certificate.identified_within},
          {"rounding_bound", certificate.rounding_bound},
          {"least_angle", certificate.least_angle},
          {"reasons", certificate.reasons}};
}

Json to_json(const Place& place) {
  return {{"kind", to_string(place.kind)},
          {"box", Json::array({to_json(place.box_low), to_json(place.box_high)})},
          {"gap", Json::array({place.gap_low, place.gap_high})}};
}

Json to_json(const std::optional<Conic>& conic, const Interval& range) {
  if (!conic) return nullptr;
  Json json = {{"type", to_string(conic->kind)},
               {conic->kind == ConicKind::Line ? "point" : "centre", to_json(conic->centre)},
               {"x", to_json(conic->x)}};
  if (conic->kind != ConicKind::Line) json["y"] = to_json(conic->y);
  switch (conic->kind) {
    case ConicKind::Line: break;
    case ConicKind::Circle: json["radius"] = conic->major; break;
    case ConicKind::Parabola: json["focal"] = conic->major; break;
    default: json["major"] = conic->major; json["minor"] = conic->minor;
  }
  json["range"] = Json::array({range.from, range.to});
  return json;
}

Json intersection_report(const IntersectionFindings& findings, const RunTimes& times) {
  const auto& [a, b, found, joined, edges] = findings;
  Json report = {{"schema", "blossom.intersection/1"}, {"a", a.name}, {"b", b.name}};
  add_times(found, times, report);
  add_findings(findings, report);
  add_edge_findings(edges, a, b, report);
  report["parts_a"] = parts_json(a, found, &occt::FaceIntersection::face_a);
  report["parts_b"] = parts_json(b, found, &occt::FaceIntersection::face_b);
  report["repairs"] = Json::array({repairs_json(a), repairs_json(b)});
  return report;
}

Json self_intersection_report(const IntersectionFindings& findings, const RunTimes& times) {
  const Input& input = findings.a;
  const occt::ShapeIntersection& found = findings.found;
  Json report = {{"schema", "blossom.self-intersection/1"},
                 {"input", input.name},
                 {"verdict", verdict_of(found)}};
  add_times(found, times, report);
  add_findings(findings, report);
  report["repairs"] = Json::array({repairs_json(input)});
  return report;
}

}  // namespace blossom::reports
