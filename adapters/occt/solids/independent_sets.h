// SPDX-License-Identifier: LGPL-2.1-or-later
// Which of many solids touch each other, and sets of them that can be worked on as one.

#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <TopoDS_Solid.hxx>

#include "adapters/occt/base/shared_limit.h"

namespace blossom::occt {

/// Places of solids in a list.
using SolidPlaces = std::vector<std::size_t>;

/// Solids, asked for their contacts.
class SolidContacts {
 public:
  /// tolerance   model units
  /// limit       kept by reference; once it is reached, all solids count as touching
  SolidContacts(const std::vector<TopoDS_Solid>& solids, double tolerance,
                const SharedLimit& limit);
  ~SolidContacts();

  /// Whether two solids are as near as the tolerance and the largest ones of both together, or
  /// their distance stays open.
  bool touch(std::size_t a, std::size_t b);

  /// Puts each of the solids into the first layer in which it touches none.
  std::vector<SolidPlaces> layers(const SolidPlaces& places);

  /// Whether two solids touch or one lies in the other.
  bool meet(std::size_t a, std::size_t b);

  /// Puts solids together that meet solids of other inputs, however indirectly.
  ///
  /// input   of each solid
  std::vector<SolidPlaces> joined(const std::vector<int>& input);

 private:
  class Neighbour;
  bool find_touch(std::size_t a, std::size_t b);

  std::vector<Neighbour> neighbours_;
  std::map<std::pair<std::size_t, std::size_t>, bool> touch_;  // what was asked
  double tolerance_;
  const SharedLimit& limit_;
};

}  // namespace blossom::occt
