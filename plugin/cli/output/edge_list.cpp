// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/edge_list.h"

#include <cmath>
#include <iomanip>
#include <numbers>
#include <set>
#include <sstream>

#include "adapters/occt/edge_facts.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/arguments/vectors.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/reports/models/edges.h"

namespace blossom::cli {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kNoAngle = 1e-9;  // degrees; what is less is rounding

std::string edge_line(const occt::EdgeFacts& edge) {
  std::ostringstream faces, line, middle;
  for (std::size_t i = 0; i < edge.faces.size(); ++i)
    faces << (i == 0 ? "" : ", ") << edge.faces[i];
  const Vec3 at = without_roundings(edge.middle);
  middle << "[" << number_text(rounded(at[0])) << ", " << number_text(rounded(at[1])) << ", "
         << number_text(rounded(at[2])) << "]";
  const double angle = edge.angle * kDegrees;
  // Wide enough for two faces of ten thousand, and for "-0.000543488" and a space.
  line << std::setw(6) << edge.number << "  " << std::left << std::setw(13) << faces.str()
       << std::setw(10) << to_string(edge.kind) << std::setw(13)
       << number_text(std::abs(angle) > kNoAngle ? rounded(angle) : 0) << std::setw(13)
       << number_text(rounded(edge.length)) << middle.str() << "\n";
  if (verbosity() == Verbosity::Verbose)
    line << "        t " << number_text(rounded(edge.from)) << " to "
         << number_text(rounded(edge.to)) << "\n";
  return line.str();
}

}  // namespace

EdgeList edge_list(const reports::Input& input) {
  std::vector<occt::EdgeFacts> edges = occt::edge_facts(input.model.shape());
  if (static_cast<int>(input.numbers.size()) < input.model.face_count()) {
    const std::set<int> own = reports::edge_numbers(input);
    std::erase_if(edges, [&](const occt::EdgeFacts& edge) { return !own.contains(edge.number); });
  }
  EdgeList list{reports::edges_json(edges),
                "  edge  faces        kind      angle°       length       middle\n"};
  for (const occt::EdgeFacts& edge : edges) list.text += edge_line(edge);
  return list;
}

}  // namespace blossom::cli
