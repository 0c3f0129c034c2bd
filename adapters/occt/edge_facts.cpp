// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/edge_facts.h"

#include <string>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/convert/curves.h"

namespace blossom::occt {
namespace {

EdgeKind kind_of(const BodyEdges& body, EdgeFacts& facts) {
  if (BRep_Tool::Degenerated(facts.edge)) return EdgeKind::Degenerate;
  if (facts.faces.size() < 2) return EdgeKind::Open;
  if (facts.faces.size() > 2) return EdgeKind::Crowded;
  if (facts.faces.front() == facts.faces.back()) return EdgeKind::Seam;
  try {
    return edge_kind(body, facts.number, facts.angle);
  } catch (const BadModel&) {
    return EdgeKind::Crowded;  // both faces use it in one direction, or a wire is open
  }
}

/// Of an edge that is a point.
Vec3 place_of(const TopoDS_Edge& edge) {
  const TopExp_Explorer vertex(edge, TopAbs_VERTEX);
  if (!vertex.More()) return {};
  const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
  return {p.X(), p.Y(), p.Z()};
}

}  // namespace

const char* to_string(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::Convex: return "convex";
    case EdgeKind::Concave: return "concave";
    case EdgeKind::Smooth: return "smooth";
    case EdgeKind::Mixed: return "mixed";
    case EdgeKind::Seam: return "seam";
    case EdgeKind::Open: return "open";
    case EdgeKind::Crowded: return "crowded";
    case EdgeKind::Degenerate: break;
  }
  return "point";
}

std::vector<EdgeFacts> edge_facts(const TopoDS_Shape& shape) {
  const BodyEdges body(shape);
  std::vector<EdgeFacts> all;
  for (int number = 1; number <= body.edge_count(); ++number) {
    EdgeFacts facts;
    facts.number = number;
    facts.edge = body.edge(number);
    all.push_back(std::move(facts));
  }
  for (int face = 1; face <= body.face_count(); ++face)
    for (TopExp_Explorer it(body.face(face), TopAbs_EDGE); it.More(); it.Next())
      all[static_cast<std::size_t>(body.number(TopoDS::Edge(it.Current()))) - 1].faces.push_back(
          face);
  for (EdgeFacts& facts : all) {
    facts.kind = kind_of(body, facts);
    BRep_Tool::Range(facts.edge, facts.from, facts.to);
    if (facts.kind == EdgeKind::Degenerate) {
      facts.middle = place_of(facts.edge);
      continue;
    }
    guarded("measuring edge " + std::to_string(facts.number), [&] {
      const BRepAdaptor_Curve curve(facts.edge);
      facts.length = edge_length(facts.edge);
      const gp_Pnt p = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
      facts.middle = {p.X(), p.Y(), p.Z()};
    });
  }
  return all;
}

}  // namespace blossom::occt
