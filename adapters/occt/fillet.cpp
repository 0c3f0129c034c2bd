// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/fillet.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/sheet/fillet_attempt.h"
#include "adapters/occt/blending/sheet/filleting.h"
#include "adapters/occt/blending/sheet/largest_fillet.h"
#include "adapters/occt/blending/strips/run_profiles.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

void check_request(const BodyEdges& body, const std::vector<int>& edges,
                   const FilletOptions& options) {
  const auto check_length = [](double length, const char* what) {
    if (!(length > 0) || !std::isfinite(length))
      throw InvalidInput(std::string("fillet: the ") + what + " has to be positive and finite");
  };
  const auto check_radius = [&](const EdgeRadius& of) {
    check_length(of.radius, "radius");
    if (of.law && !(of.law->extremes({0, 1}).from > 0))
      throw InvalidInput("fillet: the law's radius has to be positive everywhere");
  };
  check_radius({options.radius, options.law});
  for (const auto& [edge, own] : options.own) {
    check_radius(own);
    if (options.chamfer) throw InvalidInput("fillet: chamfers have no radii");
    if (std::ranges::find(edges, edge) == edges.end())
      throw InvalidInput("fillet: edge " + std::to_string(edge) +
                         " has a radius, but is not among the edges");
  }
  check_length(options.setback.value_or(1), "setback");
  if (options.setback && options.chamfer) throw InvalidInput("fillet: chamfers have no setback");
  if (options.section.kind == SectionKind::Chamfer)
    throw InvalidInput("fillet: chamfers have an option of their own");
  if (options.section.kind == SectionKind::Conic &&
      !(options.section.rho > 0 && options.section.rho < 1))
    throw InvalidInput("fillet: rho has to be between 0 and 1");
  if (options.chamfer) {
    check_length(options.chamfer->first, "distance");
    check_length(options.chamfer->second.value_or(1), "second distance");
    const double angle = options.chamfer->angle.value_or(1);
    if (!(angle > 0 && angle < std::numbers::pi))
      throw InvalidInput("fillet: the angle has to be between 0 and pi");
  }
  if (edges.empty()) throw InvalidInput("fillet: no edge is named");
  for (const int edge : edges)
    if (edge < 1 || edge > body.edge_count())
      throw InvalidInput("fillet: there is no edge " + std::to_string(edge) + ", only 1 to " +
                         std::to_string(body.edge_count()));
}

// The chains of the edges that can have fillets; the others are refused.
std::vector<FilletEdges> chains_of(const BodyEdges& body, const std::vector<int>& edges,
                                   std::vector<FilletRefusal>& refused) {
  std::vector<FilletEdges> chains;
  for (const int edge : edges) {
    if (std::ranges::any_of(chains, [&](const auto& chain) { return chain.count(edge) > 0; }))
      continue;
    try {
      chains.push_back(smooth_chain(body, edge));
    } catch (const FilletRefused& refusal) {
      refused.push_back(refusal.why());
    }
  }
  return chains;
}

// Whether an edge was refused that could be rounded, and so keeps the others from it.
bool stops_others(const FilletResult& result) {
  return std::ranges::any_of(
      result.refused, [](const FilletRefusal& why) { return why.fault != FilletFault::Nothing; });
}

// The radius that edges of a chain have of their own, if any; two that differ are refused.
std::optional<std::pair<int, EdgeRadius>> own_radius(const FilletEdges& chain,
                                                     const FilletOptions& options) {
  std::optional<std::pair<int, EdgeRadius>> found;
  for (const auto& [edge, concave] : chain) {
    const auto own = options.own.find(edge);
    if (own == options.own.end()) continue;
    if (found && !is_same(found->second, own->second))
      throw FilletRefused({FilletFault::Edge,
                           edge,
                           "edge " + std::to_string(found->first) +
                               " goes on in it smoothly, and one fillet along both cannot have two "
                               "radii; it may change from one to the other by a law",
                           {},
                           {},
                           {}});
    if (!found) found = *own;
  }
  return found;
}

// Radii of edges' own, for the whole chains of these; the notes name the edges that were asked for
// without one.
std::map<int, EdgeRadius> own_radii(std::vector<FilletEdges>& chains, const std::vector<int>& asked,
                                    const FilletOptions& options, FilletResult& result) {
  std::map<int, EdgeRadius> all;
  std::erase_if(chains, [&](const FilletEdges& chain) {
    try {
      const auto own = own_radius(chain, options);
      if (!own) return false;
      for (const auto& [edge, concave] : chain) {
        all.emplace(edge, own->second);
        if (options.own.count(edge) == 0 && std::ranges::find(asked, edge) != asked.end())
          result.notes.push_back("edge " + std::to_string(edge) + " has the radius of edge " +
                                 std::to_string(own->first) + ", which goes on in it smoothly");
      }
      return false;
    } catch (const FilletRefused& refusal) {
      result.refused.push_back(refusal.why());
      return true;
    }
  });
  return all;
}

// The parameter of the edge at fault that is nearest to the place.
void add_parameter(const BodyEdges& body, FilletRefusal& why) {
  if (why.edge < 1 || !why.point || why.parameter) return;
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(why.edge), range.from, range.to);
  if (!curve.IsNull()) why.parameter = nearest_on(curve, range, *why.point);
}

// The radius, or the first distance of a chamfer.
double size_of(const FilletOptions& options) {
  return options.chamfer ? options.chamfer->first : options.radius;
}

/// What a search for a radius that works changes.
struct ChangedRadius {
  double size = 1;
  int edge = 0;  ///< of the chain whose radius it is, while others keep theirs; 0: of all edges
};

// Where edges have radii of their own, one is changed: that of the chain at fault, or else the
// largest. Nothing if the radius is a law.
std::optional<ChangedRadius> radius_to_change(Filleting& work,
                                              const std::vector<FilletEdges>& chains,
                                              std::optional<std::size_t> at_fault,
                                              const FilletOptions& options) {
  const std::map<int, EdgeRadius> own = work.own();
  if (own.empty())
    return options.law ? std::nullopt : std::optional(ChangedRadius{size_of(options)});
  const auto radius_of = [&](const FilletEdges& chain) {
    const auto known = own.find(chain.begin()->first);
    return known == own.end() ? EdgeRadius{options.radius, options.law} : known->second;
  };
  std::size_t changed = at_fault.value_or(0);
  for (std::size_t i = 0; i < chains.size() && !at_fault; ++i)
    if (radius_of(chains[i]).radius > radius_of(chains[changed]).radius) changed = i;
  const EdgeRadius of = radius_of(chains[changed]);
  if (of.law) return std::nullopt;
  std::map<int, EdgeRadius> kept = own;
  for (const FilletEdges& chain : chains)
    for (const auto& [each, concave] : chain)
      kept.try_emplace(each, EdgeRadius{options.radius, options.law});
  for (const auto& [each, concave] : chains[changed]) kept.erase(each);
  work.set_own(std::move(kept));
  return ChangedRadius{of.radius, chains[changed].begin()->first};
}

// The largest radius with which all that was asked for can be rounded; of the chain at fault alone
// where the others are rounded without it.
void add_largest(Filleting& work, const std::vector<FilletEdges>& chains,
                 const FilletOptions& options, FilletRefusal& why) {
  if (!options.largest || options.section.kind != SectionKind::Circle || why.largest) return;
  if (why.fault == FilletFault::Setback) return;  // says itself what it has to be
  std::optional<std::size_t> at_fault;
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (chains[i].count(why.edge) > 0) at_fault = i;
  std::vector<FilletEdges> asked = chains;
  if (at_fault && options.partial) asked = {chains[*at_fault]};
  const std::map<int, EdgeRadius> own = work.own();
  const auto changed = radius_to_change(work, chains, at_fault, options);
  if (!changed) return;
  try {
    const auto found = largest_fillet(work, asked, changed->size, why);
    work.set_own(own);
    if (!found && why.fault != FilletFault::Edge)
      why.tried = std::string("; of the smaller and larger ") +
                  (options.chamfer ? "distances" : "radii") + " tried none works either";
    if (!found) return;
    why.largest = found->radius;
    why.at_least = found->at_least;
    why.of_chamfer = options.chamfer.has_value();
    if (!found->stopped.empty())
      why.tried = std::string("; larger ") + (options.chamfer ? "distances" : "balls") +
                  " are stopped by " + found->stopped;
    if (found->radius > changed->size)
      why.tried = std::string("; larger ") + (options.chamfer ? "distances" : "radii") + " work";
    if (changed->edge > 0 && changed->edge != why.edge)
      why.tried += "; smaller radii of edge " + std::to_string(changed->edge) +
                   " were tried, while others kept theirs";
  } catch (const LimitFailure&) {
    work.set_own(own);  // the refusal stands without it
    why.tried = std::string("; the largest ") + (options.chamfer ? "distance" : "radius") +
                " that works was not found within the limit";
  }
}

// As many chains as go together: one after the other is added to those that work, until no more
// can be. The others are refused, each with what it met there.
FilletAttempt as_many_as_work(Filleting& work, std::vector<FilletEdges>& chains, double radius,
                              const std::function<void(const FilletRefusal&)>& refuse) {
  FilletAttempt best;
  std::vector<FilletEdges> kept, open = std::move(chains);
  std::vector<FilletRefusal> causes;
  for (bool changed = true; changed;) {
    changed = false;
    causes.clear();
    std::vector<FilletEdges> left;
    for (FilletEdges& chain : open) {
      kept.push_back(chain);
      FilletAttempt next = fillet_attempt(work, kept, radius);
      changed = changed || !next.why;
      if (!next.why) {
        best = std::move(next);
        continue;
      }
      kept.pop_back();
      if (chain.count(next.why->edge) == 0) next.why->edge = chain.begin()->first;
      causes.push_back(*next.why);
      left.push_back(std::move(chain));
    }
    open = std::move(left);
  }
  chains = open;  // those at fault, while the reasons are told
  for (const FilletRefusal& why : causes) refuse(why);
  chains = std::move(kept);
  return best;
}

// What can be made of the chains, or why not.
void make_fillets(Filleting& work, std::vector<FilletEdges>& chains, const FilletOptions& options,
                  FilletResult& result) {
  const auto refuse = [&](const FilletRefusal& why) {
    result.refused.push_back(why);
    add_parameter(work.body(), result.refused.back());
    add_largest(work, chains, options, result.refused.back());
  };
  while (!chains.empty() && (options.partial || !stops_others(result))) {
    FilletAttempt made = fillet_attempt(work, chains, size_of(options));
    if (made.why) {
      const auto at_fault = std::ranges::find_if(
          chains, [&](const auto& chain) { return chain.count(made.why->edge) > 0; });
      const bool is_own = is_own_fault(made.why->fault) && at_fault != chains.end();
      if (!options.partial || is_own) refuse(*made.why);
      if (!options.partial) return;
      if (is_own) {
        chains.erase(at_fault);
        continue;
      }
      made = as_many_as_work(work, chains, size_of(options), refuse);
    }
    result.solids = std::move(made.solids);
    if (made.is_tolerant) result.status = Status::Tolerance;
    result.notes.insert(result.notes.end(), made.notes.begin(), made.notes.end());
    for (const FilletEdges& chain : chains)
      for (const auto& [edge, concave] : chain) result.edges.push_back(edge);
    for (const int edge : made.gone_on)
      if (std::ranges::find(result.edges, edge) == result.edges.end()) result.edges.push_back(edge);
    std::ranges::sort(result.edges);
    return;
  }
}

}  // namespace

FilletResult fillet(const TopoDS_Shape& shape, const std::vector<int>& edges,
                    const FilletOptions& options) {
  if (shape.IsNull()) throw InvalidInput("fillet: there is no shape");
  FilletResult result;
  Filleting work(shape, options);
  check_request(work.body(), edges, options);
  if (options.volumes) result.volume_before = work.volume_given();
  std::vector<FilletEdges> chains = chains_of(work.body(), edges, result.refused);
  work.set_own(own_radii(chains, edges, options, result));
  try {
    make_fillets(work, chains, options, result);
  } catch (const LimitFailure& reached) {
    result.refused.push_back({FilletFault::Result, 0, reached.what(), {}, {}, {}});
    result.status = Status::Stopped;
  }
  std::ranges::stable_partition(
      result.refused, [](const FilletRefusal& why) { return why.fault != FilletFault::Nothing; });
  return result;
}

}  // namespace blossom::occt
