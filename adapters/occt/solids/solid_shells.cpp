// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/solid_shells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/queries/solid_rays.h"
#include "adapters/occt/solids/limits.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/trim_sides.h"
#include "core/base/disjoint_sets.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

// Faces that leave an edge in directions closer than this, and bend away from each other by no more
// over half of its length, are not told apart. Radians.
constexpr double kMinAngle = 1e-6;
constexpr const char* kMakingSolids = "making solids";
constexpr double kStep = 1e-3;  // of an edge's length: how far into a face is looked
// Of the cones over a far apex: where so little is left of them, it may be that faces end apart.
constexpr double kCancelled = 1e-2;
// Ways between the vertices of a shell: edges of one that its tolerances cover are no longer. A
// choice; a longer one only keeps the shell.
constexpr double kDetour = 4;

struct Shell {
  TopoDS_Shell shape;
  double volume = 0;
  double cones = 0;  // the sum of what each face adds, without signs
};

// One use of an edge by a face.
struct EdgeUse {
  std::size_t face = 0;
  TopoDS_Edge edge;  // as the face uses it
  bool forward = false;
  double angle = 0;  // of the way into the face, about the edge's direction
  double bend = 0;   // by which the way turns to greater angles over half of the edge's length
};

struct Corner {
  Vec3 along;    // direction of the edge
  Vec3 inwards;  // from it into the face, a short way along the surface
  double bend;   // curvature of that way about the edge, times half of its length
};

// At a use of an edge, in the middle of it. Faces that are tangential there bend apart.
Corner corner_of(const EdgeUse& use, const TopoDS_Face& face) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(use.edge, range.from, range.to);
  const double middle = at(range, 0.5);
  gp_Pnt point;
  gp_Vec along;
  curve->D1(middle, point, along);
  const gp_Pnt2d uv = chart_curve_of(use.edge, face, range)->Value(middle);
  const SurfaceProjector feet(face, Precision::Confusion());
  const SurfaceJet frame = frame_at(feet.surface(), {uv.X(), uv.Y()});
  const Vec3 direction = unit(Vec3{along.X(), along.Y(), along.Z()});
  const bool turned = (face.Orientation() == TopAbs_REVERSED) == use.forward;
  const Vec3 left = cross(unit(cross(frame.du, frame.dv)), direction);
  const double step = kStep * length(range) * along.Magnitude() * (turned ? -1 : 1);
  const Vec2 beside = feet.foot(frame.point + step * left, Vec2{uv.X(), uv.Y()});
  const Vec2 rate = chart_step(frame, left);
  const SurfaceBend of = bend_at(feet.surface(), {uv.X(), uv.Y()});
  const Vec3 curvature =
      rate[0] * rate[0] * of.uu + 2 * rate[0] * rate[1] * of.uv + rate[1] * rate[1] * of.vv;
  const Vec3 rise = cross(direction, turned ? -1.0 * left : left);
  const double bend = 0.5 * std::abs(step) / kStep * dot(curvature, rise);
  return {direction, frame_at(feet.surface(), beside).point - frame.point,
          std::isfinite(bend) ? bend : 0};
}

// Sets the angles about the edge, against the first use.
void measure(std::vector<EdgeUse>& uses, const std::vector<BoundingFace>& faces) {
  Vec3 x, y;
  for (EdgeUse& use : uses) {
    const Corner corner = corner_of(use, faces[use.face].face);
    if (&use == &uses.front()) {
      const Vec3& along = corner.along;
      x = unit(corner.inwards - dot(corner.inwards, along) * along);
      y = cross(along, x);
    }
    use.angle = std::atan2(dot(corner.inwards, y), dot(corner.inwards, x));
    use.bend = corner.bend;
  }
}

// About an edge that many faces use, bodies and what is outside of them take turns.
enum class Across { Body, Air };

// Whether the next use is the other side of the same face: between the two is nothing.
bool is_other_side(const EdgeUse& use, const EdgeUse& next,
                   const std::vector<BoundingFace>& faces) {
  return use.forward && !next.forward && faces[use.face].face.IsSame(faces[next.face].face);
}

// Whether uses in their order about the edge are forward ones and reversed ones by turns, of which
// each leaves it in another direction than the next, or bends away from it.
bool are_told_apart(const std::vector<EdgeUse>& uses, const std::vector<BoundingFace>& faces) {
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const bool at_last = i + 1 == uses.size();
    const EdgeUse &use = uses[i], &next = uses[at_last ? 0 : i + 1];
    const double turn = next.angle - use.angle + (at_last ? 2 * std::numbers::pi : 0);
    const bool is_next =
        turn >= kMinAngle || next.bend - use.bend >= kMinAngle || is_other_side(use, next, faces);
    if (use.forward == next.forward || !is_next) return false;
  }
  return true;
}

// Uses that leave the edge in one direction are sorted by how they bend. None of them is apart from
// the others by half a turn, where angles begin anew.
void sort_by_bends(std::vector<EdgeUse>& uses) {
  const auto is_apart = [](const EdgeUse& use, const EdgeUse& next) {
    return next.angle - use.angle >= kMinAngle;
  };
  const auto gap = std::ranges::adjacent_find(uses, is_apart);
  if (gap != uses.end()) {
    std::for_each(uses.begin(), gap + 1, [](EdgeUse& use) { use.angle += 2 * std::numbers::pi; });
    std::rotate(uses.begin(), gap + 1, uses.end());
  }
  for (auto from = uses.begin(); from != uses.end();) {
    const auto last = std::adjacent_find(from, uses.end(), is_apart);
    const auto to = last == uses.end() ? last : last + 1;
    std::sort(from, to, [](const EdgeUse& a, const EdgeUse& b) {
      return a.bend < b.bend || (a.bend == b.bend && a.forward && !b.forward);
    });
    from = to;
  }
}

// Sorts the uses about their edge: the body lies behind the faces, so from a reversed use on to the
// next one, which is a forward one. Returns why that cannot be told.
std::string sort_about(std::vector<EdgeUse>& uses, const std::vector<BoundingFace>& faces) {
  measure(uses, faces);
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return a.angle < b.angle || (a.angle == b.angle && a.forward && !b.forward);
  });
  if (are_told_apart(uses, faces)) return {};
  sort_by_bends(uses);
  return are_told_apart(uses, faces) ? "" : "faces that meet in one edge cannot be told apart";
}

// The uses of each edge, sorted about it where they are more than two.
struct UsedEdges {
  std::vector<std::vector<EdgeUse>> uses;
  std::string obstacle;  // why they bound no body
};

UsedEdges used_edges(const std::vector<BoundingFace>& faces, const WorkLimit* limit) {
  TopTools_IndexedMapOfShape edges;
  UsedEdges found;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (TopExp_Explorer it(faces[i].face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge) || edge.Orientation() == TopAbs_INTERNAL) continue;
      const auto number = static_cast<std::size_t>(edges.Add(edge)) - 1;
      if (number == found.uses.size()) found.uses.emplace_back();
      found.uses[number].push_back({i, edge, edge.Orientation() == TopAbs_FORWARD});
    }
  int open = 0;
  for (auto& of : found.uses) {
    if (of.size() > 2) check_limit(limit, kMakingSolids);
    const auto forward =
        std::count_if(of.begin(), of.end(), [](const EdgeUse& u) { return u.forward; });
    if (2 * static_cast<std::size_t>(forward) != of.size())
      ++open;
    else if (of.size() > 2)
      if (const std::string cause = sort_about(of, faces); !cause.empty()) found.obstacle = cause;
  }
  if (open > 0) found.obstacle = "the shell does not close at " + std::to_string(open) + " edges";
  return found;
}

using Groups = std::vector<std::size_t>;  // of each face: the first one that hangs together with it

// Joined across edges of two faces, and across those of more as `across` says of each.
template <class AcrossOf>
Groups joined(std::size_t faces, const std::vector<std::vector<EdgeUse>>& edges,
              const AcrossOf& across) {
  DisjointSets sets(faces);
  for (const std::vector<EdgeUse>& uses : edges)
    for (std::size_t i = 0; i < uses.size(); ++i)
      if (uses[i].forward == (across(uses) == Across::Air)) {
        const auto [first, other] =
            std::minmax({sets.find(uses[i].face), sets.find(uses[(i + 1) % uses.size()].face)});
        sets.join(other, first);
      }
  Groups groups;
  for (std::size_t i = 0; i < faces; ++i) groups.push_back(sets.find(i));
  return groups;
}

Groups bodies_behind(std::size_t faces, const std::vector<std::vector<EdgeUse>>& edges) {
  return joined(faces, edges, [](const auto&) { return Across::Body; });
}

// Bodies that meet in an edge only are apart. Where one body meets itself in an edge, the edge
// joins what is outside of it instead: so a void that touches the skin round it is a shell of its
// own.
Groups connected(std::size_t faces, const std::vector<std::vector<EdgeUse>>& edges) {
  const Groups bodies = bodies_behind(faces, edges);
  return joined(faces, edges, [&](const std::vector<EdgeUse>& uses) {
    const bool one = std::all_of(uses.begin(), uses.end(), [&](const EdgeUse& use) {
      return bodies[use.face] == bodies[uses.front().face];
    });
    return one ? Across::Air : Across::Body;
  });
}

// Cones over a corner of the shell itself, as the common apex may be far from a small one.
double own_volume(const TopoDS_Shell& shell) {
  const TopExp_Explorer corner(shell, TopAbs_VERTEX);
  if (!corner.More()) return 0;
  const gp_Pnt apex = BRep_Tool::Pnt(TopoDS::Vertex(corner.Current()));
  double volume = 0;
  for (TopExp_Explorer it(shell, TopAbs_FACE); it.More(); it.Next())
    volume += cone_volume(TopoDS::Face(it.Current()), {apex.X(), apex.Y(), apex.Z()});
  return volume;
}

std::vector<Shell> shells_of(const std::vector<BoundingFace>& faces, std::string& obstacle,
                             const WorkLimit* limit) {
  const UsedEdges edges = used_edges(faces, limit);
  if (!edges.obstacle.empty()) {
    obstacle = edges.obstacle;
    return {};
  }
  const Groups groups = connected(faces.size(), edges.uses);
  std::map<std::size_t, Shell> shells;
  const BRep_Builder builder;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Shell& shell = shells[groups[i]];
    if (shell.shape.IsNull()) builder.MakeShell(shell.shape);
    builder.Add(shell.shape, faces[i].face);
    shell.volume += faces[i].volume;
    shell.cones += std::abs(faces[i].volume);
  }
  std::vector<Shell> all;
  for (auto& [group, shell] : shells) {
    shell.shape.Closed(Standard_True);
    if (std::abs(shell.volume) <= kCancelled * shell.cones) shell.volume = own_volume(shell.shape);
    all.push_back(std::move(shell));
  }
  return all;
}

// Whether a shell encloses no more than the balls of its vertices and the tubes of its edges, as
// far as their tolerances reach: which way it is turned is rounding then. Lengths of edges take
// time, so they are measured only where the way between vertices, for each edge, would do.
bool is_covered(const Shell& shell) {
  TopTools_IndexedMapOfShape vertices, edges;
  TopExp::MapShapes(shell.shape, TopAbs_VERTEX, vertices);
  TopExp::MapShapes(shell.shape, TopAbs_EDGE, edges);
  Bnd_Box box;
  double balls = 0, widest = 0;
  for (int i = 1; i <= vertices.Extent(); ++i) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(vertices(i));
    box.Add(BRep_Tool::Pnt(vertex));
    const double reach = BRep_Tool::Tolerance(vertex);
    widest = std::max(widest, reach);
    balls += 4.0 / 3.0 * std::numbers::pi * reach * reach * reach;
  }
  const double apart = box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
  const double tube = std::numbers::pi * widest * widest;
  const double volume = std::abs(shell.volume);
  if (volume > balls + tube * kDetour * apart * edges.Extent()) return false;
  double tubes = 0;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    const double reach = BRep_Tool::Tolerance(edge);
    tubes += std::numbers::pi * reach * reach * edge_length(edge);
  }
  return volume <= balls + tubes;
}

// Whether a point lies in a closed shell; nothing if rays cannot tell.
std::optional<bool> holds(const TopoDS_Shell& shell, const gp_Pnt& point) try {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(shell, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  SolidRays rays(std::move(faces), Precision::Confusion());
  int inside = 0, outside = 0;
  for (const Vec3& direction : kRayDirections) {
    const auto told = rays.is_inside({point.X(), point.Y(), point.Z()}, direction);
    if (told && ++(*told ? inside : outside) == kAgreeing) return *told;
  }
  return std::nullopt;
} catch (const BadModel&) {
  return std::nullopt;  // through such a face nothing can be told
}

// The smallest outer shell round a void; the number of shells if there is none, or if it is not
// known which.
std::size_t around(const Shell& hollow, const std::vector<Shell>& shells) {
  const auto point =
      point_inside(TopoDS::Face(TopExp_Explorer(hollow.shape, TopAbs_FACE).Current()));
  std::size_t best = shells.size();
  double least = kInfinity;
  for (std::size_t i = 0; point && i < shells.size(); ++i) {
    if (shells[i].volume <= -hollow.volume || shells[i].volume >= least) continue;
    const std::optional<bool> inside = holds(shells[i].shape, *point);
    if (!inside) return shells.size();
    if (!*inside) continue;
    best = i;
    least = shells[i].volume;
  }
  return best;
}

}  // namespace

std::vector<std::size_t> bodies_of(const std::vector<BoundingFace>& faces, std::string& obstacle,
                                   const WorkLimit* limit) {
  const UsedEdges edges = used_edges(faces, limit);
  if (edges.obstacle.empty()) return bodies_behind(faces.size(), edges.uses);
  obstacle = edges.obstacle;
  return {};
}

std::vector<TopoDS_Solid> solids_of(const std::vector<BoundingFace>& faces, std::string& obstacle,
                                    const WorkLimit* limit, int* left_out) {
  std::vector<Shell> shells = shells_of(faces, obstacle, limit);
  if (left_out != nullptr) *left_out += static_cast<int>(std::erase_if(shells, is_covered));
  const BRep_Builder builder;
  std::vector<TopoDS_Solid> by_shell(shells.size());
  for (std::size_t i = 0; i < shells.size(); ++i)
    if (shells[i].volume > 0) {
      builder.MakeSolid(by_shell[i]);
      builder.Add(by_shell[i], shells[i].shape);
    }
  for (const Shell& shell : shells) {
    if (shell.volume > 0) continue;
    check_limit(limit, kMakingSolids);
    const std::size_t outer = around(shell, shells);
    if (outer == shells.size()) {
      obstacle = "a shell is turned inwards, but it is not known which solid is round it";
      return {};
    }
    builder.Add(by_shell[outer], shell.shape);
  }
  std::vector<TopoDS_Solid> solids;
  for (const TopoDS_Solid& solid : by_shell)
    if (!solid.IsNull()) solids.push_back(solid);
  return solids;
}

}  // namespace blossom::occt
