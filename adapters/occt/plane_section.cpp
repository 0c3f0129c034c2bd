// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/plane_section.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/coincidence/known_crossings.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/face_data.h"
#include "adapters/occt/faces/face_list.h"
#include "adapters/occt/queries/section_frame.h"
#include "adapters/occt/queries/section_nodes.h"
#include "adapters/occt/queries/section_sides.h"
#include "adapters/occt/queries/section_wires.h"
#include "core/base/parallel.h"
#include "core/results/contact_places.h"
#include "core/surface_intersection.h"

namespace blossom::occt {
namespace {

constexpr double kFar = 1e-2;  // of a curve's length: where it ends off all edges, the nearest node

class FaceSections {
 public:
  FaceSections(FaceList& faces, const std::vector<TopoDS_Edge>& edges, const Plane& plane,
               const IntersectionOptions& options)
      : frame_(plane),
        options_(options),
        tolerance_(options.tolerances.point),
        faces_(faces),
        edges_(edges) {}

  PlaneSection run() {
    prepare();
    SectionNodes nodes(frame_, options_, faces_.size(), section_);
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (asked_[i]) nodes.add_edges(i, faces_.face(i));
    nodes.add_loose(edges_);
    std::vector<SurfaceIntersection> found(faces_.size());
    parallel_for(faces_.size(), 1, [&](std::size_t i) {
      if (searched_[i]) found[i] = search(i);
    });
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (searched_[i]) add_face(i, found[i], nodes);
    nodes.join_free_ends();
    section_.points = nodes.lone_nodes();
    find_bounding_curves(faces_, asked_, in_plane_, frame_.normal(), section_);
    chain_wires(section_, frame_.normal());
    return std::move(section_);
  }

 private:
  void prepare() {
    asked_.assign(faces_.size(), 0);
    searched_.assign(faces_.size(), 0);
    in_plane_.assign(faces_.size(), 0);
    std::vector<char> near(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i)
      near[i] = !heights_of(faces_.hull(i), frame_).apart(tolerance_);
    faces_.convert(near);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (!near[i]) continue;
      const Heights heights = heights_of(faces_.data(i).surface, frame_);
      if (heights.apart(tolerance_)) continue;
      asked_[i] = 1;
      in_plane_[i] = heights.within(tolerance_);
      searched_[i] = !in_plane_[i];
      if (searched_[i])
        ++section_.faces_searched;
      else
        section_.faces_in_plane.push_back(static_cast<int>(i));
    }
  }

  SurfaceIntersection search(std::size_t i) const {
    const FaceData& face = faces_.data(i);
    IntersectionOptions options = limit_.remaining();
    options.part_a = part_test(face.trims);
    if (auto conics = known(i)) return *std::move(conics);
    SurfaceIntersection found = intersect(face.surface, frame_.over(face.box), options);
    // What is proven at edges and vertices follows from those, so touches weaken nothing.
    for (const Touch& touch : clip(found, face.trims, nullptr)) found.points.push_back(touch.at);
    return found;
  }

  // What the plane and a quadric have in common, or a torus that it cuts in circles.
  std::optional<SurfaceIntersection> known(std::size_t i) const {
    const FaceData& face = faces_.data(i);
    if (!face.elementary) return {};
    const TopoDS_Face rectangle = frame_.face_over(face.box);
    const FaceData plane = face_data(rectangle, tolerance_);
    auto found =
        known_crossings(faces_.face(i), face, rectangle, plane, face.box, tolerance_, tolerance_);
    if (!found) return {};
    for (const Touch& touch : clip(*found, cutting_trims(face.trims), nullptr, tolerance_))
      found->points.push_back(touch.at);
    prove_deviations(faces_.face(i), face, rectangle, plane, tolerance_, *found);
    return found;
  }

  void add_face(std::size_t i, const SurfaceIntersection& found, SectionNodes& nodes) {
    section_.status = weaker(section_.status, found.status);
    add(section_.certificate, found.certificate);
    // First where curves end that end on no edge.
    for (const auto* contacts : {&found.points, &found.nodes})
      for (const SurfacePoint& contact : *contacts)
        nodes.contact_node(i, contact.point, contact_reach(found, contact.point));
    for (const Place& place : found.places) section_.places.push_back({static_cast<int>(i), place});
    for (const IntersectionCurve& curve : found.curves)
      for (const IntersectionCurve& part : curve_parts(curve, nodes.beside_edges(i, curve)))
        add_curve(i, part, found, nodes);
  }

  void add_curve(std::size_t face, const IntersectionCurve& found,
                 const SurfaceIntersection& of_face, SectionNodes& nodes) {
    const EdgeCurves curves = edge_curves(found);
    const Deviation& d = found.deviation;
    SectionCurve curve;
    curve.face = static_cast<int>(face);
    curve.curve = basis_of(curves.curve);
    curve.conic = found.conic;
    curve.pcurve = curves.pcurve_a;
    curve.range = found.curve.domain();
    curve.tolerance = curves.tolerance;
    curve.closed = found.closed;
    curve.tangential = found.tangential;
    curve.length = found.length;
    curve.deviation = std::max(d.a, d.b);  // it has no image in the plane's parameters
    curve.deviation_proven = d.proven;
    for (const SurfacePoint& x : found.samples) curve.samples.push_back(x.point);
    const double far = kFar * curve.length;
    if (!found.closed)
      for (const std::size_t side : {0, 1}) {
        const Vec3& end = side == 0 ? curve.samples.front() : curve.samples.back();
        const double reach = std::max(curve.tolerance, contact_reach(of_face, end));
        curve.nodes[side] = nodes.end_node(face, end, reach, far);
      }
    section_.curves.push_back(std::move(curve));
  }

  SectionFrame frame_;
  const IntersectionOptions& options_;
  const SharedLimit limit_{options_};
  double tolerance_;
  FaceList& faces_;
  const std::vector<TopoDS_Edge>& edges_;  // without faces
  std::vector<char> asked_;                // faces that may have a point in the plane
  std::vector<char> in_plane_;
  std::vector<char> searched_;  // asked but not in the plane
  PlaneSection section_;
};

}  // namespace

PlaneSection plane_section(const std::vector<TopoDS_Face>& faces, const Plane& plane,
                           const IntersectionOptions& options,
                           const std::vector<TopoDS_Edge>& edges) {
  return SectionedFaces(faces, options.tolerances.point, edges).section(plane, options);
}

struct SectionedFaces::Impl {
  Impl(std::vector<TopoDS_Face> all, double tolerance, std::vector<TopoDS_Edge> loose)
      : faces(std::move(all)),
        edges(std::move(loose)),
        list(faces, "", tolerance, Extent::Trims, ArcCuts::Shifted) {}

  std::vector<TopoDS_Face> faces;
  std::vector<TopoDS_Edge> edges;
  FaceList list;
};

SectionedFaces::SectionedFaces(std::vector<TopoDS_Face> faces, double tolerance,
                               std::vector<TopoDS_Edge> edges)
    : impl_(std::make_unique<Impl>(std::move(faces), tolerance, std::move(edges))) {}
SectionedFaces::~SectionedFaces() = default;
SectionedFaces::SectionedFaces(SectionedFaces&&) noexcept = default;
SectionedFaces& SectionedFaces::operator=(SectionedFaces&&) noexcept = default;

const std::vector<TopoDS_Face>& SectionedFaces::faces() const { return impl_->faces; }

PlaneSection SectionedFaces::section(const Plane& plane, const IntersectionOptions& options) {
  PlaneSection section;
  with_threads(options.threads,
               [&] { section = FaceSections(impl_->list, impl_->edges, plane, options).run(); });
  return section;
}

}  // namespace blossom::occt
