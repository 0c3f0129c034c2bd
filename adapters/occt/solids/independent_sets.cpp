// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/independent_sets.h"

#include <algorithm>

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/distance.h"
#include "adapters/occt/queries/solid_rays.h"

namespace blossom::occt {
namespace {

// Pairs of cells that a question may cost. More of them hardly ever tell two solids in contact
// apart, and two that only seem to be in contact are worked on apart.
constexpr long kBudget = 5'000;

}  // namespace

// A solid with what is asked about it.
class SolidContacts::Neighbour {
 public:
  explicit Neighbour(const TopoDS_Solid& solid)
      : solid_(solid), box_(bounds_of(solid)), own_(BRep_Tool::MaxTolerance(solid, TopAbs_EDGE)) {}

  bool is_apart_from(Neighbour& other, double tolerance) {
    Bnd_Box around = box_;
    around.Enlarge(tolerance);
    if (around.IsOut(other.box_)) return true;
    const double reach = tolerance + own_ + other.own_;
    return least_distance(measured(), other.measured(), {.budget = kBudget, .enough = reach})
               .lower > reach;
  }

  // Of a solid that does not touch this one. What rays cannot tell may be so.
  bool may_hold(const Neighbour& other, double tolerance) {
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(other.solid_, TopAbs_VERTEX, vertices);
    if (vertices.IsEmpty()) return !box_.IsOut(other.box_);
    const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(vertices(1)));
    if (box_.IsOut(point)) return false;
    SolidRays rays(measured().faces(), tolerance);
    return rays.is_inside({point.X(), point.Y(), point.Z()}).value_or(true);
  }

 private:
  const MeasuredShape& measured() {
    if (!measured_) measured_ = std::make_unique<MeasuredShape>(solid_);
    return *measured_;
  }

  TopoDS_Solid solid_;
  Bnd_Box box_;  // with the tolerances
  double own_;
  std::unique_ptr<MeasuredShape> measured_;
};

SolidContacts::SolidContacts(const std::vector<TopoDS_Solid>& solids, double tolerance,
                             const SharedLimit& limit)
    : tolerance_(tolerance), limit_(limit) {
  guarded("boxes of solids", [&] {
    for (const TopoDS_Solid& solid : solids) neighbours_.emplace_back(solid);
  });
}

SolidContacts::~SolidContacts() = default;

bool SolidContacts::touch(std::size_t a, std::size_t b) {
  const auto [known, is_new] = touch_.try_emplace(std::minmax(a, b), true);
  if (is_new) known->second = find_touch(a, b);
  return known->second;
}

// What cannot be measured is not shown to be apart.
bool SolidContacts::find_touch(std::size_t a, std::size_t b) try {
  if (limit_.is_reached()) return true;
  return guarded("telling solids apart",
                 [&] { return !neighbours_[a].is_apart_from(neighbours_[b], tolerance_); });
} catch (const Failure&) {
  return true;
} catch (const BadModel&) {
  return true;
}

bool SolidContacts::meet(std::size_t a, std::size_t b) try {
  if (touch(a, b)) return true;
  return guarded("telling solids apart", [&] {
    return neighbours_[a].may_hold(neighbours_[b], tolerance_) ||
           neighbours_[b].may_hold(neighbours_[a], tolerance_);
  });
} catch (const Failure&) {
  return true;
} catch (const BadModel&) {
  return true;
}

std::vector<SolidPlaces> SolidContacts::layers(const SolidPlaces& places) {
  std::vector<SolidPlaces> layers;
  for (const std::size_t place : places) {
    const auto has_room = [&](const SolidPlaces& layer) {
      return std::ranges::none_of(layer, [&](std::size_t other) { return touch(place, other); });
    };
    const auto free = std::ranges::find_if(layers, has_room);
    if (free == layers.end())
      layers.push_back({place});
    else
      free->push_back(place);
  }
  return layers;
}

std::vector<SolidPlaces> SolidContacts::joined(const std::vector<int>& input) {
  std::vector<SolidPlaces> sets;
  for (std::size_t place = 0; place < neighbours_.size(); ++place) {
    const auto meets = [&](const SolidPlaces& set) {
      return std::ranges::any_of(set, [&](std::size_t other) {
        return input[other] != input[place] && meet(place, other);
      });
    };
    SolidPlaces joined;
    const auto rest = std::stable_partition(sets.begin(), sets.end(),
                                            [&](const SolidPlaces& set) { return !meets(set); });
    for (auto set = rest; set != sets.end(); ++set)
      joined.insert(joined.end(), set->begin(), set->end());
    joined.push_back(place);
    sets.erase(rest, sets.end());
    sets.push_back(std::move(joined));
  }
  for (SolidPlaces& set : sets) std::ranges::sort(set);
  std::ranges::sort(sets);
  return sets;
}

}  // namespace blossom::occt
