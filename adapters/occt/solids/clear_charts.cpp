// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/clear_charts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_IntCS.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/faces/elementary_faces.h"

namespace blossom::occt {
namespace {

using std::numbers::pi;

// The c of the header. A choice: within it of a pole, longitudes are 16 times as dense as at the
// equator.
constexpr double kClear = 1.0 / 16;
// Along a seam. Where it touches a surface, the look next to the place sees it unless the surface
// bends so much more than the seam that it leaves it by kClear within half a step.
constexpr int kLooks = 128;
// Turns to choose from. A choice: each face near poles or seams rules out some.
constexpr int kTurns = 12;

using Looks = std::vector<gp_Pnt>;

// A face of the other solid that may come near, in the frame of the one that is turned.
struct Neighbour {
  Elementary surface;
  Bnd_Box box;
};

// What there is of the other solid, in that frame.
struct Surroundings {
  std::vector<Neighbour> faces;
  Looks passages;  // of its edges through the face that is turned
};

// A whole sphere or torus about the z axis of its frame, which is right-handed. Its first seam lies
// over the x axis. The other one of a torus goes about the z axis.
struct Revolved {
  TopoDS_Face face;
  gp_Ax3 frame{};
  bool is_sphere = false;
  bool is_mirrored = false;  // longitudes are counted the other way round
  double around = 0;         // from the axis to the middle of the tube; 0 of spheres
  double radius = 0;

  // The seam's largest distance from the axis.
  double size() const { return around + radius; }
};

// With a sign, which changes where the surface is crossed.
double height_over(const Elementary& surface, const Vec3& point) {
  const Vec3 from = point - surface.centre;
  const double along = dot(from, surface.axis), round = norm(across(from, surface.axis));
  switch (surface.kind) {
    case ElementaryKind::Plane: return along;
    case ElementaryKind::Cylinder: return round - surface.radius;
    case ElementaryKind::Cone:
      return round * std::cos(surface.angle) - std::abs(along) * std::sin(surface.angle);
    case ElementaryKind::Sphere: return norm(from) - surface.radius;
    case ElementaryKind::Torus: return std::hypot(round - surface.radius, along) - surface.minor;
  }
  return 0;
}

gp_Trsf into(const gp_Ax3& frame) {
  gp_Trsf made;
  made.SetTransformation(frame);
  return made;
}

// The face in a frame, as a copy that shares its geometry.
TopoDS_Face seen_in(const gp_Ax3& frame, const TopoDS_Face& face) {
  return TopoDS::Face(face.Moved(into(frame)));
}

// Whether a face has no edges but seams.
bool is_whole(const TopoDS_Face& face) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face)) return false;
  }
  return true;
}

std::optional<Revolved> revolved(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, false);
  const bool sphere = surface.GetType() == GeomAbs_Sphere;
  if ((!sphere && surface.GetType() != GeomAbs_Torus) || !is_whole(face)) return std::nullopt;
  const gp_Ax3 own = sphere ? surface.Sphere().Position() : surface.Torus().Position();
  return Revolved{face,
                  gp_Ax3(own.Location(), own.Direction(), own.XDirection()),
                  sphere,
                  !own.Direct(),
                  sphere ? 0 : surface.Torus().MajorRadius(),
                  sphere ? surface.Sphere().Radius() : surface.Torus().MinorRadius()};
}

// How a chart is turned, in the frame of its face, and how far the seam of a torus about its axis
// is moved along the tube.
struct ChartTurn {
  gp_Dir about = gp::DZ();
  double angle = 0;
  double along_tube = 0;

  gp_Trsf within(const gp_Ax3& frame) const {
    gp_Trsf made;
    const gp_XYZ axis = about.X() * frame.XDirection().XYZ() +
                        about.Y() * frame.YDirection().XYZ() + about.Z() * frame.Direction().XYZ();
    made.SetRotation(gp_Ax1(frame.Location(), gp_Dir(axis)), angle);
    return made;
  }
};

// A sphere's axes follow a spiral over half of it, which spreads them evenly, as the corners of a
// torus are spread over its chart; turns by the golden angle have no symmetry.
ChartTurn turn_of(const Revolved& of, int number) {
  const double golden = (number + 0.5) * pi * (3 - std::sqrt(5.0));
  const double share = (number + 0.5) / kTurns;
  if (!of.is_sphere) return {gp::DZ(), golden, 2 * pi * share};
  return {gp_Dir(std::cos(golden), std::sin(golden), 0), std::acos(share)};
}

// Looks at the seam from pole to pole, or round the tube from the corner on.
Looks seam_over_x(const Revolved& of, const ChartTurn& turn) {
  Looks looks;
  const gp_Trsf turned = turn.within(gp_Ax3());
  for (int look = 0; look <= kLooks; ++look) {
    const double part = static_cast<double>(look) / kLooks;
    const double v = of.is_sphere ? pi * (part - 0.5) : 2 * pi * part + turn.along_tube;
    looks.push_back(gp_Pnt(of.around + of.radius * std::cos(v), 0, of.radius * std::sin(v))
                        .Transformed(turned));
  }
  return looks;
}

// Likewise at that of a torus about its axis.
Looks seam_about_axis(const Revolved& of, const ChartTurn& turn) {
  Looks looks;
  const double far = of.around + of.radius * std::cos(turn.along_tube);
  const double high = of.radius * std::sin(turn.along_tube);
  for (int look = 0; look <= kLooks; ++look) {
    const double u = turn.angle + 2 * pi * look / kLooks;
    looks.emplace_back(far * std::cos(u), far * std::sin(u), high);
  }
  return looks;
}

std::vector<Looks> seams_of(const Revolved& of, const ChartTurn& turn) {
  if (of.is_sphere) return {seam_over_x(of, turn)};
  return {seam_over_x(of, turn), seam_about_axis(of, turn)};
}

bool is_close(const Neighbour& face, const gp_Pnt& look, double least) {
  return !face.box.IsOut(look) && std::abs(height_over(face.surface, vec(look))) < least;
}

// Whether the seam about the axis of a torus follows a face as it is: there it is a border.
bool is_followed(const Revolved& of, const Neighbour& face) {
  if (of.is_sphere) return false;
  return std::ranges::all_of(seam_about_axis(of, {}), [&](const gp_Pnt& look) {
    return is_close(face, look, kClear * of.size());
  });
}

// Where edges of the other solid go through the face, in its frame.
Looks passages_of(const Revolved& of, const Bnd_Box& own, const TrimTool& other) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(seen_in(of.frame, of.face));
  TopTools_IndexedMapOfShape edges;
  for (const TopoDS_Face& face : other.faces)
    TopExp::MapShapes(seen_in(of.frame, face), TopAbs_EDGE, edges);
  Looks passages;
  for (int number = 1; number <= edges.Extent(); ++number) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(number));
    Interval range;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
    if (curve.IsNull()) continue;
    Bnd_Box box;
    BRepBndLib::Add(edge, box, false);
    if (box.IsOut(own)) continue;
    const GeomAPI_IntCS through(new Geom_TrimmedCurve(curve, range.from, range.to), surface);
    for (int i = 1; through.IsDone() && i <= through.NbPoints(); ++i)
      passages.push_back(through.Point(i));
  }
  return passages;
}

Surroundings surroundings_of(const Revolved& of, const TrimTool& other) {
  Bnd_Box own;
  BRepBndLib::Add(seen_in(of.frame, of.face), own, false);
  Surroundings near{{}, passages_of(of, own, other)};
  for (const TopoDS_Face& face : other.faces) {
    const TopoDS_Face seen = seen_in(of.frame, face);
    const auto surface = elementary_of(BRep_Tool::Surface(seen));
    if (!surface) continue;
    Bnd_Box box;
    BRepBndLib::Add(seen, box, false);
    box.Enlarge(kClear * of.size());
    if (!box.IsOut(own) && !is_followed(of, {*surface, box})) near.faces.push_back({*surface, box});
  }
  return near;
}

enum class Clear : char { Nothing, Ends, All };

// How a seam lies to all of them.
Clear clearness(const Looks& seam, double least, const Surroundings& near) {
  const double way = 2 * seam[0].Distance(seam[1]);
  Clear clear = Clear::All;
  for (std::size_t look = 0; look < seam.size(); ++look) {
    for (const Neighbour& face : near.faces) {
      if (!is_close(face, seam[look], least)) continue;
      if (look == 0 || look + 1 == seam.size()) return Clear::Nothing;
      const double rise = height_over(face.surface, vec(seam[look + 1])) -
                          height_over(face.surface, vec(seam[look - 1]));
      if (std::abs(rise) < kClear * way) clear = Clear::Ends;
    }
    if (std::ranges::any_of(near.passages, [&](const gp_Pnt& passage) {
          return seam[look].Distance(passage) < least;
        }))
      clear = Clear::Ends;
  }
  return clear;
}

// Of all its seams when it is turned.
Clear clearness(const Revolved& of, const ChartTurn& turn, const Surroundings& near) {
  Clear clear = Clear::All;
  for (const Looks& seam : seams_of(of, turn))
    clear = std::min(clear, clearness(seam, kClear * of.size(), near));
  return clear;
}

// Nothing if none is better than to leave the face as it is.
std::optional<ChartTurn> better_turn(const Revolved& of, const Surroundings& near) {
  Clear best = clearness(of, {}, near);
  std::optional<ChartTurn> found;
  for (int number = 0; number < kTurns && best != Clear::All; ++number) {
    const ChartTurn turn = turn_of(of, number);
    const Clear clear = clearness(of, turn, near);
    if (clear <= best) continue;
    best = clear;
    found = turn;
  }
  return found;
}

// The same torus with its corner elsewhere in its chart, and the seams through it.
TopoDS_Face with_seams_at(const TopoDS_Face& face, double u, double v) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const double tolerance = BRep_Tool::MaxTolerance(face, TopAbs_EDGE);
  const BRep_Builder builder;
  TopoDS_Face made;
  builder.MakeFace(made, surface, BRep_Tool::Tolerance(face));
  TopoDS_Vertex corner;
  builder.MakeVertex(corner, surface->Value(u, v), BRep_Tool::MaxTolerance(face, TopAbs_VERTEX));
  const auto seam = [&](const Handle(Geom_Curve) & curve, double from, const gp_Pnt2d& forward,
                        const gp_Pnt2d& backward, const gp_Dir2d& along) {
    TopoDS_Edge edge;
    builder.MakeEdge(edge, curve, tolerance);
    builder.UpdateEdge(edge, new Geom2d_Line(forward, along), new Geom2d_Line(backward, along),
                       made, tolerance);
    builder.Continuity(edge, made, made, GeomAbs_CN);
    builder.Add(edge, corner.Oriented(TopAbs_FORWARD));
    builder.Add(edge, corner.Oriented(TopAbs_REVERSED));
    builder.Range(edge, from, from + 2 * pi);
    return edge;
  };
  const TopoDS_Edge round = seam(surface->VIso(v), u, {0, v}, {0, v + 2 * pi}, gp_Dir2d(1, 0));
  const TopoDS_Edge over = seam(surface->UIso(u), v, {u + 2 * pi, 0}, {u, 0}, gp_Dir2d(0, 1));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Shape& edge :
       {TopoDS_Shape(round), TopoDS_Shape(over), round.Reversed(), over.Reversed()})
    builder.Add(wire, edge);
  wire.Closed(true);
  builder.Add(made, wire);
  return TopoDS::Face(made.Oriented(face.Orientation()));
}

TopoDS_Face turned_face(const Revolved& of, const ChartTurn& turn) {
  if (!of.is_sphere)
    return with_seams_at(of.face, of.is_mirrored ? -turn.angle : turn.angle, turn.along_tube);
  BRepBuilderAPI_Transform turned(of.face, turn.within(of.frame), true);
  return TopoDS::Face(turned.Shape());
}

}  // namespace

ClearCharts clear_charts(const TrimTool& solid, const TrimTool& other) {
  ClearCharts made{solid, {}};
  for (TopoDS_Face& face : made.solid.faces) {
    const auto whole = revolved(face);
    if (!whole) continue;
    const auto turn = better_turn(*whole, surroundings_of(*whole, other));
    if (!turn) continue;
    made.turned.emplace_back(turned_face(*whole, *turn), face);
    face = made.turned.back().first;
  }
  return made;
}

void turn_back(const ClearCharts& charts, SolidTrimResult& result) {
  if (charts.turned.empty()) return;
  BRepTools_ReShape back;
  for (const auto& [now, before] : charts.turned) back.Replace(now, before);
  for (TopoDS_Solid& solid : result.solids) solid = TopoDS::Solid(back.Apply(solid));
  for (SolidFace& face : result.faces) face.face = TopoDS::Face(back.Apply(face.face));
}

}  // namespace blossom::occt
