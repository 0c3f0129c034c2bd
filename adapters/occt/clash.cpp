// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/clash.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/queries/depth.h"
#include "adapters/occt/solid_trim.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

Box box_of(const TopoDS_Shape& shape) {
  const Bnd_Box found = bounds_of(shape);
  Box box;
  if (!found.IsVoid())
    found.Get(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]);
  return box;
}

std::vector<TopoDS_Face> faces_of_part(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

double volume_of_solid(const TopoDS_Shape& solid) {
  const std::vector<TopoDS_Face> faces = faces_of_part(solid);
  const Box box = box_of(solid);
  double volume = 0;
  for (const TopoDS_Face& face : faces) volume += cone_volume(face, (box.low + box.high) * 0.5);
  return std::abs(volume);
}

// A contact of samples of what is common.
BodyContact contact_at(ContactKind kind, const std::vector<SurfacePoint>& samples,
                       const TopoDS_Face& a, const TopoDS_Face& b) {
  BodyContact contact{kind, a, b, samples[samples.size() / 2].point, {}};
  for (const SurfacePoint& sample : samples)
    contact.box = joined(contact.box, Box{sample.point, sample.point});
  return contact;
}

// Contacts within tolerance of a higher kind stand for those on their borders.
std::vector<BodyContact> contacts_of(const ShapeIntersection& found,
                                     const std::vector<TopoDS_Face>& a,
                                     const std::vector<TopoDS_Face>& b) {
  std::vector<BodyContact> contacts;
  for (const FaceIntersection& pair : found.pairs) {
    const TopoDS_Face& of_a = a[static_cast<std::size_t>(pair.face_a)];
    const TopoDS_Face& of_b = b[static_cast<std::size_t>(pair.face_b)];
    for (const Overlap& overlap : pair.found.overlaps)
      if (!overlap.boundary.empty())
        contacts.push_back(contact_at(ContactKind::Face, overlap.boundary, of_a, of_b));
    for (const IntersectionCurve& curve : pair.found.curves)
      contacts.push_back(contact_at(ContactKind::Curve, curve.samples, of_a, of_b));
    for (const SurfacePoint& point : pair.found.points)
      contacts.push_back(contact_at(ContactKind::Point, {point}, of_a, of_b));
  }
  std::ranges::stable_sort(
      contacts, [](const BodyContact& x, const BodyContact& y) { return x.kind > y.kind; });
  return contacts;
}

bool one_holds_the_other(Relation relation) {
  return relation == Relation::AInsideB || relation == Relation::BInsideA ||
         relation == Relation::Equal;
}

}  // namespace

/// The pairs of one job on their way.
class ClashSearch {
 public:
  ClashSearch(const std::vector<TopoDS_Shape>& parts, const ClashOptions& options,
              std::size_t first_of_b)
      : parts_(parts),
        options_(options),
        first_of_b_(first_of_b),
        limit_(options.engine),
        tolerance_(options.engine.tolerances.point),
        bodies_(parts.size()) {
    for (const TopoDS_Shape& part : parts) found_.boxes.push_back(box_of(part));
  }

  Clashes found() {
    look_at_near_pairs();
    if (!options_.clearance) look_for_nearest();
    std::ranges::sort(found_.pairs, {},
                      [](const Clash& pair) { return std::pair(pair.a, pair.b); });
    return std::move(found_);
  }

 private:
  bool is_asked(std::size_t i, std::size_t j) const {
    return first_of_b_ == 0 ? i != j : (i < first_of_b_) != (j < first_of_b_);
  }

  void look_at_near_pairs() {
    std::vector<Box> wide;
    const double room = 0.5 * std::max(tolerance_, options_.clearance.value_or(0));
    for (const Box& box : found_.boxes) wide.push_back(widened(box, room));
    const BoxTree tree(wide);
    std::vector<std::pair<std::size_t, std::size_t>> near;
    tree.for_each_meeting(tree, [&](int i, int j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      if (a < b && is_asked(a, b)) near.emplace_back(a, b);
    });
    std::ranges::sort(near);
    for (const auto& [a, b] : near) found_.pairs.push_back(looked_at(a, b));
  }

  // Parts that meet no other one get the nearest.
  void look_for_nearest() {
    std::vector<char> meets(parts_.size(), 0);
    for (const Clash& pair : found_.pairs)
      if (pair.relation != Relation::Disjoint) meets[pair.a] = meets[pair.b] = 1;
    for (std::size_t k = 0; k < found_.pairs.size(); ++k)
      known_.emplace(std::pair(found_.pairs[k].a, found_.pairs[k].b), k);
    const BoxTree tree(found_.boxes);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (meets[i] == 0) look_for_nearest(i, tree);
  }

  void look_for_nearest(std::size_t i, const BoxTree& tree) {
    double best = kInfinity;
    std::optional<Clash> nearest;
    tree.for_each_near(found_.boxes[i], kInfinity, [&](int item) {
      const auto j = static_cast<std::size_t>(item);
      if (j == i || !is_asked(i, j)) return best * best;
      const std::size_t a = std::min(i, j), b = std::max(i, j);
      const auto known = known_.find({a, b});
      if (known != known_.end()) {
        const Clash& pair = found_.pairs[known->second];
        if (pair.measured && pair.upper < best) {
          best = pair.upper;
          nearest.reset();
        }
        return best * best;
      }
      Clash pair = apart(a, b, best);
      if (!pair.obstacles.empty()) {
        known_.emplace(std::pair(a, b), found_.pairs.size());
        found_.pairs.push_back(std::move(pair));
        return best * best;
      }
      if (pair.measured && pair.upper < best) {
        best = pair.upper;
        nearest = std::move(pair);
      }
      return best * best;
    });
    if (!nearest) return;
    known_.emplace(std::pair(nearest->a, nearest->b), found_.pairs.size());
    found_.pairs.push_back(std::move(*nearest));
  }

  // Each shape is converted at one place and moved to the others.
  Bodies& bodies(std::size_t i) {
    if (bodies_[i]) return *bodies_[i];
    const TopoDS_Shape& part = parts_[i];
    const auto made = prototypes_.find(part.TShape().get());
    const bool scaled = std::abs(std::abs(part.Location().Transformation().ScaleFactor()) - 1) > 0;
    if (made != prototypes_.end() && !scaled)
      return bodies_[i].emplace(part, bodies_[made->second]->boundary().moved_to(part));
    Bodies& own = bodies_[i].emplace(part);
    if (!scaled) prototypes_.emplace(part.TShape().get(), i);
    return own;
  }

  DistanceOptions distance_options() const {
    DistanceOptions wanted;
    const IntersectionOptions left = limit_.remaining();
    wanted.time_limit = left.time_limit;
    wanted.cancelled = left.cancelled;
    return wanted;
  }

  ShapeDistance distance_of(std::size_t a, std::size_t b, double enough) {
    DistanceOptions wanted = distance_options();
    const MeasuredShape &of_a = bodies(a).boundary(), &of_b = bodies(b).boundary();
    if (std::isfinite(enough)) {
      wanted.enough = enough;
      const ShapeDistance side = least_distance(of_a, of_b, wanted);
      if (side.lower > enough) return side;
      wanted.enough = -1;
    }
    return least_distance(of_a, of_b, wanted);
  }

  Clash with_distance(std::size_t a, std::size_t b, double enough) {
    const ShapeDistance distance = distance_of(a, b, enough);
    Clash pair{.a = a, .b = b, .status = distance.status};
    pair.lower = distance.lower;
    pair.upper = distance.upper;
    pair.near_a = distance.a;
    pair.near_b = distance.b;
    pair.measured = !(distance.lower > enough);
    if (!pair.measured) pair.status = Status::Complete;
    return pair;
  }

  // A pair whose boxes are apart.
  Clash apart(std::size_t a, std::size_t b, double enough) try {
    Clash pair = with_distance(a, b, enough);
    pair.relation = pair.lower > 0 ? Relation::Disjoint : Relation::Unknown;
    return pair;
  } catch (const BadModel& error) {
    return not_measured(a, b, error.what());
  }

  // A damaged face is no reason to say nothing of all other pairs.
  static Clash not_measured(std::size_t a, std::size_t b, const char* cause) {
    Clash pair{.a = a, .b = b, .upper = kInfinity, .measured = false};
    leave_open(std::string("they cannot be measured: ") + cause, pair);
    return pair;
  }

  Clash looked_at(std::size_t a, std::size_t b) try {
    if (limit_.is_reached())
      return {.a = a, .b = b, .status = Status::Stopped, .upper = kInfinity, .measured = false};
    Clash pair = with_distance(a, b, options_.clearance.value_or(kInfinity));
    const bool solids = bodies(a).all().front().is_solid() && bodies(b).all().front().is_solid();
    const auto faces = relate(pair, solids ? Crossings::ThroughBoth : Crossings::All);
    const bool crosses = pair.relation == Relation::Crossing;
    if (solids && crosses) find_common_body(pair);
    if (pair.relation == Relation::Touching || (crosses && !solids))
      find_contacts(faces ? *faces : searched(pair), pair);
    if (one_holds_the_other(pair.relation)) take_held_body(pair);
    return pair;
  } catch (const BadModel& error) {
    return not_measured(a, b, error.what());
  }

  // What the faces of both have in common, where that had to be known to tell.
  std::shared_ptr<const FacesMet> relate(Clash& pair, Crossings crossings) {
    Bodies &a = bodies(pair.a), &b = bodies(pair.b);
    ShapeDistance distance{.lower = pair.lower,
                           .upper = pair.upper,
                           .a = pair.near_a,
                           .b = pair.near_b,
                           .status = pair.status};
    const ShapeMeeting met =
        meeting_at(distance, a.boundary(), b.boundary(), tolerance_, distance_options(), crossings);
    const ModelRelation found = relation_of(a, b, met, tolerance_, distance_options());
    pair.relation = found.relation;
    // What holds for any distance is not weakened by what is not known of it.
    const bool by_distance = found.relation == Relation::Disjoint && pair.measured;
    pair.status = by_distance ? weaker(pair.status, found.status) : found.status;
    if (found.relation == Relation::Unknown)
      pair.obstacles.emplace_back("it is not known how they lie to each other");
    return found.pairs.size() == 1 ? found.pairs.front().faces : nullptr;
  }

  FacesMet searched(const Clash& pair) const {
    FacesMet faces{faces_of_part(parts_[pair.a]), faces_of_part(parts_[pair.b]), {}};
    faces.found = intersect(faces.a, faces.b, limit_.remaining());
    return faces;
  }

  void find_contacts(const FacesMet& faces, Clash& pair) const {
    if (faces.found.status == Status::Stopped)  // there may be more of them
      pair.status = Status::Stopped;
    pair.contacts = contacts_of(faces.found, faces.a, faces.b);
    if (pair.contacts.empty())  // within tolerance only
      pair.contacts.push_back({ContactKind::Point,
                               {},
                               {},
                               pair.near_a.point,
                               Box{pair.near_a.point, pair.near_a.point}});
  }

  void find_common_body(Clash& pair) try {
    const TrimTool a = trim_tool(parts_[pair.a]), b = trim_tool(parts_[pair.b]);
    const SolidTrimResult made = trim_solids(a, {b}, SolidOperation::Common, limit_.remaining());
    pair.obstacles.insert(pair.obstacles.end(), made.obstacles.begin(), made.obstacles.end());
    if (!made.obstacles.empty()) {
      pair.status = weaker(pair.status, weaker(made.status, Status::Tolerance));
      return;
    }
    pair.status = weaker(pair.status, made.status);
    CommonBody& common = pair.common.emplace();
    common.volume = made.total.result;
    common.solids = made.solids;
    std::vector<TopoDS_Face> of_a, of_b;
    // A piece that bounds both lies on the other boundary all over; with several solids it may be
    // one of the last two alone.
    const bool is_pair = a.solids.size() == 1 && b.solids.size() == 1;
    common.upper = tolerance_;
    for (const SolidFace& face : made.faces)
      if (!is_pair || !face.of_both) (face.tool < 0 ? of_a : of_b).push_back(face.face);
    deepen(depth_of(of_a, bodies(pair.b).boundary(), tolerance_, common.lower, stop()), common);
    deepen(depth_of(of_b, bodies(pair.a).boundary(), tolerance_, common.lower, stop()), common);
  } catch (const BadModel& error) {
    leave_open(error.what(), pair);
  } catch (const Failure& error) {
    leave_open(error.what(), pair);
  }

  static void leave_open(std::string cause, Clash& pair) {
    pair.obstacles.push_back(std::move(cause));
    pair.status = weaker(pair.status, Status::Tolerance);
  }

  std::function<bool()> stop() const {
    return [this] { return limit_.is_reached(); };
  }

  static void deepen(const Depth& found, CommonBody& common) {
    if (found.lower > common.lower) common.deepest = found.deepest;
    common.lower = std::max(common.lower, found.lower);
    common.upper = std::max(common.upper, found.upper);
  }

  // The inner one as a whole.
  void take_held_body(Clash& pair) {
    const bool inner_a = pair.relation != Relation::BInsideA;
    const std::size_t inner = inner_a ? pair.a : pair.b, outer = inner_a ? pair.b : pair.a;
    if (!bodies(inner).all().front().is_solid()) return;
    CommonBody& common = pair.common.emplace();
    common.volume = volume_of_solid(parts_[inner]);
    for (const Body& body : bodies(inner).all())
      if (body.is_solid()) common.solids.push_back(TopoDS::Solid(body.shape));
    if (pair.relation == Relation::Equal) {  // no part of either boundary lies inside of the other
      common.upper = tolerance_;
      common.deepest = pair.near_a.point;
      return;
    }
    deepen(depth_of(faces_of_part(parts_[inner]), bodies(outer).boundary(), tolerance_,
                    common.lower, stop()),
           common);
  }

  const std::vector<TopoDS_Shape>& parts_;
  const ClashOptions& options_;
  std::size_t first_of_b_;
  const SharedLimit limit_;
  double tolerance_;
  std::vector<std::optional<Bodies>> bodies_;
  std::map<const void*, std::size_t> prototypes_{};  // by their shapes without places
  Clashes found_{};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known_{};  // places in found_.pairs
};

const char* to_string(ContactKind kind) {
  switch (kind) {
    case ContactKind::Point: return "point";
    case ContactKind::Curve: return "curve";
    case ContactKind::Face: break;
  }
  return "face";
}

Clashes clashes_of(const std::vector<TopoDS_Shape>& parts, const ClashOptions& options,
                   std::size_t first_of_b) {
  return guarded("looking for clashes",
                 [&] { return ClashSearch(parts, options, first_of_b).found(); });
}

}  // namespace blossom::occt
