// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges of solids, and of what two solids are together, are rounded and chamfered.
#include <cmath>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/solid_trim.h"
#include "core/base/errors.h"
#include "tests/fuzz/support/solids.h"

namespace blossom::fuzz {
namespace {

// Of one primitive, or of two put together.
TopoDS_Shape body_of(Choices& choices) {
  const bool two = choices.is_so();
  const auto operation = choices.is_so() ? occt::SolidOperation::Cut : occt::SolidOperation::Fuse;
  const TopoDS_Shape first = solid_of(choices);
  if (!two) return first;
  IntersectionOptions options;
  options.time_limit = 1;  // seconds
  options.threads = 1;
  const auto made = occt::trim_solids(occt::trim_tool(first), {occt::trim_tool(solid_of(choices))},
                                      operation, options);
  return occt::compound_of(made.solids);
}

occt::FilletOptions options_of(Choices& choices) {
  occt::FilletOptions options;
  options.largest = false;
  options.partial = choices.is_so();
  options.intersection.time_limit = 2;  // seconds
  options.intersection.threads = 1;
  options.radius = choices.within(0, 7) == 7 ? choices.any() : 0.05 * choices.within(1, 40);
  const int kind = choices.within(0, 8);
  const auto radius = [&] { return 0.05 * choices.within(1, 40); };
  if (kind == 1) options.law = RadiusLaw::smooth({0, 1}, radius(), radius());
  if (kind == 2) options.section = {SectionKind::Conic, choices.between(0, 1)};
  if (kind == 3)
    options.section = {choices.is_so() ? SectionKind::CurvatureRate : SectionKind::Curvature};
  if (kind == 8) options.law = RadiusLaw::table({0, 0.4, 1}, {radius(), radius(), radius()});
  if (kind < 4 || kind == 8) return options;
  options.chamfer = occt::ChamferSize{options.radius, {}, {}};
  if (kind == 5) options.chamfer->second = 0.05 * choices.within(1, 40);
  if (kind == 6) options.chamfer->angle = choices.between(0, 3.2);
  return options;
}

}  // namespace

void try_input(Bytes input) try {
  Choices choices(input);
  occt::FilletOptions options = options_of(choices);
  const TopoDS_Shape body = body_of(choices);
  const int count = static_cast<int>(occt::edge_facts(body).size());
  if (count == 0) return;
  std::vector<int> edges;
  const int wanted = choices.within(1, 4);
  for (int i = 0; i < wanted; ++i) edges.push_back(1 + choices.byte() % count);
  if (!options.chamfer && choices.is_so()) options.own[edges.front()].radius = 0.5 * options.radius;
  const occt::FilletResult made = occt::fillet(body, edges, options);
  for (const occt::FilletedSolid& filleted : made.solids) {
    require(occt::is_closed_solid(filleted.solid), "a solid is open");
    require(std::isfinite(filleted.volume), "a volume is not finite");
  }
  require(!made.solids.empty() || !made.refused.empty() || made.status == Status::Stopped,
          "there is no solid, and nothing says why");
} catch (const InvalidInput&) {
} catch (const occt::BadModel&) {
} catch (const occt::Failure&) {
}

}  // namespace blossom::fuzz
