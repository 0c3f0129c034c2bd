// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges/joined_curves.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <BRep_Builder.hxx>
#include <BndLib_Add3dCurve.hxx>
#include <Bnd_Box.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/base/points.h"
#include "core/base/disjoint_sets.h"
#include "core/bounds/box_tree.h"

namespace blossom::occt {
namespace {

/// A place where curves end.
struct CurveNode {
  Vec3 point;
  double reach = 0;   ///< how far off it what ends there may end
  double stated = 0;  ///< likewise by what faces state
};

/// A part of a curve between two nodes; of a closed one without nodes the whole.
struct Stretch {
  std::size_t curve = 0;
  Interval range;
  std::array<int, 2> nodes{-1, -1};
  bool repeats = false;  ///< another one that stays
};

Box box_of(const FoundCurve& curve) {
  Bnd_Box box;
  BndLib_Add3dCurve::Add(GeomAdaptor_Curve(curve.of.curve), curve.of.range.from, curve.of.range.to,
                         curve.tolerance, box);
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  return {vec(low), vec(high)};
}

Box box_of(const Vec3& point, double reach) {
  return {point - Vec3{reach, reach, reach}, point + Vec3{reach, reach, reach}};
}

bool is_spline(const FoundCurve& curve) {
  return curve.of.curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve));
}

class CurveJoiner {
 public:
  CurveJoiner(const std::vector<FoundCurve>& curves, const std::vector<FoundPoint>& points)
      : curves_(curves), points_(points), tree_(boxes_of(curves)), splits_(curves.size()) {}

  TopoDS_Compound run() {
    gather_ends();
    for (std::size_t i = 0; i < nodes_.size(); ++i) split_at(static_cast<int>(i));
    for (std::size_t i = 0; i < curves_.size(); ++i) add_stretches(i);
    drop_repeats();
    join_lone_ends();
    make_nodes();
    return made();
  }

 private:
  static std::vector<Box> boxes_of(const std::vector<FoundCurve>& curves) {
    std::vector<Box> boxes;
    for (const FoundCurve& curve : curves) boxes.push_back(box_of(curve));
    return boxes;
  }

  Vec3 point_at(std::size_t curve, double t) const {
    return vec(curves_[curve].of.curve->Value(t));
  }
  double end_of(std::size_t curve, std::size_t side) const {
    const Interval& range = curves_[curve].of.range;
    return side == 0 ? range.from : range.to;
  }

  void gather_ends();
  int new_node(const Vec3& point, double reach);
  void split_at(int node);
  void split(std::size_t curve, double t, int node);
  void add_stretches(std::size_t curve);
  void add_closed(std::size_t curve);
  void drop_repeats();
  bool is_along(const Stretch& one, const Stretch& other) const;
  bool is_better(const Stretch& one, const Stretch& other) const;
  void join_lone_ends();
  void make_nodes();
  TopoDS_Edge edge_of(const Stretch& stretch) const;
  TopoDS_Wire wire_from(std::size_t start, std::size_t side, std::vector<bool>& used) const;
  std::optional<std::pair<std::size_t, std::size_t>> next(std::size_t stretch,
                                                          std::size_t side) const;
  bool is_passed(const FoundPoint& point) const;
  TopoDS_Compound made() const;

  const std::vector<FoundCurve>& curves_;
  const std::vector<FoundPoint>& points_;
  BoxTree tree_;  // of the curves
  std::vector<CurveNode> nodes_;
  std::vector<std::array<int, 2>> ends_;                     // by curve, the nodes in which it ends
  std::vector<std::vector<std::pair<double, int>>> splits_;  // by curve, with their nodes
  std::vector<Stretch> stretches_;
  std::vector<TopoDS_Vertex> vertices_;                               // by node
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> at_;  // by node, stretches' ends
};

int CurveJoiner::new_node(const Vec3& point, double reach) {
  nodes_.push_back({point, reach});
  return static_cast<int>(nodes_.size()) - 1;
}

// Ends within reach of each other are one node, and so is what is within reach of one of them.
void CurveJoiner::gather_ends() {
  struct End {
    std::size_t curve, side;
    Vec3 point;
    double reach;
  };
  std::vector<End> ends;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < curves_.size(); ++i)
    for (const std::size_t side : {0, 1}) {
      if (curves_[i].closed) continue;
      const double reach = std::max(curves_[i].tolerance, curves_[i].reach[side]);
      ends.push_back({i, side, point_at(i, end_of(i, side)), reach});
      boxes.push_back(box_of(ends.back().point, reach));
    }
  DisjointSets sets(ends.size());
  const BoxTree tree(boxes);
  tree.for_each_meeting(tree, [&](int i, int j) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    if (a < b && distance(ends[a].point, ends[b].point) <= ends[a].reach + ends[b].reach)
      sets.join(b, a);
  });
  ends_.assign(curves_.size(), {-1, -1});
  std::vector<int> node_of(ends.size(), -1);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    int& node = node_of[sets.find(i)];
    if (node < 0) node = new_node(ends[i].point, ends[i].reach);
    CurveNode& at = nodes_[static_cast<std::size_t>(node)];
    at.stated = std::max(at.stated, curves_[ends[i].curve].stated);
    at.reach =
        std::max(at.reach, distance(at.point, ends[i].point) + curves_[ends[i].curve].tolerance);
    ends_[ends[i].curve][ends[i].side] = node;
  }
}

// Nodes are also where a curve of theirs ends on another one.
void CurveJoiner::split_at(int node) {
  const Vec3 point = nodes_[static_cast<std::size_t>(node)].point;
  const double reach = nodes_[static_cast<std::size_t>(node)].reach;
  tree_.for_each_near(point, reach * reach, [&](int i) {
    const auto curve = static_cast<std::size_t>(i);
    if (ends_[curve][0] != node && ends_[curve][1] != node) {
      const EdgeFoot foot = foot_on(curves_[curve].of, pnt(point));
      if (foot.distance <= reach + curves_[curve].tolerance) split(curve, foot.parameter, node);
    }
    return reach * reach;
  });
}

// A closed spline begins in a node where it has any.
void CurveJoiner::split(std::size_t curve, double t, int node) {
  const FoundCurve& of = curves_[curve];
  const bool first = splits_[curve].empty();
  splits_[curve].emplace_back(t, node);
  if (!first || !of.closed || !is_spline(of)) return;
  const Vec3 start = point_at(curve, of.of.range.from);
  const CurveNode& at = nodes_[static_cast<std::size_t>(node)];
  const bool begins = distance(start, at.point) <= at.reach + of.tolerance;
  const int begin = begins ? node : new_node(start, of.tolerance);
  ends_[curve] = {begin, begin};
}

void CurveJoiner::add_stretches(std::size_t curve) {
  const FoundCurve& of = curves_[curve];
  auto& splits = splits_[curve];
  std::erase_if(splits, [&](const auto& at) {
    return at.second == ends_[curve][0] || at.second == ends_[curve][1];
  });
  std::ranges::sort(splits);
  if (of.closed && ends_[curve][0] < 0) return add_closed(curve);
  double from = of.of.range.from;
  int node = ends_[curve][0];
  splits.emplace_back(of.of.range.to, ends_[curve][1]);
  for (const auto& [t, end] : splits) {
    // What begins and ends in one node, and does not leave it, is that node.
    const CurveNode& at_end = nodes_[static_cast<std::size_t>(end)];
    const double far = distance(at_end.point, point_at(curve, 0.5 * (from + t)));
    if (node != end || far > at_end.reach) stretches_.push_back({curve, {from, t}, {node, end}});
    from = t;
    node = end;
  }
}

// A closed curve whose beginning is no node: a conic between its splits, or as it is.
void CurveJoiner::add_closed(std::size_t curve) {
  const Interval& range = curves_[curve].of.range;
  const auto& splits = splits_[curve];
  if (splits.empty()) stretches_.push_back({curve, range, {-1, -1}});
  for (std::size_t i = 0; i < splits.size(); ++i) {
    const bool last = i + 1 == splits.size();
    const auto& [to, end] = splits[last ? 0 : i + 1];
    stretches_.push_back(
        {curve, {splits[i].first, to + (last ? length(range) : 0)}, {splits[i].second, end}});
  }
}

bool CurveJoiner::is_along(const Stretch& one, const Stretch& other) const {
  const FoundCurve &a = curves_[one.curve], &b = curves_[other.curve];
  return std::ranges::all_of(std::array{0.5, 0.23, 0.79}, [&](double part) {
    const gp_Pnt point = a.of.curve->Value(at(one.range, part));
    return foot_on({b.of.curve, other.range}, point).distance <= a.tolerance + b.tolerance;
  });
}

bool CurveJoiner::is_better(const Stretch& one, const Stretch& other) const {
  const FoundCurve &a = curves_[one.curve], &b = curves_[other.curve];
  if (is_spline(a) != is_spline(b)) return is_spline(b);
  return a.tolerance < b.tolerance;
}

void CurveJoiner::drop_repeats() {
  std::map<std::array<int, 2>, std::vector<Stretch*>> kept;
  for (Stretch& each : stretches_) {
    auto& between =
        kept[{std::min(each.nodes[0], each.nodes[1]), std::max(each.nodes[0], each.nodes[1])}];
    const auto same =
        std::ranges::find_if(between, [&](const Stretch* other) { return is_along(each, *other); });
    if (same == between.end()) {
      between.push_back(&each);
      continue;
    }
    (is_better(each, **same) ? **same : each).repeats = true;
    if ((*same)->repeats) *same = &each;
  }
  std::erase_if(stretches_, [](const Stretch& each) { return each.repeats; });
}

// Nearer pairs first. What is no longer than its faces' edges may be off stays open.
void CurveJoiner::join_lone_ends() {
  std::vector<std::vector<Stretch*>> ending(nodes_.size());
  for (Stretch& each : stretches_)
    for (const int node : each.nodes)
      if (node >= 0) ending[static_cast<std::size_t>(node)].push_back(&each);
  std::vector<std::size_t> lone;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (ending[i].size() != 1 || !(nodes_[i].stated > 0)) continue;
    lone.push_back(i);
    boxes.push_back(box_of(nodes_[i].point, nodes_[i].stated));
  }
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  const BoxTree tree(boxes);
  tree.for_each_meeting(tree, [&](int i, int j) {
    const std::size_t a = lone[static_cast<std::size_t>(i)], b = lone[static_cast<std::size_t>(j)];
    const double apart = distance(nodes_[a].point, nodes_[b].point);
    const Stretch& of = *ending[a].front();
    const bool short_of =
        &of == ending[b].front() &&
        distance(nodes_[a].point, point_at(of.curve, at(of.range, 0.5))) <= nodes_[a].stated;
    if (a < b && !short_of && apart <= nodes_[a].stated + nodes_[b].stated)
      pairs.emplace_back(apart, a, b);
  });
  std::ranges::sort(pairs);
  for (const auto& [apart, a, b] : pairs) {
    if (ending[a].empty() || ending[b].empty()) continue;
    std::ranges::replace(ending[b].front()->nodes, static_cast<int>(b), static_cast<int>(a));
    ending[a].clear();
    ending[b].clear();
  }
}

void CurveJoiner::make_nodes() {
  const BRep_Builder builder;
  for (const CurveNode& node : nodes_) {
    builder.MakeVertex(vertices_.emplace_back(), pnt(node.point), Precision::Confusion());
    at_.emplace_back();
  }
  for (std::size_t i = 0; i < stretches_.size(); ++i)
    for (const std::size_t side : {0, 1}) {
      const int node = stretches_[i].nodes[side];
      if (node < 0) continue;
      const auto place = static_cast<std::size_t>(node);
      at_[place].emplace_back(i, side);
      const double t = side == 0 ? stretches_[i].range.from : stretches_[i].range.to;
      builder.UpdateVertex(vertices_[place],
                           distance(nodes_[place].point, point_at(stretches_[i].curve, t)) +
                               curves_[stretches_[i].curve].tolerance);
    }
}

TopoDS_Edge CurveJoiner::edge_of(const Stretch& stretch) const {
  const FoundCurve& of = curves_[stretch.curve];
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, of.of.curve, std::max(Precision::Confusion(), of.tolerance));
  TopoDS_Vertex lone;
  builder.MakeVertex(lone, of.of.curve->Value(stretch.range.from), of.tolerance);
  for (const std::size_t side : {0, 1}) {
    const int node = stretch.nodes[side];
    const TopoDS_Vertex vertex = node < 0 ? lone : vertices_[static_cast<std::size_t>(node)];
    builder.Add(edge, TopoDS_Vertex(vertex).Oriented(side == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
  }
  builder.Range(edge, stretch.range.from, stretch.range.to);
  return edge;
}

// The end of the stretch that alone goes on from an end of another one.
std::optional<std::pair<std::size_t, std::size_t>> CurveJoiner::next(std::size_t stretch,
                                                                     std::size_t side) const {
  const int node = stretches_[stretch].nodes[side];
  if (node < 0) return {};
  const auto& here = at_[static_cast<std::size_t>(node)];
  if (here.size() != 2) return {};
  return here[0] == std::pair(stretch, side) ? here[1] : here[0];
}

TopoDS_Wire CurveJoiner::wire_from(std::size_t start, std::size_t side,
                                   std::vector<bool>& used) const {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  std::optional at{std::pair(start, side)};
  while (at && !used[at->first]) {
    used[at->first] = true;
    builder.Add(wire, edge_of(stretches_[at->first])
                          .Oriented(at->second == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
    at = next(at->first, 1 - at->second);
  }
  const std::array<int, 2>& nodes = stretches_[start].nodes;
  wire.Closed(at.has_value() || nodes[0] == nodes[1]);
  return wire;
}

bool CurveJoiner::is_passed(const FoundPoint& point) const {
  bool passed = false;
  tree_.for_each_near(point.point, point.reach * point.reach, [&](int i) {
    const FoundCurve& curve = curves_[static_cast<std::size_t>(i)];
    passed =
        passed || foot_on(curve.of, pnt(point.point)).distance <= point.reach + curve.tolerance;
    return point.reach * point.reach;
  });
  return passed;
}

TopoDS_Compound CurveJoiner::made() const {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  std::vector<bool> used(stretches_.size(), false);
  // First from where nothing leads on; what is left then is closed.
  for (const bool open : {true, false})
    for (std::size_t i = 0; i < stretches_.size(); ++i)
      for (const std::size_t side : {0, 1})
        if (!used[i] && (!open || !next(i, side)) && (!open || stretches_[i].nodes[0] >= 0))
          builder.Add(all, wire_from(i, side, used));
  std::vector<FoundPoint> lone;
  for (const FoundPoint& point : points_) {
    const bool repeats = std::ranges::any_of(lone, [&](const FoundPoint& other) {
      return distance(point.point, other.point) <= point.reach + other.reach;
    });
    if (repeats || is_passed(point)) continue;
    lone.push_back(point);
    TopoDS_Vertex vertex;
    builder.MakeVertex(vertex, pnt(point.point), Precision::Confusion());
    builder.Add(all, vertex);
  }
  return all;
}

}  // namespace

TopoDS_Compound joined_curves(const std::vector<FoundCurve>& curves,
                              const std::vector<FoundPoint>& points) {
  return CurveJoiner(curves, points).run();
}

}  // namespace blossom::occt
