// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/soundness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>

#include <BRepCheck_Shell.hxx>
#include <BRepCheck_Solid.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/base/check_words.h"
#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/repair/edge_gaps.h"

namespace blossom::occt {
namespace {

// What rounding of coordinates may add to a gap, relative to the tolerance.
constexpr double kRounding = 1e-6;

bool exceeds(double gap, double tolerance) { return gap > (1 + kRounding) * tolerance; }

// How often the faces of one shell use an edge, along it and against it.
struct Uses {
  int along = 0;
  int against = 0;
};
using UsesByNumber = std::map<int, Uses>;

struct Numbers {
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;
};

UsesByNumber uses_in(const TopTools_MapOfShape& faces, const Numbers& numbers) {
  UsesByNumber all;
  for (TopTools_MapOfShape::Iterator face(faces); face.More(); face.Next())
    for (TopExp_Explorer it(face.Value(), TopAbs_EDGE); it.More(); it.Next()) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
      Uses& uses = all[numbers.edges.FindIndex(it.Current())];
      ++(it.Current().Orientation() == TopAbs_REVERSED ? uses.against : uses.along);
    }
  return all;
}

TopTools_MapOfShape faces_in(const TopoDS_Shape& shape, TopAbs_ShapeEnum avoid = TopAbs_SHAPE) {
  TopTools_MapOfShape faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE, avoid); it.More(); it.Next()) faces.Add(it.Current());
  return faces;
}

// A solid may touch itself along an edge: its faces then use it as often along as against.
void mark_uses(const UsesByNumber& all, bool closed, std::vector<EdgeSoundness>& edges) {
  for (const auto& [number, uses] : all) {
    const int count = uses.along + uses.against;
    EdgeSoundness& edge = edges[static_cast<std::size_t>(number) - 1];
    if (count == 1) {
      edge.free = true;
      if (closed) edge.problems.push_back({"is free, the solid is open there"});
    } else if (count > 2) {
      edge.crowded = true;
      if (closed && uses.along == uses.against) continue;
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

void check_shell(const TopoDS_Shell& shell, std::vector<std::string>& found) {
  const Handle(BRepCheck_Shell) check = new BRepCheck_Shell(shell);
  check->Orientation(Standard_True);
  add_words_of(check, TopAbs_SHELL, found);
}

// So far the volume of a solid is not known, since its edges may be off their curves.
double volume_error(const TopoDS_Solid& solid) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(solid, properties);
  return largest_edge_tolerance(solid) * std::abs(properties.Mass());
}

// What cannot be measured has problems of its own.
void add_volume_problem(const TopoDS_Solid& solid, std::vector<std::string>& found) try {
  const TopExp_Explorer first(solid, TopAbs_VERTEX);
  if (!first.More()) return;
  const Vec3 apex = vec(BRep_Tool::Pnt(TopoDS::Vertex(first.Current())));
  const TopTools_MapOfShape faces = faces_in(solid);
  const double error = volume_error(solid);
  double volume = 0;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    volume += cone_volume(TopoDS::Face(it.Current()), apex, error / faces.Extent());
  if (volume > 0) return;
  found.emplace_back(volume < -error ? "is turned inside out" : "encloses no volume");
} catch (const BadModel&) {
}

void check_solid(const TopoDS_Solid& solid, std::vector<std::string>& found) {
  if (!TopExp_Explorer(solid, TopAbs_FACE).More()) {
    found.emplace_back("has no faces");
    return;
  }
  add_words_of(new BRepCheck_Solid(solid), TopAbs_SOLID, found);
  add_volume_problem(solid, found);
}

// What cannot be checked is a finding, so that the rest of the shape is still looked at.
template <class Finding, class Check>
void add_findings(const char* otherwise, std::vector<Finding>& found, const Check& check) try {
  guarded(otherwise, check);
} catch (const Failure& failure) {
  found.push_back({failure.what()});
}

std::vector<std::string> body_problems(const TopoDS_Shape& shape, const CheckRunner& run) {
  std::vector<std::string> problems;
  const auto look_at_all = [&](const std::string& noun, TopAbs_ShapeEnum kind, const auto& check) {
    TopTools_IndexedMapOfShape bodies;
    TopExp::MapShapes(shape, kind, bodies);
    for (int i = 1; i <= bodies.Extent(); ++i) {
      const std::string name = noun + " " + std::to_string(i);
      std::vector<std::string> found;
      const auto look = [&] { check(bodies(i), found); };
      if (!run("checking " + name, [&] { add_findings("it cannot be checked", found, look); }))
        found = {kUnchecked};
      for (const std::string& each : found) problems.push_back(name + ": " + each);
    }
  };
  look_at_all("shell", TopAbs_SHELL, [](const TopoDS_Shape& shell, auto& found) {
    check_shell(TopoDS::Shell(shell), found);
  });
  look_at_all("solid", TopAbs_SOLID, [](const TopoDS_Shape& solid, auto& found) {
    check_solid(TopoDS::Solid(solid), found);
  });
  return problems;
}

void measure(const TopoDS_Edge& edge, const TopoDS_Face& face, EdgeSoundness& of) {
  add_findings("it cannot be measured", of.problems, [&] { add_gaps(edge_gaps(edge, face), of); });
}

std::vector<Problem> problems_of_wires(const TopoDS_Face& face) {
  std::vector<Problem> found;
  add_findings("its wires cannot be checked", found, [&] { found = wire_problems(face); });
  return found;
}

FaceSoundness looked_at(int number, const std::vector<std::string>& problems,
                        const Numbers& numbers, std::vector<EdgeSoundness>& edges) {
  const TopoDS_Face face = TopoDS::Face(numbers.faces(number));
  FaceSoundness found{number, {}, {}};
  for (const std::string& what : problems) found.problems.push_back({what});
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const int edge = numbers.edges.FindIndex(it.Current());
    EdgeSoundness& of = edges[static_cast<std::size_t>(edge) - 1];
    of.faces.push_back(number);
    if (std::find(found.edges.begin(), found.edges.end(), edge) == found.edges.end())
      found.edges.push_back(edge);
    measure(TopoDS::Edge(it.Current()), face, of);
  }
  if (found.problems.empty()) found.problems = problems_of_wires(face);
  return found;
}

std::vector<EdgeSoundness> stated(const TopTools_IndexedMapOfShape& edges) {
  std::vector<EdgeSoundness> all;
  for (int i = 1; i <= edges.Extent(); ++i) {
    EdgeSoundness& edge = all.emplace_back();
    edge.number = i;
    edge.edge = TopoDS::Edge(edges(i));
    edge.tolerance = BRep_Tool::Tolerance(edge.edge);
  }
  return all;
}

Soundness looked_at(const TopoDS_Shape& shape, const std::vector<int>& wanted,
                    const CheckRunner& run) {
  Numbers numbers;
  TopExp::MapShapes(shape, TopAbs_FACE, numbers.faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, numbers.edges);
  std::vector<TopoDS_Face> faces;
  for (const int number : wanted) faces.push_back(TopoDS::Face(numbers.faces(number)));
  const std::vector<std::vector<std::string>> problems = face_problems(faces, wanted, run);
  std::vector<EdgeSoundness> edges = stated(numbers.edges);
  Soundness result;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    result.faces.push_back(looked_at(wanted[i], problems[i], numbers, edges));
  mark_all_uses(shape, numbers, edges);
  for (EdgeSoundness& edge : edges)
    if (!edge.faces.empty()) {
      judge(edge);
      result.edges.push_back(std::move(edge));
    }
  return result;
}

// The first thing that is wrong with a face or its wires.
std::optional<Problem> first_problem(const TopoDS_Face& face, const std::vector<std::string>& own) {
  if (!own.empty()) return Problem{own.front()};
  const std::vector<Problem> of_wires = problems_of_wires(face);
  if (of_wires.empty()) return std::nullopt;
  return of_wires.front();
}

const CheckRunner& known_or_direct(const CheckRunner& run) {
  static const CheckRunner kDirectly = [](const std::string&, const std::function<void()>& work) {
    work();
    return true;
  };
  return run ? run : kDirectly;
}

}  // namespace

std::string Problem::figure() const {
  std::ostringstream text;
  if (place) text << " at (" << (*place)[0] << ", " << (*place)[1] << ", " << (*place)[2] << ")";
  if (gap > 0) text << " by " << gap << ", more than the tolerance " << tolerance;
  return text.str();
}

Soundness soundness(const TopoDS_Shape& shape, const CheckRunner& run) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<int> all(static_cast<std::size_t>(faces.Extent()));
  std::iota(all.begin(), all.end(), 1);
  Soundness result = looked_at(shape, all, known_or_direct(run));
  result.problems = body_problems(shape, known_or_direct(run));
  return result;
}

Soundness soundness(const TopoDS_Shape& shape, const std::vector<int>& faces,
                    const CheckRunner& run) {
  return looked_at(shape, faces, known_or_direct(run));
}

std::vector<std::optional<Problem>> face_faults(const std::vector<TopoDS_Face>& faces, bool valid) {
  std::vector<int> numbers(faces.size());
  std::iota(numbers.begin(), numbers.end(), 1);
  std::vector<std::vector<std::string>> own(faces.size());
  if (!valid) own = face_problems(faces, numbers, known_or_direct({}));
  for (std::size_t i = 0; valid && i < faces.size(); ++i) own[i] = conversion_problems(faces[i]);
  std::vector<std::optional<Problem>> found;
  for (std::size_t i = 0; i < faces.size(); ++i) found.push_back(first_problem(faces[i], own[i]));
  return found;
}

}  // namespace blossom::occt
