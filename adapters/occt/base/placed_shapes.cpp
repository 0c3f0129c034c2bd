// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/base/placed_shapes.h"

#include <algorithm>
#include <functional>

#include <TopoDS_Iterator.hxx>

namespace blossom::occt {

PlacedShapes::PlacedShapes(const TopoDS_Shape& shape) {
  places_.emplace_back();
  origins_.emplace_back();
  moves_.emplace_back();
  enter(shape.Located(TopLoc_Location()), composed(0, shape.Location()));
}

std::size_t PlacedShapes::Hash::operator()(const Key& key) const {
  return std::hash<const void*>()(key.shape) ^ (static_cast<std::size_t>(key.place) << 48);
}

TopoDS_Shape PlacedShapes::placed(const PlacedShape& part) const {
  return part.shape.Located(places_[static_cast<std::size_t>(part.place)],
                            false);  // also where it mirrors
}

// What several parts share is entered once.
void PlacedShapes::enter(const TopoDS_Shape& unplaced, int place) {
  const TopAbs_ShapeEnum kind = unplaced.ShapeType();
  if (!known_.insert({unplaced.TShape().get(), place}).second) return;
  if (kind == TopAbs_FACE) faces_.push_back({unplaced, place});
  if (kind == TopAbs_EDGE) edges_.push_back({unplaced, place});
  if (kind == TopAbs_VERTEX) {
    vertices_.push_back({unplaced, place});
    return;
  }
  for (TopoDS_Iterator part(unplaced, true, false); part.More(); part.Next()) {
    const TopoDS_Shape& own = part.Value();
    if (own.Location().IsIdentity())
      enter(own, place);
    else
      enter(own.Located(TopLoc_Location()), composed(place, own.Location()));
  }
}

int PlacedShapes::composed(int place, const TopLoc_Location& location) {
  if (location.IsIdentity()) return place;
  const auto found = std::find_if(origins_.begin(), origins_.end(), [&](const auto& origin) {
    return origin.first == place && origin.second == location;
  });
  if (found != origins_.end()) return static_cast<int>(found - origins_.begin());
  places_.push_back(places_[static_cast<std::size_t>(place)] * location);
  origins_.emplace_back(place, location);
  moves_.push_back(places_.back().Transformation());
  return static_cast<int>(places_.size()) - 1;
}

}  // namespace blossom::occt
