// SPDX-License-Identifier: LGPL-2.1-or-later
// What edges that are inputs by themselves, and the edges of wires, have in common with the other
// input.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Edge.hxx>

#include "adapters/occt/edge_intersection.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// The edges of an input that are intersected as such: those that it names, or those of a model
/// without faces.
std::vector<TopoDS_Edge> edges_to_intersect(const Input& input);

/// The numbers of edges without faces that an input has beside these.
std::vector<int> edges_left_out(const Input& input);

struct EdgesOf {
  std::vector<TopoDS_Edge> edges{};
  occt::EdgeIntersection met{};
};

/// Edges of a with all of b, and edges of b with the faces of a.
struct EdgeFindings {
  EdgesOf a, b;

  std::size_t points() const { return a.met.points.size() + b.met.points.size(); }
  std::size_t stretches() const { return a.met.stretches.size() + b.met.stretches.size(); }
  double length() const;  ///< of all stretches, model units
};

/// throws   BadModel as occt::intersect_edges
EdgeFindings edge_findings(const Input& a, const Input& b, const IntersectionOptions& options);

/// Takes what is not proven of the edges into the status and the reasons of the faces.
void add_status(const EdgeFindings& edges, occt::ShapeIntersection& found);

/// Adds points and stretches to the wires of the faces.
/// throws   occt::Failure as occt::joined_edges
void add_edges(const EdgeFindings& edges, occt::JoinedIntersection& joined);

/// Where an edge meets the other input: numbers, and words of the inputs ("edge 3", "face 5
/// (Block)").
struct EdgeMeeting {
  Vec3 point{};       ///< or where the stretch begins
  Vec3 end{};         ///< likewise ends
  double length = 0;  ///< of a stretch
  Interval range{};   ///< of the edge's parameter; of a point it has no length
  Json on_a, on_b;    ///< {"kind": "edge", "number": 3}
  std::string of_a{}, of_b{};
};
struct EdgeMeetingLists {
  std::vector<EdgeMeeting> points, stretches;
};
EdgeMeetingLists meetings_of(const EdgeFindings& edges, const Input& a, const Input& b);

/// `edge_points` and `edge_stretches` of the report; see plugin/cli/schemas/intersection-1.md.
void add_edge_findings(const EdgeFindings& edges, const Input& a, const Input& b, Json& report);

}  // namespace blossom::reports
