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
#include <Geom_Curve.hxx>
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

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/untrimmed.h"
#include "adapters/occt/faces/watertight_faces.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/splitting/edges/edge_joins.h"
#include "core/base/disjoint_sets.h"
#include "core/math/index.h"

namespace blossom::occt {
namespace {

constexpr double kSameRange = 1e-9;  // of parameters, relative to their range
constexpr double kMuchNearer = 0.5;  // as near are borders that are worth parameters of their own

// ---- to the core

// Vertices of joined edges are one.
class UnitedVertices {
 public:
  int number_of(const TopoDS_Vertex& vertex) {
    const int number = numbers_.Add(vertex) - 1;
    if (index(number) == sets_.size()) sets_.add();
    return number;
  }

  /// The number that stands for all that a number has been united with.
  int root(int number) { return static_cast<int>(sets_.find(index(number))); }

  void unite(const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
    const int root_a = root(number_of(a)), root_b = root(number_of(b));
    sets_.join(index(std::max(root_a, root_b)), index(std::min(root_a, root_b)));
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
  DisjointSets sets_;
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

  /// None if it is told to end.
  std::optional<CommonModel> read(const std::vector<TopoDS_Face>& faces) {
    for (const TopoDS_Face& face : faces) {
      if (ask_ && !ask_()) return std::nullopt;
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
    const TrimShapes shapes = trim_shapes(face);
    CommonFace made{bezier_surface(face), trimmed_chart(trims), {}, {}};
    for (const auto& loop : trims.loops)
      for (const Coedge& coedge : loop) {
        const TopoDS_Edge edge = shapes.edge(coedge);
        made.edges.push_back(number_of(edge, coedge));
        made.parameters.push_back(parameters(made.edges.back(), edge, face));
      }
    model_.faces.push_back(std::move(made));
  }

  BorderParameters parameters(int edge, const TopoDS_Edge& of, const TopoDS_Face& face) const {
    const bool first = !joined_.IsBound(of) && face.IsSame(face_of(of));
    const auto found = parameters_.find({edge, faces_.FindIndex(of)});
    return first || found == parameters_.end() ? BorderParameters{} : found->second;
  }

  int number_of(const TopoDS_Edge& edge, const Coedge& coedge) {
    if (joined_.IsBound(edge)) return joined_(edge);
    const int known = edges_.FindIndex(edge) - 1;
    const int number = known >= 0 ? known : edges_.Add(edge) - 1;
    if (known < 0) model_.edges.push_back(made(edge, coedge, number));
    if (parameters_.contains({number, faces_.FindIndex(edge)})) return number;
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

  CommonEdge made(const TopoDS_Edge& of, const Coedge& coedge, int number) {
    CommonEdge edge = with_ends(of);
    edge.domain = coedge.curve.domain();
    edge.is_point = coedge.degenerated;
    if (edge.is_point) return edge;
    const TopTools_ListOfShape& faces = faces_.FindFromKey(of);
    if (faces.Extent() == 1) {
      const BorderImage image(of, face_of(of));
      edge.point = [image](double t) { return image.at(t); };
      return edge;
    }
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(of, first, last);
    if (curve.IsNull()) throw BadModel("an edge has no curve in space");
    if (std::abs(first - edge.domain.from) + std::abs(last - edge.domain.to) >
        kSameRange * std::abs(last - first))
      throw BadModel("an edge has different ranges of parameters in space and on a face");
    edge.point = [curve](double t) {
      const gp_Pnt p = curve->Value(t);
      return Vec3{p.X(), p.Y(), p.Z()};
    };
    if (faces.Extent() == 2 && !faces.First().IsSame(faces.Last()))
      take_middle(edge, TopoDS::Edge(of.Oriented(TopAbs_FORWARD)), number);
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
  std::function<bool()> ask_;
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

// What is not checked is not done.
WatertightShape ended_before(std::size_t faces) {
  WatertightShape ended;
  ended.pieces.obstacle = "it was ended before all faces were done";
  for (std::size_t f = 0; f < faces; ++f) ended.pieces.open.push_back(static_cast<int>(f));
  return ended;
}

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
  const auto goes_on = [&options] { return !options.ask || options.ask(); };
  const auto model = Reader(shape, options).read(given);
  if (!model) return ended_before(given.size());
  result.pieces = watertight_pieces(*model, options);
  if (!result.pieces.obstacle.empty()) return result;
  result.faces.resize(given.size());
  PieceFaces writer(result.pieces);
  for (const WatertightPiece& piece : result.pieces.pieces) {
    if (!goes_on()) return ended_before(given.size());
    result.faces[index(piece.face)].push_back(
        TopoDS::Face(writer.face_of(piece).Oriented(given[index(piece.face)].Orientation())));
  }
  result.pieces.deviation += writer.flattened();
  Rebuilder rebuilder(shape, result.faces);
  result.shape =
      shape.ShapeType() == TopAbs_FACE ? rebuilder.of_face(shape) : rebuilder.rebuilt(shape);
  if (!goes_on()) return ended_before(given.size());
  const std::string fault = watertight_fault(shape, result.shape);
  if (fault.empty()) return result;
  WatertightShape refused;
  refused.pieces.obstacle =
      fault + "; they are within " + std::to_string(result.pieces.deviation) + " of the faces";
  return refused;
}

}  // namespace blossom::occt
