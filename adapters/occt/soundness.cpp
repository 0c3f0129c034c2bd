// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/soundness.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <sstream>

#include <BRepCheck.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListIteratorOfListOfStatus.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepCheck_Solid.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/repair/edge_gaps.h"

namespace blossom::occt {
namespace {

// What rounding of coordinates may add to a gap, relative to the tolerance.
constexpr double kRounding = 1e-6;

bool exceeds(double gap, double tolerance) { return gap > (1 + kRounding) * tolerance; }

void add_statuses(const BRepCheck_ListOfStatus& statuses, std::vector<std::string>& problems) {
  for (BRepCheck_ListIteratorOfListOfStatus it(statuses); it.More(); it.Next()) {
    if (it.Value() == BRepCheck_NoError) continue;
    std::ostringstream text;
    BRepCheck::Print(it.Value(), text);
    std::string word = text.str();
    while (!word.empty() && (word.back() == '\n' || word.back() == ' ')) word.pop_back();
    if (std::find(problems.begin(), problems.end(), word) == problems.end())
      problems.push_back(word);
  }
}

void add_result(const Handle(BRepCheck_Result) & result, std::vector<std::string>& problems) {
  if (result.IsNull()) return;
  add_statuses(result->Status(), problems);
  for (result->InitContextIterator(); result->MoreShapeInContext(); result->NextShapeInContext())
    add_statuses(result->StatusOnShape(), problems);
}

// How often the faces of one shell use each edge, by number.
using Uses = std::map<int, int>;

struct Numbers {
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;
};

Uses uses_in(const TopTools_MapOfShape& faces, const Numbers& numbers) {
  Uses uses;
  for (TopTools_MapOfShape::Iterator face(faces); face.More(); face.Next())
    for (TopExp_Explorer it(face.Value(), TopAbs_EDGE); it.More(); it.Next())
      if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
        ++uses[numbers.edges.FindIndex(it.Current())];
  return uses;
}

TopTools_MapOfShape faces_in(const TopoDS_Shape& shape, TopAbs_ShapeEnum avoid = TopAbs_SHAPE) {
  TopTools_MapOfShape faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE, avoid); it.More(); it.Next()) faces.Add(it.Current());
  return faces;
}

void mark_uses(const Uses& uses, bool closed, std::vector<EdgeSoundness>& edges) {
  for (const auto& [number, count] : uses) {
    EdgeSoundness& edge = edges[static_cast<std::size_t>(number) - 1];
    if (count == 1) {
      edge.free = true;
      if (closed) edge.problems.push_back({"is free, the solid is open there"});
    } else if (count > 2) {
      edge.crowded = true;
      edge.problems.push_back({"is used " + std::to_string(count) + " times in one shell"});
    }
  }
}

void mark_all_uses(const TopoDS_Shape& shape, const Numbers& numbers,
                   std::vector<EdgeSoundness>& edges) {
  TopTools_IndexedMapOfShape shells, in_solids;
  TopExp::MapShapes(shape, TopAbs_SHELL, shells);
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    TopExp::MapShapes(solid.Current(), TopAbs_SHELL, in_solids);
  for (int i = 1; i <= shells.Extent(); ++i)
    mark_uses(uses_in(faces_in(shells(i)), numbers), in_solids.Contains(shells(i)), edges);
  mark_uses(uses_in(faces_in(shape, TopAbs_SHELL), numbers), false, edges);
}

void add_gaps(const EdgeGaps& found, EdgeSoundness& edge) {
  edge.gap = std::max(edge.gap, found.gap);
  edge.same_parameter = std::max(edge.same_parameter, found.same_parameter);
  if (edge.vertex_tolerance == 0 ||
      found.vertex_gap * edge.vertex_tolerance > edge.vertex_gap * found.vertex_tolerance) {
    edge.vertex_gap = found.vertex_gap;
    edge.vertex_tolerance = found.vertex_tolerance;
  }
  const auto add = [&](const std::string& what) {
    if (std::none_of(edge.problems.begin(), edge.problems.end(),
                     [&](const Problem& known) { return known.what == what; }))
      edge.problems.push_back({what});
  };
  if (!found.has_curve) add("has no curve in space");
  if (!found.has_pcurve) add("has no parametric curve on a face");
}

void judge(EdgeSoundness& edge) {
  const auto compare = [&](const std::string& what, double gap, double tolerance) {
    if (exceeds(gap, tolerance)) edge.problems.push_back({what, std::nullopt, gap, tolerance});
  };
  compare("its curves are apart", edge.gap, edge.tolerance);
  if (BRep_Tool::SameParameter(edge.edge) && !exceeds(edge.gap, edge.tolerance))
    compare("its curves are apart at the same parameter", edge.same_parameter, edge.tolerance);
  compare("it misses a vertex", edge.vertex_gap, edge.vertex_tolerance);
}

std::vector<std::string> body_problems(const TopoDS_Shape& shape) {
  std::vector<std::string> problems;
  const auto add = [&](const std::string& name, const Handle(BRepCheck_Result) & result) {
    std::vector<std::string> found;
    add_result(result, found);
    for (const std::string& each : found) problems.push_back(name + ": " + each);
  };
  TopTools_IndexedMapOfShape shells, solids;
  TopExp::MapShapes(shape, TopAbs_SHELL, shells);
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  for (int i = 1; i <= shells.Extent(); ++i) {
    const Handle(BRepCheck_Shell) check = new BRepCheck_Shell(TopoDS::Shell(shells(i)));
    check->Orientation(Standard_True);
    add("shell " + std::to_string(i), check);
  }
  for (int i = 1; i <= solids.Extent(); ++i) {
    const std::string name = "solid " + std::to_string(i);
    if (!TopExp_Explorer(solids(i), TopAbs_FACE).More()) {
      problems.push_back(name + ": has no faces");
      continue;
    }
    add(name, new BRepCheck_Solid(TopoDS::Solid(solids(i))));
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solids(i), properties);
    if (!(properties.Mass() > 0))
      problems.push_back(name + ": is turned inside out, or no numbers");
  }
  return problems;
}

FaceSoundness looked_at(int number, const Numbers& numbers, std::vector<EdgeSoundness>& edges) {
  const TopoDS_Face face = TopoDS::Face(numbers.faces(number));
  FaceSoundness found{number, {}, {}};
  for (const std::string& what : face_problems(face)) found.problems.push_back({what});
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const int edge = numbers.edges.FindIndex(it.Current());
    EdgeSoundness& of = edges[static_cast<std::size_t>(edge) - 1];
    of.faces.push_back(number);
    if (std::find(found.edges.begin(), found.edges.end(), edge) == found.edges.end())
      found.edges.push_back(edge);
    guarded("measuring an edge",
            [&] { add_gaps(edge_gaps(TopoDS::Edge(it.Current()), face), of); });
  }
  if (found.problems.empty())
    guarded("checking wires", [&] { found.problems = wire_problems(face); });
  return found;
}

Soundness looked_at(const TopoDS_Shape& shape, const std::vector<int>& faces) {
  Numbers numbers;
  TopExp::MapShapes(shape, TopAbs_FACE, numbers.faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, numbers.edges);
  std::vector<EdgeSoundness> edges;
  for (int i = 1; i <= numbers.edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(numbers.edges(i));
    EdgeSoundness& of = edges.emplace_back();
    of.number = i;
    of.edge = edge;
    of.tolerance = BRep_Tool::Tolerance(edge);
  }
  Soundness result;
  for (const int number : faces) result.faces.push_back(looked_at(number, numbers, edges));
  mark_all_uses(shape, numbers, edges);
  for (EdgeSoundness& edge : edges)
    if (!edge.faces.empty()) {
      judge(edge);
      result.edges.push_back(std::move(edge));
    }
  return result;
}

}  // namespace

std::string Problem::figure() const {
  std::ostringstream text;
  if (place) text << " at (" << (*place)[0] << ", " << (*place)[1] << ", " << (*place)[2] << ")";
  if (gap > 0) text << " by " << gap << ", more than the tolerance " << tolerance;
  return text.str();
}

std::vector<std::string> face_problems(const TopoDS_Face& face) {
  // Open CASCADE's checker does not look for numbers that are none, and can loop on them.
  try {
    guarded("converting the face", [&] { bezier_surface(face); });
  } catch (const std::runtime_error& error) {
    return {error.what()};
  }
  std::vector<std::string> problems;
  guarded("checking the face", [&] {
    const BRepCheck_Analyzer analyzer(face);
    if (analyzer.IsValid()) return;
    for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_WIRE, TopAbs_EDGE, TopAbs_VERTEX}) {
      TopTools_IndexedMapOfShape shapes;
      TopExp::MapShapes(face, kind, shapes);
      for (int i = 1; i <= shapes.Extent(); ++i) add_result(analyzer.Result(shapes(i)), problems);
    }
    if (problems.empty()) problems.push_back("BRepCheck finds an edge that does not fit the face");
  });
  return problems;
}

Soundness soundness(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<int> all(static_cast<std::size_t>(faces.Extent()));
  std::iota(all.begin(), all.end(), 1);
  Soundness result = looked_at(shape, all);
  guarded("checking shells and solids", [&] { result.problems = body_problems(shape); });
  return result;
}

Soundness soundness(const TopoDS_Shape& shape, const std::vector<int>& faces) {
  return looked_at(shape, faces);
}

}  // namespace blossom::occt
