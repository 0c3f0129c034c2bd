// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/edge_tolerances.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/repair/edge_gaps.h"
#include "core/base/sampled_margin.h"

namespace blossom::occt {
namespace {

// Of the least tolerance: between samples gaps are not so much larger that it would not cover them.
constexpr double kMinGap = 0.25;
constexpr double kExcess = 10;  // a tolerance this many times as large as it has to be is lowered

// An edge or vertex that states another tolerance than it needs.
struct Wrong {
  TopoDS_Shape part;
  NeededTolerance tolerance;
};

struct WrongTolerances {
  std::vector<Wrong> edges, vertices;

  bool empty() const { return edges.empty() && vertices.empty(); }
};

bool is_wrong(const NeededTolerance& tolerance) {
  return tolerance.is_too_small() || tolerance.is_far_too_large();
}

bool is_end(const TopoDS_Shape& vertex) {
  return vertex.Orientation() == TopAbs_FORWARD || vertex.Orientation() == TopAbs_REVERSED;
}

WrongTolerances wrong_tolerances(const TopoDS_Shape& shape, const WorkLimit& limit) {
  const SharedParts parts(shape);
  NeededTolerances needs(parts, [&limit] { check_limit(&limit, "measuring tolerances"); });
  WrongTolerances found;
  const auto add = [&](const auto& part, std::vector<Wrong>& all) {
    if (const NeededTolerance& tolerance = needs.of(part); is_wrong(tolerance))
      all.push_back({part, tolerance});
  };
  for (int i = 1; i <= parts.faces_of_edges.Extent(); ++i)
    add(TopoDS::Edge(parts.faces_of_edges.FindKey(i)), found.edges);
  for (int i = 1; i <= parts.edges_of_vertices.Extent(); ++i)
    add(TopoDS::Vertex(parts.edges_of_vertices.FindKey(i)), found.vertices);
  return found;
}

// A copy with the tolerances.
class Copy {
 public:
  Copy(const TopoDS_Shape& shape, const WrongTolerances& wrong) : copy_(shape, Standard_False) {
    for (const Wrong& each : wrong.edges) set<BRep_TEdge>(each);
    for (const Wrong& each : wrong.vertices) set<BRep_TVertex>(each);
  }

  TopoDS_Shape of(const TopoDS_Shape& part) {
    return copy_.ModifiedShape(part).Oriented(part.Orientation());
  }

 private:
  template <class Data>
  void set(const Wrong& each) {
    Handle(Data)::DownCast(copy_.ModifiedShape(each.part).TShape())
        ->Tolerance(each.tolerance.needed);
  }

  BRepBuilderAPI_Copy copy_;
};

std::string words_about(const WrongTolerances& wrong) {
  int raised = 0, lowered = 0;
  double most = 0, least = 0;
  for (const auto& [part, tolerance] : wrong.edges) {
    if (tolerance.is_too_small()) {
      ++raised;
      most = std::max(most, tolerance.gap);
    } else {
      ++lowered;
      least = std::max(least, tolerance.given);
    }
  }
  std::ostringstream words;
  if (raised > 0)
    words << "the curves of " << raised << " edges are up to " << most
          << " apart, more than their tolerances say";
  if (lowered > 0)
    words << (raised > 0 ? "; " : "") << lowered << " edges state tolerances up to " << least
          << ", more than ten times what they need";
  if (words.str().empty()) words << wrong.vertices.size() << " vertices state wrong tolerances";
  return words.str() + "; true ones are used";
}

}  // namespace

double needed_tolerance(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
  double largest = 0;
  if (BRep_Tool::Degenerated(edge)) {
    for (const TopoDS_Shape& face : faces)
      largest = std::max(largest, edge_gaps(edge, TopoDS::Face(face)).gap);
    return std::max(BRep_Tool::Tolerance(edge), kSampledMargin * largest);
  }
  for (const TopoDS_Shape& each : faces) {
    const TopoDS_Face face = TopoDS::Face(each);
    const bool is_seam = BRep_Tool::IsClosed(edge, face);
    for (const bool second : {false, true}) {
      if (second && !is_seam) continue;
      const auto gap = same_parameter_gap(second ? TopoDS::Edge(edge.Reversed()) : edge, face,
                                          kMinGap * Precision::Confusion());
      if (!gap) return BRep_Tool::Tolerance(edge);
      largest = std::max(largest, *gap);
    }
  }
  return std::max(Precision::Confusion(), kSampledMargin * largest);
}

double distance_at(const TopoDS_Vertex& vertex, const TopoDS_Edge& edge,
                   const TopTools_ListOfShape& faces) {
  const double end = BRep_Tool::Parameter(vertex, edge);
  const gp_Pnt point = BRep_Tool::Pnt(vertex);
  double largest = 0;
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (!curve.IsNull()) largest = point.Distance(curve->Value(end));
  for (const TopoDS_Shape& each : faces) {
    const TopoDS_Face face = TopoDS::Face(each);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    const bool is_seam = BRep_Tool::IsClosed(edge, face);
    for (const TopAbs_Orientation side : {TopAbs_FORWARD, TopAbs_REVERSED}) {
      if (side == TopAbs_REVERSED && !is_seam) continue;
      const Handle(Geom2d_Curve) chart =
          chart_curve_of(TopoDS::Edge(edge.Oriented(side)), face, range);
      if (chart.IsNull()) continue;
      const gp_Pnt2d uv = chart->Value(end);
      largest = std::max(largest, point.Distance(surface->Value(uv.X(), uv.Y())));
    }
  }
  return largest;
}

bool NeededTolerance::is_too_small() const {
  return std::isfinite(needed) && gap > std::max(given, Precision::Confusion());
}

bool NeededTolerance::is_far_too_large() const {
  return std::isfinite(needed) && given > kExcess * needed;
}

const NeededTolerance& NeededTolerances::of(const TopoDS_Edge& edge) {
  if (const NeededTolerance* known = known_.Seek(edge)) return *known;
  if (stop_) stop_();
  const double needed = needed_tolerance(edge, parts_.faces_of_edges.FindFromKey(edge));
  return *known_.Bound(edge, {BRep_Tool::Tolerance(edge), needed, needed / kSampledMargin});
}

const NeededTolerance& NeededTolerances::of(const TopoDS_Vertex& vertex) {
  if (const NeededTolerance* known = known_.Seek(vertex)) return *known;
  const NeededTolerance made = measured(vertex);
  return *known_.Bound(vertex, made);
}

NeededTolerance NeededTolerances::measured(const TopoDS_Vertex& vertex) {
  double of_edges = Precision::Confusion(), distance = 0;
  for (const TopoDS_Shape& each : parts_.edges_of_vertices.FindFromKey(vertex)) {
    const TopoDS_Edge edge = TopoDS::Edge(each);
    const NeededTolerance& own = of(edge);
    of_edges = std::max(of_edges, is_wrong(own) ? own.needed : own.given);
    for (TopoDS_Iterator end(edge.Oriented(TopAbs_FORWARD)); end.More(); end.Next())
      if (end.Value().IsSame(vertex) && is_end(end.Value()))
        distance = std::max(distance, distance_at(TopoDS::Vertex(end.Value()), edge,
                                                  parts_.faces_of_edges.FindFromKey(edge)));
  }
  return {BRep_Tool::Tolerance(vertex), std::max(of_edges, kSampledMargin * distance),
          std::max(of_edges, distance)};
}

TrueSolid with_true_tolerances(const TrimTool& solid, const WorkLimit& limit) {
  return guarded("measuring tolerances", [&]() -> TrueSolid {
    const TopoDS_Compound shape = compound_of(solid.solids);
    const WrongTolerances wrong = wrong_tolerances(shape, limit);
    if (wrong.empty()) return {solid, {}};
    Copy copy(shape, wrong);
    TrueSolid made{{}, words_about(wrong)};
    for (const TopoDS_Face& face : solid.faces)
      made.solid.faces.push_back(TopoDS::Face(copy.of(face)));
    for (const TopoDS_Solid& each : solid.solids)
      made.solid.solids.push_back(TopoDS::Solid(copy.of(each)));
    return made;
  });
}

}  // namespace blossom::occt
