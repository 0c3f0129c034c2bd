// SPDX-License-Identifier: LGPL-2.1-or-later
// What two elementary surfaces have in common by a closed form.

#pragma once

#include <vector>

#include "core/forms/conic.h"
#include "core/forms/meetings/pipe_joint.h"
#include "core/math/vec.h"

namespace blossom {

/// What distances count as nothing; model units.
struct MeetingLimits {
  double exact = 0;    ///< axes and centres that lie on each other do so within this; where nothing
                       ///< touches, also if that keeps all curves within half a contact
  double contact = 0;  ///< surfaces that pass each other no farther apart, or deeper, touch
};

/// A line or conic in which two surfaces cross, or along which they touch.
struct MeetingCurve {
  Conic conic;  ///< a line goes on without end
  bool tangential = false;
  double gap = 0;  ///< of a contact: how far the surfaces are apart there, or reach into each other
  std::vector<double> nodes{};  ///< parameters, increasing, where it crosses others of the meeting
};

/// A point in which two surfaces touch.
struct MeetingPoint {
  Vec3 point;
  double gap = 0;
};

/// A point in which curves cross: the surfaces touch there.
struct MeetingNode {
  Vec3 point;
  double gap = 0;    ///< of the surfaces, where axes and radii count as one that differ
  double reach = 0;  ///< so far off the point may curves then bend from one branch to the other
};

struct ElementaryMeeting {
  std::vector<MeetingCurve> curves;
  std::vector<MeetingPoint> points;
  std::vector<MeetingNode> nodes{};
  std::vector<PipeCrossing> crossings{};  ///< curves, too
};

}  // namespace blossom
