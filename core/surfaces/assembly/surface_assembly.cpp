// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/assembly/surface_assembly.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "core/base/unbounded.h"
#include "core/base/work_limit.h"
#include "core/cells/limits.h"
#include "core/forms/evaluation.h"
#include "core/results/contact_places.h"
#include "core/results/result_places.h"
#include "core/surfaces/adjacency/smooth_neighbours.h"
#include "core/surfaces/assembly/border_strip.h"
#include "core/surfaces/assembly/chain_fits.h"
#include "core/surfaces/branches/arc_chains.h"
#include "core/surfaces/branches/arcs_along_borders.h"
#include "core/surfaces/branches/chains_at_poles.h"
#include "core/surfaces/branches/found_places.h"
#include "core/surfaces/branches/shared_borders.h"
#include "core/surfaces/branches/spurious_branches.h"
#include "core/surfaces/coincidence/overlaps.h"
#include "core/surfaces/contacts/contact_arms.h"
#include "core/surfaces/contacts/contact_chains.h"
#include "core/surfaces/contacts/contact_reach.h"
#include "core/surfaces/contacts/critical_places.h"
#include "core/surfaces/search/pair_search.h"
#include "core/surfaces/search/self_search.h"
#include "core/tracing/trace.h"

namespace blossom {
namespace {

constexpr double kOnCurve = 1e-4;       // of the surfaces' size
constexpr double kRoundings = 0x1p-46;  // of the coordinates: so far rounding moves a border

// Tolerances: two cells no larger than one, whose boxes meet, hold no points farther apart.
constexpr double kThinGap = 2;

// Narrower common regions are not told from contacts; times the root of tolerance and size.
constexpr double kRegionWidth = 3;

constexpr const char* kSharedBorder = "the surfaces touch along a common border";

class Assembly {
 public:
  Assembly(const BoxedSurface& a, const BoxedSurface& b, const IntersectionOptions& options)
      : a_(a.surface),
        b_(b.surface),
        options_(options),
        limit_(options),
        boxes_a_(a.boxes),
        boxes_b_(b.boxes),
        size_(std::max(diagonal(boxes_a_.all()), diagonal(boxes_b_.all()))),
        origin_(0.5 * (boxes_a_.all().low + boxes_a_.all().high)),
        known_(options.known, origin_) {}

  SurfaceIntersection run() {
    SurfaceCells cells_a(a_, origin_, options_.form, kSurfaceOffMiddle, options_.part_a);
    if (itself()) {
      found_ = search_itself(cells_a, origin_, size_, known_, options_);
      result_.certificate = found_.certificate;
      return joined_from(cells_a, cells_a);
    }
    SurfaceCells cells_b(b_, origin_, options_.form, kSurfaceOffMiddle, options_.part_b);
    std::vector<StartPair> pairs;
    for (const auto& [i, j] : meeting_patches(boxes_a_, boxes_b_, options_.tolerances.point))
      pairs.push_back({i, 0, j, 0});
    const NeighbourContacts neighbours =
        take_neighbours(cells_a, cells_b, pairs, options_.tolerances.point, limit_);
    shared_gap_ = neighbours.gap;
    found_ = search_pairs(cells_a, cells_b, pairs, size_, known_, options_);
    add(neighbours, found_);
    drop_beside_known(cells_a);
    result_.certificate = found_.certificate;
    if (neighbours.touch) weaken(Status::Tolerance, kSharedBorder);
    return joined_from(cells_a, cells_b);
  }

 private:
  bool itself() const { return &a_ == &b_; }

  SurfaceIntersection joined_from(SurfaceCells& cells_a, SurfaceCells& cells_b) {
    drop_beside_contacts(found_, cells_a, cells_b, options_.tolerances.point);
    if (!itself()) add_overlaps(cells_a, cells_b);
    clusters_ = clusters_of(found_.critical);
    join_singular(clusters_, options_.tolerances.point);
    contacts_ =
        contact_chains(found_, cells_a, cells_b, clusters_, size_, options_.tolerances.point);
    drop_beside_known(cells_a);
    attach(loose_ends(found_, cells_a, cells_b, contacts_), found_, cells_a, cells_b, contacts_,
           size_, options_.tolerances.point);
    drop_spurious_branches(found_, cells_a, cells_b, contacts_, clusters_,
                           options_.tolerances.point);
    meet_in_centres(contacts_, cells_a, cells_b, found_, options_.tolerances.point);
    drop_regular(contacts_, found_, cells_a);
    std::vector<Chain> chains = chains_of(found_, cells_a, cells_b, contacts_, clusters_);
    straighten_at_poles(chains, found_, cells_a, cells_b, contacts_, size_,
                        options_.tolerances.point);
    put_on_borders(found_, cells_a, cells_b, kRoundings * (max_norm(origin_) + size_));
    if (found_.stopped) result_.status = Status::Stopped;  // the search has given its reason
    if (found_.along_border) weaken(Status::Tolerance, "a curve runs along a border or knot line");
    for (SurfaceCells* cells : {&cells_a, &cells_b}) cells->drop_cells();
    std::vector<std::optional<IntersectionCurve>> fits = fits_of(cells_a, cells_b, chains);
    for (std::size_t i = 0; i < chains.size(); ++i)
      fits[i] ? add_curve(cells_a, cells_b, chains[i], std::move(*fits[i]))
              : add_short(cells_a, cells_b, chains[i]);
    for (const CornerContact& corner_contact : lone_corner_contacts(found_, cells_a, cells_b))
      add_corner_contact(cells_a, cells_b, corner_contact);
    for (const ContactChain& contact : contacts_) {
      add_contact(cells_a, cells_b, contact);
      if (contact.passed_by) weaken(Status::Tolerance, kEndsBesideNode);
      result_.certificate.beside_node |= contact.passed_by;
    }
    for (const CriticalCluster& cluster : clusters_) add_place(cells_a, cells_b, cluster);
    for (const CriticalCluster& cluster : clusters_of(found_.slow))
      add_slow(cells_a, cells_b, cluster);
    if (found_.cut_by_samples)
      weaken(Status::Tolerance, "points, not a proof, tell where a curve near a contact ends");
    if (found_.beside_known) add_known_curves();
    note_approximations();
    return std::move(result_);
  }

  void weaken(Status status, const std::string& reason) {
    result_.status = weaker(result_.status, status);
    auto& reasons = result_.certificate.reasons;
    if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end())
      reasons.push_back(reason);
  }

  void stop_at_limit(const char* reason) {
    weaken(Status::Stopped, reason);
    result_.certificate.limited = true;
  }

  // Where smooth faces meet along a known curve, what rounding makes of their borders crosses there
  // again and again.
  void drop_beside_known(SurfaceCells& cells_a) {
    if (known_.empty()) return;
    for (FoundArc& arc : found_.arcs) {
      const RationalBezierPatch& patch = cells_a.tree(arc.patch_a).patch();
      const Point4 &p = arc.arc.from, &q = arc.arc.to;
      const auto is_near = [&](double t) {
        const Vec3 x = point_at(patch, at(Interval{p[0], q[0]}, t), at(Interval{p[1], q[1]}, t));
        return known_.hold({x, x});
      };
      arc.dropped = arc.dropped || (is_near(0) && is_near(0.5) && is_near(1));
      found_.beside_known = found_.beside_known || arc.dropped;
    }
  }

  // --- coincidence

  // Regions in which the surfaces coincide become overlaps, borders that they share arcs; the
  // critical pairs that these explain are taken out.
  void add_overlaps(SurfaceCells& cells_a, SurfaceCells& cells_b) {
    if (found_.cancelled) return;
    std::vector<CriticalPair> within_tolerance(found_.critical);
    std::erase_if(within_tolerance,
                  [](const CriticalPair& pair) { return !pair.within_tolerance; });
    const double tolerance = options_.tolerances.point;
    const auto is_large = [&](const CriticalCluster& c) {
      const double width = diagonal(c.box);
      return width > kPointCluster * size_ ||
             (width > kRegionWidth * std::sqrt(tolerance * size_) &&
              meets_border(c, within_tolerance));
    };
    if (std::ranges::none_of(clusters_of(within_tolerance), is_large)) return;
    const Overlaps overlaps =
        find_overlaps(cells_a, cells_b, within_tolerance, tolerance, size_, limit_);
    if (overlaps.stopped != nullptr) stop_at_limit(overlaps.stopped);
    for (const OverlapRegion& region : overlaps.regions) add_overlap(cells_a, cells_b, region);
    for (const SharedBorder& border : overlaps.edges) add_border(cells_a, cells_b, border);
  }

  void add_overlap(SurfaceCells& cells_a, SurfaceCells& cells_b, const OverlapRegion& region) {
    Overlap overlap;
    Place place{PlaceKind::Overlap, {}, {}, kUnbounded, 0, {}};
    place.parameters.fill({kUnbounded, -kUnbounded});
    Box box;
    std::vector<std::vector<SurfacePoint>> loops;
    for (const BoundaryLoop& loop : region.loops) {
      loops.emplace_back();
      for (const ContactPoint& p : loop) {
        const SurfacePoint x = surface_point(cells_a, cells_b, origin_, p);
        loops.back().push_back(x);
        box = joined(box, {x.point, x.point});
        widen(place, x, p.gap);
      }
      const auto is_first = [&](const SurfacePoint& x) {
        return distance(x.point, loops.back().front().point) <= options_.tolerances.point;
      };
      if (std::ranges::all_of(loops.back(), is_first)) loops.pop_back();  // round a pole
    }
    overlap.boundary = joined_loops(loops);
    for (const CriticalPair& pair : taken(Coincidence(region, cells_a))) {
      box = joined(box, {pair.low + origin_, pair.high + origin_});
      widen(place, parameters_of(cells_a, cells_b, pair));
      place.gap_low = 0;
      place.gap_high = options_.tolerances.point;
    }
    overlap.gap_high = place.gap_high;
    const double r = options_.tolerances.point;
    place.box_low = box.low - Vec3{r, r, r};
    place.box_high = box.high + Vec3{r, r, r};
    result_.places.push_back(place);
    result_.overlaps.push_back(std::move(overlap));
    weaken(Status::Tolerance, "the surfaces coincide in the listed contacts");
  }

  // The critical pairs in a region or along a border, taken out of the search's.
  std::vector<CriticalPair> taken(const Coincidence& coincidence) {
    const auto rest = std::stable_partition(
        found_.critical.begin(), found_.critical.end(), [&](const CriticalPair& pair) {
          return !pair.within_tolerance || !coincidence.holds(pair);
        });
    const std::vector<CriticalPair> result(rest, found_.critical.end());
    found_.critical.erase(rest, found_.critical.end());
    return result;
  }

  // Where the surfaces also stay within tolerance beside it, more may lie there.
  void add_border(const SurfaceCells& a, const SurfaceCells& b, const SharedBorder& border) {
    if (!add_shared_border(border, found_)) return;
    if (!border.wide)
      strips_.push_back(
          border_strip(a, b, origin_, taken(Coincidence(border, a, b)), options_.tolerances.point));
    for (const ContactPoint& p : border.path) shared_gap_ = std::max(shared_gap_, p.gap);
    weaken(Status::Tolerance, kSharedBorder);
  }

  void add_corner_contact(SurfaceCells& cells_a, SurfaceCells& cells_b,
                          const CornerContact& corner_contact) {
    const SurfacePoint contact =
        surface_point(cells_a, cells_b, origin_,
                      {corner_contact.patch_a, corner_contact.patch_b, corner_contact.x});
    const Vec3& x = contact.point;
    if (is_known_contact(result_, x, contact_length()) ||
        ends_curve(result_, x, contact_length()) || in_cluster(x) || in_contact(x) || on_curve(x))
      return;
    result_.points.push_back(contact);
    Place place = place_at(contact, options_.tolerances.point);
    place.kind = PlaceKind::Touch;
    result_.places.push_back(place);
    weaken(Status::Tolerance, kTouchInPlaces);
  }

  // What has not been fitted in time is listed as not traced.
  std::vector<std::optional<IntersectionCurve>> fits_of(SurfaceCells& cells_a,
                                                        SurfaceCells& cells_b,
                                                        const std::vector<Chain>& chains) {
    const FitContext context{.found = found_,
                             .cells_a = cells_a,
                             .cells_b = cells_b,
                             .a = a_,
                             .b = b_,
                             .origin = origin_,
                             .size = size_,
                             .tolerance = options_.tolerances.point,
                             .contact_length = contact_length(),
                             .gap = largest_gap(),
                             .limit = limit_};
    ChainFits fits = fitted_chains(context, chains);
    if (fits.stopped != nullptr) stop_at_limit(fits.stopped);
    if (limit_.late_after_search()) stop_at_limit("the time limit is reached");
    return std::move(fits.curves);
  }

  bool is_short(const ChainTracer& tracer) const {
    return tracer.stations().back() <= kShortestBranch * options_.tolerances.point;
  }

  void add_short(SurfaceCells& cells_a, SurfaceCells& cells_b, const Chain& chain) {
    const ChainTracer tracer(found_, cells_a, cells_b, origin_, chain);
    if (!is_short(tracer) || !belongs_to_contact(chain)) add_small_contact(cells_a, chain, tracer);
  }

  // What is so short is a point but for the tolerance, as a loop round the tip of a cone.
  void add_unfitted(SurfaceCells& cells_a, SurfaceCells& cells_b, const Chain& chain) {
    const ChainTracer tracer(found_, cells_a, cells_b, origin_, chain);
    is_short(tracer) ? add_short(cells_a, cells_b, chain) : add_untraced(cells_a, cells_b, chain);
  }

  void add_curve(SurfaceCells& cells_a, SurfaceCells& cells_b, const Chain& chain,
                 IntersectionCurve&& curve) {
    const Deviation& d = curve.deviation;
    if (!std::isfinite(curve.length + d.a + d.b + d.between))
      return add_unfitted(cells_a, cells_b, chain);
    curve.closed = chain.closed;
    curve.ends = {chain.ends[0].kind, chain.ends[1].kind};
    for (std::size_t side = 0; side < 2; ++side) {
      const SurfacePoint& end = side == 0 ? curve.samples.front() : curve.samples.back();
      if (!chain.closed && chain.ends[side].kind == CurveEnd::Place &&
          chain.ends[side].cluster < 0 && chain.ends[side].contact < 0 && !curve.tangential &&
          !bounds_overlap(result_, end.point, contact_length()) && !beside_known(end.point))
        add_loose_end(end);
    }
    double& least = result_.certificate.least_angle;
    least = result_.curves.empty() ? curve.least_angle : std::min(least, curve.least_angle);
    result_.curves.push_back(std::move(curve));
  }

  // Of the surfaces along their tangential curves.
  double largest_gap() const {
    double gap = shared_gap_;
    for (const ContactChain& contact : contacts_)
      if (contact.curve)
        for (const ContactPoint& p : contact.path) gap = std::max(gap, p.gap);
    return gap;
  }

  void add_contact(SurfaceCells& cells_a, SurfaceCells& cells_b, const ContactChain& contact) {
    Place place{PlaceKind::Tangential, {}, {}, kUnbounded, 0, {}};
    place.parameters.fill({kUnbounded, -kUnbounded});
    bool known = true;
    for (const ContactPoint& p : contact.path) {
      const SurfacePoint x = surface_point(cells_a, cells_b, origin_, p);
      known = known && beside_known(x.point);
      widen(place, x, p.gap);
    }
    if (known && contact.arm_count() <= 2) {
      found_.beside_known = true;
      return;
    }
    const double r = options_.tolerances.point;
    place.box_low = contact.box.low + origin_ - Vec3{r, r, r};
    place.box_high = contact.box.high + origin_ + Vec3{r, r, r};
    if (!contact.curve) {
      const SurfacePoint centre = surface_point(cells_a, cells_b, origin_, contact.centre);
      const std::size_t arms = contact.arm_count();
      place.kind = contact.kind_of_point();
      if (arms == 0 && on_curve(centre.point, true)) place.kind = PlaceKind::Tangential;
      if (arms == 0 && contact.pole && on_curve(centre.point)) place.kind = PlaceKind::Pole;
      const bool touches = contact.centre.gap <= options_.tolerances.point;
      if (arms == 0 && touches && !on_curve(centre.point)) result_.points.push_back(centre);
      if (contact.is_node()) result_.nodes.push_back(centre);
    }
    result_.places.push_back(place);
    weaken(Status::Tolerance, kTouchInPlaces);
  }

  // A curve that only touches the border stays within tolerance of it for about this long.
  double contact_length() const { return 0.1 * std::sqrt(options_.tolerances.point * size_); }

  void add_small_contact(SurfaceCells& cells_a, const Chain& chain, const ChainTracer& tracer) {
    const TracePoint middle = tracer.at(0.5 * tracer.stations().back(), true);
    if (in_contact(middle.point)) return;
    const SurfacePoint contact{middle.point, middle.a, middle.b};
    if (!is_known_contact(result_, contact.point, contact_length()))
      result_.points.push_back(contact);
    const Box box = end_box(cells_a, found_, chain);
    Place place = place_at(contact, options_.tolerances.point);
    place.kind = PlaceKind::Touch;
    place.box_low = box.low + origin_;
    place.box_high = box.high + origin_;
    result_.places.push_back(place);
    weaken(Status::Tolerance, kTouchInPlaces);
  }

  // A contact in the middle of a curve is no isolated point: so near is the chord of two samples.
  bool on_curve(const Vec3& point, bool tangential_only = false) const {
    return is_on_curve(result_, point, kOnCurve * size_, tangential_only);
  }

  bool in_cluster(const Vec3& point) const {
    const double r = options_.tolerances.point;
    const Vec3 low = point - origin_ - Vec3{r, r, r}, high = point - origin_ + Vec3{r, r, r};
    return std::any_of(clusters_.begin(), clusters_.end(), [&](const CriticalCluster& cluster) {
      return meet(cluster.box, {low, high});
    });
  }

  // A branch that is proven to be there but cannot be written down, at a pole perhaps. Nothing is
  // open along a contact whose surfaces stay together between its points, by samples.
  void add_untraced(SurfaceCells& cells_a, SurfaceCells& cells_b, const Chain& chain) {
    const Box box = end_box(cells_a, found_, chain);
    const bool contact = std::ranges::all_of(chain.links, [&](const ChainLink& link) {
      return runs_in_contact(cells_a, cells_b, found_.arcs[static_cast<std::size_t>(link.arc)],
                             options_.tolerances.point);
    });
    const double gap = contact ? kAttachGap * options_.tolerances.point : diagonal(box);
    Place place{PlaceKind::Open, box.low + origin_, box.high + origin_, 0, gap, {}};
    if (contact) place.kind = PlaceKind::Tangential;
    result_.places.push_back(place);
    weaken(contact ? Status::Tolerance : Status::Stopped, "a branch could not be traced");
  }

  bool in_contact(const Vec3& point) const {
    const double r = contact_length();
    const Vec3 low = point - origin_ - Vec3{r, r, r}, high = point - origin_ + Vec3{r, r, r};
    return std::any_of(contacts_.begin(), contacts_.end(), [&](const ContactChain& contact) {
      return !contact.curve && meet(contact.box, {low, high});
    });
  }

  // True if a branch may end there, since what follows was not searched.
  bool beside_known(const Vec3& point) const {
    return known_.hold({point - origin_, point - origin_});
  }

  void add_loose_end(const SurfacePoint& end) {
    const auto strip = std::find_if(strips_.begin(), strips_.end(),
                                    [&](const BorderStrip& each) { return each.holds(end.point); });
    if (strip != strips_.end()) {
      if (!strip->told) result_.places.push_back(strip->place);
      strip->told = true;
      return;
    }
    result_.places.push_back(place_at(end, options_.tolerances.point));
    weaken(Status::Stopped, "a branch ends inside both surfaces without a reason");
  }

  // What a cluster is: by its size, by whether the surfaces are within tolerance all over it, and
  // by the arcs that end on it.
  void add_place(SurfaceCells& cells_a, SurfaceCells& cells_b, const CriticalCluster& cluster) {
    Place place{PlaceKind::Open,
                cluster.box.low + origin_,
                cluster.box.high + origin_,
                0,
                diagonal(cluster.box),
                parameters_of(cells_a, cells_b, found_.critical, cluster)};
    if (cluster.within_tolerance) {  // within tolerance all over, whatever the surfaces do in it
      if (!cluster.singular) place.gap_high = kThinGap * options_.tolerances.point;
      place.kind = cluster.singular ? PlaceKind::Cusp : PlaceKind::Tangential;
    }
    // Where the area has a border of its own it is a region already.
    const bool coincides = cluster.within_tolerance && holds_area(cluster, found_.critical);
    if (coincides) {
      place.kind = PlaceKind::Overlap;
      result_.overlaps.push_back({{}, place.gap_high});
    }
    result_.places.push_back(place);
    if (coincides)
      weaken(Status::Tolerance, "the surfaces coincide in the listed contacts");
    else if (!cluster.within_tolerance)
      weaken(Status::Stopped, "some regions are unresolved");
    else if (cluster.singular)
      weaken(Status::Tolerance, "the surface is singular, or nearly, in the listed contacts");
    else
      weaken(Status::Tolerance, kTouchInPlaces);
  }

  void add_slow(const SurfaceCells& a, const SurfaceCells& b, const CriticalCluster& cluster) {
    const double r = options_.tolerances.point;
    result_.places.push_back({PlaceKind::Tangential, cluster.box.low + origin_,
                              cluster.box.high + origin_, 0, kThinGap * r,
                              parameters_of(a, b, found_.slow, cluster)});
    weaken(Status::Tolerance, kTouchInPlaces);
  }

  void add_known_curves() {
    for (const KnownCurve& curve : options_.known) {
      const Vec3 r{curve.radius, curve.radius, curve.radius};
      Box box;
      for (const Vec3& p : curve.points) box = joined(box, {p - r, p + r});
      result_.places.push_back({PlaceKind::Tangential, box.low, box.high, 0, curve.gap, {}});
    }
    weaken(Status::Tolerance,
           "faces beside a common edge are too near each other to be told apart there");
  }

  // Places nearer than the tolerance are listed: without any, what is approximated is apart, too.
  void note_approximations() {
    const double error = std::max(a_.error, b_.error);
    const bool apart = result_.curves.empty() && result_.points.empty() && result_.places.empty() &&
                       result_.status == Status::Complete;
    if (!(error > 0) || (apart && a_.error + b_.error < options_.tolerances.point)) return;
    std::ostringstream text;
    text << "a surface is an approximation within " << error;
    weaken(Status::Tolerance, text.str());
  }

  const BezierSurface& a_;
  const BezierSurface& b_;
  const IntersectionOptions& options_;
  const WorkLimit limit_;
  const PatchBoxes &boxes_a_, &boxes_b_;
  const double size_;
  const Vec3 origin_;
  const KnownCurves known_;
  PairSearchResult found_;
  std::vector<ContactChain> contacts_;
  std::vector<CriticalCluster> clusters_;
  double shared_gap_ = 0;  // along borders that both surfaces share
  std::vector<BorderStrip> strips_;
  SurfaceIntersection result_;
};

}  // namespace

SurfaceIntersection assembled(const BoxedSurface& a, const BoxedSurface& b,
                              const IntersectionOptions& options) {
  return Assembly(a, b, options).run();
}

}  // namespace blossom
