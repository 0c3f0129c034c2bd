// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/queries/rays.h"

#include <cstddef>

#include "plugin/reports/models/repairs.h"
#include "plugin/reports/models/shape_numbers.h"

namespace blossom::reports {
namespace {

Json hit_json(const Input& input, const ShapeNumbers& numbers, const occt::ShapeHit& found) {
  const RayHit& hit = found.hit;
  const int face = input.numbers[static_cast<std::size_t>(hit.surface)];
  return {{"distance", hit.parameter},
          {"first", hit.first},
          {"last", hit.last},
          {"point", hit.point.coordinates},
          {"face", face},
          {"uv", hit.uv.coordinates},
          {"normal", hit.normal.coordinates},
          {"on", numbers.place(found.on, face)},
          {"grazing", hit.grazing},
          {"status", to_string(hit.status)}};
}

}  // namespace

Json ray_report(const Input& input, const RayAnswer& answer) {
  const ShapeNumbers numbers(input.model.shape());
  Json report = {{"schema", "blossom.query/1"},
                 {"kind", "ray"},
                 {"file", input.name},
                 {"from", answer.ray.origin.coordinates},
                 {"direction", answer.ray.direction.coordinates},
                 {"line", answer.line},
                 {"first", answer.first_only},
                 {"tolerance", answer.tolerance},
                 {"status", to_string(answer.status)},
                 {"seconds", answer.seconds}};
  report["hits"] = Json::array();
  for (const occt::ShapeHit& hit : answer.hits)
    report["hits"].push_back(hit_json(input, numbers, hit));
  report["repairs"] = Json::array({repairs_json(input)});
  return report;
}

}  // namespace blossom::reports
