// SPDX-License-Identifier: LGPL-2.1-or-later
// Chamfers that go on over edges beside theirs, as those between the walls of a pocket with draft:
// borders lie in the planes across an edge of the run all the way, whatever the face behind.
#include <string>
#include <utility>

#include <BRep_Tool.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/strips/ball_walker.h"

namespace blossom::occt {

// Whether what follows lies in the planes across the next edge of the run from the end of this one
// on: both have that plane in common.
bool BallWalker::turns_to_next(const WalkedStrip& of, std::size_t place, int step) const {
  return options_.fillet.chamfer && !of.strip.closed && of.strip.edge == run_.edges[place].edge &&
         next_place(place, step).has_value();
}

// The strip beside the same edge on the faces behind, or, where none is crossed, beside the next
// one on the same faces.
std::pair<WalkedStrip, double> BallWalker::chamfer_following(const WalkedStrip& of,
                                                             const WalkExit& exit,
                                                             const std::array<int, 2>& faces,
                                                             std::size_t& place, int step) {
  const bool turns = !exit.over[0] && !exit.over[1];
  if (turns) place = next_place(place, step).value_or(place);
  const RunEdge& beside = run_.edges[place];
  double t = 0;
  const auto given_out = [&](WalkedStrip made) -> std::pair<WalkedStrip, double> {
    if (reaches(made, of, exit.t, reach_at(of, exit), t)) return {std::move(made), t};
    refuse(FilletFault::Corner, place, "the chamfer does not go on over an edge beside it",
           vec(of.strip.spine->Value(exit.t).XYZ()));
  };
  if (faces == faces_of(place)) return given_out(strip_at(place));
  options_.tick();
  ChamferPlace at;
  at.edge = beside.edge;
  at.ahead = beside.forward == (step > 0);
  for (const std::size_t side : {0U, 1U}) {
    const std::size_t k = beside.forward ? side : 1 - side;
    at.faces[k] = faces[side];
    at.charts[k] = chart_behind(of, exit, side);
  }
  Interval domain;
  BRep_Tool::Range(body_.edge(beside.edge), domain.from, domain.to);
  at.at = !turns ? exit.t : at.ahead ? domain.from : domain.to;
  return given_out({profiles_.chamfer(body_, place, at), beside.forward, at.at, false});
}

}  // namespace blossom::occt
