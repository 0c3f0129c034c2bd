// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/validity/own_contacts.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/shared_limit.h"
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

}  // namespace

std::vector<Finding> own_contacts(const TrimTool& input, int tool,
                                  const IntersectionOptions& options) {
  const SharedLimit limit(options);
  TopTools_IndexedMapOfShape places;
  for (const TopoDS_Face& face : input.faces) places.Add(face);
  std::vector<Finding> all;
  for (const TopoDS_Solid& solid : input.solids) {
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(solid, TopAbs_FACE, own);
    std::vector<TopoDS_Face> faces;
    for (int i = 1; i <= own.Extent(); ++i) faces.push_back(TopoDS::Face(own(i)));
    const auto input_face = [&](int face) {
      return InputFace{tool, places.FindIndex(faces[static_cast<std::size_t>(face)]) - 1};
    };
    for (const FaceIntersection& pair :
         self_intersect(faces, SelfScope::AllFaces, limit.remaining()).pairs) {
      const auto contact = contact_of(pair.found);
      if (!contact) continue;
      Finding made{
          FindingCode::InputMeetsItself, {input_face(pair.face_a)}, contact->point, contact->size};
      if (pair.face_b != pair.face_a) made.faces.push_back(input_face(pair.face_b));
      all.push_back(made);
    }
  }
  return all;
}

}  // namespace blossom::occt
