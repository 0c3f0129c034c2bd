// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/continuity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/edge_borders.h"
#include "adapters/occt/convert/hulls.h"
#include "core/base/parallel.h"

namespace blossom::occt {
namespace {

/// How a face uses an edge, with the face oriented forward.
struct FaceUse {
  int face = 0;
  TopoDS_Edge edge;
};

struct Numbers {
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;

  TopoDS_Face face(int number) const {
    return TopoDS::Face(faces(number).Oriented(TopAbs_FORWARD));
  }
};

using Uses = std::map<int, std::vector<FaceUse>>;  // by the edge's number

void add_face(const TopoDS_Shape& face, const Numbers& numbers, Uses& uses) {
  for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next())
    uses[numbers.edges.FindIndex(it.Current())].push_back(
        {numbers.faces.FindIndex(face), TopoDS::Edge(it.Current())});
}

/// Of every shell, and of the faces outside of shells.
std::vector<Uses> all_uses(const TopoDS_Shape& shape, const Numbers& numbers) {
  std::vector<Uses> all;
  const auto add = [&](const TopoDS_Shape& of, TopAbs_ShapeEnum avoid) {
    TopTools_MapOfShape known;
    Uses uses;
    for (TopExp_Explorer it(of, TopAbs_FACE, avoid); it.More(); it.Next())
      if (known.Add(it.Current())) add_face(it.Current(), numbers, uses);
    all.push_back(std::move(uses));
  };
  TopTools_IndexedMapOfShape shells;
  TopExp::MapShapes(shape, TopAbs_SHELL, shells);
  for (int i = 1; i <= shells.Extent(); ++i) add(shells(i), TopAbs_SHAPE);
  add(shape, TopAbs_SHELL);
  return all;
}

bool is_border(const FaceUse& use) {
  return use.edge.Orientation() == TopAbs_FORWARD || use.edge.Orientation() == TopAbs_REVERSED;
}

EdgeRole kind_of(const std::vector<FaceUse>& uses) {
  if (BRep_Tool::Degenerated(uses.front().edge)) return EdgeRole::Degenerate;
  if (!std::all_of(uses.begin(), uses.end(), is_border))
    return uses.size() == 1 ? EdgeRole::Inner : EdgeRole::NonManifold;
  if (uses.size() == 1) return EdgeRole::Open;
  if (uses.size() > 2) return EdgeRole::NonManifold;
  if (uses[0].face != uses[1].face) return EdgeRole::Shared;
  return uses[0].edge.Orientation() == uses[1].edge.Orientation() ? EdgeRole::NonManifold
                                                                  : EdgeRole::Seam;
}

/// Diagonals of the faces' boxes, measured once.
class FaceSizes {
 public:
  explicit FaceSizes(const Numbers& numbers) : numbers_(numbers) {}

  double of(int face) {
    const auto [at, is_new] = sizes_.try_emplace(face, 0);
    if (is_new) {
      const Bnd_Box box = bounds_of(numbers_.faces(face));
      if (!box.IsVoid()) at->second = std::sqrt(box.SquareExtent());
    }
    return at->second;
  }

 private:
  const Numbers& numbers_;
  std::map<int, double> sizes_;
};

/// An edge with what is needed to measure it.
struct Task {
  EdgeContinuity result;
  std::vector<FaceUse> uses;
  double flat = 0;
};

std::vector<double> merged(std::vector<double> breaks, const std::vector<double>& others) {
  breaks.insert(breaks.end(), others.begin(), others.end());
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> kept{0};
  for (const double x : breaks)
    if (x > kept.back() + kSliver && x < 1 - kSliver) kept.push_back(x);
  kept.push_back(1);
  return kept;
}

void raise(double& bound, const LargestFound& found) { bound = std::max(bound, found.value); }

void bound(const EdgeBorder& a, const EdgeBorder& b, double flat, EdgeContinuity& result) {
  result.no_bounds = a.spans ? b.no_spans : a.no_spans;
  if (!a.spans || !b.spans) return;
  result.bounds = continuity_bounds(*a.spans, *b.spans, flat);
  if (!result.bounds) {
    result.no_bounds = "the parameters of its two images do not correspond";
    return;
  }
  // What was found compares nearest points, the bounds equal parameters: to rounding the same.
  raise(result.bounds->gap, result.found->gap);
  raise(result.bounds->angle, result.found->angle);
  raise(result.bounds->difference, result.found->difference);
  raise(result.bounds->curvature, result.found->curvature);
}

/// From fractions of the range to the edge's own parameter.
void give_parameters(const TopoDS_Edge& edge, MeasuredContinuity& found) {
  Interval range;
  BRep_Tool::Range(edge, range.from, range.to);
  for (LargestFound* largest : {&found.gap, &found.angle, &found.difference, &found.curvature})
    largest->parameter = at(range, largest->parameter);
}

void measure(const Task& task, const Numbers& numbers, const ContinuityTolerances& tolerances,
             EdgeContinuity& result) {
  const EdgeBorder a = edge_border(task.uses[0].edge, numbers.face(task.uses[0].face));
  const EdgeBorder b = edge_border(task.uses[1].edge, numbers.face(task.uses[1].face));
  guarded("measuring an edge", [&] {
    result.found = measured_continuity(a.sides, b.sides, merged(a.breaks, b.breaks), task.flat);
  });
  if (!std::isfinite(result.found->gap.value)) throw BadModel("a point of it is not finite");
  bound(a, b, task.flat, result);
  give_parameters(result.edge, *result.found);
  result.smoothness = smoothness(*result.found, tolerances);
  result.proven = result.bounds && is_proven(result.smoothness, *result.bounds, tolerances);
}

void run(const Task& task, const Numbers& numbers, const ContinuityTolerances& tolerances,
         EdgeContinuity& result) {
  try {
    measure(task, numbers, tolerances, result);
  } catch (const std::runtime_error& error) {
    result.found.reset();
    result.bounds.reset();
    result.problem = error.what();
  } catch (const std::invalid_argument& error) {
    result.found.reset();
    result.bounds.reset();
    result.problem = error.what();
  }
}

bool are_chosen(const std::vector<FaceUse>& uses, const std::vector<int>& faces) {
  return faces.empty() || std::all_of(uses.begin(), uses.end(), [&](const FaceUse& use) {
           return std::find(faces.begin(), faces.end(), use.face) != faces.end();
         });
}

Task task_of(int number, const std::vector<FaceUse>& uses, const Numbers& numbers,
             FaceSizes& sizes) {
  Task task;
  task.uses = uses;
  task.result.number = number;
  task.result.edge = TopoDS::Edge(numbers.edges(number));
  task.result.kind = kind_of(uses);
  double size = 0;
  for (const FaceUse& use : uses) {
    task.result.faces.push_back(use.face);
    size = std::max(size, sizes.of(use.face));
  }
  task.flat = size > 0 && std::isfinite(size) ? 1 / (kFlatSizes * size) : 1;
  return task;
}

std::vector<Task> tasks_of(const TopoDS_Shape& shape, const Numbers& numbers,
                           const std::vector<int>& faces) {
  FaceSizes sizes(numbers);
  std::vector<Task> tasks;
  for (const Uses& uses : all_uses(shape, numbers))
    for (const auto& [number, of_edge] : uses)
      if (are_chosen(of_edge, faces)) tasks.push_back(task_of(number, of_edge, numbers, sizes));
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return a.result.number < b.result.number; });
  return tasks;
}

}  // namespace

const char* to_string(EdgeRole kind) {
  switch (kind) {
    case EdgeRole::Shared: return "shared";
    case EdgeRole::Seam: return "seam";
    case EdgeRole::Open: return "open";
    case EdgeRole::NonManifold: return "non-manifold";
    case EdgeRole::Degenerate: return "degenerate";
    case EdgeRole::Inner: break;
  }
  return "inner";
}

std::vector<EdgeContinuity> edge_continuity(const TopoDS_Shape& shape,
                                            const ContinuityOptions& options) {
  Numbers numbers;
  TopExp::MapShapes(shape, TopAbs_FACE, numbers.faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, numbers.edges);
  const std::vector<Task> tasks = guarded("looking for edges that faces share",
                                          [&] { return tasks_of(shape, numbers, options.faces); });
  std::vector<EdgeContinuity> results;
  for (const Task& task : tasks) results.push_back(task.result);
  parallel_for(tasks.size(), 1, [&](std::size_t i) {
    options.tick();
    if (tasks[i].result.kind == EdgeRole::Shared || tasks[i].result.kind == EdgeRole::Seam)
      run(tasks[i], numbers, options.tolerances, results[i]);
  });
  return results;
}

}  // namespace blossom::occt
