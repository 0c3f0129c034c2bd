// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/clear_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_IntCS.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/faces/elementary_faces.h"
#include "adapters/occt/solids/free_charts.h"

namespace blossom::occt {
namespace {

using std::numbers::pi;

// The c of the header. Beside a seam that touches, at a height h, curves of intersection have a way
// of sqrt(8 h r): with c r as much as half the chord of a quarter arc, as arcs are cut.
constexpr double kClear = 1.0 / 16;
// Turns to choose from. Of n multiples of the golden angle no two are nearer than 0.38 of an even
// share: so no two of these are ruled out by one point that a seam has to keep off.
constexpr int kTurns = static_cast<int>(0.38 * pi / kClear);
// Of c r: the length of a stretch of a seam that is looked at as one. In its middle |df/ds| is less
// than c if the seam touches in it with a radius of more than half of this part of r.
constexpr double kStretch = 0.25;

// A face of the other solid that may come near, in the frame of a chart.
struct Neighbour {
  Elementary surface;
  Bnd_Box box;
};

// What there is of the other solid, in that frame.
struct Surroundings {
  std::vector<Neighbour> faces;
  std::vector<Vec3> passages;  // of its edges through faces of the chart
};

// The face in a frame, as a copy that shares its geometry.
TopoDS_Face seen_in(const gp_Ax3& frame, const TopoDS_Face& face) {
  gp_Trsf into;
  into.SetTransformation(frame);
  return TopoDS::Face(face.Moved(into, false));
}

// Whether a stretch of a seam lies in a face and crosses it. Of a seam whose surface is not
// elementary nobody knows: it then lies ill.
bool is_border(const Seam& seam, const Interval& part, const Elementary& face) {
  if (!seam.surface) return false;
  for (const double place : {part.from, at(part, 0.5), part.to})
    if (std::abs(height_over(face, vec(seam.point(place))).value) > Precision::Confusion())
      return false;
  const Vec3 point = vec(seam.point(at(part, 0.5)));
  return norm(cross(height_over(face, point).rise, height_over(*seam.surface, point).rise)) >=
         kClear;
}

// Whether some stretch of a seam between parameters lies ill. Along it f changes by no more than
// its length.
bool lies_ill(const Seam& seam, const Interval& part, double least, const Neighbour& face) {
  gp_Pnt middle;
  gp_Vec along;
  seam.curve->D1(at(part, 0.5), middle, along);
  const double reach = seam.speed * length(part) / 2;
  Bnd_Box held(middle, middle);
  held.SetGap(reach);
  const Height height = height_over(face.surface, vec(middle));
  if (face.box.IsOut(held) || std::abs(height.value) >= least + reach) return false;
  if (2 * reach <= kStretch * least)
    return std::abs(dot(height.rise, vec(along))) < kClear * seam.speed &&
           !is_border(seam, part, face.surface);
  return lies_ill(seam, {part.from, at(part, 0.5)}, least, face) ||
         lies_ill(seam, {at(part, 0.5), part.to}, least, face);
}

bool lies_ill(const Seam& seam, double least, const Vec3& passage) {
  const gp_Pnt point = pnt(passage);
  const auto [from, to] = seam.range;
  const double near = least * (1 + kStretch / 2);
  if (point.Distance(seam.point(from)) < near || point.Distance(seam.point(to)) < near) return true;
  const GeomAPI_ProjectPointOnCurve feet(point, seam.curve, from, to);
  return feet.NbPoints() > 0 && feet.LowerDistance() < near;
}

// How many ends of seams lie ill. Where one of the seams is a border the corner lies in it; poles
// are singular whatever goes through them.
int ill_ends(const std::vector<Seam>& seams, double least, const Neighbour& face) {
  const auto is_followed = [&](const Seam& seam) {
    const double step = kStretch * least / seam.speed;
    return is_border(seam, {seam.range.from, seam.range.from + step}, face.surface) ||
           is_border(seam, {seam.range.to - step, seam.range.to}, face.surface);
  };
  const bool any_followed = std::ranges::any_of(seams, is_followed);
  int count = 0;
  for (const Seam& seam : seams)
    for (const bool last : {false, true}) {
      const gp_Pnt end = seam.point(last ? seam.range.to : seam.range.from);
      count += (seam.at_pole[last] || !any_followed) && !face.box.IsOut(end) &&
               std::abs(height_over(face.surface, vec(end)).value) < least;
    }
  return count;
}

// Of ends that lie ill, and of seams; fewer is better, of ends first.
using Hazards = std::array<int, 2>;

Hazards hazards_of(const std::vector<Seam>& seams, double least, const Surroundings& near) {
  Hazards count{};
  for (const Neighbour& face : near.faces) {
    count[0] += ill_ends(seams, least, face);
    for (const Seam& seam : seams) count[1] += lies_ill(seam, seam.range, least, face);
  }
  for (const Vec3& passage : near.passages)
    for (const Seam& seam : seams) count[1] += lies_ill(seam, least, passage);
  return count;
}

// Where edges of some faces go through the faces of a chart, in its frame.
std::vector<Vec3> passages_of(const FreeChart& chart, const std::vector<TopoDS_Face>& others) {
  TopTools_IndexedMapOfShape edges;
  for (const TopoDS_Face& face : others)
    TopExp::MapShapes(seen_in(chart.frame, face), TopAbs_EDGE, edges);
  std::vector<Vec3> passages;
  for (const TopoDS_Face& face : chart.faces) {
    const TopoDS_Face seen = seen_in(chart.frame, face);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(seen);
    const Bnd_Box own = bounds_of(seen);
    for (int number = 1; number <= edges.Extent(); ++number) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges(number));
      Interval range;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
      if (curve.IsNull() || bounds_of(edge).IsOut(own)) continue;
      const GeomAPI_IntCS through(new Geom_TrimmedCurve(curve, range.from, range.to), surface);
      for (int i = 1; through.IsDone() && i <= through.NbPoints(); ++i)
        passages.push_back(vec(through.Point(i)));
    }
  }
  return passages;
}

// boxes   of the other's faces
Surroundings surroundings_of(const FreeChart& chart, const TrimTool& other,
                             const std::vector<Bnd_Box>& boxes) {
  const double least = kClear * chart.size;
  Bnd_Box own = bounds_of(compound_of(chart.faces));
  own.Enlarge(least);
  std::vector<TopoDS_Face> reached;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].IsOut(own)) reached.push_back(other.faces[i]);
  Surroundings near{{}, passages_of(chart, reached)};
  for (const TopoDS_Face& face : reached) {
    const TopoDS_Face seen = seen_in(chart.frame, face);
    const auto surface = elementary_of(BRep_Tool::Surface(seen));
    if (!surface) continue;
    near.faces.push_back({*surface, bounds_of(seen)});
    near.faces.back().box.Enlarge(least);
  }
  return near;
}

// Turns by the golden angle have no symmetry. Those of a sphere about its axis come first: circles
// round it stay lines of the chart. Then its axes follow a spiral over half of it, which spreads
// them evenly, as the corners of a torus are spread over its chart.
ChartMove move_of(ChartKind kind, int number) {
  const int turn = number % kTurns;
  const double golden = std::fmod((turn + 0.5) * pi * (3 - std::sqrt(5.0)), 2 * pi);
  const double share = (turn + 0.5) / kTurns;
  if (kind == ChartKind::Ring) return {gp::DZ(), golden, 2 * pi * share};
  if (number < kTurns) return {gp::DZ(), golden};
  return {gp_Dir(std::cos(golden), std::sin(golden), 0), std::acos(share)};
}

// Nothing if none is better than to leave the chart as it is.
std::optional<ChartMove> better_move(const FreeChart& chart, const Surroundings& near) {
  const double least = kClear * chart.size;
  Hazards best = hazards_of(chart.seams, least, near);
  std::optional<ChartMove> found;
  const int moves = chart.kind == ChartKind::Ball ? 2 * kTurns : kTurns;
  for (int number = 0; number < moves && best > Hazards{}; ++number) {
    const ChartMove move = move_of(chart.kind, number);
    const Hazards left = hazards_of(moved_seams(chart, move), least, near);
    if (left >= best) continue;
    best = left;
    found = move;
  }
  return found;
}

// Faces that are as they were moved, and still whole.
using Whole = std::vector<std::pair<TopoDS_Face, TopoDS_Face>>;

// Whether an edge that a face has got by a move bounds others as well that are not whole.
bool hangs_on(const std::pair<TopoDS_Face, TopoDS_Face>& face, const TopTools_MapOfShape& whole,
              const TopTools_IndexedDataMapOfShapeListOfShape& faces_of_edge) {
  TopTools_MapOfShape before;
  for (TopExp_Explorer it(face.second, TopAbs_EDGE); it.More(); it.Next()) before.Add(it.Current());
  for (TopExp_Explorer it(face.first, TopAbs_EDGE); it.More(); it.Next()) {
    if (before.Contains(it.Current())) continue;
    for (const TopoDS_Shape& other : faces_of_edge.FindFromKey(it.Current()))
      if (!whole.Contains(other)) return true;
  }
  return false;
}

// Those that can become what they were.
Whole whole_faces(const ClearCharts& charts, const SolidTrimResult& result) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopTools_MapOfShape made, whole;
  for (const SolidFace& face : result.faces) {
    made.Add(face.face);
    TopExp::MapShapesAndAncestors(face.face, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  }
  Whole faces;
  for (const auto& face : charts.turned)
    if (made.Contains(face.first)) {
      faces.push_back(face);
      whole.Add(face.first);
    }
  const auto is_held = [&](const auto& face) {
    return hangs_on(face, whole, faces_of_edge) && whole.Remove(face.first);
  };
  while (std::erase_if(faces, is_held) > 0) {
  }
  return faces;
}

}  // namespace

ClearCharts clear_charts(const TrimTool& solid, const TrimTool& other) {
  ClearCharts made{solid, {}};
  const std::vector<FreeChart> charts = free_charts(solid.faces);
  if (charts.empty()) return made;
  std::vector<Bnd_Box> boxes;
  for (const TopoDS_Face& face : other.faces) boxes.push_back(bounds_of(face));
  BRepTools_ReShape moves;
  bool any = false;
  for (const FreeChart& chart : charts)
    if (const auto move = better_move(chart, surroundings_of(chart, other, boxes))) {
      move_chart(chart, *move, moves);
      any = true;
    }
  if (!any) return made;
  for (TopoDS_Face& face : made.solid.faces) {
    const TopoDS_Face before = std::exchange(face, TopoDS::Face(moves.Apply(face)));
    if (!face.IsSame(before)) made.turned.emplace_back(face, before);
  }
  return made;
}

void turn_back(const ClearCharts& charts, SolidTrimResult& result) {
  if (charts.turned.empty()) return;
  BRepTools_ReShape back;
  for (const auto& [now, before] : whole_faces(charts, result)) back.Replace(now, before);
  for (TopoDS_Solid& solid : result.solids) solid = TopoDS::Solid(back.Apply(solid));
  for (SolidFace& face : result.faces) face.face = TopoDS::Face(back.Apply(face.face));
}

}  // namespace blossom::occt
