// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exact/exact_places.h"

#include <cstring>
#include <ios>
#include <type_traits>
#include <vector>

#include <TopLoc_Datum3D.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Trsf.hxx>

namespace blossom::occt {
namespace {

static_assert(std::is_trivially_copyable_v<gp_Trsf>);

template <class Value>
void put(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <class Value>
Value taken(const std::string& bytes, std::size_t& at) {
  if (sizeof(Value) > bytes.size() - at) throw std::ios_base::failure("places are cut off");
  Value value;
  std::memcpy(static_cast<void*>(&value), bytes.data() + at, sizeof(value));
  at += sizeof(value);
  return value;
}

// A place that others are made of.
bool is_elementary(const TopLoc_Location& place) {
  return place.FirstPower() == 1 && place.NextLocation().IsIdentity();
}

// Either as its transformation, or as the numbers and powers of those that it is made of.
void put_place(std::string& bytes, const TopLoc_Location& place,
               const BinTools_LocationSet& places) {
  std::vector<int> chain;
  if (!is_elementary(place))
    for (TopLoc_Location rest = place; !rest.IsIdentity(); rest = rest.NextLocation()) {
      chain.push_back(places.Index(TopLoc_Location(rest.FirstDatum())));
      chain.push_back(rest.FirstPower());
    }
  put(bytes, chain.size());
  for (const int number : chain) put(bytes, number);
  if (chain.empty()) put(bytes, place.FirstDatum()->Transformation());
}

TopLoc_Location taken_place(const std::string& bytes, std::size_t& at,
                            const std::vector<TopLoc_Location>& before) {
  const auto count = taken<std::size_t>(bytes, at);
  if (count == 0) return TopLoc_Location(taken<gp_Trsf>(bytes, at));
  TopLoc_Location place;
  for (std::size_t i = 0; i < count; i += 2) {
    const int number = taken<int>(bytes, at), power = taken<int>(bytes, at);
    if (number < 1 || static_cast<std::size_t>(number) > before.size())
      throw std::ios_base::failure("a place is made of one that is not there");
    place = before[static_cast<std::size_t>(number) - 1].Powered(power) * place;
  }
  return place;
}

}  // namespace

std::string bytes_of(const BinTools_LocationSet& places) {
  std::string bytes;
  for (int i = 1; i <= places.NbLocations(); ++i) put_place(bytes, places.Location(i), places);
  return bytes;
}

void ExactPlacesSet::ReadGeometry(Standard_IStream& in, const Message_ProgressRange& range) {
  BinTools_ShapeSet::ReadGeometry(in, range);
  std::vector<TopLoc_Location> places;
  for (std::size_t at = 0; at < places_.size();) places.push_back(taken_place(places_, at, places));
  if (static_cast<int>(places.size()) != Locations().NbLocations())
    throw std::ios_base::failure("there are not as many places");
  ChangeLocations().Clear();
  for (const TopLoc_Location& place : places) ChangeLocations().Add(place);
}

}  // namespace blossom::occt
