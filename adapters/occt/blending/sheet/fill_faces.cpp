// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/fill_faces.h"

#include <array>
#include <cstddef>
#include <map>
#include <tuple>

#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/blending/fills/fill_layout.h"

namespace blossom::occt {
namespace {

// Edges 0 and 1 of a patch run with its parameters, the others against them.
bool runs_with_parameter(int edge) { return edge < 2; }

Handle(Geom_Curve) border_curve(const Handle(Geom_BezierSurface) & surface, int edge) {
  switch (edge) {
    case 0: return surface->VIso(0);
    case 1: return surface->UIso(1);
    case 2: return surface->VIso(1);
    default: return surface->UIso(0);
  }
}

// The chart of an edge of a patch whose curve runs with the patch's parameter, or against it.
Handle(Geom2d_Curve) border_line(int edge, bool with_parameter) {
  const double start = with_parameter ? 0 : 1, way = with_parameter ? 1 : -1;
  const bool along_u = edge % 2 == 0;
  const double fixed = edge == 1 || edge == 2 ? 1 : 0;
  return new Geom2d_Line(along_u ? gp_Pnt2d(start, fixed) : gp_Pnt2d(fixed, start),
                         along_u ? gp_Dir2d(way, 0) : gp_Dir2d(0, way));
}

class FillTopology {
 public:
  FillTopology(const Fill& fill, const std::vector<TopoDS_Vertex>& corners,
               const std::function<TopoDS_Vertex(int side, const Vec3&)>& middle);

  std::vector<FillFace> faces(const std::function<PathEdge(const FillBorder&)>& border);

 private:
  std::size_t patch_of(const QuadEdge& at) const;
  LayoutVertex corner(const QuadEdge& at, int i) const;
  Vec3 corner_point(const QuadEdge& at, int i) const;
  const TopoDS_Vertex& vertex(const QuadEdge& at, int i);
  void add(const QuadEdge& at, const TopoDS_Edge& edge, bool forward);
  void share(const SharedQuadEdge& shared, int turn);

  PolygonLayout layout_;
  std::vector<Handle(Geom_BezierSurface)> surfaces_;
  std::vector<FillFace> faces_;
  std::map<std::pair<int, int>, TopoDS_Vertex> vertices_;  // by role and sector
};

FillTopology::FillTopology(const Fill& fill, const std::vector<TopoDS_Vertex>& corners,
                           const std::function<TopoDS_Vertex(int side, const Vec3&)>& middle)
    : layout_(polygon_layout(fill.layout, static_cast<int>(corners.size()))) {
  for (const RationalBezierPatch& patch : fill.patches) {
    surfaces_.push_back(to_occt(patch));
    FillFace made;
    BRep_Builder().MakeFace(made.face, surfaces_.back(), Precision::Confusion());
    faces_.push_back(std::move(made));
  }
  for (int k = 0; k < layout_.sides; ++k) {
    QuadEdge at = layout_.borders[0];
    at.sector += k;
    const LayoutVertex start = corner(at, 0), half = corner(at, 1);
    vertices_[{start.role, start.sector}] = corners[static_cast<std::size_t>(k)];
    vertices_[{half.role, half.sector}] = middle(k, corner_point(at, 1));
  }
}

std::size_t FillTopology::patch_of(const QuadEdge& at) const {
  const int sector = (at.sector % layout_.sides + layout_.sides) % layout_.sides;
  return static_cast<std::size_t>(sector) * layout_.quads.size() +
         static_cast<std::size_t>(at.quad);
}

LayoutVertex FillTopology::corner(const QuadEdge& at, int i) const {
  LayoutVertex place = layout_.quads[static_cast<std::size_t>(at.quad)]
                           .corners[static_cast<std::size_t>((at.edge + i) % 4)];
  if (place.role == layout_.centre) return place;
  place.sector = ((place.sector + at.sector) % layout_.sides + layout_.sides) % layout_.sides;
  return place;
}

Vec3 FillTopology::corner_point(const QuadEdge& at, int i) const {
  const int k = (at.edge + i) % 4;
  const gp_Pnt p = surfaces_[patch_of(at)]->Value(k == 1 || k == 2 ? 1 : 0, k >= 2 ? 1 : 0);
  return {p.X(), p.Y(), p.Z()};
}

const TopoDS_Vertex& FillTopology::vertex(const QuadEdge& at, int i) {
  const LayoutVertex place = corner(at, i);
  TopoDS_Vertex& known = vertices_[{place.role, place.sector}];
  if (known.IsNull()) known = vertex_at(corner_point(at, i));
  return known;
}

// forward   whether the patch uses it so
void FillTopology::add(const QuadEdge& at, const TopoDS_Edge& edge, bool forward) {
  faces_[patch_of(at)].edges.push_back(
      TopoDS::Edge(edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED)));
}

// An inner edge and its use by both patches.
void FillTopology::share(const SharedQuadEdge& shared, int turn) {
  QuadEdge a = shared.a, b = shared.b;
  a.sector += turn;
  b.sector += turn;
  const bool forward = runs_with_parameter(a.edge);
  const TopoDS_Vertex from = vertex(a, forward ? 0 : 1), to = vertex(a, forward ? 1 : 0);
  const TopoDS_Edge edge = edge_on(border_curve(surfaces_[patch_of(a)], a.edge), {0, 1}, from, to);
  add_chart(edge, border_line(a.edge, true), faces_[patch_of(a)].face);
  // The other patch walks the edge the other way.
  const bool with_parameter = forward != runs_with_parameter(b.edge);
  add_chart(edge, border_line(b.edge, with_parameter), faces_[patch_of(b)].face);
  add(a, edge, forward);
  add(b, edge, !forward);
}

std::vector<FillFace> FillTopology::faces(
    const std::function<PathEdge(const FillBorder&)>& border) {
  for (int k = 0; k < layout_.sides; ++k) {
    for (const int half : {0, 1}) {
      QuadEdge at = layout_.borders[static_cast<std::size_t>(half)];
      at.sector += k;
      const Handle(Geom_BezierSurface)& surface = surfaces_[patch_of(at)];
      const PathEdge made = border({k, half, vertex(at, 0), vertex(at, 1),
                                    border_curve(surface, at.edge), runs_with_parameter(at.edge),
                                    faces_[patch_of(at)].face, border_line(at.edge, true)});
      add(at, made.edge, made.forward);
    }
    for (const SharedQuadEdge& each : layout_.shared) share(each, k);
  }
  return std::move(faces_);
}

}  // namespace

std::vector<FillFace> fill_faces(const Fill& fill, const std::vector<TopoDS_Vertex>& corners,
                                 const std::function<TopoDS_Vertex(int side, const Vec3&)>& middle,
                                 const std::function<PathEdge(const FillBorder&)>& border) {
  return FillTopology(fill, corners, middle).faces(border);
}

}  // namespace blossom::occt
