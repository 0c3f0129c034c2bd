// SPDX-License-Identifier: LGPL-2.1-or-later
// How large fillets and chamfers are, in the words that the doors of text have in common.

#pragma once

#include <map>
#include <string>
#include <vector>

#include "adapters/occt/fillet.h"

namespace blossom::reports {

/// "2".
/// throws   InvalidInput if it is no positive number
double positive_size(const std::string& word);

/// "2", or "2..5" from the start to the end of a run of edges.
/// throws   InvalidInput if it is none of these, or a number is not positive
occt::EdgeRadius edge_radius(const std::string& word);

/// Edges by number, and the radii that some of them have.
struct EdgeChoice {
  std::vector<int> edges{};
  std::map<int, occt::EdgeRadius> own{};
};

/// "12" or "Edge12", a range "5-9", "12:5" with a radius of its own, or "12:2..5".
/// throws   InvalidInput if it is none of these, or an edge has another radius already
void choose_edges(const std::string& word, EdgeChoice& choice);

/// A law as JSON: `law` is "linear", "smooth" or "table", `radii` its numbers, of a table with the
/// shares `at` of the run's length, from 0 to 1, where they are.
/// throws   InvalidInput likewise
RadiusLaw radius_law(const std::string& json);

/// "circle", "conic:0.4" with a number below 1, "g2" or "g3".
/// throws   InvalidInput likewise
occt::FilletSection fillet_section(const std::string& word);

/// The same the other way, "circle", "conic", "g2" or "g3".
std::string section_name(const occt::FilletSection& section);

/// "2", or "2,1" with two distances, or "2:30" with an angle in degrees.
/// throws   InvalidInput likewise
occt::ChamferSize chamfer_size(const std::string& word);

}  // namespace blossom::reports
