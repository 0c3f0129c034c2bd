// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids are combined: whatever comes out is closed, and its volumes add up.
#include "adapters/occt/base/errors.h"
#include "adapters/occt/solid_trim.h"
#include "core/base/errors.h"
#include "tests/fuzz/support/solids.h"

namespace blossom::fuzz {
namespace {

IntersectionOptions limited() {
  IntersectionOptions options;
  options.time_limit = 2;  // seconds
  options.threads = 1;
  return options;
}

void look_at(const occt::SolidTrimResult& made) {
  for (const TopoDS_Solid& solid : made.solids)
    require(occt::is_closed_solid(solid), "a solid is open");
  require(!made.solids.empty() || !made.obstacles.empty() || made.total.result == 0,
          "there is no solid, and nothing says why");
  if (made.obstacles.empty())
    for (const occt::SolidVolumes& volumes : made.volumes)
      require(volumes.cut >= -1e-6 * volumes.part && volumes.common >= -1e-6 * volumes.part,
              "a volume is negative");
}

}  // namespace

void try_input(Bytes input) try {
  Choices choices(input);
  const auto operation = static_cast<occt::SolidOperation>(choices.within(0, 3));
  const int count = choices.within(1, 2);
  const occt::TrimTool part = occt::trim_tool(solid_of(choices));
  std::vector<occt::TrimTool> tools;
  for (int i = 0; i < count; ++i) tools.push_back(occt::trim_tool(solid_of(choices)));
  look_at(occt::trim_solids(part, tools, operation, limited()));
} catch (const InvalidInput&) {
} catch (const occt::BadModel&) {
} catch (const occt::Failure&) {
}

}  // namespace blossom::fuzz
