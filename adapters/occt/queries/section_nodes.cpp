// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/section_nodes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <BRep_Tool.hxx>
#include <BndLib_Add3dCurve.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/limits.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "core/curve_surface_intersection.h"

namespace blossom::occt {
namespace {

constexpr int kEdgeSamples = 65;

double distance_to(const SectionCurve& curve, const Vec3& p) {
  double least = std::min(distance(p, curve.samples.front()), distance(p, curve.samples.back()));
  const GeomAPI_ProjectPointOnCurve foot(pnt(p), curve.curve, curve.range.from, curve.range.to);
  if (foot.NbPoints() > 0) least = std::min(least, foot.LowerDistance());
  return least;
}

double reach_of(const SectionCurve& edge, double tolerance) {
  return kOnIt * std::max(tolerance, edge.tolerance);
}

SectionCurve curve_of(std::size_t face, const TopoDS_Edge& edge, const Heights& heights) {
  SectionCurve curve;
  curve.face = static_cast<int>(face);
  curve.edge = edge;
  curve.curve = BRep_Tool::Curve(edge, curve.range.from, curve.range.to);
  curve.tolerance = BRep_Tool::Tolerance(edge);
  curve.deviation = std::max(heights.high, -heights.low) + heights.margin;
  curve.length = edge_length(edge);
  for (int i = 0; i < kEdgeSamples; ++i)
    curve.samples.push_back(
        vec(curve.curve->Value(at(curve.range, static_cast<double>(i) / (kEdgeSamples - 1)))));
  return curve;
}

// How far off its node on an edge a curve of one of its faces may end. The curve ends on the face's
// image of the edge, which is off the edge by its tolerance, and leaves the plane as steeply.
double slack_at(const TopoDS_Edge& edge, double parameter, double tolerance, const Vec3& normal) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  gp_Pnt point;
  gp_Vec direction;
  curve->D1(parameter, point, direction);
  const double speed = direction.Magnitude();
  const double off = 2 * std::max(tolerance, BRep_Tool::Tolerance(edge));
  const double rise = std::abs(dot(normal, vec(direction.XYZ())));
  // Where the edge is tangent to the plane it stays near it for about sqrt(off * length).
  const double extent = speed * length(range);
  return std::max(off, std::min(off * speed / rise, std::sqrt(off * extent)));
}

}  // namespace

SectionNodes::SectionNodes(const SectionFrame& frame, const IntersectionOptions& options,
                           std::size_t faces, PlaneSection& section)
    : frame_(frame),
      options_(options),
      tolerance_(options.tolerances.point),
      section_(section),
      nodes_of_(faces),
      curves_of_(faces) {}

void SectionNodes::add_edges(std::size_t index, const TopoDS_Face& face) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(face, TopAbs_EDGE, edges);
  for (int k = 1; k <= edges.Extent(); ++k) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(k));
    if (!edges_.Contains(edge)) {
      edges_.Add(edge);
      known_.push_back(known_edge(index, edge));
    }
    const KnownEdge& known = known_[static_cast<std::size_t>(edges_.FindIndex(edge) - 1)];
    nodes_of_[index].insert(nodes_of_[index].end(), known.nodes.begin(), known.nodes.end());
    if (known.curve >= 0) curves_of_[index].push_back(known.curve);
  }
}

void SectionNodes::add_loose(const std::vector<TopoDS_Edge>& edges) {
  for (const TopoDS_Edge& edge : edges) {
    if (edges_.Contains(edge)) continue;
    edges_.Add(edge);
    known_.push_back(known_edge(nodes_of_.size(), edge));
    if (known_.back().in_part) weaken("an edge without a face lies in the plane in part");
    if (known_.back().curve < 0) continue;
    SectionCurve& curve = section_.curves[static_cast<std::size_t>(known_.back().curve)];
    curve.face = -1;
    curve.bounding = false;
  }
}

SectionNodes::KnownEdge SectionNodes::known_edge(std::size_t face, const TopoDS_Edge& edge) {
  KnownEdge known;
  for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
    if (!end.IsNull() && touches(end)) known.nodes.push_back(node_of_vertex(end));
  if (BRep_Tool::Degenerated(edge)) return known;
  const CurveSpans curve = bezier_spans(edge, tolerance_);
  const Heights heights = heights_of(curve, frame_);
  if (heights.apart(tolerance_)) return known;
  if (heights.within(tolerance_)) {
    add_curve(face, edge, known);
    return known;
  }
  IntersectionOptions options = options_;
  options.part_a = options.part_b = {};
  add_points(edge, intersect(curve, frame_.over(heights.box), options), known);
  return known;
}

// An edge in the plane is a curve of the section, from vertex to vertex.
void SectionNodes::add_curve(std::size_t face, const TopoDS_Edge& edge, KnownEdge& known) {
  SectionCurve curve = curve_of(face, edge, heights_of(bezier_spans(edge, tolerance_), frame_));
  const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
  curve.closed = !first.IsNull() && first.IsSame(last);
  if (!first.IsNull()) curve.nodes[0] = node_of_vertex(first);
  if (!last.IsNull()) curve.nodes[1] = node_of_vertex(last);
  for (const int node : curve.nodes)
    if (node >= 0) known.nodes.push_back(node);
  known.curve = static_cast<int>(section_.curves.size());
  section_.curves.push_back(std::move(curve));
}

void SectionNodes::add_points(const TopoDS_Edge& edge, const CurveSurfaceIntersection& found,
                              KnownEdge& known) {
  if (found.status == Status::Stopped) {
    weaken("it is not known where an edge meets the plane");
    section_.status = Status::Stopped;
  }
  for (const CurveSurfacePoint& point : found.points) {
    int node = -1;
    for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
      if (!end.IsNull() && distance(vec(BRep_Tool::Pnt(end)), point.point) <=
                               std::max(tolerance_, BRep_Tool::Tolerance(end)))
        node = node_of_vertex(end);
    if (node < 0)
      node = new_node(edge, point.point, slack_at(edge, point.t, tolerance_, frame_.normal()),
                      point.proven);
    known.nodes.push_back(node);
  }
  // A run along a part of an edge starts and ends in nodes; the curve itself is its faces'.
  const CurveSpans curve = bezier_spans(edge, tolerance_);
  known.in_part = !found.overlaps.empty();
  for (const CurveSurfaceOverlap& run : found.overlaps)
    for (const double t : {run.t.from, run.t.to})
      known.nodes.push_back(new_node(edge, point_at(curve, t),
                                     slack_at(edge, t, tolerance_, frame_.normal()), false));
}

bool SectionNodes::touches(const TopoDS_Vertex& vertex) const {
  return std::abs(frame_.height(vec(BRep_Tool::Pnt(vertex)))) <=
         std::max(tolerance_, BRep_Tool::Tolerance(vertex));
}

int SectionNodes::node_of_vertex(const TopoDS_Vertex& vertex) {
  const int known = vertices_.FindIndex(vertex);
  if (known > 0) return vertex_nodes_[static_cast<std::size_t>(known - 1)];
  vertices_.Add(vertex);
  vertex_nodes_.push_back(
      new_node(vertex, vec(BRep_Tool::Pnt(vertex)), BRep_Tool::Tolerance(vertex), false));
  return vertex_nodes_.back();
}

int SectionNodes::new_node(const TopoDS_Shape& on, const Vec3& point, double slack, bool proven) {
  section_.nodes.push_back({point, on, 0, proven});
  slack_.push_back(slack);
  return static_cast<int>(section_.nodes.size()) - 1;
}

int SectionNodes::nearest_node(std::size_t face, const Vec3& point) const {
  int best = -1;
  double least = 0;
  for (const int node : nodes_of_[face]) {
    const double gap = distance(section_.nodes[static_cast<std::size_t>(node)].point, point);
    if (best >= 0 && gap >= least) continue;
    best = node;
    least = gap;
  }
  return best;
}

void SectionNodes::weaken(const std::string& reason) {
  section_.status = weaker(section_.status, Status::Tolerance);
  auto& reasons = section_.certificate.reasons;
  if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) reasons.push_back(reason);
}

int SectionNodes::end_node(std::size_t face, const Vec3& point, double reach, double far) {
  const double off = tolerance_ + reach;
  const int node = nearest_node(face, point);
  if (node >= 0) {
    SectionNode& known = section_.nodes[static_cast<std::size_t>(node)];
    const double gap = distance(known.point, point);
    const bool near = gap <= off + slack_[static_cast<std::size_t>(node)];
    if (near || gap <= far) {
      if (!near)
        weaken("a section curve ends beside an edge of its face, farther off than its tolerance");
      known.reach = std::max(known.reach, gap);
      return node;
    }
  }
  weaken("a section curve ends on no edge of its face");
  nodes_of_[face].push_back(new_node({}, point, off, false));
  return nodes_of_[face].back();
}

int SectionNodes::contact_node(std::size_t face, const Vec3& point, double reach) {
  const int node = nearest_node(face, point);
  if (node >= 0 && distance(section_.nodes[static_cast<std::size_t>(node)].point, point) <=
                       tolerance_ + reach + slack_[static_cast<std::size_t>(node)])
    return node;
  nodes_of_[face].push_back(new_node({}, point, tolerance_ + reach, false));
  return nodes_of_[face].back();
}

void SectionNodes::join_free_ends() {
  std::vector<int> ends(section_.nodes.size());
  for (const SectionCurve& curve : section_.curves)
    for (const int node : curve.nodes)
      if (node >= 0) ++ends[static_cast<std::size_t>(node)];
  std::vector<std::size_t> alone;
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i] == 1) alone.push_back(i);
  const auto x = [&](std::size_t i) { return section_.nodes[i].point[0]; };
  std::sort(alone.begin(), alone.end(), [&](std::size_t a, std::size_t b) { return x(a) < x(b); });
  double widest = 0;
  for (const std::size_t i : alone) widest = std::max(widest, slack_[i]);
  std::vector<int> becomes(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) becomes[i] = static_cast<int>(i);
  for (std::size_t k = 0; k < alone.size(); ++k) {
    const std::size_t i = alone[k];
    for (std::size_t l = k + 1; l < alone.size() && ends[i] == 1; ++l) {
      const std::size_t j = alone[l];
      if (x(j) - x(i) > 2 * widest) break;
      SectionNode &p = section_.nodes[i], &q = section_.nodes[j];
      const double gap = distance(p.point, q.point);
      if (ends[j] != 1 || gap > slack_[i] + slack_[j]) continue;
      const bool to_q = p.on.IsNull();
      (to_q ? becomes[i] : becomes[j]) = static_cast<int>(to_q ? j : i);
      (to_q ? q : p).reach = std::max(p.reach, q.reach) + gap;
      ends[i] = ends[j] = 2;
    }
  }
  for (SectionCurve& curve : section_.curves)
    for (int& node : curve.nodes)
      if (node >= 0) node = becomes[static_cast<std::size_t>(node)];
  drop_joined(becomes);
}

// Nodes that have become others go, and the numbers close up.
void SectionNodes::drop_joined(const std::vector<int>& becomes) {
  std::vector<int> number(becomes.size(), -1);
  std::vector<SectionNode> kept;
  std::vector<double> slack;
  for (std::size_t i = 0; i < becomes.size(); ++i) {
    if (becomes[i] != static_cast<int>(i)) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(section_.nodes[i]);
    slack.push_back(slack_[i]);
  }
  section_.nodes = std::move(kept);
  slack_ = std::move(slack);
  for (SectionCurve& curve : section_.curves)
    for (int& node : curve.nodes)
      if (node >= 0) node = number[static_cast<std::size_t>(node)];
}

std::vector<std::size_t> SectionNodes::lone_nodes() const {
  std::vector<Bnd_Box> boxes;  // of the curves, with what is near enough to them but for the slack
  for (const SectionCurve& curve : section_.curves) {
    boxes.emplace_back();
    BndLib_Add3dCurve::Add(GeomAdaptor_Curve(curve.curve), curve.range.from, curve.range.to,
                           curve.tolerance + tolerance_, boxes.back());
  }
  std::vector<bool> ended(section_.nodes.size());
  for (const SectionCurve& curve : section_.curves)
    for (const int node : curve.nodes)
      if (node >= 0) ended[static_cast<std::size_t>(node)] = true;
  std::vector<std::size_t> lone;
  for (std::size_t i = 0; i < ended.size(); ++i) {
    if (ended[i]) continue;
    // Curves run over poles and seams.
    const Vec3& p = section_.nodes[i].point;
    const double reach = tolerance_ + slack_[i];
    Bnd_Box around;
    around.Set(pnt(p));
    around.SetGap(slack_[i]);
    bool passed = false;
    for (std::size_t k = 0; k < boxes.size() && !passed; ++k)
      passed = !boxes[k].IsOut(around) &&
               distance_to(section_.curves[k], p) <= section_.curves[k].tolerance + reach;
    if (!passed) lone.push_back(i);
  }
  return lone;
}

bool SectionNodes::lies_on_edge(std::size_t face, const Vec3& point) const {
  return std::ranges::any_of(curves_of_[face], [&](int k) {
    const SectionCurve& edge = section_.curves[static_cast<std::size_t>(k)];
    return distance_to(edge, point) <= reach_of(edge, tolerance_);
  });
}

std::vector<Interval> SectionNodes::beside_edges(std::size_t face,
                                                 const IntersectionCurve& curve) const {
  const Interval domain = curve.curve.domain();
  if (curves_of_[face].empty()) return {domain};
  std::vector<double> cuts{domain.from, domain.to};
  const Handle(Geom_BSplineCurve) line = to_occt(curve.curve);
  for (const int k : curves_of_[face]) {
    const SectionCurve& edge = section_.curves[static_cast<std::size_t>(k)];
    for (const Vec3& end : {edge.samples.front(), edge.samples.back()}) {
      const GeomAPI_ProjectPointOnCurve foot(pnt(end), line);
      if (foot.NbPoints() > 0 && foot.LowerDistance() <= reach_of(edge, tolerance_))
        cuts.push_back(foot.LowerDistanceParameter());
    }
  }
  std::ranges::sort(cuts);
  std::vector<Interval> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Interval part{cuts[i], cuts[i + 1]};
    const auto on_edge = [&](double share) {
      return lies_on_edge(face, point_at(curve.curve, at(part, share)));
    };
    if (on_edge(0.25) && on_edge(0.5) && on_edge(0.75)) continue;
    if (!parts.empty() && parts.back().to == part.from)
      parts.back().to = part.to;
    else
      parts.push_back(part);
  }
  return parts;
}

}  // namespace blossom::occt
