// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs whose balls come to a sharp edge on the way: walks along their parts.
#include "adapters/occt/blending/strips/ball_walk.h"

#include <cstddef>
#include <utility>

#include "adapters/occt/blending/strips/ball_walker.h"

namespace blossom::occt {
namespace {

// A run and the strips that are known beside its edges.
struct KnownRun {
  EdgeRun run;
  BallWalker::Strips strips;
};

// From one place of a run to before another one. Of a run that was closed, strips that come back to
// their beginning are not known to parts.
KnownRun part_of_run(const KnownRun& whole, std::size_t from, std::size_t to) {
  KnownRun part;
  part.run.concave = whole.run.concave;
  for (std::size_t i = from; i < to; ++i) {
    part.run.edges.push_back(whole.run.edges[i]);
    part.strips.push_back(whole.strips[i]);
    if (part.strips.back() && part.strips.back()->strip.closed) part.strips.back().reset();
  }
  return part;
}

// The parts of a run before and after a cut; of a closed run the one that is left.
std::vector<KnownRun> parts_of(const KnownRun& whole, std::size_t cut) {
  std::vector<KnownRun> parts;
  parts.push_back(part_of_run(whole, 0, cut + 1));
  parts.push_back(part_of_run(whole, cut + 1, whole.run.edges.size()));
  if (!whole.run.closed) return parts;
  KnownRun &before = parts[0], &after = parts[1];
  for (std::size_t i = 0; i <= cut; ++i) {
    after.run.edges.push_back(before.run.edges[i]);
    after.strips.push_back(before.strips[i]);
  }
  parts.erase(parts.begin());
  return parts;
}

std::vector<BallWalk> walks_along(const BodyEdges& body, const KnownRun& of,
                                  const WalkOptions& options) {
  BallWalker walker(body, of.run, options, of.strips);
  BallWalk whole = walker.walk();
  if (!walker.cut()) return {std::move(whole)};
  std::vector<BallWalk> all;
  for (const KnownRun& part : parts_of({of.run, walker.strips()}, *walker.cut()))
    for (BallWalk& each : walks_along(body, part, options)) all.push_back(std::move(each));
  return all;
}

}  // namespace

std::vector<BallWalk> ball_walks(const BodyEdges& body, const EdgeRun& run,
                                 const WalkOptions& options) {
  return walks_along(body, {run, BallWalker::Strips(run.edges.size())}, options);
}

}  // namespace blossom::occt
