// SPDX-License-Identifier: LGPL-2.1-or-later
// Which of many solids touch each other, and sets of them that can be worked on as one.

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <TopoDS_Solid.hxx>

#include "adapters/occt/shared_limit.h"

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

  /// Puts solids together that touch solids of other inputs, however indirectly.
  ///
  /// input   of each solid
  std::vector<SolidPlaces> joined(const std::vector<int>& input);

 private:
  class Neighbour;
  std::vector<Neighbour> neighbours_;
  double tolerance_;
  const SharedLimit& limit_;
};

}  // namespace blossom::occt
