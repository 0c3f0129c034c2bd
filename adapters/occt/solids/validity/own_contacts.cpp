// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/validity/own_contacts.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

// A point that both faces have, and how long what they have in common is.
struct OwnContact {
  Vec3 point;
  double size = 0;
};

// Of regions the border, else the longest curve, else a point; nothing where a search stayed open.
std::optional<OwnContact> contact_of(const SurfaceIntersection& found) {
  for (const Overlap& region : found.overlaps)
    if (!region.boundary.empty()) {
      OwnContact of{region.boundary.front().point};
      for (const SurfacePoint& at : region.boundary)
        of.size = std::max(of.size, distance(at.point, of.point));
      return of;
    }
  if (!found.curves.empty()) {
    const IntersectionCurve& longest =
        *std::ranges::max_element(found.curves, {}, &IntersectionCurve::length);
    return OwnContact{longest.samples[longest.samples.size() / 2].point, longest.length};
  }
  if (!found.points.empty()) return OwnContact{found.points.front().point};
  return std::nullopt;
}

// A solid of an input, or all faces of one that has none.
struct Body {
  const TrimTool& input;
  int tool = 0;        // as in `InputFace`
  TopoDS_Solid solid;  // null: the faces
  Bnd_Box box;
};

void add_bodies(const TrimTool& input, int tool, std::vector<Body>& bodies) {
  for (const TopoDS_Solid& solid : input.solids)
    bodies.push_back({input, tool, solid, bounds_of(solid)});
  if (input.is_solid()) return;
  Bnd_Box box;
  for (const TopoDS_Face& face : input.faces) box.Add(bounds_of(face));
  bodies.push_back({input, tool, {}, box});
}

// Options for each pair of faces.
IntersectionOptions share_of_pair(IntersectionOptions options, std::size_t faces) {
  options.budget =
      std::max(options.budget / static_cast<long>(std::max<std::size_t>(faces, 1)), 1L);
  options.contact_budget = options.budget;
  return options;
}

void add_contacts(const Body& of, const IntersectionOptions& options, std::vector<Finding>& all) {
  TopTools_IndexedMapOfShape places, own;
  for (const TopoDS_Face& face : of.input.faces) places.Add(face);
  TopExp::MapShapes(of.solid, TopAbs_FACE, own);
  std::vector<TopoDS_Face> faces;
  for (int i = 1; i <= own.Extent(); ++i) faces.push_back(TopoDS::Face(own(i)));
  const auto input_face = [&](int face) {
    return InputFace{of.tool, places.FindIndex(faces[static_cast<std::size_t>(face)]) - 1};
  };
  const ShapeIntersection found =
      self_intersect(faces, SelfScope::AllFaces, share_of_pair(options, faces.size()));
  for (const FaceIntersection& pair : found.pairs) {
    const auto contact = contact_of(pair.found);
    if (!contact) continue;
    Finding made{
        FindingCode::InputMeetsItself, {input_face(pair.face_a)}, contact->point, contact->size};
    if (pair.face_b != pair.face_a) made.faces.push_back(input_face(pair.face_b));
    all.push_back(made);
  }
}

}  // namespace

std::vector<Finding> own_contacts(const TrimTool& part, const std::vector<TrimTool>& tools,
                                  const IntersectionOptions& options) {
  const SharedLimit limit(options);
  std::vector<Body> bodies;
  add_bodies(part, -1, bodies);
  for (std::size_t i = 0; i < tools.size(); ++i) add_bodies(tools[i], static_cast<int>(i), bodies);
  const auto meets_others = [&](const Body& body) {
    return std::ranges::any_of(
        bodies, [&](const Body& other) { return &other != &body && !other.box.IsOut(body.box); });
  };
  std::vector<Finding> all;
  for (const Body& body : bodies)
    if (!body.solid.IsNull() && meets_others(body) && !limit.is_reached())
      add_contacts(body, limit.remaining(), all);
  return all;
}

}  // namespace blossom::occt
