// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/filleting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/sheet/blend_check.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/blending/sheet/fillet_order.h"
#include "adapters/occt/blending/strips/ball_walk.h"
#include "adapters/occt/blending/strips/held_strip.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/queries/solid_rays.h"
#include "adapters/occt/solids/solid_shells.h"

namespace blossom::occt {
namespace {

// Of what balls take off between tangent planes: errors with which the change of a volume is
// measured, until it is certain which sign it has. It is a sum of some hundred integrals whose
// error estimates exceed their errors by far.
constexpr std::array kShares{1e-3, 1e-5};
constexpr double kSure = 100;
// Radians: at sharper edges contacts come to the ends of faces, and less is taken off than between
// planes.
constexpr double kSharpest = 2.5;

// Of the corner of two planes that a disc of radius 1 leaves free, by the angle of their normals.
double corner_area(double angle) {
  const double half = 0.5 * std::min(angle, kSharpest);
  return std::tan(half) - half;
}

}  // namespace

void Filleting::find_parts(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces, solids;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  for (int i = 1; i <= faces.Extent(); ++i) faces_given_.push_back(TopoDS::Face(faces(i)));
  if (body_.edge_count() > 0) {
    const gp_Pnt p = BRep_Tool::Pnt(body_.vertex({1, true}));
    cones_ = ConeVolumes({p.X(), p.Y(), p.Z()});
  }
  for (int i = 1; i <= solids.Extent(); ++i) {
    SolidPart part;
    part.solid = TopoDS::Solid(solids(i));
    part.one_shell = part.solid.NbChildren() == 1;
    for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next())
      part.faces.insert(faces.FindIndex(it.Current()));
    parts_.push_back(std::move(part));
  }
}

double Filleting::volume_of(const SolidPart& part) {
  double volume = 0;
  for (const int face : part.faces) volume += cones_.of(face_given(face));
  return volume;
}

double Filleting::volume_given() {
  double volume = 0;
  for (const SolidPart& part : parts_) volume += volume_of(part);
  return volume;
}

// Whether the faces of a solid are turned into it: by lines that leave it, or else by its volume.
bool Filleting::is_inside_out(const SolidPart& part) {
  std::vector<TopoDS_Face> faces;
  for (const int number : part.faces) faces.push_back(face_given(number));
  const std::optional<gp_Pnt> inside = point_inside(faces.front());
  SolidRays rays(std::move(faces), Precision::Confusion());
  if (inside)
    for (const Vec3& direction : kRayDirections)
      if (const auto outwards = rays.leaves({inside->X(), inside->Y(), inside->Z()}, direction))
        return !*outwards;
  return volume_of(part) <= 0;
}

SolidPart& Filleting::part_of(int edge) {
  const int face = body_.use(edge, true).face;
  const auto found = std::ranges::find_if(
      parts_, [face](const SolidPart& part) { return part.faces.count(face) > 0; });
  if (found == parts_.end())
    throw FilletRefused({FilletFault::Edge,
                         edge,
                         "it belongs to no solid, its faces are those of a shell alone: edges of "
                         "closed solids are rounded",
                         {},
                         {},
                         {}});
  if (!found->inside_out) found->inside_out = is_inside_out(*found);
  if (*found->inside_out)
    throw FilletRefused({FilletFault::Edge, edge, "its solid is turned inside out", {}, {}, {}});
  return *found;
}

bool Filleting::is_kept(const TrimmedFace& face) const {
  return face.from > 0 && face.face.IsSame(body_.face(face.from));
}

// What is between the faces at an edge of the body and the parts of it that are lost.
double Filleting::volume_beside(int edge, const std::vector<TopoDS_Edge>& left,
                                const Vec3& apex) const {
  const TopoDS_Edge whole = body_.edge(edge);
  if (BRep_Tool::Degenerated(whole) || BRep_Tool::Tolerance(whole) <= Precision::Confusion())
    return 0;
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(whole, range.from, range.to);
  std::vector<Interval> lost{range};
  for (const TopoDS_Edge& each : left) {
    Interval kept;
    if (BRep_Tool::Curve(each, kept.from, kept.to) != curve) continue;
    const Interval last = lost.back();
    lost.back().to = kept.from;
    lost.push_back({kept.to, last.to});
  }
  double volume = 0;
  for (const Interval& part : lost)
    for (const bool forward : {true, false}) {
      const EdgeUseInFace& use = body_.use(edge, forward);
      const TopAbs_Orientation as = use.coedge->reversed ? TopAbs_REVERSED : TopAbs_FORWARD;
      if (length(part) > 0)
        volume +=
            cone_volume_beside(body_.face(use.face), TopoDS::Edge(whole.Oriented(as)), part, apex);
    }
  return volume;
}

// How much more the solid has, by the faces that changed and the edges that are lost: what the gaps
// between their faces enclose may be more than a small ball takes off.
double Filleting::change(const SolidPart& part, const TrimmedBody& trimmed, const Vec3& apex,
                         double enough) const {
  double change = 0;
  std::set<int> lost = part.faces;
  for (const TrimmedFace& each : trimmed.faces)
    if (is_kept(each))
      lost.erase(each.from);
    else if (each.from == 0 || part.faces.count(each.from) > 0)
      change += cone_volume(each.face, apex, enough);
  for (const int face : lost) change -= cone_volume(face_given(face), apex, enough);
  for (const auto& [edge, left] : trimmed.edges) change -= volume_beside(edge, left, apex);
  return change;
}

// The least along the edge.
double Filleting::square_of_radius(int edge) const {
  const EdgeRadius of = options_.radius_of(edge);
  const double radius = of.law ? of.law->extremes({0, 1}).from : of.radius;
  return radius * radius;
}

// The same, only as exact as its sign needs; over a point of a filleted edge, which the more exact
// it is the less of it there is.
double Filleting::sure_change(const SolidPart& part, const TrimmedBody& trimmed,
                              const FilletEdges& edges) const {
  Interval range;
  const Handle(Geom_Curve) curve =
      BRep_Tool::Curve(body_.edge(edges.begin()->first), range.from, range.to);
  const Vec3 apex = vec(curve->Value(at(range, 0.5)));
  if (options_.chamfer) return change(part, trimmed, apex, 0);
  double size = 0;
  for (const auto& [edge, concave] : edges) {
    double angle = 0;
    edge_kind(body_, edge, angle);
    size += square_of_radius(edge) * corner_area(angle) * edge_length(body_.edge(edge));
  }
  for (const double share : kShares) {
    const double enough = share * size;
    const double change = this->change(part, trimmed, apex, enough);
    if (std::abs(change) > kSure * enough) return change;
  }
  return change(part, trimmed, apex, 0);
}

// The one shell of a solid stays turned outwards as long as it is one: its volume need not be
// known.
FilletedSolid Filleting::closed(const SolidPart& part, const std::vector<TrimmedFace>& faces,
                                const FilletEdges& edges) {
  const bool measured = options_.volumes || !part.one_shell;
  FilletedSolid made;
  std::vector<BoundingFace> bounding;
  for (const TrimmedFace& each : faces) {
    if (each.from > 0 && part.faces.count(each.from) == 0) continue;
    double volume = 1;
    if (measured) volume = cones_.of(is_kept(each) ? face_given(each.from) : each.face);
    bounding.push_back({each.face, volume});
    if (options_.volumes) made.volume += volume;
    if (is_kept(each)) unflatten(each.face, face_given(each.from));
    made.faces.push_back({each.face, each.from, each.edge});
  }
  std::string obstacle;
  const std::vector<TopoDS_Solid> solids = solids_of(bounding, obstacle);
  if (!obstacle.empty() || solids.size() != 1)
    throw FilletRefused({FilletFault::Result,
                         edges.begin()->first,
                         obstacle.empty() ? "the solid would fall apart" : obstacle,
                         {},
                         {},
                         {}});
  made.solid = solids.front();
  return made;
}

// Along all runs of a group.
std::vector<BallWalk> Filleting::walks(const FilletEdges& edges) const {
  WalkOptions walking{options_, options_.intersection.tolerances.point, {}, [this] {
                        check_limit(limit_.get(), kFilleting);
                      }};
  for (const auto& [edge, concave] : edges) walking.filleted.insert(edge);
  walking.ended_before = ended_before_;
  std::vector<BallWalk> all;
  for (const EdgeRun& run : edge_runs(body_, edges))
    for (BallWalk& walk : ball_walks(body_, run, walking)) all.push_back(std::move(walk));
  return all;
}

// What was rolled just before is taken, but once only: what is made of it may change its curves.
std::vector<BallWalk> Filleting::walks_or_rolled(const FilletEdges& edges) {
  if (rolled_ && rolled_->size == size() && rolled_->edges == edges)
    return std::move(std::exchange(rolled_, std::nullopt)->walks);
  return walks(edges);
}

// Edges of one group, into a solid of the shape.
Grouped Filleting::with_group(const SolidPart& part, const FilletEdges& edges) {
  const auto tick = [this] { check_limit(limit_.get(), kFilleting); };
  const double tolerance = options_.intersection.tolerances.point;
  BlendSheet sheet(body_, tolerance, options_.chamfer.has_value(), options_.setback);
  for (const BallWalk& walk : walks_or_rolled(edges)) {
    sheet.add(walk);
    for (const WalkedStrip& each : walk.strips)
      if (const std::string text = held_text(each.strip);
          !text.empty() && std::ranges::count(notes_, text) == 0)
        notes_.push_back(text);
  }
  tick();
  sheet.build();
  tick();
  TrimmedBody trimmed = trimmed_by_sheet(body_, sheet, tolerance);
  notes_.insert(notes_.end(), sheet.notes().begin(), sheet.notes().end());
  is_tolerant_ = is_tolerant_ || sheet.is_tolerant();
  const double change = sure_change(part, trimmed, edges);
  Grouped grouped{closed(part, trimmed.faces, edges), std::move(trimmed.edges)};
  check_blended(body_, part.solid, grouped.made, edges, change);
  check_apart(grouped.made, options_.intersection, tick);
  return grouped;
}

// Of an edge of a solid with fillets, the number of the one that it is, or is left of; 0 for none.
int Filleting::number_before(const TopoDS_Edge& edge, const Grouped& done) const {
  if (const int number = body_.number(edge); number > 0) return number;
  for (const auto& [number, left] : done.edges)
    if (std::ranges::any_of(left, [&](const TopoDS_Edge& each) { return each.IsSame(edge); }))
      return number;
  return 0;
}

// The edges of a group in a solid that other fillets were put into, and the numbers that they had.
Filleting::Renamed Filleting::renamed(const Filleting& next, const Grouped& done,
                                      const FilletEdges& group) const {
  Renamed renamed;
  TopTools_IndexedMapOfShape numbers;
  TopExp::MapShapes(done.made.solid, TopAbs_EDGE, numbers);
  for (const auto& [edge, concave] : group) {
    const FilletRefused consumed({FilletFault::EdgeConsumed,
                                  edge,
                                  "blends of other edges take it away",
                                  std::nullopt,
                                  std::nullopt,
                                  {}});
    std::vector<TopoDS_Edge> left{body_.edge(edge)};
    if (const auto known = done.edges.find(edge); known != done.edges.end()) left = known->second;
    if (left.empty()) throw consumed;
    for (const TopoDS_Edge& each : left) {
      const int number = numbers.FindIndex(each);
      if (number == 0) throw consumed;
      renamed.of.emplace(number, edge);
      if (const auto own = options_.own.find(edge); own != options_.own.end())
        renamed.own.emplace(number, own->second);
    }
  }
  const std::map<int, EdgeRadius> named = renamed.own;
  for (const auto& [number, edge] : renamed.of) {
    const FilletEdges chain = smooth_chain(next.body(), number);
    if (const auto own = named.find(number); own != named.end())
      for (const auto& [each, concave] : chain)
        if (renamed.of.count(each) == 0) renamed.own.emplace(each, own->second);
    renamed.edges.insert(chain.begin(), chain.end());
  }
  return renamed;
}

FilletEdges Filleting::Renamed::asked() const {
  FilletEdges all = edges;
  std::erase_if(all, [&](const auto& each) { return of.count(each.first) == 0; });
  return all;
}

std::set<int> Filleting::Renamed::gone_on() const {
  std::set<int> all;
  for (const auto& [edge, concave] : edges)
    if (of.count(edge) == 0) all.insert(edge);
  return all;
}

// What is said of a solid with fillets, by the numbers of the one that was given.
std::string Filleting::in_own_words(const std::string& text, const Filleting& next,
                                    const Grouped& done) const {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(done.made.solid, TopAbs_EDGE, edges);
  const auto edge = [&](int number) {
    const int before =
        number <= edges.Extent() ? number_before(TopoDS::Edge(edges(number)), done) : 0;
    return before > 0 ? "edge " + std::to_string(before) : std::string("an edge of a blend");
  };
  const auto face = [&](int number) -> std::string {
    if (number > static_cast<int>(next.faces_given_.size())) return "a face";
    const TopoDS_Face& there = next.face_given(number);
    for (const FilletFace& each : done.made.faces) {
      if (!each.face.IsSame(there)) continue;
      if (each.from > 0) return "face " + std::to_string(each.from);
      if (each.edge > 0) return "the blend of edge " + std::to_string(each.edge);
    }
    return "the blend of a corner";
  };
  return renumbered(text, edge, face);
}

// What was to go on in other edges, as far as it need not: nothing if that cannot be made either.
std::optional<FilletedSolid> Filleting::made_before(const FilletEdges& edges,
                                                    std::set<int> others) {
  if (others.empty()) return std::nullopt;
  ended_before_ = std::move(others);
  try {
    return made(edges, size()).front();
  } catch (const FilletRefused&) {
    return std::nullopt;
  }
}

// A group into a solid that other groups were put into.
FilletedSolid Filleting::with_next(const Grouped& done, const FilletEdges& group) {
  Filleting next(done.made.solid, options_, limit_);
  Renamed in_next = renamed(next, done, group);
  next.set_own(in_next.own);
  const auto old_number = [&](int number) {
    const auto known = in_next.of.find(number);
    return known == in_next.of.end() ? 0 : known->second;
  };
  FilletedSolid made;
  try {
    made = next.made(in_next.edges, size()).front();
  } catch (const FilletRefused& refusal) {
    FilletRefusal why = refusal.why();
    why.edge = old_number(why.edge);
    if (why.edge == 0) why.edge = group.begin()->first;
    why.cause = in_own_words(why.cause, next, done);
    std::optional<FilletedSolid> shorter;  // of no help against what is wrong with the edges
    if (why.fault != FilletFault::Edge)
      shorter = next.made_before(in_next.asked(), in_next.gone_on());
    if (!shorter) throw FilletRefused(why);
    made = *std::move(shorter);
    in_next.edges = in_next.asked();
    notes_.push_back(
        "the fillet of edge " + std::to_string(why.edge) +
        " ends where others meet it, and does not go on smoothly beside them: " + why.cause);
  }
  for (const std::string& note : next.notes_) notes_.push_back(in_own_words(note, next, done));
  is_tolerant_ = is_tolerant_ || next.is_tolerant_;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(done.made.solid, TopAbs_EDGE, edges);
  std::set<int> numbers = next.gone_on_;
  for (const auto& [number, concave] : in_next.edges) numbers.insert(number);
  for (const int number : numbers)
    if (const int before = number_before(TopoDS::Edge(edges(number)), done))
      gone_on_.insert(before);
  for (FilletFace& face : made.faces) {
    if (face.from == 0) {
      face.edge = old_number(face.edge);
      continue;
    }
    const TopoDS_Face& before = next.face_given(face.from);
    const auto origin = std::ranges::find_if(
        done.made.faces, [&](const FilletFace& each) { return each.face.IsSame(before); });
    face.from = origin->from;
    face.edge = origin->edge;
  }
  return made;
}

void Filleting::set_size(double size) {
  if (!options_.chamfer) {
    options_.radius = size;
    return;
  }
  ChamferSize& chamfer = *options_.chamfer;
  if (chamfer.second) *chamfer.second *= size / chamfer.first;
  chamfer.first = size;
}

// What was made may stay, or may have failed: either way nothing of it comes into what is made
// next.
void Filleting::renew_body() {
  if (!std::exchange(is_used_, false)) return;
  rolled_.reset();  // it points into the body
  body_ = BodyEdges(flat_copy(given_));
}

void Filleting::roll(const FilletEdges& edges, double size) {
  renew_body();
  set_size(size);
  std::map<const SolidPart*, FilletEdges> of;
  for (const auto& [edge, concave] : edges) of[&part_of(edge)].emplace(edge, concave);
  rolled_.reset();
  for (const auto& [part, own] : of) {
    FilletEdges first = fillet_order(body_, own, options_).front();
    std::vector<BallWalk> made = walks(first);
    rolled_ = Rolled{size, std::move(first), std::move(made)};
  }
}

std::vector<FilletedSolid> Filleting::made(const FilletEdges& edges, double size) {
  renew_body();
  is_used_ = true;
  set_size(size);
  std::vector<FilletedSolid> all;
  notes_.clear();
  is_tolerant_ = false;
  gone_on_.clear();
  for (const auto& [edge, concave] : edges) part_of(edge);  // refuses edges of no solid
  for (SolidPart& part : parts_) {
    FilletEdges own;
    for (const auto& [edge, concave] : edges)
      if (&part_of(edge) == &part) own.emplace(edge, concave);
    if (own.empty()) {
      FilletedSolid kept{part.solid, {}, options_.volumes ? volume_of(part) : 0};
      for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next())
        kept.faces.push_back({TopoDS::Face(it.Current()), 0, 0});
      std::size_t next = 0;
      for (const int number : part.faces) kept.faces[next++].from = number;
      all.push_back(std::move(kept));
      continue;
    }
    const std::vector<FilletEdges> groups = fillet_order(body_, own, options_);
    Grouped done = with_group(part, groups.front());
    if (groups.size() > 1) {
      FilletEdges others;
      for (std::size_t i = 1; i < groups.size(); ++i)
        others.insert(groups[i].begin(), groups[i].end());
      done.made = with_next(done, others);
    }
    all.push_back(std::move(done.made));
  }
  return all;
}

}  // namespace blossom::occt
