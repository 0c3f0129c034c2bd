// SPDX-License-Identifier: LGPL-2.1-or-later
// The end of a search for the common points of a curve with a curve or a surface.

#pragma once

#include "core/base/status.h"
#include "core/math/vec.h"

namespace blossom {

/// Why a result that lists places is within tolerance.
inline constexpr const char* kContactsWithinTolerance = "contacts within tolerance";

/// Takes points and places back from the origin, and lets counts and status tell what was found.
///
/// approximate   says what is only an approximation; nullptr: nothing is
/// stopped       says why the search or what follows it ended early; nullptr: it did not
template <class Result, class Findings>
void close_search(Result& result, const Findings& found, const Vec3& origin,
                  const char* approximate, const char* stopped) {
  for (auto& point : result.points) point.point += origin;
  for (auto& place : result.places) {
    place.box_low += origin;
    place.box_high += origin;
  }
  result.certificate.excluded = found.excluded;
  result.certificate.certified = found.certified;
  const auto weaken = [&](Status status, const char* reason) {
    result.status = weaker(result.status, status);
    result.certificate.reasons.emplace_back(reason);
  };
  if (!result.places.empty()) weaken(Status::Tolerance, kContactsWithinTolerance);
  if (approximate != nullptr) weaken(Status::Tolerance, approximate);
  if (stopped != nullptr) weaken(Status::Stopped, stopped);
}

}  // namespace blossom
