// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/blend_check.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/solids/validity/solid_validity.h"
#include "adapters/occt/soundness.h"

namespace blossom::occt {
namespace {

// The edge in whose place a face is, or one that the face borders on the strip of.
int edge_beside(const FilletedSolid& made, const FilletFace& face, int otherwise) {
  if (face.edge > 0) return face.edge;
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(face.face, TopAbs_EDGE, own);
  for (const FilletFace& other : made.faces)
    for (TopExp_Explorer it(other.face, TopAbs_EDGE); other.edge > 0 && it.More(); it.Next())
      if (own.Contains(it.Current())) return other.edge;
  return otherwise;
}

// Most often it is too large there, so that its border comes to others of the face or past them.
std::string fault_text(const FilletFace& face, const std::string& what) {
  if (face.from > 0)
    return "face " + std::to_string(face.from) +
           " has no room for the blend, what would be left of it is not sound: " + what;
  return std::string(face.edge > 0 ? "its strip" : "what would fill its corner") +
         " is not sound: " + what;
}

// The first fault of a face that is new or was cut, if the face that it is left of had none; as a
// refusal of the edge beside it.
// valid   whether BRepCheck found nothing in them
std::optional<FilletRefusal> new_fault(const BodyEdges& body, const FilletedSolid& made,
                                       const TopTools_MapOfShape& known, bool valid, int first) {
  std::vector<TopoDS_Face> changed;
  std::vector<const FilletFace*> of;
  for (const FilletFace& face : made.faces) {
    if (known.Contains(face.face)) continue;
    changed.push_back(face.face);
    of.push_back(&face);
  }
  const std::vector<std::optional<Problem>> faults = face_faults(changed, valid);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (!faults[i]) continue;
    if (of[i]->from > 0 && face_faults({body.face(of[i]->from)}).front()) continue;
    FilletRefusal why;
    why.edge = edge_beside(made, *of[i], first);
    why.cause = fault_text(*of[i], faults[i]->what);
    why.point = faults[i]->place;
    if (!why.point) {
      const TopExp_Explorer corner(changed[i], TopAbs_VERTEX);
      if (corner.More()) why.point = point_of(TopoDS::Vertex(corner.Current()));
    }
    return why;
  }
  return std::nullopt;
}

// The faces that are as they were.
TopTools_MapOfShape kept_faces(const BodyEdges& body, const FilletedSolid& made) {
  TopTools_MapOfShape kept;
  for (const FilletFace& face : made.faces)
    if (face.from > 0 && face.face.IsSame(body.face(face.from))) kept.Add(face.face);
  return kept;
}

// Those of them that have no vertex of another face, and so nothing that could have changed.
TopTools_MapOfShape apart_from_changes(const FilletedSolid& made, const TopTools_MapOfShape& kept) {
  TopTools_IndexedMapOfShape touched;
  for (const FilletFace& face : made.faces)
    if (!kept.Contains(face.face)) TopExp::MapShapes(face.face, TopAbs_VERTEX, touched);
  TopTools_MapOfShape apart;
  for (const FilletFace& face : made.faces) {
    bool is_apart = kept.Contains(face.face);
    for (TopExp_Explorer it(face.face, TopAbs_VERTEX); it.More() && is_apart; it.Next())
      is_apart = !touched.Contains(it.Current());
    if (is_apart) apart.Add(face.face);
  }
  return apart;
}

// Whether no face is left of a solid, though some have none of the edges: blends consume the faces
// beside them, as a ball does those of a cube, but what parts nothing from the rest takes all.
bool takes_all(const BodyEdges& body, const TopoDS_Solid& before, const FilletedSolid& made,
               const FilletEdges& edges) {
  if (std::ranges::any_of(made.faces, [](const FilletFace& face) { return face.from > 0; }))
    return false;
  std::set<int> beside;
  for (const auto& [edge, concave] : edges)
    for (const bool forward : {true, false}) beside.insert(body.use(edge, forward).face);
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(before, TopAbs_FACE, all);
  return beside.size() < static_cast<std::size_t>(all.Extent());
}

}  // namespace

void check_blended(const BodyEdges& body, const TopoDS_Solid& before, const FilletedSolid& made,
                   const FilletEdges& edges, double change) {
  const int first = edges.begin()->first;
  const TopTools_MapOfShape known = kept_faces(body, made);
  const bool valid = is_valid(made.solid, apart_from_changes(made, known)) ||
                     (is_valid(made.solid, known) && !BRepCheck_Analyzer(before).IsValid());
  if (const auto fault = new_fault(body, made, known, valid, first)) throw FilletRefused(*fault);
  if (!valid)
    throw FilletRefused({FilletFault::Result,
                         first,
                         "the solid that comes out is not valid by BRepCheck",
                         {},
                         {},
                         {}});
  if (takes_all(body, before, made, edges))
    throw FilletRefused(
        {FilletFault::Result, first, "nothing would be left of the solid", {}, {}, {}});
  const bool any_concave = std::ranges::any_of(edges, [](const auto& e) { return e.second; });
  const bool any_convex = std::ranges::any_of(edges, [](const auto& e) { return !e.second; });
  if ((!any_concave && change >= 0) || (!any_convex && change <= 0))
    throw FilletRefused({FilletFault::Result,
                         first,
                         std::string("the volume does not get ") +
                             (any_convex ? "smaller" : "larger") + " as it should",
                         {},
                         {},
                         {}});
}

namespace {

bool is_plane(const TopoDS_Face& face) {
  return !Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face)).IsNull();
}

// The faces that a face has no vertex in common with although their boxes meet. Two planes of the
// sheet, as walls at the ends of strips are, may meet in a vertex and go through each other.
// boxes   of all faces
std::vector<TopoDS_Face> strangers(const FilletedSolid& made, std::size_t place,
                                   const std::vector<Bnd_Box>& boxes) {
  const TopoDS_Face& face = made.faces[place].face;
  TopTools_IndexedMapOfShape own;
  TopExp::MapShapes(face, own);
  const bool of_plane = is_plane(face);
  std::vector<TopoDS_Face> found;
  for (std::size_t i = 0; i < made.faces.size(); ++i) {
    if (boxes[place].IsOut(boxes[i])) continue;
    const FilletFace& other = made.faces[i];
    bool known = other.face.IsSame(face);
    const bool both_planes = of_plane && other.from == 0 && is_plane(other.face);
    TopExp_Explorer it(other.face, both_planes ? TopAbs_EDGE : TopAbs_VERTEX);
    for (; it.More() && !known; it.Next()) known = own.Contains(it.Current());
    if (!known) found.push_back(other.face);
  }
  return found;
}

}  // namespace

void check_apart(const FilletedSolid& made, const IntersectionOptions& options,
                 const std::function<void()>& tick) {
  std::vector<Bnd_Box> boxes(made.faces.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = bounds_of(made.faces[i].face);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const FilletFace& blend = made.faces[i];
    if (blend.from > 0) continue;
    tick();
    const std::vector<TopoDS_Face> others = strangers(made, i, boxes);
    if (others.empty()) continue;
    const ShapeIntersection found = intersect({blend.face}, others, options);
    for (const FaceIntersection& pair : found.pairs) {
      if (pair.found.curves.empty()) continue;
      const TopoDS_Face& met = others[static_cast<std::size_t>(pair.face_b)];
      const auto of = std::ranges::find_if(
          made.faces, [&](const FilletFace& face) { return face.face.IsSame(met); });
      throw FilletRefused({FilletFault::Interference,
                           blend.edge,
                           of->from > 0 ? "its strip runs into face " + std::to_string(of->from)
                                        : "its strip runs into another one",
                           {},
                           pair.found.curves.front().samples.front().point,
                           {}});
    }
  }
}

}  // namespace blossom::occt
