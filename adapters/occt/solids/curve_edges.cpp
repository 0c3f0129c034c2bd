// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/curve_edges.h"

#include <algorithm>
#include <cmath>

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "core/math/interval.h"

namespace blossom::occt {
namespace {

constexpr int kChords = 16;        // by which a curve's length is told
constexpr double kEndPart = 0.25;  // of an edge: ends so near each other may be one

// Uses along an edge have the middle half of their range.
Interval whole_range(const Interval& middle) {
  const double half = length(middle);
  return {at(middle, 0.5) - half, at(middle, 0.5) + half};
}

// The edge, turned as the curve runs along it.
TopoDS_Edge along_curve(const CutUse& use) {
  const bool walked_back = use.at.to < use.at.from;
  return TopoDS::Edge(walked_back ? use.edge.Reversed() : TopoDS_Shape(use.edge));
}

// Edges that are made one end together, but for a part of their length.
bool have_same_ends(const CurveEdge& edge, const CurveEdge& other) {
  const double most = kEndPart * length(edge.at);
  return std::abs(edge.at.from - other.at.from) <= most &&
         std::abs(edge.at.to - other.at.to) <= most;
}

const CurveEdge* counterpart(const CurveEdge& edge, const std::vector<CurveEdge>& others) {
  const auto holds_middle = [](const Interval& of, const Interval& other) {
    const double middle = at(other, 0.5);
    return of.from < middle && middle < of.to;
  };
  const auto found = std::ranges::find_if(others, [&](const CurveEdge& other) {
    return holds_middle(edge.at, other.at) && holds_middle(other.at, edge.at);
  });
  return found == others.end() ? nullptr : &*found;
}

// Joins what one side made and the other has.
bool join_made(const CurveEdges& a, const CurveEdges& b, const CommonEdges& common,
               EdgeUnion& joined) {
  return std::ranges::all_of(a.made, [&](const CurveEdge& made) {
    const CurveEdge* there = counterpart(made, b.along);
    if (counterpart(made, b.made) != nullptr || there == nullptr) return true;
    if (!have_same_ends(made, *there)) return false;
    return join_along(there->edge, made.edge, common, joined);
  });
}

// The length of a curve between two parameters, by chords.
double length_of(const Spline& curve, const Interval& range) {
  double length = 0;
  for (int i = 0; i < kChords; ++i)
    length += distance(point_at(curve, at(range, static_cast<double>(i) / kChords)),
                       point_at(curve, at(range, (i + 1.0) / kChords)));
  return length;
}

// Of the vertices at both ends, the larger one.
double end_tolerance(const TopoDS_Edge& edge) {
  double largest = 0;
  for (TopoDS_Iterator it(edge); it.More(); it.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(it.Value())));
  return largest;
}

}  // namespace

void CurveEdges::add(const CutUse& use) {
  auto& known = use.along ? along : made;
  if (std::ranges::any_of(known, [&](const auto& each) { return each.edge.IsSame(use.edge); }))
    return;
  const Interval range = increasing(use.at);
  if (use.along)
    known.push_back({whole_range(range), along_curve(use)});
  else
    known.push_back({range, use.edge});
}

bool is_matched(const CurveEdges& side, const CurveEdges& other) {
  return std::ranges::all_of(side.made, [&](const CurveEdge& edge) {
    return counterpart(edge, other.made) != nullptr || counterpart(edge, other.along) != nullptr;
  });
}

bool match(const CurveEdges& a, const CurveEdges& b) {
  return is_matched(a, b) && is_matched(b, a);
}

bool join_along(const TopoDS_Edge& other, const TopoDS_Edge& edge, const CommonEdges& common,
                EdgeUnion& joined) {
  const TopoDS_Edge first = joined.first(other);
  const bool reversed = first.Orientation() == TopAbs_REVERSED;
  const TopoDS_Edge image =
      common.image(TopoDS::Edge(first.Oriented(TopAbs_FORWARD)), edge, reversed);
  return joined.join(first, edge, image, reversed);
}

bool join_matching(const CurveEdges& a, const CurveEdges& b, const CommonEdges& common,
                   EdgeUnion& joined) {
  for (const CurveEdge& made : a.made)
    if (const CurveEdge* other = counterpart(made, b.made);
        other != nullptr && !joined.join(made.edge, other->edge) &&
        !joined.join(other->edge, made.edge))  // others run along the second one
      return false;
  return join_made(a, b, common, joined) && join_made(b, a, common, joined);
}

double longest_rest(const Spline& curve, const CurveEdges& a, const CurveEdges& b) {
  struct Covered {
    Interval at;
    double beyond;  // so far do its ends reach
  };
  std::vector<Covered> covered;
  for (const auto* edges : {&a.along, &b.along, &a.made, &b.made})
    for (const CurveEdge& edge : *edges) covered.push_back({edge.at, end_tolerance(edge.edge)});
  std::ranges::sort(covered, {}, [](const Covered& each) { return each.at.from; });
  covered.push_back({{curve.knots.back(), curve.knots.back()}, 0});
  double longest = 0, from = curve.knots.front(), beyond = 0;
  for (const Covered& each : covered) {
    const double rest = length_of(curve, {from, std::max(from, each.at.from)});
    longest = std::max(longest, rest - beyond - each.beyond);
    if (each.at.to > from) beyond = 0;
    if (each.at.to >= from) beyond = std::max(beyond, each.beyond);
    from = std::max(from, each.at.to);
  }
  return longest;
}

}  // namespace blossom::occt
