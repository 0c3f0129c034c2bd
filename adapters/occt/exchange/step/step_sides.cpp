// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_sides.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include <BRep_Tool.hxx>
#include <ShapeFix_Shell.hxx>
#include <ShapeFix_Solid.hxx>
#include <StepGeom_BSplineSurface.hxx>
#include <StepGeom_SphericalSurface.hxx>
#include <StepGeom_SurfaceOfRevolution.hxx>
#include <StepGeom_ToroidalSurface.hxx>
#include <StepShape_Edge.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <StepShape_VertexLoop.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeBinder.hxx>
#include <Transfer_Binder.hxx>

#include "adapters/occt/repair/rest_of_surface.h"

namespace blossom::occt {
namespace {

using Face = Handle(StepShape_FaceSurface);

/// Surfaces that may be closed in both directions.
bool may_be_closed(const Handle(StepGeom_Surface) & surface) {
  if (surface.IsNull()) return false;
  return surface->IsKind(STANDARD_TYPE(StepGeom_SphericalSurface)) ||
         surface->IsKind(STANDARD_TYPE(StepGeom_ToroidalSurface)) ||
         surface->IsKind(STANDARD_TYPE(StepGeom_SurfaceOfRevolution)) ||
         surface->IsKind(STANDARD_TYPE(StepGeom_BSplineSurface));
}

/// Whether an edge runs as its curve does, as the edges do that Open CASCADE makes.
bool runs_with_curve(const StepShape_Edge& edge) {
  const auto* curve = dynamic_cast<const StepShape_EdgeCurve*>(&edge);
  return curve == nullptr || curve->SameSense();
}

/// The edges of a face's loops with the directions in which these go along the edges' curves, seen
/// against the normal of the surface.
struct FileBorder {
  std::map<Handle(StepShape_Edge), int> directions;  ///< 1 or -1; 0 of seams, used in both
  bool shows_closing = false;                        ///< by a seam, or by a loop that is a pole

  explicit FileBorder(const StepShape_FaceSurface& face) {
    for (int i = 1; i <= face.NbBounds(); ++i)
      if (const auto bound = face.BoundsValue(i); !bound.IsNull() && !bound->Bound().IsNull())
        add(*bound, face.SameSense() ? 1 : -1);
  }

 private:
  void add(const StepShape_FaceBound& bound, int sense) {
    shows_closing |= bound.Bound()->IsKind(STANDARD_TYPE(StepShape_VertexLoop));
    const auto loop = Handle(StepShape_EdgeLoop)::DownCast(bound.Bound());
    for (int k = 1; !loop.IsNull() && k <= loop->NbEdgeList(); ++k) {
      const auto used = loop->EdgeListValue(k);
      if (used.IsNull() || used->EdgeElement().IsNull()) continue;
      const auto edge = used->EdgeElement();
      const bool along = runs_with_curve(*edge) == (used->Orientation() == bound.Orientation());
      const int direction = along ? sense : -sense;
      const auto [place, is_new] = directions.emplace(edge, direction);
      if (is_new) continue;
      shows_closing |= place->second == -direction;
      place->second = 0;
    }
  }
};

int sign_of(const TopoDS_Shape& shape) { return shape.Orientation() == TopAbs_REVERSED ? -1 : 1; }

/// All faces that were made of one.
std::vector<TopoDS_Face> faces_of(const Transfer_TransientProcess& made, const Face& face) {
  std::vector<TopoDS_Face> faces;
  const TopoDS_Shape shape = TransferBRep::ShapeResult(made.Find(face));
  if (shape.IsNull()) return faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

bool is_pole(const TopoDS_Face& face) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) return false;
  return true;
}

/// Whether the borders of what was made run against those of the file: all that can be compared.
bool is_turned(const Transfer_TransientProcess& made, const FileBorder& border,
               const std::vector<TopoDS_Face>& faces) {
  TopTools_IndexedMapOfShape edges;
  std::vector<int> directions;
  for (const TopoDS_Face& face : faces)
    for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next())
      if (edges.Add(it.Current()) > static_cast<int>(directions.size()))
        directions.push_back(sign_of(it.Current()));
  int turned = 0, kept = 0;
  for (const auto& [entity, direction] : border.directions) {
    const TopoDS_Shape shape = TransferBRep::ShapeResult(made.Find(entity));
    if (shape.IsNull() || direction == 0) continue;
    for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
      const int index = edges.FindIndex(it.Current());
      if (index == 0) continue;
      ++(directions[index - 1] == direction ? kept : turned);
    }
  }
  return turned > 0 && kept == 0;
}

/// The shapes of all entities with those of a change in their place.
void exchange(Transfer_TransientProcess& made, BRepTools_ReShape& change) {
  for (int i = 1; i <= made.NbMapped(); ++i) {
    const auto binder = Handle(TransferBRep_ShapeBinder)::DownCast(made.MapItem(i));
    if (!binder.IsNull() && binder->HasResult() && !binder->Result().IsNull())
      binder->SetResult(change.Apply(binder->Result()));
  }
}

/// Shells and solids of changed faces look where the others of theirs do; solids outwards.
void orient(const Transfer_TransientProcess& made, BRepTools_ReShape& change) {
  TopTools_IndexedMapOfShape solids, shells;
  for (int i = 1; i <= made.NbMapped(); ++i) {
    const TopoDS_Shape shape = TransferBRep::ShapeResult(made.MapItem(i));
    if (shape.IsNull()) continue;
    TopExp::MapShapes(shape, TopAbs_SOLID, solids);
    for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
      shells.Add(it.Current());
  }
  for (int i = 1; i <= solids.Extent(); ++i) {
    const TopoDS_Shape now = change.Apply(solids(i).Oriented(TopAbs_FORWARD));
    if (now.IsNull() || now.IsSame(solids(i)) || now.ShapeType() != TopAbs_SOLID) continue;
    ShapeFix_Solid fix(TopoDS::Solid(now));
    fix.Perform();
    if (fix.Solid().ShapeType() == TopAbs_SOLID) change.Replace(now, fix.Solid());
  }
  for (int i = 1; i <= shells.Extent(); ++i) {
    const TopoDS_Shape now = change.Apply(shells(i).Oriented(TopAbs_FORWARD));
    if (now.IsNull() || now.IsSame(shells(i)) || now.ShapeType() != TopAbs_SHELL) continue;
    ShapeFix_Shell fix;
    if (fix.FixFaceOrientation(TopoDS::Shell(now))) change.Replace(now, fix.Shape());
  }
}

/// The faces of a file that were turned.
class Search {
 public:
  Search(const StepData_StepModel& model, Transfer_TransientProcess& made)
      : model_(model), made_(made) {}

  TurnedFaces mend() {
    TurnedFaces result;
    for (int i = 1; i <= model_.NbEntities(); ++i) {
      const auto face = Face::DownCast(model_.Value(i));
      if (face.IsNull() || !may_be_closed(face->FaceGeometry())) continue;
      const std::vector<TopoDS_Face> pieces = faces_of(made_, face);
      const FileBorder border(*face);
      if (pieces.empty() || !is_turned(made_, border, pieces)) continue;
      TopoDS_Face rest = rest_of_surface(pieces);
      if (!border.shows_closing && (rest.IsNull() || !is_file_right())) continue;
      if (rest.IsNull()) {
        result.left.push_back(face);
        continue;
      }
      put(rest, pieces, result);
    }
    if (result.mended.IsNull()) return result;
    orient(made_, *result.mended);
    exchange(made_, *result.mended);
    return result;
  }

 private:
  static void put(const TopoDS_Shape& rest, const std::vector<TopoDS_Face>& pieces,
                  TurnedFaces& result) {
    if (result.mended.IsNull()) result.mended = new BRepTools_ReShape;
    // Poles that nothing belongs to are pieces, too, in shells of their own.
    const auto first = std::find_if_not(pieces.begin(), pieces.end(), is_pole);
    for (auto piece = pieces.begin(); piece != pieces.end(); ++piece)
      if (piece == first)
        result.mended->Replace(*piece, rest.Oriented(piece->Orientation()));
      else
        result.mended->Remove(*piece);
  }

  /// Whether no face without a choice is turned; found when it is first asked for.
  bool is_file_right() {
    if (right_) return *right_;
    right_ = true;
    for (int i = 1; *right_ && i <= model_.NbEntities(); ++i) {
      const auto face = Face::DownCast(model_.Value(i));
      if (face.IsNull() || may_be_closed(face->FaceGeometry())) continue;
      right_ = !is_turned(made_, FileBorder(*face), faces_of(made_, face));
    }
    return *right_;
  }

  const StepData_StepModel& model_;
  Transfer_TransientProcess& made_;
  std::optional<bool> right_;
};

}  // namespace

TurnedFaces mend_turned_faces(const StepData_StepModel& model, Transfer_TransientProcess& made) {
  return Search(model, made).mend();
}

}  // namespace blossom::occt
