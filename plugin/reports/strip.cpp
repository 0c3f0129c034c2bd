// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/strip.h"

#include <algorithm>

#include "plugin/reports/repairs.h"

namespace blossom::reports {
namespace {

Json contact_json(const StripContact& contact) {
  return {{"gap", contact.gap}, {"normal_angle", contact.normal_angle}, {"scale", contact.scale}};
}

Json side_json(const Input& input, SurfaceSide side, double weight) {
  return {{"file", input.name},
          {"face", input.numbers.front()},
          {"edge", to_string(side)},
          {"weight", weight}};
}

}  // namespace

StripContact worst_of(const Strip& strip) {
  const auto& [a, b] = strip.contacts;
  return {std::max(a.gap, b.gap), std::max(a.normal_angle, b.normal_angle), 0};
}

Json strip_report(const Input& a, const Input& b, const StripOptions& options,
                  const occt::FaceStrip& made, double seconds) {
  const StripContact worst = worst_of(made.strip);
  return {{"schema", "blossom.blend/1"},
          {"kind", "strip"},
          {"a", side_json(a, made.side_a, options.weight_a)},
          {"b", side_json(b, made.side_b, options.weight_b)},
          {"backward", made.strip.backward},
          {"degree", {made.surface->UDegree(), made.surface->VDegree()}},
          {"spans", {made.surface->NbUKnots() - 1, made.surface->NbVKnots() - 1}},
          {"rational", made.strip.surface.rational},
          {"continuity",
           {{"gap", worst.gap},
            {"normal_angle", worst.normal_angle},
            {"a", contact_json(made.strip.contacts[0])},
            {"b", contact_json(made.strip.contacts[1])}}},
          {"source_error", made.strip.surface.error},
          {"seconds", seconds},
          {"repairs", Json::array({repairs_json(a), repairs_json(b)})}};
}

}  // namespace blossom::reports
