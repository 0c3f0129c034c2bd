// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/watertight.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/curves.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/surfaces.h"
#include "adapters/occt/untrimmed.h"
#include "core/base/tolerances.h"
#include "core/blossom/triangle_conversion.h"
#include "core/forms/conversion.h"

namespace blossom::occt {
namespace {

constexpr double kSameRange = 1e-9;  // of parameters, relative to their range

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// ---- to the core

class Reader {
 public:
  CommonModel read(const TopoDS_Shape& shape) {
    for (const TopoDS_Face& face : faces_of(shape)) add(face);
    return std::move(model_);
  }

 private:
  void add(const TopoDS_Face& face) {
    const FaceTrims trims = face_trims(face);
    CommonFace made{bezier_surface(face), trimmed_chart(trims), {}};
    for (const auto& loop : trims.loops)
      for (const Coedge& coedge : loop) made.edges.push_back(edge_of(coedge));
    model_.faces.push_back(std::move(made));
  }

  int vertex_of(const TopoDS_Vertex& vertex) {
    const int count = vertices_.Extent();
    const int number = vertices_.Add(vertex) - 1;
    if (number == count) {
      const gp_Pnt p = BRep_Tool::Pnt(vertex);
      model_.vertices.push_back({p.X(), p.Y(), p.Z()});
    }
    return number;
  }

  int edge_of(const Coedge& coedge) {
    const int count = edges_.Extent();
    const int number = edges_.Add(coedge.edge) - 1;
    if (number == count) model_.edges.push_back(made(coedge));
    const Interval known = model_.edges[index(number)].domain, own = coedge.curve.domain();
    const double same = kSameRange * std::abs(length(known));
    if (std::abs(known.from - own.from) > same || std::abs(known.to - own.to) > same)
      throw BadModel("an edge has different ranges of parameters on its faces");
    return number;
  }

  CommonEdge made(const Coedge& coedge) {
    CommonEdge edge;
    edge.domain = coedge.curve.domain();
    const TopoDS_Edge forward = TopoDS::Edge(coedge.edge.Oriented(TopAbs_FORWARD));
    edge.from = vertex_of(TopExp::FirstVertex(forward));
    edge.to = vertex_of(TopExp::LastVertex(forward));
    edge.is_point = coedge.degenerated;
    if (edge.is_point) return edge;
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(forward, first, last);
    if (curve.IsNull()) throw BadModel("an edge has no curve in space");
    if (std::abs(first - edge.domain.from) + std::abs(last - edge.domain.to) >
        kSameRange * std::abs(last - first))
      throw BadModel("an edge has different ranges of parameters in space and on a face");
    edge.point = [curve](double t) {
      const gp_Pnt p = curve->Value(t);
      return Vec3{p.X(), p.Y(), p.Z()};
    };
    return edge;
  }

  CommonModel model_;
  TopTools_IndexedMapOfShape vertices_, edges_;
};

// ---- and back

// The triangle with its corners renamed: `first` becomes a, the next one b.
BezierTriangle turned(const BezierTriangle& triangle, std::size_t first) {
  BezierTriangle result = triangle;
  for (int nu = 0; nu <= triangle.degree; ++nu)
    for (int mu = 0; nu + mu <= triangle.degree; ++mu) {
      std::array<int, 3> count{};
      count[first] = nu;
      count[(first + 1) % 3] = mu;
      count[(first + 2) % 3] = triangle.degree - nu - mu;
      result(nu, mu) = triangle(count[0], count[1]);
    }
  return result;
}

class Writer {
 public:
  explicit Writer(const WatertightPieces& pieces) : pieces_(pieces) {
    for (const Vec3& p : pieces.vertices) {
      TopoDS_Vertex vertex;
      builder_.MakeVertex(vertex, gp_Pnt(p[0], p[1], p[2]), kTolerance);
      vertices_.push_back(vertex);
    }
    for (const WatertightSide& side : pieces.sides) edges_.push_back(edge_on(side));
  }

  TopoDS_Face face_of(const WatertightPiece& piece) {
    const auto* triangle = std::get_if<BezierTriangle>(&piece.form);
    if (!triangle) {
      begin(std::get<BezierPatch>(piece.form));
      for (std::size_t k = 0; k < 4; ++k) add_side(piece, k, k);
      return finished();
    }
    const std::size_t a = first_corner(piece);
    begin(collapsed_patch(turned(*triangle, a)));
    add_side(piece, (a + 2) % 3, 0);  // c to a along v = 0
    add_side(piece, a, 1);
    add_side(piece, (a + 1) % 3, 2);
    add_point(piece.vertices[(a + 2) % 3], 3);
    return finished();
  }

 private:
  static constexpr double kTolerance = Tolerances{}.point;

  // The side from a to b stays whole. It is one that is a point, since collapsed sides beside each
  // other do not survive a STEP file; or else one on an edge.
  std::size_t first_corner(const WatertightPiece& piece) const {
    std::size_t best = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const WatertightSide& side = pieces_.sides[index(piece.sides[k])];
      if (side.curve.points.empty()) return k;
      if (side.edge >= 0) best = k;
    }
    return best;
  }

  TopoDS_Edge edge_on(const WatertightSide& side) {
    TopoDS_Edge edge;
    if (side.curve.points.empty()) return edge;
    RationalBezierCurve curve;
    for (const Vec3& p : side.curve.points) curve.points.push_back({p[0], p[1], p[2], 1});
    builder_.MakeEdge(edge, to_occt(curve), kTolerance);
    add_ends(edge, side.from, side.to);
    return edge;
  }

  void add_ends(TopoDS_Edge& edge, int from, int to) {
    builder_.Add(edge, vertices_[index(from)].Oriented(TopAbs_FORWARD));
    builder_.Add(edge, vertices_[index(to)].Oriented(TopAbs_REVERSED));
    builder_.Range(edge, 0, 1);
  }

  void begin(const BezierPatch& patch) {
    surface_ = to_occt(homogeneous(patch));
    builder_.MakeFace(face_, surface_, kTolerance);
    builder_.MakeWire(wire_);
  }

  // Border k of the unit square, counter-clockwise from v = 0.
  void add_side(const WatertightPiece& piece, std::size_t side, std::size_t border) {
    TopoDS_Edge& edge = edges_[index(piece.sides[side])];
    if (edge.IsNull()) return add_point(piece.vertices[side], border);
    add_pcurve(edge, border, piece.along[side]);
    builder_.Add(wire_, edge.Oriented(piece.along[side] ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  void add_point(int vertex, std::size_t border) {
    TopoDS_Edge edge;
    builder_.MakeEdge(edge);
    builder_.Degenerated(edge, Standard_True);
    builder_.UpdateEdge(edge, kTolerance);
    add_pcurve(edge, border, true);
    add_ends(edge, vertex, vertex);
    builder_.Add(wire_, edge);
  }

  void add_pcurve(TopoDS_Edge& edge, std::size_t border, bool along) {
    static const gp_Pnt2d corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const gp_Pnt2d& from = corners[along ? border : (border + 1) % 4];
    const gp_Pnt2d& to = corners[along ? (border + 1) % 4 : border];
    const Handle(Geom2d_Line) line = new Geom2d_Line(from, gp_Dir2d(gp_Vec2d(from, to)));
    builder_.UpdateEdge(edge, line, surface_, TopLoc_Location(), kTolerance);
    builder_.Range(edge, surface_, TopLoc_Location(), 0, 1);
  }

  TopoDS_Face finished() {
    wire_.Closed(Standard_True);
    builder_.Add(face_, wire_);
    return face_;
  }

  const WatertightPieces& pieces_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;  // null for sides that are points
  Handle(Geom_BezierSurface) surface_;
  TopoDS_Face face_;
  TopoDS_Wire wire_;
};

// The shape with other faces: shells and solids stay what they are.
class Rebuilder {
 public:
  Rebuilder(const TopoDS_Shape& shape, const std::vector<std::vector<TopoDS_Face>>& faces)
      : faces_(faces) {
    TopExp::MapShapes(shape, TopAbs_FACE, numbers_);
  }

  TopoDS_Shape rebuilt(const TopoDS_Shape& shape) {
    TopoDS_Shape result = empty_like(shape);
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      if (it.Value().ShapeType() == TopAbs_FACE)
        add_pieces(result, it.Value());
      else if (it.Value().ShapeType() < TopAbs_FACE)
        builder_.Add(result, rebuilt(it.Value()));
    }
    if (result.ShapeType() == TopAbs_SHELL) result.Closed(BRep_Tool::IsClosed(result));
    return result;
  }

  TopoDS_Shape of_face(const TopoDS_Shape& face) {
    TopoDS_Compound compound;
    builder_.MakeCompound(compound);
    add_pieces(compound, face);
    return compound;
  }

 private:
  static TopoDS_Shape empty_like(const TopoDS_Shape& shape) {
    TopoDS_Shape result = shape.EmptyCopied();
    result.Location(TopLoc_Location());
    return result;
  }

  // The pieces have the orientation of the face as the map knows it.
  void add_pieces(TopoDS_Shape& shape, const TopoDS_Shape& face) {
    const int number = numbers_.FindIndex(face);
    const bool turned = numbers_(number).Orientation() != face.Orientation();
    for (const TopoDS_Face& piece : faces_[index(number - 1)])
      builder_.Add(shape, turned ? piece.Reversed() : TopoDS_Shape(piece));
  }

  BRep_Builder builder_;
  const std::vector<std::vector<TopoDS_Face>>& faces_;
  TopTools_IndexedMapOfShape numbers_;
};

}  // namespace

std::string watertight_fault(const TopoDS_Shape& given, const TopoDS_Shape& made) {
  TopExp_Explorer before(given, TopAbs_SHELL), after(made, TopAbs_SHELL);
  for (; before.More() && after.More(); before.Next(), after.Next())
    if (BRep_Tool::IsClosed(before.Current()) && !BRep_Tool::IsClosed(after.Current()))
      return "the pieces of a closed shell do not close";
  return BRepCheck_Analyzer(made).IsValid() ? "" : "the pieces are not valid by BRepCheck";
}

WatertightShape watertight(const TopoDS_Shape& shape, const WatertightOptions& options) {
  WatertightShape result;
  result.pieces = watertight_pieces(Reader().read(shape), options);
  if (!result.pieces.obstacle.empty()) return result;
  const std::vector<TopoDS_Face> given = faces_of(shape);
  result.faces.resize(given.size());
  Writer writer(result.pieces);
  for (const WatertightPiece& piece : result.pieces.pieces)
    result.faces[index(piece.face)].push_back(
        TopoDS::Face(writer.face_of(piece).Oriented(given[index(piece.face)].Orientation())));
  Rebuilder rebuilder(shape, result.faces);
  result.shape =
      shape.ShapeType() == TopAbs_FACE ? rebuilder.of_face(shape) : rebuilder.rebuilt(shape);
  const std::string fault = watertight_fault(shape, result.shape);
  if (fault.empty()) return result;
  WatertightShape refused;
  refused.pieces.obstacle =
      fault + "; they are within " + std::to_string(result.pieces.deviation) + " of the faces";
  return refused;
}

}  // namespace blossom::occt
