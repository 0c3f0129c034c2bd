// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/pair_search/pair_intersector.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/limits.h"
#include "adapters/occt/base/step_failure.h"
#include "adapters/occt/coincidence/conic_images.h"
#include "adapters/occt/coincidence/known_crossings.h"
#include "adapters/occt/coincidence/one_spline.h"
#include "adapters/occt/coincidence/one_surface.h"
#include "adapters/occt/coincidence/trimmed_overlaps.h"
#include "adapters/occt/faces/elementary_faces.h"
#include "adapters/occt/faces/face_data.h"
#include "adapters/occt/faces/pairs/edge_contacts.h"
#include "adapters/occt/faces/pairs/pole_contacts.h"
#include "adapters/occt/pair_search/arc_lines.h"
#include "adapters/occt/pair_search/pair_places.h"
#include "core/neighbours/along_shared_edges.h"
#include "core/neighbours/neighbour_proof.h"
#include "core/neighbours/sliver_spans.h"
#include "core/results/contact_places.h"
#include "core/results/result_places.h"
#include "core/surfaces/retry/exchanged_order.h"

namespace blossom::occt {
namespace {

constexpr double kSmoothAngle = 0.05;  // radians: so flat an edge is taken for smooth
constexpr double kExact = 1e-9;        // of the size: borders as near as this agree
// Of the length, about the root of tolerance times size, along which surfaces that touch keep
// within tolerance: what is no farther apart is one contact.
constexpr double kContactPart = 0.1;
constexpr const char* kNoTime = "the limit was reached before these faces were searched";

}  // namespace

FaceIntersection PairIntersector::of(const std::pair<int, int>& pair) const {
  FaceIntersection result;
  result.face_a = pair.first;
  result.face_b = pair.second;
  if (const FaceMatch* match = copies_.between(pair.first, pair.second))
    add_whole_face(*match, result);
  else if (limit_.is_reached())
    leave_open(result);
  else
    search(result);
  return result;
}

std::size_t PairIntersector::size_of(const std::pair<int, int>& pair) const {
  const auto points = [](const FaceData& data) {
    const auto& patches = data.surface.patches;
    return patches.values().size() * patches(0, 0).points.values().size();
  };
  return points(faces_a_.data(static_cast<std::size_t>(pair.first))) *
         points(faces_b_.data(static_cast<std::size_t>(pair.second)));
}

FaceIntersection PairIntersector::exchanged(FaceIntersection known,
                                            const std::pair<int, int>& pair) const {
  known.face_a = pair.first;
  known.face_b = pair.second;
  const FaceData& a = faces_a_.data(static_cast<std::size_t>(pair.first));
  const FaceData& b = faces_b_.data(static_cast<std::size_t>(pair.second));
  known.found = blossom::exchanged(std::move(known.found), a.surface, b.surface);
  add_shapes(a, b, known);
  return known;
}

// Curves as Open CASCADE has them, and the edges and vertices that points are on.
void PairIntersector::add_shapes(const FaceData& a, const FaceData& b,
                                 FaceIntersection& result) const {
  result.edges.clear();
  result.borders.clear();
  for (const IntersectionCurve& curve : result.found.curves)
    result.edges.push_back(edge_curves(curve));
  if (result.found.points.empty()) return;
  const auto [of_a, of_b] = shapes_of(result);
  for (const SurfacePoint& x : result.found.points)
    result.borders.push_back(
        {of_a.at(border_at(a.trims, x.uv_a)), of_b.at(border_at(b.trims, x.uv_b))});
}

std::array<TrimShapes, 2> PairIntersector::shapes_of(const FaceIntersection& pair) const {
  return {trim_shapes(faces_a_.face(static_cast<std::size_t>(pair.face_a))),
          trim_shapes(faces_b_.face(static_cast<std::size_t>(pair.face_b)))};
}

// Whatever the surface does, all of one face is in the other.
void PairIntersector::add_whole_face(const FaceMatch& match, FaceIntersection& result) const {
  const auto i = static_cast<std::size_t>(result.face_a);
  const auto j = static_cast<std::size_t>(result.face_b);
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  result.found.overlaps = {whole_overlap(faces_a_.face(i), a.trims, match.map, match.gap)};
  const auto [of_a, of_b] = shapes_of(result);
  for (const auto& [on_a, on_b] : match.edges)
    result.equal_edges.emplace_back(TopoDS::Edge(of_a.edges(on_a + 1)),
                                    TopoDS::Edge(of_b.edges(on_b + 1)));
  result.found.places = {whole_place(a, b, match.gap)};
  identify(result.found.certificate, match.gap);
  if (match.gap <= one_within(options_.tolerances, largest_coordinate(a, b))) return;
  result.found.status = Status::Tolerance;
  result.found.certificate.reasons = {"the surfaces coincide in the listed contacts"};
}

// Of faces that there was no time for nothing is known but where they may meet.
void PairIntersector::leave_open(FaceIntersection& result) const {
  const FaceData& a = faces_a_.data(static_cast<std::size_t>(result.face_a));
  const FaceData& b = faces_b_.data(static_cast<std::size_t>(result.face_b));
  result.found.places = {open_place(a, b)};
  result.found.status = Status::Stopped;
  result.found.certificate.limited = true;
  const IntersectionOptions left = limit_.remaining();
  const char* cancelled = WorkLimit(left).reached();
  result.found.certificate.reasons = {cancelled != nullptr ? cancelled : kNoTime};
}

void PairIntersector::search(FaceIntersection& result) const {
  const auto i = static_cast<std::size_t>(result.face_a);
  const auto j = static_cast<std::size_t>(result.face_b);
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  const TopoDS_Face &shape_a = faces_a_.face(i), &shape_b = faces_b_.face(j);
  const std::vector<SharedEdge> edges = copies_.shared(result.face_a, result.face_b);
  const double within = one_within(options_.tolerances, largest_coordinate(a, b));
  if (is_settled_by_neighbours(a, b, edges, result)) return;
  if (is_settled_by_closed_forms(i, j, edges, within, result.found)) return;
  std::vector<Touch> touches;
  std::vector<SharedEdge> touching;
  if (const auto gap = gap_of_one_surface(i, j); gap && *gap <= options_.tolerances.point) {
    result.found = on_surface_of_both({result.face_a, result.face_b}, edges, *gap, within);
  } else {
    if (edges.empty()) touching = touched_.of(result.face_a, result.face_b, kSmoothAngle);
    const std::vector<SharedEdge>& known = edges.empty() ? touching : edges;
    auto touches_of_known = find_known(i, j, known, within, result.found);
    touches =
        touches_of_known ? *std::move(touches_of_known) : find_between(i, j, known, result.found);
    drop_along_edges(result.found, touches, known, options_.tolerances.point);
    weaken_along_trims(a.trims, b.trims, within, result.found);
    add_touching(a, b, touching, options_.tolerances.point, result.found, touches);
    if (&a != &b) add_pole_contacts(i, j, result.found, touches);
  }
  result.chains =
      chains_over_seams(result.found.curves, a.surface, b.surface, options_.tolerances.point);
  if (edges.empty()) add_edge_contacts(shape_a, shape_b, result.found, touches);
  if (shared_ == Shared::Listed) {
    add_edges(edges, result);
  } else if (&a != &b) {
    if (!edges.empty()) drop_places_along_edges(result.found, edges, options_.tolerances.point);
    const std::array<TrimShapes, 2> shapes = shapes_of(result);
    const auto is_shared = [&](const SurfacePoint& x) {
      const TopoDS_Shape on_a = shapes[0].at(border_at(a.trims, x.uv_a));
      return !on_a.IsNull() && on_a.IsSame(shapes[1].at(border_at(b.trims, x.uv_b)));
    };
    std::erase_if(result.found.points, is_shared);
    std::erase_if(touches, [&](const Touch& touch) { return is_shared(touch.at); });
  }
  add_touches(touches, options_.tolerances.point, within, result.found);
  trust_approximations(a.surface.error + b.surface.error, result.found);
  add_shapes(a, b, result);
}

// Places nearer than the tolerance are listed. If trims and shared edges leave nothing, what is
// approximated within less does not meet either. Where a result is not complete, approximations
// are among the reasons: a single one is theirs.
void PairIntersector::trust_approximations(double error, SurfaceIntersection& found) const {
  const bool apart = found.curves.empty() && found.points.empty() && found.nodes.empty() &&
                     found.overlaps.empty() && found.places.empty();
  if (!apart || found.status != Status::Tolerance || !(error > 0) ||
      error >= options_.tolerances.point || found.certificate.reasons.size() != 1)
    return;
  found.status = Status::Complete;
  found.certificate.reasons.clear();
}

// What two faces share may be all that they have in common.
bool PairIntersector::is_settled_by_neighbours(const FaceData& a, const FaceData& b,
                                               const std::vector<SharedEdge>& edges,
                                               FaceIntersection& result) const {
  if (&a == &b || (shared_ == Shared::Listed && edges.empty())) return false;
  const IntersectionOptions left = limit_.remaining();
  const std::vector<SharedVertex> vertices =
      shared_vertices(faces_a_.face(static_cast<std::size_t>(result.face_a)),
                      faces_b_.face(static_cast<std::size_t>(result.face_b)));
  NeighbourProof proof =
      meet_in_shared_only(a, b, edges, vertices, left.tolerances.point, WorkLimit(left));
  if (!proof.proven) return false;
  result.found.certificate = std::move(proof.certificate);
  if (shared_ == Shared::Listed) add_edges(edges, result);
  add_shapes(a, b, result);
  return true;
}

// What two surfaces have in common by closed forms may be the edges that the faces share.
bool PairIntersector::is_settled_by_closed_forms(std::size_t i, std::size_t j,
                                                 const std::vector<SharedEdge>& edges,
                                                 double within, SurfaceIntersection& found) const {
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  if (&a == &b || edges.empty() || shared_ == Shared::Listed) return false;
  auto known = known_crossings(faces_a_.face(i), a, faces_b_.face(j), b, common_box(a, b), within,
                               options_.tolerances.point);
  if (!known || known->curves.empty()) return false;
  std::vector<Touch> touches = clip_known(i, j, *known);
  drop_along_edges(*known, touches, edges, options_.tolerances.point);
  const bool is_all = known->status == Status::Complete && known->curves.empty() &&
                      known->points.empty() && known->nodes.empty() && known->overlaps.empty() &&
                      known->places.empty() && touches.empty();
  if (is_all) found = *std::move(known);
  return is_all;
}

// A bound on the distance of two surfaces of one kind where the faces may meet.
std::optional<double> PairIntersector::gap_of_one_surface(std::size_t i, std::size_t j) const {
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  if (&a == &b) return {};
  const Box common = common_box(a, b);
  const Ball ball{0.5 * (common.low + common.high), 0.5 * diagonal(common)};
  if (a.elementary && b.elementary)
    return distance_bound(*a.elementary, *b.elementary, ball) + a.off_elementary + b.off_elementary;
  if (a.swept && b.swept) return gap_of_one_sweep(*a.swept, *b.swept, ball, options_.tolerances);
  return gap_of_one_spline(faces_a_.face(i), faces_b_.face(j), limit_.remaining());
}

// What the outlines leave open is listed.
SurfaceIntersection PairIntersector::on_surface_of_both(const std::pair<int, int>& pair,
                                                        const std::vector<SharedEdge>& edges,
                                                        double gap, double within) const {
  const auto i = static_cast<std::size_t>(pair.first), j = static_cast<std::size_t>(pair.second);
  const IntersectionOptions left = limit_.remaining();
  SurfaceIntersection found;
  const std::string failure = failure_of("laying two outlines over each other", [&] {
    found = on_one_surface(faces_a_.face(i), faces_b_.face(j), edges, gap, within,
                           left.tolerances.point, WorkLimit(left));
  });
  if (!failure.empty()) {
    found.status = Status::Stopped;
    found.certificate.reasons.push_back(failure);
  }
  if (found.status == Status::Stopped)
    found.places.push_back(open_place(faces_a_.data(i), faces_b_.data(j)));
  return found;
}

// Quadrics in special positions cross in conics, or touch. Their images were only sampled before
// they were clipped; where one turns out to be off, a search tells what there is.
std::optional<std::vector<Touch>> PairIntersector::find_known(std::size_t i, std::size_t j,
                                                              const std::vector<SharedEdge>& edges,
                                                              double within,
                                                              SurfaceIntersection& found) const {
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  if (&a == &b || !edges.empty()) return {};
  const double tolerance = options_.tolerances.point;
  auto known = known_crossings(faces_a_.face(i), a, faces_b_.face(j), b, common_box(a, b), within,
                               tolerance);
  if (!known) return {};
  std::vector<Touch> touches = clip_known(i, j, *known);
  double gap = tolerance;
  for (const Place& place : known->places) gap = std::max(gap, place.gap_high);
  for (const IntersectionCurve& curve : known->curves)
    if (!(std::max(curve.deviation.a, curve.deviation.b) <= 2 * kImageOff * gap)) return {};
  found = *std::move(known);
  return touches;
}

std::vector<Touch> PairIntersector::clip_known(std::size_t i, std::size_t j,
                                               SurfaceIntersection& found) const {
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  if (found.curves.empty()) return clip(found, a.trims, &b.trims);
  const FaceTrims trims_a = cutting_trims(a.trims), trims_b = cutting_trims(b.trims);
  std::vector<Touch> touches = clip(found, trims_a, &trims_b, options_.tolerances.point);
  prove_deviations(faces_a_.face(i), a, faces_b_.face(j), b, options_.tolerances.point, found);
  return touches;
}

std::vector<Touch> PairIntersector::find_between(std::size_t i, std::size_t j,
                                                 const std::vector<SharedEdge>& edges,
                                                 SurfaceIntersection& found) const {
  found = between(i, j, edges);
  const std::vector<Overlap> whole = found.overlaps;
  const std::vector<Touch> touches = clip(found, faces_a_.data(i).trims, &faces_b_.data(j).trims, 0,
                                          std::max(kOnWire, options_.tolerances.point));
  if (found.overlaps.size() < whole.size()) add_overlaps(i, j, whole, found);
  return touches;
}

// Planes that cross do so in a line; all else is searched, and where planes at a small angle keep
// within tolerance of each other beside their line.
SurfaceIntersection PairIntersector::between(std::size_t i, std::size_t j,
                                             const std::vector<SharedEdge>& edges) const {
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  if (&a == &b) return with_itself(a, options_for(a, b, edges));
  auto line = crossing_of_planes(
      BRep_Tool::Surface(faces_a_.face(i)), BRep_Tool::Surface(faces_b_.face(j)), common_box(a, b),
      kBeyondBox * std::max(diagonal(a.box), diagonal(b.box)), options_.tolerances.point);
  if (!line) return found_between(i, j, edges);
  if (line->curves.empty() || line->curves.front().least_angle > kSlowAngle)
    return *std::move(line);
  SurfaceIntersection found = found_between(i, j, edges);
  found.curves = std::move(line->curves);
  return found;
}

// A curve that touches the line between two spans of an arc may stay open there, or look like a
// contact of the surfaces; the line is our own choice, so it is put elsewhere then. Not the seam of
// a whole turn: there both have theirs.
SurfaceIntersection PairIntersector::found_between(std::size_t i, std::size_t j,
                                                   const std::vector<SharedEdge>& edges) const {
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  SurfaceIntersection found = intersect(a.surface, b.surface, options_for(a, b, edges));
  if (found.certificate.limited ||
      !may_be_of_arc_lines(found, a.surface, b.surface, options_.tolerances.point))
    return found;
  SurfaceIntersection again = intersect(faces_a_.with_shifted_arcs(i),
                                        faces_b_.with_shifted_arcs(j), options_for(a, b, edges));
  const bool settles = found.status == Status::Stopped ? again.status != Status::Stopped
                                                       : again.status == Status::Complete;
  return settles ? again : found;
}

IntersectionOptions PairIntersector::options_for(const FaceData& a, const FaceData& b,
                                                 const std::vector<SharedEdge>& edges) const {
  IntersectionOptions options = limit_.remaining();
  const double size = std::min(diagonal(a.box), diagonal(b.box));
  for (const SharedEdge& edge : edges) {
    KnownCurve known = known_curve(edge, size);
    if (edge.curve.least_angle < kSmoothAngle || known.gap > kExact * size)
      options.known.push_back(std::move(known));
  }
  options.part_a = part_test(a.trims);
  options.part_b = part_test(b.trims);
  return options;
}

void PairIntersector::add_edges(const std::vector<SharedEdge>& edges, FaceIntersection& result) {
  for (const SharedEdge& edge : edges) {
    const int place = static_cast<int>(result.found.curves.size());
    result.chains.push_back({{{place, true}}, edge.curve.closed});
    result.found.curves.push_back(edge.curve);
  }
}

// Where something stays within tolerance, but no curve or region tells what, the faces may have
// single points of their outlines in common. What is said of those at other places is less exact.
void PairIntersector::add_edge_contacts(const TopoDS_Face& a, const TopoDS_Face& b,
                                        SurfaceIntersection& found,
                                        std::vector<Touch>& touches) const {
  if (found.status != Status::Tolerance || !found.curves.empty() || !found.overlaps.empty() ||
      a.IsSame(b))
    return;
  const double reach = 2 * options_.tolerances.point;
  for (const auto& [x, gap, crosses] : outline_contacts(a, b, options_.tolerances.point).points) {
    const auto is_here = [&, &point = x.point](const SurfacePoint& known) {
      return distance(known.point, point) <= reach;
    };
    if (std::ranges::any_of(found.points, is_here) ||
        std::ranges::any_of(touches, is_here, &Touch::at))
      continue;
    std::erase_if(found.places, [&, &point = x.point](const Place& place) {
      return place.kind == PlaceKind::Touch && distance(place.box_low, point) <= reach &&
             distance(place.box_high, point) <= reach;
    });
    touches.push_back({x, gap});
  }
}

// A curve, point or place that is near tells of the pole as well.
void PairIntersector::add_pole_contacts(std::size_t i, std::size_t j,
                                        const SurfaceIntersection& found,
                                        std::vector<Touch>& touches) const {
  const FaceData &a = faces_a_.data(i), &b = faces_b_.data(j);
  const double tolerance = options_.tolerances.point;
  const double reach =
      kContactPart * std::sqrt(tolerance * std::min(diagonal(a.box), diagonal(b.box)));
  for (const Touch& touch : pole_contacts(faces_a_.face(i), a, faces_b_.face(j), b, tolerance)) {
    const Vec3& pole = touch.at.point;
    const auto holds = [&](const Place& place) {
      return meet(widened({place.box_low, place.box_high}, tolerance), {pole, pole});
    };
    const auto is_here = [&](const Touch& known) {
      return distance(known.at.point, pole) <= reach;
    };
    if (!is_known_contact(found, pole, reach) && !is_on_curve(found, pole, reach) &&
        std::ranges::none_of(found.places, holds) && std::ranges::none_of(touches, is_here))
      touches.push_back(touch);
  }
}

// What the trims leave of common regions of the surfaces.
void PairIntersector::add_overlaps(std::size_t i, std::size_t j, const std::vector<Overlap>& whole,
                                   SurfaceIntersection& found) const {
  TrimmedOverlaps trimmed;
  const IntersectionOptions left = limit_.remaining();
  const std::string failure = failure_of("clipping a common region", [&] {
    trimmed = trimmed_overlaps(faces_a_.face(i), faces_b_.face(j), whole, left.tolerances.point,
                               WorkLimit(left));
  });
  if (!failure.empty()) {
    trimmed.complete = false;
    found.certificate.reasons.push_back(failure);
  }
  found.overlaps = std::move(trimmed.regions);
  std::erase_if(found.places, [](const Place& place) { return place.kind == PlaceKind::Overlap; });
  for (const Overlap& region : found.overlaps)
    if (!region.boundary.empty())
      found.places.push_back(
          place_of(region.boundary, PlaceKind::Overlap, region.gap_high, left.tolerances.point));
    else  // it is all there is
      found.places.push_back(whole_place(faces_a_.data(i), faces_b_.data(j), region.gap_high));
  if (trimmed.complete) return;
  found.places.push_back(open_place(faces_a_.data(i), faces_b_.data(j)));
  found.status = Status::Stopped;
  found.certificate.reasons.emplace_back(
      trimmed.stopped != nullptr ? trimmed.stopped
                                 : "the trims divide a common region in an unknown way");
}

}  // namespace blossom::occt
