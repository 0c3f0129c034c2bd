// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs whose balls come to a sharp edge on the way, or to edges that are too tight for them: walks
// along their parts.
#include "adapters/occt/blending/strips/ball_walk.h"

#include <cstddef>
#include <set>
#include <utility>

#include "adapters/occt/blending/strips/ball_walker.h"

namespace blossom::occt {
namespace {

// A run and the strips that are known beside its edges.
struct KnownRun {
  EdgeRun run;
  BallWalker::Strips strips;
};

// From one place of a run to another, round a closed one. Of a run that was closed, strips that
// come back to their beginning are not known to parts.
KnownRun part_of_run(const KnownRun& whole, std::size_t from, std::size_t to) {
  KnownRun part;
  part.run.concave = whole.run.concave;
  const std::size_t count = whole.run.edges.size();
  for (std::size_t i = from;; i = (i + 1) % count) {
    part.run.edges.push_back(whole.run.edges[i]);
    part.strips.push_back(whole.strips[i]);
    if (part.strips.back() && part.strips.back()->strip.closed) part.strips.back().reset();
    if (i == to) return part;
  }
}

// The parts of a run before and after a cut; of a closed run the one that is left.
std::vector<KnownRun> parts_of(const KnownRun& whole, const RunCut& cut) {
  if (whole.run.closed) return {part_of_run(whole, cut.before, cut.after)};
  return {part_of_run(whole, 0, cut.after),
          part_of_run(whole, cut.before, whole.run.edges.size() - 1)};
}

std::vector<BallWalk> walks_along(const BodyEdges& body, const KnownRun& of,
                                  const WalkOptions& options, std::set<int>& passed) {
  BallWalker walker(body, of.run, options, of.strips, passed);
  BallWalk whole = walker.walk();
  if (!walker.cut()) return {std::move(whole)};
  for (const PassedEdge& each : walker.cut()->passed) passed.insert(each.edge);
  std::vector<BallWalk> all;
  for (const KnownRun& part : parts_of({of.run, walker.strips()}, *walker.cut()))
    for (BallWalk& each : walks_along(body, part, options, passed)) all.push_back(std::move(each));
  const std::vector<PassedEdge>& here = walker.cut()->passed;
  all.front().passed.insert(all.front().passed.end(), here.begin(), here.end());
  return all;
}

}  // namespace

std::vector<BallWalk> ball_walks(const BodyEdges& body, const EdgeRun& run,
                                 const WalkOptions& options) {
  std::set<int> passed;
  return walks_along(body, {run, BallWalker::Strips(run.edges.size())}, options, passed);
}

}  // namespace blossom::occt
