// SPDX-License-Identifier: LGPL-2.1-or-later
// What pipes that touch along a circle have in common by closed forms.

#pragma once

#include <optional>

#include "core/forms/elementary.h"
#include "core/forms/meetings/meeting.h"

namespace blossom {

/// The whole intersection of two pipes with a joint (`pipe_joint.h`), or of a torus and a sphere
/// that fits into its tube.
///
/// returns   nothing for other surfaces and positions, or where it has no closed form
std::optional<ElementaryMeeting> meeting_of_pipes(const Elementary& a, const Elementary& b,
                                                  const MeetingLimits& limits);

}  // namespace blossom
