// SPDX-License-Identifier: LGPL-2.1-or-later
// Chamfers, and fillets of changing radius, that go on over edges beside theirs, as those between
// the walls of a pocket with draft: they lie in the planes across an edge of the run all the way,
// whatever the face behind.
#include <string>
#include <utility>

#include <BRep_Tool.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/strips/ball_walker.h"

namespace blossom::occt {

// Whether what follows lies in the planes across the next edge of the run from the end of this one
// on: both have that plane in common.
bool BallWalker::turns_to_next(const WalkedStrip& of, std::size_t place, int step) const {
  return is_guided() && !of.strip.closed && of.strip.edge == run_.edges[place].edge &&
         next_place(place, step).has_value();
}

// Whether a ball of changing radius is still beside the edge of a place there, before the plane
// that this has in common with the next one.
bool BallWalker::is_before_next(const WalkedStrip& of, std::size_t place, int step,
                                double t) const {
  if (options_.fillet.chamfer || !turns_to_next(of, place, step)) return false;
  const bool rises = of.forward == (step > 0);
  const double end = rises ? of.strip.edge_range.to : of.strip.edge_range.from;
  return (rises ? end - t : t - end) > same_place(of, t);
}

// The strip beside the same edge on the faces behind, or, where none is crossed, beside the next
// one on the same faces. Both lie in one plane across the edge there, which its parameter tells
// exactly.
std::pair<WalkedStrip, double> BallWalker::guided_following(const WalkedStrip& of,
                                                            const WalkExit& exit,
                                                            const std::array<int, 2>& faces,
                                                            std::size_t& place, int step) {
  const bool turns = !exit.over[0] && !exit.over[1];
  if (turns) place = next_place(place, step).value_or(place);
  const RunEdge& beside = run_.edges[place];
  GuidedPlace at;
  at.edge = beside.edge;
  at.ahead = beside.forward == (step > 0);
  Interval domain;
  BRep_Tool::Range(body_.edge(beside.edge), domain.from, domain.to);
  at.at = !turns ? exit.t : at.ahead ? domain.from : domain.to;
  const auto given_out = [&](WalkedStrip made) -> std::pair<WalkedStrip, double> {
    double t = 0;
    if (reaches(made, of, exit.t, reach_at(of, exit), t)) return {std::move(made), at.at};
    refuse(FilletFault::Corner, place, "it does not go on over an edge beside it",
           vec(of.strip.spine->Value(exit.t).XYZ()));
  };
  if (faces == faces_of(place)) return given_out(strip_at(place));
  options_.tick();
  for (const std::size_t side : {0U, 1U}) {
    const std::size_t k = beside.forward ? side : 1 - side;
    at.faces[k] = faces[side];
    at.charts[k] = chart_behind(of, exit, side);
  }
  return given_out({profiles_.guided(body_, place, at), beside.forward, at.at, false});
}

}  // namespace blossom::occt
