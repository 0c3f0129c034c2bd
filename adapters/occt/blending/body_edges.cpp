// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/body_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/faces/surface_projector.h"

namespace blossom::occt {
namespace {

// Where along an edge its faces' normals are compared; ends may be singular.
constexpr std::array<double, 5> kNormalSamples{0.03, 0.25, 0.5, 0.75, 0.97};
constexpr double kStep = 1e-4;  // of the chart's size: how far beside a pole a normal is taken

std::string edge_name(int edge) { return "edge " + std::to_string(edge); }

// The unit normal of the surface; beside a pole where there is none.
Vec3 normal_at(const Handle(Geom_Surface) & surface, Vec2 uv) {
  constexpr double kNoSine = 1e-12;  // between both derivatives: at a pole but for rounding
  Vec3 normal;
  for (int i = 0; i < 4; ++i, uv += Vec2{kStep, kStep}) {
    const SurfaceJet frame = frame_at(surface, uv);
    normal = cross(frame.du, frame.dv);
    if (norm(normal) > kNoSine * norm(frame.du) * norm(frame.dv) && norm(normal) > 0) break;
  }
  return unit(normal);
}

// Walking along the uses of one loop: corners tell what follows what.
void connect(std::vector<EdgeUseInFace>& uses, std::size_t first) {
  for (std::size_t i = first; i < uses.size(); ++i)
    for (std::size_t k = first; k < uses.size(); ++k)
      if (uses[i].coedge->to == uses[k].coedge->from) {
        uses[i].next = static_cast<int>(k);
        uses[k].previous = static_cast<int>(i);
      }
}

}  // namespace

BodyEdges::BodyEdges(const TopoDS_Shape& body) : body_(body), faces_of_(1) {
  TopExp::MapShapes(body, TopAbs_EDGE, edges_);
  TopExp::MapShapes(body, TopAbs_FACE, faces_);
  for (int i = 1; i <= faces_.Extent(); ++i) faces_of_.push_back(TopoDS::Face(faces_(i)));
  faces_at_edge_.resize(static_cast<std::size_t>(edges_.Extent()) + 1);
  for (int i = 1; i <= faces_.Extent(); ++i)
    for (TopExp_Explorer it(faces_(i), TopAbs_EDGE); it.More(); it.Next())
      faces_at_edge_[static_cast<std::size_t>(edges_.FindIndex(it.Current()))].push_back(i);
}

TopoDS_Edge BodyEdges::edge(int number) const {
  return TopoDS::Edge(edges_(number).Oriented(TopAbs_FORWARD));
}

TopoDS_Vertex BodyEdges::vertex(const DirectedEdge& half) const {
  const TopoDS_Edge of = edge(half.edge);
  return half.at_start ? TopExp::FirstVertex(of) : TopExp::LastVertex(of);
}

const BodyEdges::FaceUses& BodyEdges::uses_of(int number) const {
  if (const auto known = known_.find(number); known != known_.end()) return known->second;
  FaceUses& made = known_[number];
  made.trims = face_trims(face(number));
  const TrimShapes shapes = trim_shapes(face(number));
  const bool reversed = face(number).Orientation() == TopAbs_REVERSED;
  for (const auto& loop : made.trims.loops) {
    const std::size_t first = made.uses.size();
    for (const Coedge& coedge : loop)
      made.uses.push_back({number, edges_.FindIndex(shapes.edge(coedge)),
                           coedge.reversed == reversed, &coedge, -1, -1});
    connect(made.uses, first);
    for (std::size_t i = first; reversed && i < made.uses.size(); ++i)
      std::swap(made.uses[i].next, made.uses[i].previous);
  }
  return made;
}

const FaceTrims& BodyEdges::trims(int face) const { return uses_of(face).trims; }

const std::vector<EdgeUseInFace>& BodyEdges::uses(int face) const { return uses_of(face).uses; }

const EdgeUseInFace& BodyEdges::use(int edge, bool forward) const {
  const EdgeUseInFace* found = nullptr;
  int count = 0;
  const std::vector<int>& all = faces_at_edge_[static_cast<std::size_t>(edge)];
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::find(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), all[i]) !=
        all.begin() + static_cast<std::ptrdiff_t>(i))
      continue;
    for (const EdgeUseInFace& each : uses(all[i]))
      if (each.edge == edge) {
        ++count;
        if (each.forward == forward) found = &each;
      }
  }
  if (count < 2 || found == nullptr) throw BadModel(edge_name(edge) + " is open");
  if (count > 2) throw BadModel(edge_name(edge) + " is used by more than two faces");
  return *found;
}

std::vector<VertexSector> BodyEdges::round(const DirectedEdge& half) const {
  std::vector<VertexSector> sectors;
  DirectedEdge at = half;
  do {
    const EdgeUseInFace& leaving = use(at.edge, at.at_start);
    const std::vector<EdgeUseInFace>& all = uses(leaving.face);
    sectors.push_back({at, leaving.face, static_cast<int>(&leaving - all.data())});
    const EdgeUseInFace* arriving = &leaving;
    do {
      if (arriving->previous < 0) throw BadModel("a wire of a face is open");
      arriving = &all[static_cast<std::size_t>(arriving->previous)];
    } while (arriving->coedge->degenerated && arriving != &leaving);
    at = {arriving->edge, !arriving->forward};
    if (sectors.size() > static_cast<std::size_t>(2 * edge_count()))
      throw BadModel("the faces at a vertex make no ring");
  } while (!(at == half));
  return sectors;
}

BodyEdges::Corner BodyEdges::corner(const EdgeUseInFace& use, double parameter) const {
  const TopoDS_Face& of = face(use.face);
  gp_Pnt point;
  gp_Vec along;
  BRepAdaptor_Curve(edge(use.edge)).D1(parameter, point, along);
  const Vec2 chart = point_at(use.coedge->curve, parameter);
  const Vec2 scale = trims(use.face).scale;
  const double outwards = of.Orientation() == TopAbs_REVERSED ? -1 : 1;
  Corner found;
  found.point = vec(point.XYZ());
  found.along = unit(Vec3{along.X(), along.Y(), along.Z()});
  found.normal =
      outwards * normal_at(BRep_Tool::Surface(of), {chart[0] / scale[0], chart[1] / scale[1]});
  found.inwards = unit(cross(found.normal, use.forward ? found.along : -found.along));
  return found;
}

Vec3 direction_at(const BodyEdges& body, const DirectedEdge& half) {
  const BRepAdaptor_Curve curve(body.edge(half.edge));
  gp_Pnt point;
  gp_Vec along;
  curve.D1(half.at_start ? curve.FirstParameter() : curve.LastParameter(), point, along);
  const Vec3 direction = unit(Vec3{along.X(), along.Y(), along.Z()});
  return half.at_start ? direction : -direction;
}

bool is_narrow(const BodyEdges& body, const VertexSector& sector, const DirectedEdge& next) {
  double first = 0, last = 0;
  BRep_Tool::Range(body.edge(sector.half.edge), first, last);
  const EdgeUseInFace& use = body.uses(sector.face)[static_cast<std::size_t>(sector.use)];
  const Vec3 inwards = body.corner(use, sector.half.at_start ? first : last).inwards;
  return dot(direction_at(body, next), inwards) > std::sin(kSmoothJoint);
}

namespace {

// How much the normals of the faces turn at a place of an edge, and which way.
struct EdgeTurn {
  double angle = 0;
  EdgeKind kind = EdgeKind::Smooth;
};

EdgeTurn turn_at(const BodyEdges& body, int edge, double parameter) {
  const BodyEdges::Corner a = body.corner(body.use(edge, true), parameter);
  const BodyEdges::Corner b = body.corner(body.use(edge, false), parameter);
  const double angle = std::atan2(norm(cross(a.normal, b.normal)), dot(a.normal, b.normal));
  if (angle < kSmoothEdge) return {angle, EdgeKind::Smooth};
  const bool is_convex = dot(cross(a.normal, b.normal), a.along) > 0;
  return {angle, is_convex ? EdgeKind::Convex : EdgeKind::Concave};
}

}  // namespace

EdgeKind kind_at(const BodyEdges& body, int edge, double parameter) {
  return turn_at(body, edge, parameter).kind;
}

EdgeKind kind_at(const BodyEdges& body, const DirectedEdge& half) {
  double first = 0, last = 0;
  BRep_Tool::Range(body.edge(half.edge), first, last);
  return kind_at(body, half.edge, half.at_start ? first : last);
}

EdgeKind edge_kind(const BodyEdges& body, int edge, double& angle) {
  double first = 0, last = 0;
  BRep_Tool::Range(body.edge(edge), first, last);
  bool convex = false, concave = false, smooth = false;
  angle = 0;
  for (const double part : kNormalSamples) {
    const EdgeTurn turn = turn_at(body, edge, first + part * (last - first));
    angle = std::max(angle, turn.angle);
    (turn.kind == EdgeKind::Smooth   ? smooth
     : turn.kind == EdgeKind::Convex ? convex
                                     : concave) = true;
  }
  if (convex + concave + smooth != 1) return EdgeKind::Mixed;
  return convex ? EdgeKind::Convex : concave ? EdgeKind::Concave : EdgeKind::Smooth;
}

}  // namespace blossom::occt
