// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/intersection.h"

#include <algorithm>
#include <utility>

#include "plugin/pictures/scene/hatch.h"
#include "plugin/pictures/scene/mesh.h"
#include "plugin/reports/cuts/intersection_words.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::pictures {
namespace {

using reports::Input;
using reports::number_text;
using reports::rounded;
using reports::short_name;

constexpr double kHatchSpacing = 1.0 / 90;  // of the size of both inputs

// The layers of an intersection, in the order in which they are drawn.
struct IntersectionLayers {
  PictureLayer overlaps{"overlapping", kOverlapColour, LayerStyle::Hatch};
  PictureLayer borders{"", kOverlapColour, LayerStyle::Net};
  PictureLayer edges{"edge", kNetColour, LayerStyle::Curve};
  PictureLayer overlapping_edges{"common stretch", kOverlapColour, LayerStyle::Curve};
  PictureLayer crossing{"crossing", kCurveColour, LayerStyle::Curve};
  PictureLayer touching{"touching", kTouchColour, LayerStyle::Curve};
  PictureLayer points{"point", kCurveColour, LayerStyle::Dot};
  PictureLayer contacts{"contact within tolerance", kTouchColour, LayerStyle::Ring};
  PictureLayer unresolved{"unresolved", kUnresolvedColour, LayerStyle::Square};

  std::vector<PictureLayer> all() const {
    return {overlaps, borders, edges,    overlapping_edges, crossing,
            touching, points,  contacts, unresolved};
  }
};

std::string deviation_text(const Deviation& d) {
  const auto number = [](double value) { return number_text(rounded(value)); };
  return "deviation " + number(d.a) + " from A, " + number(d.b) + " from B, " + number(d.between) +
         " between them, " + (d.proven ? "proven" : "not proven");
}

std::vector<Vec3> points_of(const std::vector<SurfacePoint>& samples) {
  std::vector<Vec3> points;
  for (const SurfacePoint& sample : samples) points.push_back(sample.point);
  return points;
}

// The loops of a boundary without the steps from one to the other, see joined_loops.
std::vector<std::vector<Vec3>> loops_of(const std::vector<SurfacePoint>& boundary) {
  const std::vector<Vec3> points = points_of(boundary);
  std::vector<std::vector<Vec3>> loops;
  for (auto first = points.begin(); first != points.end();) {
    const auto last = std::find(first + 1, points.end(), *first);
    if (last == points.end()) break;  // only the way back is left
    loops.emplace_back(first, last + 1);
    first = last + 1;
  }
  return loops;
}

void add_curves(const occt::FaceIntersection& pair, const std::string& name,
                IntersectionLayers& layers) {
  for (const CurveChain& chain : pair.chains) {
    const reports::ChainFacts facts = reports::facts_of(pair.found.curves, chain);
    const std::string label = name + "\ncurve, " + reports::curve_text(pair, chain, true) +
                              "\nleast angle of the faces " +
                              number_text(rounded(facts.least_angle)) + " rad\n" +
                              deviation_text(facts.deviation);
    PictureLayer& layer = facts.tangential ? layers.touching : layers.crossing;
    for (const ChainUse& use : chain.uses)
      layer.items.push_back(
          {points_of(pair.found.curves[static_cast<std::size_t>(use.curve)].samples), label});
  }
}

void add_overlap(const Input& a, const occt::FaceIntersection& pair, const Overlap& overlap,
                 const std::string& name, double spacing, IntersectionLayers& layers) {
  const TopoDS_Face& face = a.faces[static_cast<std::size_t>(pair.face_a)];
  const std::string label =
      name + "\noverlap of about " + number_text(rounded(overlap_area(a, pair, overlap))) + " mm²";
  std::vector<std::vector<Vec2>> polygons;
  if (pair.equal_edges.empty() && !overlap.boundary.empty()) {
    polygons.emplace_back();
    for (const SurfacePoint& point : overlap.boundary) polygons.back().push_back(point.uv_a);
  } else {
    polygons = wire_polygons(face);
  }
  for (std::vector<Vec3>& line : hatch_lines(face, polygons, spacing))
    layers.overlaps.items.push_back({std::move(line), label});
  for (std::vector<Vec3>& loop : loops_of(overlap.boundary))
    layers.borders.items.push_back({std::move(loop), label});
}

void add_places(const occt::FaceIntersection& pair, const std::string& name,
                IntersectionLayers& layers) {
  for (const SurfacePoint& point : pair.found.points)
    layers.points.items.push_back({{point.point}, name + "\npoint"});
  for (const SurfacePoint& node : pair.found.nodes)
    layers.points.items.push_back({{node.point}, name + "\nbranching point"});
  for (const Place& place : pair.found.places) {
    const Vec3 centre = 0.5 * (place.box_low + place.box_high);
    PictureItem mark{{centre}, name + "\n" + reports::place_text(place)};
    if (place.kind == PlaceKind::Open)
      layers.unresolved.items.push_back(std::move(mark));
    else if (place.kind != PlaceKind::Overlap || pair.found.overlaps.empty())
      layers.contacts.items.push_back(std::move(mark));
  }
}

// The edges themselves, and what they have in common with the other input.
void add_edge_meetings(const reports::IntersectionFindings& findings, IntersectionLayers& layers) {
  const reports::EdgeFindings& edges = findings.edges;
  for (const reports::EdgesOf* of : {&edges.a, &edges.b}) {
    for (const TopoDS_Edge& edge : of->edges) layers.edges.items.push_back({edge_points(edge)});
    for (const occt::EdgeStretch& stretch : of->met.stretches)
      layers.overlapping_edges.items.push_back(
          {edge_points(of->edges[static_cast<std::size_t>(stretch.edge)], stretch.range),
           "common stretch of " + number_text(rounded(stretch.length)) + " mm"});
  }
  for (const reports::EdgeMeeting& point :
       reports::meetings_of(edges, findings.a, findings.b).points)
    layers.points.items.push_back({{point.point}, point.of_a + " x " + point.of_b + "\npoint"});
}

}  // namespace

std::vector<std::string> certificate_facts(const Certificate& certificate) {
  const auto number = [](double value) { return number_text(rounded(value)); };
  std::vector<std::string> facts = {
      std::to_string(certificate.excluded) + " pairs of cells proven without a common point",
      std::to_string(certificate.certified) + " pairs proven to hold one arc each",
      std::to_string(certificate.critical) + " pairs near critical points",
      "least angle of the faces along curves " + number(certificate.least_angle) + " rad",
      "roundings at most " + number(certificate.rounding_bound)};
  if (certificate.identified > 0)
    facts.push_back(std::to_string(certificate.identified) +
                    " pairs of faces on one surface within " +
                    number(certificate.identified_within));
  facts.insert(facts.end(), certificate.reasons.begin(), certificate.reasons.end());
  return facts;
}

Picture intersection_picture(const reports::IntersectionFindings& findings, Status stated) {
  const auto& [a, b, found, joined, edges] = findings;
  const bool itself = &a == &b;
  Picture picture;
  picture.title = short_name(a.name) + (itself ? " with itself" : " x " + short_name(b.name));
  picture.subtitle =
      std::string(to_string(stated)) + ": " + counts_text(reports::counts_of(a, found, edges));
  picture.groups = {{a.faces, kFirstColour, itself ? kSecondOpacity : kFirstOpacity,
                     short_name(a.name), face_labels(a)}};
  if (!itself)
    picture.groups.push_back(
        {b.faces, kSecondColour, kSecondOpacity, short_name(b.name), face_labels(b)});
  const double spacing = kHatchSpacing * std::max(size_of(a.faces), size_of(b.faces));
  const reports::PairNames names(a, b);
  IntersectionLayers layers;
  for (const occt::FaceIntersection& pair : found.pairs) {
    const std::string name = names.of(pair);
    add_curves(pair, name, layers);
    for (const Overlap& overlap : pair.found.overlaps)
      add_overlap(a, pair, overlap, name, spacing, layers);
    add_places(pair, name, layers);
  }
  add_edge_meetings(findings, layers);
  picture.layers = layers.all();
  picture.facts = certificate_facts(found.certificate);
  return picture;
}

}  // namespace blossom::pictures
