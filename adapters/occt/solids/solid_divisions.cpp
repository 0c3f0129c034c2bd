// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/solid_divisions.h"

#include <algorithm>
#include <sstream>

#include "adapters/occt/solids/tolerances/contact_scale.h"
#include "adapters/occt/solids/tolerances/stated_tolerance.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/limits.h"

namespace blossom::occt {
namespace {

// A look at the faces, and how it is read.
struct Reading {
  std::size_t look = 0;
  EdgesLie lying = EdgesLie::WhereFacesMeet;
};

// What is not there to be near is read first, at both tolerances.
constexpr std::array<Reading, 6> kReadings{{{0, EdgesLie::WhereFacesMeet},
                                            {1, EdgesLie::WhereFacesMeet},
                                            {0, EdgesLie::Nearby},
                                            {1, EdgesLie::Nearby},
                                            {2, EdgesLie::WhereFacesMeet},
                                            {2, EdgesLie::Nearby}}};

}  // namespace

SolidDivisions::SolidDivisions(const TrimTool& a, const TrimTool& b, double stated,
                               const IntersectionOptions& options)
    : a_(a),
      b_(b),
      options_(options),
      stated_(std::max(stated, stated_tolerance(a, b, options.tolerances.point))) {}

IntersectionOptions SolidDivisions::left(double tolerance) const {
  IntersectionOptions rest = limit_.remaining();
  rest.threads = options_.threads;
  rest.tolerances.point = tolerance;
  return rest;
}

double SolidDivisions::other_tolerance() {
  const double point = options_.tolerances.point;
  const double reach = kLooseReach * kLooseReach * point;
  if (!other_)
    other_ = stated_ != point ? point : contact_scale(contact_gaps(a_, b_, reach, limit_), point);
  return *other_;
}

const SolidDivisions::Look* SolidDivisions::look(std::size_t number) {
  std::optional<Look>& look = looks_[number];
  if (look) return &*look;
  const double tolerance = number == 0 ? stated_ : other_tolerance();
  if (number == 1 && tolerance == stated_) return nullptr;
  const Extent extent = number < 2 ? Extent::Extended : Extent::Trims;
  look = Look{tolerance, intersect(a_.faces, b_.faces, left(tolerance), extent)};
  return &*look;
}

void SolidDivisions::tell_tolerance(double tolerance, SolidPieces& pieces) const {
  if (tolerance == stated_) return;
  std::ostringstream text;
  if (stated_ > tolerance)
    text << "what the inputs state to be uncertain, up to " << stated_
         << ", may be apart in the result";
  else
    text << "what is nearer to each other than " << tolerance << " counts as one";
  pieces.merged.push_back(text.str());
  pieces.status = weaker(pieces.status, Status::Tolerance);
}

std::optional<SolidPieces> SolidDivisions::next() {
  const Look* found_in = nullptr;
  Reading reading;
  while (found_in == nullptr) {
    if (readings_ == kReadings.size() || (readings_ > 0 && limit_.is_reached())) return {};
    reading = kReadings[readings_++];
    found_in = look(reading.look);
  }
  // What stands against later ones is not told.
  const Causes causes = readings_ == 1 ? Causes::WhereCutsBreakOff : Causes::Short;
  SolidPieces found =
      solid_pieces(a_, b_, found_in->faces, reading.lying, left(found_in->tolerance), causes);
  if (found.obstacles.empty()) tell_tolerance(found_in->tolerance, found);
  return found;
}

}  // namespace blossom::occt
