// SPDX-License-Identifier: LGPL-2.1-or-later
// The JSON report of an intersection; see plugin/cli/schemas/intersection-1.md.

#pragma once

#include <cstddef>
#include <vector>

#include <optional>

#include <TopoDS_Compound.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "plugin/reports/cuts/edge_findings.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// Seconds from two shapes in memory to finished curves.
struct RunTimes {
  double seconds = 0;  ///< the median of all calls
  double first = 0;    ///< the first call in the process
};

/// What all pieces of a curve have in common, or the worst or the sum of them.
struct ChainFacts {
  bool tangential = true;
  double length = 0;
  double least_angle = 0;
  int degree = 0;
  std::size_t poles = 0;
  Deviation deviation;
};
ChainFacts facts_of(const std::vector<IntersectionCurve>& curves, const CurveChain& chain);

/// What wires and lone vertices of a compound come to.
struct WireFacts {
  std::size_t wires = 0;
  std::size_t closed = 0;  ///< of the wires
  std::size_t edges = 0;
  std::size_t points = 0;  ///< vertices on no edge
  double length = 0;       ///< of all edges, model units
};
WireFacts facts_of(const TopoDS_Compound& wires);

/// Whether surfaces keep within tolerance of each other in a place; an overlap has an area besides.
bool is_contact(const Place& place);

/// Whether faces of one input meet: "none found", "found" or "undecided". While something is open,
/// none may be there that was not found.
const char* verdict_of(const occt::ShapeIntersection& found);

/// Pieces that other commands' reports have in common with it.
Json to_json(const Vec2& point);
Json to_json(const Vec3& point);
Json to_json(const Certificate& certificate);
Json to_json(const Place& place);

/// What a curve is over a range of its parameter; null if it is no line and no conic.
Json to_json(const std::optional<Conic>& conic, const Interval& range);

/// What was found between two inputs, or between the faces of one.
struct IntersectionFindings {
  const Input& a;
  const Input& b;
  const occt::ShapeIntersection& found;
  const occt::JoinedIntersection& joined;
  const EdgeFindings& edges;  ///< none between the faces of one
};

/// The whole object, schema "blossom.intersection/1".
Json intersection_report(const IntersectionFindings& findings, const RunTimes& times);

/// Likewise of the faces of one input with themselves, schema "blossom.self-intersection/1"; see
/// plugin/cli/schemas/self-intersection-1.md.
Json self_intersection_report(const IntersectionFindings& findings, const RunTimes& times);

}  // namespace blossom::reports
