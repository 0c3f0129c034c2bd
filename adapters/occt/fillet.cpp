// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/fillet.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/ball_walk.h"
#include "adapters/occt/blending/blend_check.h"
#include "adapters/occt/blending/blend_sheet.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/fillet_limit.h"
#include "adapters/occt/blending/fillet_order.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/sheet_trim.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/solids/solid_shells.h"
#include "core/base/errors.h"
#include "core/base/work_limit.h"

namespace blossom::occt {
namespace {

constexpr const char* kFilleting = "rounding edges";

// The faces of one solid of a shape.
struct SolidPart {
  TopoDS_Solid solid;  // of the shape that was given
  std::set<int> faces;
  double volume = 0;
};

// A solid with fillets, and what is left in it of the edges that it had, by number; others are
// whole.
struct Grouped {
  FilletedSolid made;
  std::map<int, std::vector<TopoDS_Edge>> edges;
};

// A shape with what is needed to fillet it again and again.
class Filleting {
 public:
  /// limit   of work that this is a part of; null: its time begins to run
  Filleting(const TopoDS_Shape& shape, const FilletOptions& options,
            std::shared_ptr<const WorkLimit> limit = nullptr)
      : body_(BRepBuilderAPI_Copy(shape, Standard_False).Shape()),
        options_(options),
        limit_(limit ? std::move(limit)
                     : std::make_shared<const WorkLimit>(options_.intersection)) {
    find_parts(shape);
  }

  const BodyEdges& body() const { return body_; }
  const std::vector<SolidPart>& parts() const { return parts_; }

  /// All these edges, or a refusal.
  std::vector<FilletedSolid> made(const FilletEdges& edges);
  /// Of what was made last.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void find_parts(const TopoDS_Shape& shape);
  const SolidPart& part_of(int edge) const;
  FilletedSolid closed(const SolidPart& part, const std::vector<TrimmedFace>& faces,
                       const FilletEdges& edges) const;
  Grouped with_group(const SolidPart& part, const FilletEdges& edges);
  struct Renamed {
    FilletEdges edges;      // with those in which they go on
    std::map<int, int> of;  // numbers before, by numbers now
  };
  Renamed renamed(const Filleting& next, const Grouped& done, const FilletEdges& group) const;
  FilletedSolid with_next(const Grouped& done, const FilletEdges& group);
  const TopoDS_Face& face_given(int number) const {
    return faces_given_[static_cast<std::size_t>(number) - 1];
  }

  BodyEdges body_;
  FilletOptions options_;
  std::shared_ptr<const WorkLimit> limit_;
  std::vector<SolidPart> parts_;
  std::vector<TopoDS_Face> faces_given_;  // by number
  std::vector<std::string> notes_;
  Vec3 apex_;
};

void Filleting::find_parts(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces, solids;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  for (int i = 1; i <= faces.Extent(); ++i) faces_given_.push_back(TopoDS::Face(faces(i)));
  if (body_.edge_count() > 0) {
    const gp_Pnt p = BRep_Tool::Pnt(body_.vertex({1, true}));
    apex_ = {p.X(), p.Y(), p.Z()};
  }
  for (int i = 1; i <= solids.Extent(); ++i) {
    SolidPart part;
    part.solid = TopoDS::Solid(solids(i));
    for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next()) {
      const int number = faces.FindIndex(it.Current());
      part.faces.insert(number);
      part.volume += cone_volume(TopoDS::Face(it.Current()), apex_);
    }
    parts_.push_back(std::move(part));
  }
}

const SolidPart& Filleting::part_of(int edge) const {
  const int face = body_.use(edge, true).face;
  const auto found = std::ranges::find_if(
      parts_, [face](const SolidPart& part) { return part.faces.count(face) > 0; });
  if (found == parts_.end())
    throw FilletRefused({FilletFault::Edge, edge, "it belongs to no solid", {}, {}, {}});
  if (found->volume <= 0)
    throw FilletRefused({FilletFault::Edge, edge, "its solid is turned inside out", {}, {}, {}});
  return *found;
}

FilletedSolid Filleting::closed(const SolidPart& part, const std::vector<TrimmedFace>& faces,
                                const FilletEdges& edges) const {
  FilletedSolid made;
  std::vector<BoundingFace> bounding;
  for (const TrimmedFace& each : faces) {
    if (each.from > 0 && part.faces.count(each.from) == 0) continue;
    bounding.push_back({each.face, cone_volume(each.face, apex_)});
    made.volume += bounding.back().volume;
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

// Edges of one group, into a solid of the shape.
Grouped Filleting::with_group(const SolidPart& part, const FilletEdges& edges) {
  const auto tick = [this] { check_limit(limit_.get(), kFilleting); };
  const double tolerance = options_.intersection.tolerances.point;
  WalkOptions walking{options_, tolerance, {}, tick};
  for (const auto& [edge, concave] : edges) walking.filleted.insert(edge);
  BlendSheet sheet(body_, tolerance, options_.chamfer.has_value());
  for (const EdgeRun& run : edge_runs(body_, edges)) sheet.add(ball_walk(body_, run, walking));
  tick();
  sheet.build();
  tick();
  TrimmedBody trimmed = trimmed_by_sheet(body_, sheet, tolerance);
  notes_.insert(notes_.end(), sheet.notes().begin(), sheet.notes().end());
  Grouped grouped{closed(part, trimmed.faces, edges), std::move(trimmed.edges)};
  check_blended(body_, part.solid, part.volume, grouped.made, edges);
  check_apart(grouped.made, options_.intersection, tick);
  return grouped;
}

// The edges of a group in a solid that other fillets were put into, and the numbers that they had.
Filleting::Renamed Filleting::renamed(const Filleting& next, const Grouped& done,
                                      const FilletEdges& group) const {
  Renamed renamed;
  TopTools_IndexedMapOfShape numbers;
  TopExp::MapShapes(done.made.solid, TopAbs_EDGE, numbers);
  for (const auto& [edge, concave] : group) {
    std::vector<TopoDS_Edge> left{body_.edge(edge)};
    if (const auto known = done.edges.find(edge); known != done.edges.end()) left = known->second;
    for (const TopoDS_Edge& each : left) {
      const int number = numbers.FindIndex(each);
      if (number == 0)
        throw FilletRefused({FilletFault::EdgeConsumed,
                             edge,
                             "fillets of other edges take it away",
                             std::nullopt,
                             std::nullopt,
                             {}});
      renamed.of.emplace(number, edge);
    }
  }
  for (const auto& [number, edge] : renamed.of)
    renamed.edges.merge(smooth_chain(next.body(), number));
  return renamed;
}

// A group into a solid that other groups were put into.
FilletedSolid Filleting::with_next(const Grouped& done, const FilletEdges& group) {
  Filleting next(done.made.solid, options_, limit_);
  Renamed in_next = renamed(next, done, group);
  const auto old_number = [&](int number) {
    const auto known = in_next.of.find(number);
    return known == in_next.of.end() ? 0 : known->second;
  };
  FilletedSolid made;
  try {
    made = next.made(in_next.edges).front();
  } catch (const FilletRefused& refusal) {
    FilletRefusal why = refusal.why();
    why.edge = old_number(why.edge);
    if (why.edge == 0) why.edge = group.begin()->first;
    throw FilletRefused(why);
  }
  notes_.insert(notes_.end(), next.notes_.begin(), next.notes_.end());
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

std::vector<FilletedSolid> Filleting::made(const FilletEdges& edges) {
  std::vector<FilletedSolid> all;
  notes_.clear();
  for (const SolidPart& part : parts_) {
    FilletEdges own;
    for (const auto& [edge, concave] : edges)
      if (&part_of(edge) == &part) own.emplace(edge, concave);
    if (own.empty()) {
      FilletedSolid kept{part.solid, {}, part.volume};
      for (TopExp_Explorer it(part.solid, TopAbs_FACE); it.More(); it.Next())
        kept.faces.push_back({TopoDS::Face(it.Current()), 0, 0});
      std::size_t next = 0;
      for (const int number : part.faces) kept.faces[next++].from = number;
      all.push_back(std::move(kept));
      continue;
    }
    const std::vector<FilletEdges> groups = fillet_order(body_, own);
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

void check_request(const BodyEdges& body, const std::vector<int>& edges,
                   const FilletOptions& options) {
  const auto check_length = [](double length, const char* what) {
    if (!(length > 0) || !std::isfinite(length))
      throw InvalidInput(std::string("fillet: the ") + what + " has to be positive and finite");
  };
  check_length(options.radius, "radius");
  check_length(options.last_radius.value_or(1), "last radius");
  if (options.rho && !(*options.rho > 0 && *options.rho < 1))
    throw InvalidInput("fillet: rho has to be between 0 and 1");
  if (options.chamfer) {
    check_length(options.chamfer->first, "distance");
    check_length(options.chamfer->second.value_or(1), "second distance");
    const double angle = options.chamfer->angle.value_or(1);
    if (!(angle > 0 && angle < std::numbers::pi))
      throw InvalidInput("fillet: the angle has to be between 0 and pi");
  }
  if (edges.empty()) throw InvalidInput("fillet: no edge is named");
  for (const int edge : edges)
    if (edge < 1 || edge > body.edge_count())
      throw InvalidInput("fillet: there is no edge " + std::to_string(edge) + ", only 1 to " +
                         std::to_string(body.edge_count()));
}

// The chains of the edges that can have fillets; the others are refused.
std::vector<FilletEdges> chains_of(const BodyEdges& body, const std::vector<int>& edges,
                                   std::vector<FilletRefusal>& refused) {
  std::vector<FilletEdges> chains;
  for (const int edge : edges) {
    if (std::ranges::any_of(chains, [&](const auto& chain) { return chain.count(edge) > 0; }))
      continue;
    try {
      chains.push_back(smooth_chain(body, edge));
    } catch (const FilletRefused& refusal) {
      refused.push_back(refusal.why());
    }
  }
  return chains;
}

// The largest radius of the edge at fault, where it is the radius that does not fit.
void add_limit(const BodyEdges& body, const std::vector<FilletEdges>& chains, double radius,
               FilletRefusal& why) {
  const bool of_radius = why.fault == FilletFault::NoBall || why.fault == FilletFault::Pinch ||
                         why.fault == FilletFault::LeavesFace;
  if (!of_radius || why.largest) return;
  for (const FilletEdges& chain : chains) {
    const auto edge = chain.find(why.edge);
    if (edge == chain.end()) continue;
    if (const auto limit = fillet_limit(body, edge->first, edge->second, radius)) {
      why.largest = limit->radius;
      why.cause += "; larger balls are stopped by " + limit->cause;
    }
  }
}

// What went wrong where no edge is known to be at fault.
FilletRefusal not_put_together(const std::exception& error) {
  return {FilletFault::Result,
          0,
          std::string("the strips cannot be put into the solid together: ") + error.what(),
          {},
          {},
          {}};
}

}  // namespace

FilletResult fillet(const TopoDS_Shape& shape, const std::vector<int>& edges,
                    const FilletOptions& options) {
  if (shape.IsNull()) throw InvalidInput("fillet: there is no shape");
  FilletResult result;
  Filleting work(shape, options);
  check_request(work.body(), edges, options);
  for (const SolidPart& part : work.parts()) result.volume_before += part.volume;
  std::vector<FilletEdges> chains = chains_of(work.body(), edges, result.refused);
  const auto refuse = [&](const FilletRefusal& why) {
    result.refused.push_back(why);
    if (!options.chamfer && !options.last_radius && !options.rho)
      add_limit(work.body(), chains, options.radius, result.refused.back());
    const auto at_fault =
        std::ranges::find_if(chains, [&](const auto& chain) { return chain.count(why.edge) > 0; });
    chains.erase(at_fault == chains.end() ? chains.end() - 1 : at_fault);
  };
  while (!chains.empty() && (options.partial || result.refused.empty())) {
    FilletEdges all;
    for (const FilletEdges& chain : chains) all.insert(chain.begin(), chain.end());
    try {
      result.solids = guarded(kFilleting, [&] { return work.made(all); });
      for (const auto& [edge, concave] : all) result.edges.push_back(edge);
      result.notes = work.notes();
      return result;
    } catch (const FilletRefused& refusal) {
      refuse(refusal.why());
    } catch (const LimitFailure& reached) {
      result.refused.push_back({FilletFault::Result, 0, reached.what(), {}, {}, {}});
      result.status = Status::Stopped;
      return result;
    } catch (const Failure& failure) {
      refuse(not_put_together(failure));
    } catch (const BadModel& error) {
      refuse(not_put_together(error));
    }
  }
  return result;
}

}  // namespace blossom::occt
