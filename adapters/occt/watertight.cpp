// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/watertight.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/curves.h"
#include "adapters/occt/edge_joins.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/surfaces.h"
#include "adapters/occt/untrimmed.h"
#include "core/base/tolerances.h"
#include "core/blossom/triangle_conversion.h"
#include "core/forms/conversion.h"
#include "core/trimming/flat_pieces.h"

namespace blossom::occt {
namespace {

constexpr double kSameRange = 1e-9;  // of parameters, relative to their range
constexpr double kMuchNearer = 0.5;  // as near are borders that are worth parameters of their own

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// ---- to the core

// Vertices of joined edges are one.
class UnitedVertices {
 public:
  int number_of(const TopoDS_Vertex& vertex) {
    const int number = numbers_.Add(vertex) - 1;
    if (index(number) == first_.size()) first_.push_back(number);
    return number;
  }

  /// The number that stands for all that a number has been united with.
  int root(int number) const {
    while (first_[index(number)] != number) number = first_[index(number)];
    return number;
  }

  void unite(const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
    const int root_a = root(number_of(a)), root_b = root(number_of(b));
    first_[index(std::max(root_a, root_b))] = std::min(root_a, root_b);
  }

  std::vector<Vec3> points() const {
    std::vector<Vec3> points;
    for (int k = 1; k <= numbers_.Extent(); ++k) {
      const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(numbers_(k)));
      points.push_back({p.X(), p.Y(), p.Z()});
    }
    return points;
  }

 private:
  TopTools_IndexedMapOfShape numbers_;
  std::vector<int> first_;
};

// What two borders have in common: a curve between them.
struct Middle {
  BorderImage first;
  std::optional<BorderRelation> relation;  // none: the parameters are the same
  BorderImage second;

  Vec3 at(double s) const {
    return 0.5 * (first.at(s) + second.at(relation ? relation->second_at(s) : s));
  }
};

// An edge of one face has the image of its border, one of two faces whose images are apart the
// middle between these, and others have their curve in space.
class Reader {
 public:
  Reader(const TopoDS_Shape& shape, const WatertightOptions& options)
      : tolerance_(options.tolerance), ask_(options.ask) {
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_);
    for (const EdgeJoin& join : edge_joins(faces_, tolerance_)) add(join);
  }

  CommonModel read(const std::vector<TopoDS_Face>& faces) {
    for (const TopoDS_Face& face : faces) {
      if (ask_) ask_();
      add(face);
    }
    model_.vertices = vertices_.points();
    for (CommonEdge& edge : model_.edges) {
      edge.from = vertices_.root(edge.from);
      edge.to = vertices_.root(edge.to);
    }
    return std::move(model_);
  }

 private:
  static std::pair<TopoDS_Vertex, TopoDS_Vertex> ends_of(const TopoDS_Edge& edge) {
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    return {TopExp::FirstVertex(forward), TopExp::LastVertex(forward)};
  }

  static BorderParameters parameters(const BorderRelation& relation) {
    return {[relation](double t) { return relation.first_at(t); },
            [relation](double s) { return relation.second_at(s); }};
  }

  TopoDS_Face face_of(const TopoDS_Edge& edge) const {
    return TopoDS::Face(faces_.FindFromKey(edge).First());
  }

  void add(const EdgeJoin& join) {
    const auto [from, to] = ends_of(join.given_up);
    vertices_.unite(ends_of(join.kept).first, join.reversed ? to : from);
    vertices_.unite(ends_of(join.kept).second, join.reversed ? from : to);
    CommonEdge edge = with_ends(join.kept);
    const Middle middle{join.relation.first(), join.relation, join.relation.second()};
    edge.domain = middle.first.domain();
    edge.point = [middle](double s) { return middle.at(s); };
    edge.apart = join.relation.apart();
    const int number = edges_.Add(join.kept) - 1;
    model_.edges.push_back(std::move(edge));
    joined_.Bind(join.given_up, number);
    parameters_[{number, faces_.FindIndex(join.given_up)}] = parameters(join.relation);
  }

  void add(const TopoDS_Face& face) {
    const FaceTrims trims = face_trims(face);
    CommonFace made{bezier_surface(face), trimmed_chart(trims), {}, {}};
    for (const auto& loop : trims.loops)
      for (const Coedge& coedge : loop) {
        made.edges.push_back(edge_of(coedge));
        made.parameters.push_back(parameters(made.edges.back(), coedge.edge, face));
      }
    model_.faces.push_back(std::move(made));
  }

  BorderParameters parameters(int edge, const TopoDS_Edge& of, const TopoDS_Face& face) const {
    const bool first = !joined_.IsBound(of) && face.IsSame(face_of(of));
    const auto found = parameters_.find({edge, faces_.FindIndex(of)});
    return first || found == parameters_.end() ? BorderParameters{} : found->second;
  }

  int edge_of(const Coedge& coedge) {
    if (joined_.IsBound(coedge.edge)) return joined_(coedge.edge);
    const int known = edges_.FindIndex(coedge.edge) - 1;
    const int number = known >= 0 ? known : edges_.Add(coedge.edge) - 1;
    if (known < 0) model_.edges.push_back(made(coedge, number));
    if (parameters_.contains({number, faces_.FindIndex(coedge.edge)})) return number;
    const Interval domain = model_.edges[index(number)].domain, own = coedge.curve.domain();
    const double same = kSameRange * std::abs(length(domain));
    if (std::abs(domain.from - own.from) > same || std::abs(domain.to - own.to) > same)
      throw BadModel("an edge has different ranges of parameters on its faces");
    return number;
  }

  CommonEdge with_ends(const TopoDS_Edge& edge) {
    const auto [from, to] = ends_of(edge);
    CommonEdge made;
    made.from = vertices_.number_of(from);
    made.to = vertices_.number_of(to);
    return made;
  }

  CommonEdge made(const Coedge& coedge, int number) {
    CommonEdge edge = with_ends(coedge.edge);
    edge.domain = coedge.curve.domain();
    edge.is_point = coedge.degenerated;
    if (edge.is_point) return edge;
    const TopTools_ListOfShape& faces = faces_.FindFromKey(coedge.edge);
    if (faces.Extent() == 1) {
      const BorderImage image(coedge.edge, face_of(coedge.edge));
      edge.point = [image](double t) { return image.at(t); };
      return edge;
    }
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(coedge.edge, first, last);
    if (curve.IsNull()) throw BadModel("an edge has no curve in space");
    if (std::abs(first - edge.domain.from) + std::abs(last - edge.domain.to) >
        kSameRange * std::abs(last - first))
      throw BadModel("an edge has different ranges of parameters in space and on a face");
    edge.point = [curve](double t) {
      const gp_Pnt p = curve->Value(t);
      return Vec3{p.X(), p.Y(), p.Z()};
    };
    if (faces.Extent() == 2 && !faces.First().IsSame(faces.Last()))
      take_middle(edge, TopoDS::Edge(coedge.edge.Oriented(TopAbs_FORWARD)), number);
    return edge;
  }

  // Where the images of the borders are apart at equal parameters, they may be nearer at others.
  void take_middle(CommonEdge& edge, const TopoDS_Edge& of, int number) {
    const TopTools_ListOfShape& faces = faces_.FindFromKey(of);
    const BorderImage first(of, TopoDS::Face(faces.First()));
    const BorderImage second(of, TopoDS::Face(faces.Last()));
    edge.apart = apart(first, second);
    if (edge.apart <= tolerance_) return;
    const BorderRelation relation(first, second, false);
    Middle middle{first, {}, second};
    if (relation.apart() < kMuchNearer * edge.apart) {
      middle.relation = relation;
      edge.apart = relation.apart();
      parameters_[{number, faces_.FindIndex(of)}] = parameters(relation);
    }
    edge.point = [middle](double s) { return middle.at(s); };
  }

  double tolerance_;
  std::function<void()> ask_;
  CommonModel model_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_;  // of each edge
  TopTools_DataMapOfShapeInteger joined_;            // edges given up: the model's edge
  // Of a border on the edge's second face, or of an edge given up: by the model's and the shape's
  // number of the edge.
  std::map<std::pair<int, int>, BorderParameters> parameters_;
  UnitedVertices vertices_;
  TopTools_IndexedMapOfShape edges_;
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

  /// How far faces are from the pieces that they are of, at most; model units.
  double flattened() const { return flattened_; }

  TopoDS_Face face_of(const WatertightPiece& piece) {
    const auto* triangle = std::get_if<BezierTriangle>(&piece.form);
    if (!triangle) {
      begin(std::get<BezierPatch>(piece.form));
      for (std::size_t k = 0; k < 4; ++k) add_side(piece, k, k);
      return finished();
    }
    if (const auto plane = plane_of(pieces_, piece, kInPlane, kNarrow))
      return flat_face(piece, *plane);
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
  static constexpr double kInPlane = 0.5 * kTolerance;
  static constexpr double kNarrow = 100 * kTolerance;  // no mesher finds triangles in less than 1

  // Meshers put nodes inside of collapsed patches even if they are flat, where facets with corners
  // at the tip then lie over each other; inside of planes they have no reason to.
  TopoDS_Face flat_face(const WatertightPiece& piece, const PiecePlane& plane) {
    flattened_ = std::max(flattened_, plane.error);
    const Vec3 normal = cross(plane.x, plane.y);
    const auto direction = [](const Vec3& v) { return gp_Dir(v[0], v[1], v[2]); };
    const gp_Pnt origin(plane.origin[0], plane.origin[1], plane.origin[2]);
    builder_.MakeFace(face_, new Geom_Plane(gp_Ax3(origin, direction(normal), direction(plane.x))),
                      kTolerance);
    builder_.MakeWire(wire_);
    for (std::size_t k = 0; k < 3; ++k)
      if (TopoDS_Edge& edge = edges_[index(piece.sides[k])]; !edge.IsNull()) {
        const std::vector<Vec3>& points = pieces_.sides[index(piece.sides[k])].curve.points;
        TColgp_Array1OfPnt2d flat(1, static_cast<int>(points.size()));
        for (std::size_t i = 0; i < points.size(); ++i) {
          const Vec2 at = plane.at(points[i]);
          flat(static_cast<int>(i) + 1) = {at[0], at[1]};
        }
        builder_.UpdateEdge(edge, new Geom2d_BezierCurve(flat), face_, kTolerance);
        builder_.Add(wire_, edge.Oriented(piece.along[k] ? TopAbs_FORWARD : TopAbs_REVERSED));
      }
    return finished();
  }

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
  double flattened_ = 0;
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
  const std::vector<TopoDS_Face> given = faces_of(shape);
  result.pieces = watertight_pieces(Reader(shape, options).read(given), options);
  if (!result.pieces.obstacle.empty()) return result;
  const auto ask = [&options] {
    if (options.ask) options.ask();
  };
  result.faces.resize(given.size());
  Writer writer(result.pieces);
  for (const WatertightPiece& piece : result.pieces.pieces) {
    ask();
    result.faces[index(piece.face)].push_back(
        TopoDS::Face(writer.face_of(piece).Oriented(given[index(piece.face)].Orientation())));
  }
  result.pieces.deviation += writer.flattened();
  Rebuilder rebuilder(shape, result.faces);
  result.shape =
      shape.ShapeType() == TopAbs_FACE ? rebuilder.of_face(shape) : rebuilder.rebuilt(shape);
  ask();
  const std::string fault = watertight_fault(shape, result.shape);
  if (fault.empty()) return result;
  WatertightShape refused;
  refused.pieces.obstacle =
      fault + "; they are within " + std::to_string(result.pieces.deviation) + " of the faces";
  return refused;
}

}  // namespace blossom::occt
