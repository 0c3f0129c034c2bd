// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/clear_charts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
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

// A face of the other solid that may come near, in the frame of the one that is turned.
struct Neighbour {
  Elementary surface;
  Bnd_Box box;
};

// A whole sphere or torus about the z axis of its frame, which is right-handed. Its seam that a
// turn moves lies over the x axis.
struct Revolved {
  TopoDS_Face face;
  gp_Ax3 frame{};
  bool is_sphere = false;
  double size = 0;             // the seam's largest distance from the axis
  std::vector<gp_Pnt> seam{};  // looks at it, in the frame
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

// From pole to pole, or round the tube.
std::vector<gp_Pnt> looks_along(bool sphere, double around, double radius) {
  std::vector<gp_Pnt> looks;
  for (int look = 0; look <= kLooks; ++look) {
    const double part = static_cast<double>(look) / kLooks;
    const double v = sphere ? pi * (part - 0.5) : 2 * pi * part;
    looks.emplace_back(around + radius * std::cos(v), 0, radius * std::sin(v));
  }
  return looks;
}

std::optional<Revolved> revolved(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, false);
  const bool sphere = surface.GetType() == GeomAbs_Sphere;
  if ((!sphere && surface.GetType() != GeomAbs_Torus) || !is_whole(face)) return std::nullopt;
  const gp_Ax3 own = sphere ? surface.Sphere().Position() : surface.Torus().Position();
  const double around = sphere ? 0 : surface.Torus().MajorRadius();
  const double radius = sphere ? surface.Sphere().Radius() : surface.Torus().MinorRadius();
  return Revolved{face, gp_Ax3(own.Location(), own.Direction(), own.XDirection()), sphere,
                  around + radius, looks_along(sphere, around, radius)};
}

std::vector<Neighbour> neighbours_of(const Revolved& of, const TrimTool& other) {
  Bnd_Box own;
  BRepBndLib::Add(of.face.Moved(into(of.frame)), own, false);
  std::vector<Neighbour> near;
  for (const TopoDS_Face& face : other.faces) {
    const TopoDS_Face seen = seen_in(of.frame, face);
    const auto surface = elementary_of(BRep_Tool::Surface(seen));
    if (!surface) continue;
    Bnd_Box box;
    BRepBndLib::Add(seen, box, false);
    box.Enlarge(kClear * of.size);
    if (!box.IsOut(own)) near.push_back({*surface, box});
  }
  return near;
}

enum class Clear : char { Nothing, Ends, All };

// How the seam lies to all of them when it is turned.
Clear clearness(const Revolved& of, const gp_Trsf& turn, std::span<const Neighbour> near) {
  std::vector<gp_Pnt> seam = of.seam;
  for (gp_Pnt& look : seam) look.Transform(turn);
  const double least = kClear * of.size, way = 2 * seam[0].Distance(seam[1]);
  Clear clear = Clear::All;
  for (std::size_t look = 0; look < seam.size(); ++look) {
    const auto is_close = [&](const Neighbour& face) {
      return !face.box.IsOut(seam[look]) &&
             std::abs(height_over(face.surface, vec(seam[look]))) < least;
    };
    int close = 0;
    for (const Neighbour& face : near) {
      if (!is_close(face)) continue;
      if (look == 0 || look + 1 == seam.size()) return Clear::Nothing;
      const double rise = height_over(face.surface, vec(seam[look + 1])) -
                          height_over(face.surface, vec(seam[look - 1]));
      if (std::abs(rise) < kClear * way || ++close > 1) clear = Clear::Ends;
    }
  }
  return clear;
}

struct ChartTurn {
  gp_Dir about = gp::DZ();  // in the face's frame
  double angle = 0;

  gp_Trsf within(const gp_Ax3& frame) const {
    gp_Trsf made;
    const gp_XYZ axis = about.X() * frame.XDirection().XYZ() +
                        about.Y() * frame.YDirection().XYZ() + about.Z() * frame.Direction().XYZ();
    made.SetRotation(gp_Ax1(frame.Location(), gp_Dir(axis)), angle);
    return made;
  }
};

// A sphere's axes follow a spiral over half of it, which spreads them evenly; turns by the golden
// angle have no symmetry.
ChartTurn turn_of(const Revolved& of, int number) {
  const double golden = (number + 0.5) * pi * (3 - std::sqrt(5.0));
  if (!of.is_sphere) return {gp::DZ(), golden};
  return {gp_Dir(std::cos(golden), std::sin(golden), 0), std::acos((number + 0.5) / kTurns)};
}

// Nothing if none is better than to leave the face as it is.
std::optional<ChartTurn> better_turn(const Revolved& of, std::span<const Neighbour> near) {
  Clear best = clearness(of, {}, near);
  std::optional<ChartTurn> found;
  for (int number = 0; number < kTurns && best != Clear::All; ++number) {
    const ChartTurn turn = turn_of(of, number);
    const Clear clear = clearness(of, turn.within(gp_Ax3()), near);
    if (clear <= best) continue;
    best = clear;
    found = turn;
  }
  return found;
}

}  // namespace

ClearCharts clear_charts(const TrimTool& solid, const TrimTool& other) {
  ClearCharts made{solid, {}};
  for (TopoDS_Face& face : made.solid.faces) {
    const auto whole = revolved(face);
    if (!whole) continue;
    const auto turn = better_turn(*whole, neighbours_of(*whole, other));
    if (!turn) continue;
    BRepBuilderAPI_Transform turned(face, turn->within(whole->frame), true);
    made.turned.emplace_back(TopoDS::Face(turned.Shape()), face);
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
