// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/paired_parameters.h"

#include <cmath>
#include <optional>

#include "core/regions/border_arcs.h"

namespace blossom {
namespace {

// What goes with a parameter, or with one within kShortestArc of it.
std::optional<double> known_for(const std::map<double, double>& pairs, double parameter,
                                const Interval& domain) {
  const double same = kShortestArc * length(domain);
  std::optional<double> best;
  double nearest = same;
  for (auto it = pairs.lower_bound(parameter - same);
       it != pairs.end() && it->first <= parameter + same; ++it) {
    if (best && std::abs(it->first - parameter) >= nearest) continue;
    nearest = std::abs(it->first - parameter);
    best = it->second;
  }
  return best;
}

}  // namespace

bool PairedParameters::is_same(std::size_t face, std::size_t border) const {
  const CommonFace& of = model_.faces[face];
  return of.parameters.empty() || !of.parameters[border].to_edge;
}

double PairedParameters::on_edge(std::size_t face, std::size_t border, double parameter) {
  if (is_same(face, border)) return parameter;
  const CommonFace& of = model_.faces[face];
  Known& known = known_[{face, border}];
  const Interval domain = of.chart.borders[border].curve.domain();
  const std::optional<double> before = known_for(known.on_edge, parameter, domain);
  const double edge = before ? *before : of.parameters[border].to_edge(parameter);
  known.on_edge[parameter] = edge;
  known.on_border.try_emplace(edge, parameter);
  return edge;
}

double PairedParameters::on_border(std::size_t face, std::size_t border, double parameter) {
  if (is_same(face, border)) return parameter;
  const CommonFace& of = model_.faces[face];
  Known& known = known_[{face, border}];
  const Interval domain = model_.edges[static_cast<std::size_t>(of.edges[border])].domain;
  const std::optional<double> before = known_for(known.on_border, parameter, domain);
  const double own = before ? *before : of.parameters[border].from_edge(parameter);
  known.on_border[parameter] = own;
  known.on_edge[own] = parameter;
  const double same = kShortestArc * length(of.chart.borders[border].curve.domain());
  for (auto it = known.on_edge.lower_bound(own - same);
       it != known.on_edge.end() && it->first <= own + same; ++it)
    it->second = parameter;
  return own;
}

}  // namespace blossom
