// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/shapes/edge_tolerances.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <NCollection_DataMap.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/compounds.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/faces/shared_limit.h"
#include "adapters/occt/forms/edge_charts.h"
#include "adapters/occt/shapes/edge_gaps.h"

namespace blossom::occt {
namespace {

constexpr double kMargin = 1.1;  // of gaps, which are measured at samples
// Of the least tolerance: between samples gaps are not so much larger that it would not cover them.
constexpr double kLeastGap = 0.25;
constexpr double kExcess = 10;  // a tolerance this many times as large as it has to be is lowered

using Users = TopTools_IndexedDataMapOfShapeListOfShape;

// An edge or vertex and the tolerance that it needs.
struct Needed {
  TopoDS_Shape part;
  double given = 0;
  double needed = 0;
  double gap = 0;  // without a margin: what it cannot do without

  bool is_raised() const { return gap > std::max(given, Precision::Confusion()); }
};

// Needed tolerances that are not those given.
struct Wrong {
  std::vector<Needed> edges, vertices;

  bool empty() const { return edges.empty() && vertices.empty(); }
};

void add_if_wrong(const Needed& each, std::vector<Needed>& all) {
  if (std::isfinite(each.needed) && (each.is_raised() || each.given > kExcess * each.needed))
    all.push_back(each);
}

using EdgeNeeds = NCollection_DataMap<TopoDS_Shape, double, TopTools_ShapeMapHasher>;

bool is_end(const TopoDS_Shape& vertex) {
  return vertex.Orientation() == TopAbs_FORWARD || vertex.Orientation() == TopAbs_REVERSED;
}

// What a vertex needs: no less than its edges, whose ends it covers.
Needed needed_by(const TopoDS_Vertex& vertex, const TopTools_ListOfShape& edges,
                 const Users& faces_of, const EdgeNeeds& needs) {
  double of_edges = Precision::Confusion(), distance = 0;
  for (const TopoDS_Shape& each : edges) {
    const TopoDS_Edge edge = TopoDS::Edge(each);
    of_edges = std::max(of_edges, needs(edge));
    for (TopoDS_Iterator end(edge.Oriented(TopAbs_FORWARD)); end.More(); end.Next())
      if (end.Value().IsSame(vertex) && is_end(end.Value()))
        distance = std::max(
            distance, distance_at(TopoDS::Vertex(end.Value()), edge, faces_of.FindFromKey(edge)));
  }
  return {vertex, BRep_Tool::Tolerance(vertex), std::max(of_edges, kMargin * distance),
          std::max(of_edges, distance)};
}

// limit   null: none
Wrong wrong_tolerances(const TopoDS_Shape& shape, const WorkLimit* limit) {
  Wrong found;
  Users faces_of, edges_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  TopExp::MapShapesAndAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edges_of);
  EdgeNeeds needs;
  for (int i = 1; i <= faces_of.Extent(); ++i) {
    check_limit(limit, "measuring tolerances");
    const TopoDS_Edge edge = TopoDS::Edge(faces_of.FindKey(i));
    const double given = BRep_Tool::Tolerance(edge);
    const double needed = needed_tolerance(edge, faces_of(i));
    const Needed each{edge, given, needed, needed / kMargin};
    const std::size_t before = found.edges.size();
    add_if_wrong(each, found.edges);
    needs.Bind(edge, found.edges.size() > before ? each.needed : given);
  }
  for (int i = 1; i <= edges_of.Extent(); ++i) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(edges_of.FindKey(i));
    add_if_wrong(needed_by(vertex, edges_of(i), faces_of, needs), found.vertices);
  }
  return found;
}

template <class Data>
void set_tolerance(const TopoDS_Shape& part, double tolerance) {
  Handle(Data)::DownCast(part.TShape())->Tolerance(tolerance);
}

template <class Data>
void raise(const std::vector<Needed>& wrong, TopTools_IndexedMapOfShape& raised) {
  for (const Needed& each : wrong) {
    if (!each.is_raised()) continue;
    set_tolerance<Data>(each.part, each.needed);
    raised.Add(each.part);
  }
}

// A copy with the tolerances.
class Copy {
 public:
  Copy(const TopoDS_Shape& shape, const Wrong& wrong) : copy_(shape, Standard_False) {
    for (const Needed& each : wrong.edges) set<BRep_TEdge>(each);
    for (const Needed& each : wrong.vertices) set<BRep_TVertex>(each);
  }

  TopoDS_Shape of(const TopoDS_Shape& part) {
    return copy_.ModifiedShape(part).Oriented(part.Orientation());
  }

 private:
  template <class Data>
  void set(const Needed& each) {
    set_tolerance<Data>(copy_.ModifiedShape(each.part), each.needed);
  }

  BRepBuilderAPI_Copy copy_;
};

std::string words_about(const Wrong& wrong) {
  int raised = 0, lowered = 0;
  double most = 0, least = 0;
  for (const Needed& each : wrong.edges) {
    (each.is_raised() ? raised : lowered) += 1;
    (each.is_raised() ? most : least) =
        std::max(each.is_raised() ? most : least, each.is_raised() ? each.gap : each.given);
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
    return std::max(BRep_Tool::Tolerance(edge), kMargin * largest);
  }
  for (const TopoDS_Shape& each : faces) {
    const TopoDS_Face face = TopoDS::Face(each);
    const bool is_seam = BRep_Tool::IsClosed(edge, face);
    for (const bool second : {false, true}) {
      if (second && !is_seam) continue;
      const auto gap = same_parameter_gap(second ? TopoDS::Edge(edge.Reversed()) : edge, face,
                                          kLeastGap * Precision::Confusion());
      if (!gap) return BRep_Tool::Tolerance(edge);
      largest = std::max(largest, *gap);
    }
  }
  return std::max(Precision::Confusion(), kMargin * largest);
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

double RaisedTolerances::largest() const {
  double most = 0;
  for (int i = 1; i <= edges.Extent(); ++i)
    most = std::max(most, BRep_Tool::Tolerance(TopoDS::Edge(edges(i))));
  for (int i = 1; i <= vertices.Extent(); ++i)
    most = std::max(most, BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i))));
  return most;
}

RaisedTolerances raise_tolerances(const TopoDS_Shape& shape) {
  const Wrong wrong = wrong_tolerances(shape, nullptr);
  RaisedTolerances raised;
  raise<BRep_TEdge>(wrong.edges, raised.edges);
  raise<BRep_TVertex>(wrong.vertices, raised.vertices);
  return raised;
}

TrueSolid with_true_tolerances(const TrimTool& solid, const WorkLimit& limit) {
  return guarded("measuring tolerances", [&]() -> TrueSolid {
    const TopoDS_Compound shape = compound_of(solid.solids);
    const Wrong wrong = wrong_tolerances(shape, &limit);
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
