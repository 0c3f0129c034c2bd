// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/queries/mass.h"

#include <utility>

#include "adapters/occt/base/shared_limit.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::reports {
namespace {

Json mass_json(const occt::Mass& mass) {
  Json json = {{"area", mass.area}, {"centre", mass.centre.coordinates}};
  if (!mass.is_solid) return json;
  const auto& [xx, yy, zz, xy, xz, yz] = mass.inertia.coordinates;
  json["volume"] = mass.volume;
  json["inertia"] = Json::array({{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}});
  return json;
}

Json part_json(const PartMass& measured) {
  Json json = mass_json(measured.mass);
  json["name"] = measured.part.name;
  json["part"] = measured.part.part;
  json["solid"] = measured.part.solid > 0 ? Json(measured.part.solid) : Json();
  json["faces"] = measured.part.faces;
  return json;
}

}  // namespace

MassAnswer masses_of(const Input& input, const WorkLimit& limit) {
  MassAnswer answer;
  answer.solids.is_solid = true;
  try {
    for (NamedPart& part : named_parts(input)) {
      const occt::Mass mass = occt::mass_of(part.shape, &limit);
      if (mass.is_solid) answer.solids += mass;
      answer.parts.push_back({std::move(part), mass});
    }
  } catch (const occt::LimitFailure&) {  // the others are known
    answer.status = Status::Stopped;
  }
  return answer;
}

double kilograms(double volume, double density) { return volume * 1e-9 * density; }

Json mass_report(const Input& input, const MassAnswer& answer, double density) {
  Json report = {{"schema", "blossom.query/1"}, {"kind", "mass"},
                 {"file", input.name},          {"status", to_string(answer.status)},
                 {"seconds", answer.seconds},   {"total", nullptr},
                 {"parts", Json::array()}};
  for (const PartMass& part : answer.parts) {
    Json& json = report["parts"].emplace_back(part_json(part));
    if (!part.mass.is_solid) continue;
    report["total"] = mass_json(answer.solids);
    if (density <= 0) continue;
    json["mass"] = kilograms(part.mass.volume, density);
    report["total"]["mass"] = kilograms(answer.solids.volume, density);
  }
  report["repairs"] = Json::array({repairs_json(input)});
  return report;
}

}  // namespace blossom::reports
